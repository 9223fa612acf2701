#pragma once
// How pages are worded and printed, as options that several commands have.

#include "report/html/page/print_pages.h"
#include "report/shell/command/command.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace cli {

enum class DecimalSign { of_language, point, comma };

// Words in this language, numbers with this sign.
report::Texts texts_with(report::Language language, DecimalSign decimal);

// --decimal and --paper; of: what they are of, "html".
Option decimal_option(DecimalSign& target, const std::string& of);
Option paper_option(report::Paper& target, const std::string& of);

// Of a tool whose page is its only output in other languages than English.
struct PageChoice {
  report::Language language = report::Language::english;
  DecimalSign decimal = DecimalSign::of_language;
  report::Paper paper = report::Paper::a4;

  report::Texts texts() const { return texts_with(language, decimal); }
};
// --language, --decimal and --paper; of: what the page is, "html".
std::vector<Option> page_options(PageChoice& target, const std::string& of);

}  // namespace cli
