#include "report/text/texts.h"

namespace report {

std::string Texts::number(std::string text) const {
  if (!has_decimal_comma_) return text;
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_digit = [&text](std::size_t at) {
      return at < text.size() && text[at] >= '0' && text[at] <= '9';
    };
    if (text[i] == '.' && i > 0 && is_digit(i - 1) && is_digit(i + 1)) {
      shown += ',';
    } else if (text[i] == ',') {
      shown += ';';
    } else {
      shown += text[i];
    }
  }
  return shown;
}

std::string Texts::english_html(const std::string& html) const {
  if (language_ == Language::english || html.empty()) return html;
  return "<span lang=\"en\">" + html + "</span>";
}

}  // namespace report
