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

// Where the light of luminaires comes from: documents hold only two curves of it.
class SheetSource {
 public:
  virtual ~SheetSource() = default;
  // Of each project, as it was before redact(). result: the file that it was read from, "" = none.
  virtual void see(const ProjectPart& project, const std::string& result) = 0;
  // That which the row was calculated with, or why there is none: Text::sheet_not_found and others.
  virtual std::variant<SheetLight, Text> light_of(const LuminaireRow& row) const = 0;
};

// A report has at most so many sheets.
inline constexpr std::size_t kMostSheets = 200;

struct DataSheets {
  std::string html;  // "" = the project has no luminaires
  struct Entry {
    std::string anchor, name;  // name: not escaped
  };
  std::vector<Entry> entries;  // for the contents
};

// One for each photometry that types have, in order of the types; types with the same light share
// one. index: of the project. sheets_before: how many the report has already, at most kMostSheets.
DataSheets data_sheets(const Texts& t, const ProjectPart& project, std::size_t index,
                       const SheetSource& source, std::size_t sheets_before);

}  // namespace report
