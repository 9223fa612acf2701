#pragma once
// --datasheets: photometry files are read again, when everything else is done.

#include "report/html/chapters/data_sheets.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace cli {

// A file counts only with the hash that the result has of it, and a light only if it is that of the
// result: its curves and what is said of it. So neither a file that was changed nor another variant
// of it is ever shown. Lights of a GLDF variant's emitters are found alone, as their fittings and
// all together; not those of some of three and more.
class SheetFiles : public report::SheetSource {
 public:
  void see(const report::ProjectPart& project, const std::string& result) override;
  std::variant<report::SheetLight, report::Text> light_of(
      const report::LuminaireRow& row) const override;

 private:
  // A result may be anybody's: what it names must lie in the folder of the project or below it.
  struct SheetPlace {
    std::string folder, file;
    bool operator==(const SheetPlace&) const = default;
  };
  std::map<std::string, std::vector<SheetPlace>> places_;  // where a file may be, by its hash
};

}  // namespace cli
