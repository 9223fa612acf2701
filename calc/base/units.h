#pragma once
// The only place with unit conversions. Inside the program: metres, radians, lux, candela, lumens;
// degrees appear in file readers and writers only (calc/CONVENTIONS.md).

#include <array>
#include <numbers>
#include <string_view>

namespace calc {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kMetresPerFoot = 0.3048;        // international foot, exact
inline constexpr double kMetresPerInch = 0.0254;        // international inch, exact
inline constexpr double kMetresPerMillimetre = 1.0e-3;  // exact
inline constexpr double kMetresPerCentimetre = 1.0e-2;  // exact

struct LengthUnit {
  std::string_view name;
  double metres;
};
// Names of length units in projects and in columns of tables.
inline constexpr std::array kLengthUnits{
    LengthUnit{"m", 1.0}, LengthUnit{"cm", kMetresPerCentimetre},
    LengthUnit{"mm", kMetresPerMillimetre}, LengthUnit{"in", kMetresPerInch},
    LengthUnit{"ft", kMetresPerFoot}};

inline constexpr double kLuxPerFootcandle = 1.0 / (kMetresPerFoot * kMetresPerFoot);  // lm/ft2
static_assert(kLuxPerFootcandle > 10.76391041670972 && kLuxPerFootcandle < 10.76391041670973);

constexpr double radians_from_degrees(double deg) { return deg * kRadiansPerDegree; }
constexpr double degrees_from_radians(double rad) { return rad / kRadiansPerDegree; }

}  // namespace calc
