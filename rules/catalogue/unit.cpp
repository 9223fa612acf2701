#include "rules/catalogue/unit.h"

#include "calc/base/units.h"

#include <array>

namespace rules {
namespace {

// 1 fc = 1 lm/ft2, and so is W/ft2 in W/m2: both are the square feet of a square metre.
constexpr double kPerSquareFoot = calc::kLuxPerFootcandle;

constexpr std::array kUnits{
    Unit{"none", Dimension::plain, 1.0},
    Unit{"lx", Dimension::illuminance, 1.0},
    Unit{"fc", Dimension::illuminance, calc::kLuxPerFootcandle},
    Unit{"cd/m2", Dimension::luminance, 1.0},
    Unit{"cd", Dimension::intensity, 1.0},
    Unit{"W", Dimension::power, 1.0},
    Unit{"W/m2", Dimension::power_density, 1.0},
    Unit{"W/ft2", Dimension::power_density, kPerSquareFoot},
    Unit{"kWh/m2/a", Dimension::energy_density, 1.0},
    Unit{"m", Dimension::length, 1.0},
    Unit{"ft", Dimension::length, calc::kMetresPerFoot},
};

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

std::optional<Unit> unit_from_name(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return unit;
  }
  return std::nullopt;
}

calc::Names unit_names() {
  calc::Names names;
  for (const Unit& unit : kUnits) names.push_back(unit.name);
  return names;
}

std::optional<Unit> unit_at_start(std::string_view text) {
  std::optional<Unit> longest;
  for (const Unit& unit : kUnits) {
    if (unit.dimension == Dimension::plain || !text.starts_with(unit.name)) continue;
    const bool ends_here =
        text.size() == unit.name.size() || !is_letter_or_digit(text[unit.name.size()]);
    if (ends_here && (!longest || unit.name.size() > longest->name.size())) longest = unit;
  }
  return longest;
}

const char* base_unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::plain:
      return "";
    case Dimension::illuminance:
      return "lx";
    case Dimension::luminance:
      return "cd/m2";
    case Dimension::intensity:
      return "cd";
    case Dimension::power:
      return "W";
    case Dimension::power_density:
      return "W/m2";
    case Dimension::energy_density:
      return "kWh/m2/a";
    case Dimension::length:
      return "m";
  }
  return "";
}

const char* dimension_name(Dimension dimension) {
  switch (dimension) {
    case Dimension::plain:
      return "a plain number";
    case Dimension::illuminance:
      return "an illuminance (lx, fc)";
    case Dimension::luminance:
      return "a luminance (cd/m2)";
    case Dimension::intensity:
      return "a luminous intensity (cd)";
    case Dimension::power:
      return "a power (W)";
    case Dimension::power_density:
      return "a power density (W/m2, W/ft2)";
    case Dimension::energy_density:
      return "the energy of a year by area (kWh/m2/a)";
    case Dimension::length:
      return "a length (m, ft)";
  }
  return "";
}

}  // namespace rules
