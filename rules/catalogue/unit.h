#pragma once
// Units of limits in rule packs, and what they measure.

#include "calc/base/xml_reader.h"

#include <optional>
#include <string_view>

namespace rules {

// plain: ratios, shares, UGR, Ra and other numbers without a unit.
enum class Dimension {
  plain,
  illuminance,
  luminance,
  intensity,
  power,
  power_density,
  energy_density,  // in a year
  length
};

// value in base units = value * factor; base units are lx, cd/m2, cd, W, W/m2,
// kWh/m2/a and m.
struct Unit {
  std::string_view name;
  Dimension dimension;
  double factor;
};

// Returns the unit of this name; "none" is the unit of plain numbers.
std::optional<Unit> unit_from_name(std::string_view name);
calc::Names unit_names();
// Returns the longest unit at the start of `text` that is not followed by a letter or digit: "lx)"
// is "lx". Never "none".
std::optional<Unit> unit_at_start(std::string_view text);

const char* base_unit(Dimension dimension);       // "lx", "" for plain
const char* dimension_name(Dimension dimension);  // "illuminance (lx)", "a plain number"

}  // namespace rules
