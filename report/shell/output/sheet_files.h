#pragma once
// Option --datasheets: reads photometry files again when everything else is done.

#include "report/html/chapters/data_sheets.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace cli {

// A file counts only with its hash in the result, and a light only if its curves and facts are
// those of the result. So neither a changed file nor another variant is ever shown. For the
// emitters of a GLDF variant single lights and all together are found, not subsets of three or
// more.
class SheetFiles : public report::SheetSource {
 public:
  void see(const report::ProjectPart& project, const std::string& result) override;
  std::variant<report::SheetLight, report::Text> light_of(
      const report::LuminaireRow& row) const override;

 private:
  // The place of a sheet. A result may come from anybody: files it names must be in the folder of
  // the project or below it.
  struct SheetPlace {
    std::string folder, file;
    bool operator==(const SheetPlace&) const = default;
  };
  std::map<std::string, std::vector<SheetPlace>> places_;  // where a file may be, by its hash
};

}  // namespace cli
