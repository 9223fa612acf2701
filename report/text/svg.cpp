#include "report/text/svg.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <cmath>

namespace report {
namespace {

// As its decimal digits are read: 3 and -1 are 0.3. Never -0.
double number_of(double digits, int exponent) {
  return calc::parse_number(fmt::format("{}e{}", digits, exponent)).value_or(0.0) + 0.0;
}

}  // namespace

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

std::vector<double> round_ticks(double low, double high, int most) {
  std::vector<double> ticks;
  if (!(low < high) || !std::isfinite(high - low)) return ticks;
  // The smallest step with so few of them.
  const int first = static_cast<int>(std::floor(calc::log10((high - low) / most))) - 1;
  for (int exponent = first;; ++exponent) {
    for (const int digit : {1, 2, 5}) {
      const double step = number_of(digit, exponent);
      const double from = std::ceil(low / step), to = std::floor(high / step);
      if (to - from + 1.0 > most) continue;
      for (double k = from; k <= to; k += 1.0) ticks.push_back(number_of(k * digit, exponent));
      return ticks;
    }
  }
}

}  // namespace report
