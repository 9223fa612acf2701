#include "report/shell/output/page_options.h"

#include "report/shell/command/option_values.h"
#include "report/shell/output/language_option.h"

namespace cli {

report::Texts texts_with(report::Language language, DecimalSign decimal) {
  const bool has_comma = decimal == DecimalSign::of_language
                             ? report::language_row(language).has_decimal_comma
                             : decimal == DecimalSign::comma;
  return {language, has_comma};
}

Option decimal_option(DecimalSign& target, const std::string& of) {
  return {
      "--decimal", "SIGN",
      "Choose the decimal sign: point or comma; default that of the language. It applies to " + of +
          ". All other formats have points",
      choice<DecimalSign>(target, {{"point", DecimalSign::point}, {"comma", DecimalSign::comma}})};
}

Option paper_option(report::Paper& target, const std::string& of) {
  return {"--paper", "SIZE", "Choose the paper size: a4 or letter; default a4. It applies to " + of,
          choice<report::Paper>(target,
                                {{"a4", report::Paper::a4}, {"letter", report::Paper::letter}})};
}

std::vector<Option> page_options(PageChoice& target, const std::string& of) {
  return {{"--language", "LANG",
           "Choose the language of " + of + ": " + language_names() +
               "; default en. Everything else is English",
           language_choice(target.language)},
          decimal_option(target.decimal, of),
          paper_option(target.paper, of + " when it is printed")};
}

}  // namespace cli
