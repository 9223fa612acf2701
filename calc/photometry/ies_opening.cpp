#include "calc/photometry/ies_opening.h"

#include <cmath>

namespace calc {
namespace {

// h >= 0: flat shapes and upright bodies on them.
Lm63Opening upright(double width_m, double length_m, double height_m) {
  const double width = std::abs(width_m);
  const double length = std::abs(length_m);
  if (width_m >= 0.0 && length_m >= 0.0) {
    const bool none = width == 0.0 && length == 0.0;
    return {{none ? OpeningShape::point : OpeningShape::rectangle, length, width, height_m}, ""};
  }
  if (width == 0.0 || length == 0.0) {  // one diameter
    const double diameter = width + length;
    return {{OpeningShape::disk, diameter, diameter, height_m}, ""};
  }
  return {{OpeningShape::disk, length, width, height_m}, ""};  // equal: circle, else ellipse
}

// h < 0: round bodies.
Lm63Opening round_body(double width_m, double length_m, double height_m, Lm63Version version) {
  const double width = std::abs(width_m);
  const double length = std::abs(length_m);
  const double height = std::abs(height_m);
  const bool before_2002 = version <= Lm63Version::v1995;
  if ((width_m < 0.0 && length_m < 0.0) || (before_2002 && width_m * length_m < 0.0)) {
    return {{OpeningShape::disk, length, width, height}, "a sphere or ellipsoid"};
  }
  if (before_2002 && width_m < 0.0) return {{OpeningShape::disk, width, width, height}, "a sphere"};
  if (width_m <= 0.0 && length_m > 0.0) {
    return {{OpeningShape::rectangle, length, width > 0.0 ? width : height, height},
            "a horizontal cylinder along C0"};
  }
  if (width_m > 0.0 && length_m <= 0.0) {
    return {{OpeningShape::rectangle, length > 0.0 ? length : height, width, height},
            "a horizontal cylinder along C90"};
  }
  if (width_m < 0.0)
    return {{OpeningShape::rectangle, 0.0, width, height}, "a vertical circle facing C0"};
  const bool none = width == 0.0 && length == 0.0;
  return {{none ? OpeningShape::point : OpeningShape::rectangle, length, width, height},
          "no shape of the code tables"};
}

}  // namespace

Lm63Opening decode_opening(double width_m, double length_m, double height_m, Lm63Version version) {
  return height_m < 0.0 ? round_body(width_m, length_m, height_m, version)
                        : upright(width_m, length_m, height_m);
}

}  // namespace calc
