#pragma once
// Options for the wording and printing of pages, shared by several commands.

#include "report/html/page/print_pages.h"
#include "report/shell/command/command.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace cli {

enum class DecimalSign { of_language, point, comma };

// Returns texts in this language, with numbers in this decimal style.
report::Texts texts_with(report::Language language, DecimalSign decimal);

// Returns --decimal and --paper. of: the format, "html".
Option decimal_option(DecimalSign& target, const std::string& of);
Option paper_option(report::Paper& target, const std::string& of);

// Choices for a tool whose page is its only output in other languages than English.
struct PageChoice {
  report::Language language = report::Language::english;
  DecimalSign decimal = DecimalSign::of_language;
  report::Paper paper = report::Paper::a4;

  report::Texts texts() const { return texts_with(language, decimal); }
};
// Returns --language, --decimal and --paper. of: the format of the page, "html".
std::vector<Option> page_options(PageChoice& target, const std::string& of);

}  // namespace cli
