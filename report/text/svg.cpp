#include "report/text/svg.h"

#include "report/text/markup.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

namespace report {

std::string svg_number(double value) {
  std::string text = format_fixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string svg_text(double x, double y, const char* anchor, std::string_view text) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", svg_number(x),
                     svg_number(y), anchor, escape_html(text));
}

}  // namespace report
