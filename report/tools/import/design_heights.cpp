#include "report/tools/import/design_heights.h"

#include "calc/base/text.h"
#include "report/tools/import/import_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace cli {

std::optional<double> length_of_text(const std::string& text, double metres_per_unit) {
  std::string number(calc::trim(text));
  double factor = metres_per_unit;
  for (const std::string_view unit : {"mm", "cm", "m"}) {
    if (number.size() <= unit.size() ||
        calc::ascii_lowered(number).compare(number.size() - unit.size(), unit.size(), unit) != 0) {
      continue;
    }
    number = calc::trim(std::string_view(number).substr(0, number.size() - unit.size()));
    factor = *metres_per_import_unit(unit);
    break;
  }
  if (std::count(number.begin(), number.end(), ',') == 1 && number.find('.') == number.npos) {
    number[number.find(',')] = '.';
  }
  const std::optional<double> value = calc::parse_number(number);
  return value ? std::optional(*value * factor) : std::nullopt;
}

std::optional<double> height_of_attribute(const DesignLuminaire& luminaire,
                                          const std::string& pattern, double metres_per_unit,
                                          DesignNotes& notes) {
  constexpr double kHighest_m = 1000.0;
  for (const auto& [name, value] : luminaire.attribute) {
    if (!matches_name(pattern, name) || calc::trim(value).empty()) continue;
    const std::optional<double> height_m = length_of_text(value, metres_per_unit);
    if (height_m && *height_m > 0.0 && *height_m <= kHighest_m) return height_m;
    notes.doubt(fmt::format("luminaire {}", luminaire.type),
                fmt::format("its attribute {} is not a height", name), luminaire.source.place);
    break;
  }
  return std::nullopt;
}

}  // namespace cli
