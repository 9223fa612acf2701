#pragma once
// The data sheets of a project's luminaire types, for the annex of a page.

#include "report/document/document.h"
#include "report/html/chapters/sheet_body.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace report {

// The source of the light of luminaires: documents hold only two curves of it.
class SheetSource {
 public:
  virtual ~SheetSource() = default;
  // Sees each project as it was before redact(). result: the file that it was read from, "" = none.
  virtual void see(const ProjectPart& project, const std::string& result) = 0;
  // Returns the light that the row was calculated with, or why there is none: Text::sheet_not_found
  // and others.
  virtual std::variant<SheetLight, Text> light_of(const LuminaireRow& row) const = 0;
};

// The most sheets of a report.
inline constexpr std::size_t kMostSheets = 200;

struct DataSheets {
  std::string html;  // "" = the project has no luminaires
  struct Entry {
    std::string anchor, name;  // name: not escaped
  };
  std::vector<Entry> entries;  // for the contents
};

// Returns one sheet for each photometry of the types, in their order; types with the same light
// share a sheet. index: of the project. sheets_before: sheets that the report already has, at most
// kMostSheets.
DataSheets data_sheets(const Texts& t, const ProjectPart& project, std::size_t index,
                       const SheetSource& source, std::size_t sheets_before);

}  // namespace report
