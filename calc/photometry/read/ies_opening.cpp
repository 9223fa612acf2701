#include "calc/photometry/read/ies_opening.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

// Sizes along C0, C90 and the vertical, without signs.
struct Sizes {
  double length_m, width_m, height_m;
};

Lm63Opening shaped(OpeningShape shape, const Sizes& sizes) {
  return {{shape, sizes.length_m, sizes.width_m, sizes.height_m}, ""};
}

// h >= 0: flat shapes and upright bodies on them.
Lm63Opening upright(double width_m, double length_m, const Sizes& sizes) {
  const bool is_round = width_m < 0.0 || length_m < 0.0;
  Sizes base = sizes;
  if (is_round && (sizes.width_m == 0.0 || sizes.length_m == 0.0)) {  // one diameter
    base.width_m = base.length_m = sizes.width_m + sizes.length_m;
  }
  const bool is_thin = is_flat_enough(base.length_m, base.width_m, base.height_m);
  if (is_round) return shaped(is_thin ? OpeningShape::disk : OpeningShape::cylinder, base);
  if (base.width_m == 0.0 && base.length_m == 0.0 && base.height_m == 0.0) {
    return shaped(OpeningShape::point, base);
  }
  if (base.width_m == 0.0 && base.length_m == 0.0) {  // an upright line
    const double thin_m = 0.01 * base.height_m;
    return shaped(OpeningShape::cylinder, {thin_m, thin_m, base.height_m});
  }
  return shaped(is_thin ? OpeningShape::rectangle : OpeningShape::box, base);
}

// h < 0: round bodies.
Lm63Opening round_body(double width_m, double length_m, const Sizes& sizes, Lm63Version version) {
  const bool before_2002 = version <= Lm63Version::v1995;
  if ((width_m < 0.0 && length_m < 0.0) || (before_2002 && width_m * length_m < 0.0)) {
    return shaped(OpeningShape::ellipsoid, sizes);
  }
  if (before_2002 && width_m < 0.0) {
    return shaped(OpeningShape::ellipsoid, {sizes.width_m, sizes.width_m, sizes.height_m});
  }
  if (width_m <= 0.0 && length_m > 0.0) {
    const double across_m = sizes.width_m > 0.0 ? sizes.width_m : sizes.height_m;
    return shaped(OpeningShape::cylinder_c0, {sizes.length_m, across_m, sizes.height_m});
  }
  if (width_m > 0.0 && length_m <= 0.0) {
    const double across_m = sizes.length_m > 0.0 ? sizes.length_m : sizes.height_m;
    return shaped(OpeningShape::cylinder_c90, {across_m, sizes.width_m, sizes.height_m});
  }
  if (width_m < 0.0) {  // a vertical circle facing C0
    return shaped(OpeningShape::cylinder_c0, {0.0, sizes.width_m, sizes.height_m});
  }
  return {{OpeningShape::box, sizes.length_m, sizes.width_m, sizes.height_m},
          "no shape of the code tables"};
}

}  // namespace

bool is_flat_enough(double length_m, double width_m, double height_m) {
  constexpr double kThinShare = 0.1;
  return height_m <= kThinShare * std::max(length_m, width_m);
}

Lm63Opening decode_opening(double width_m, double length_m, double height_m, Lm63Version version) {
  const Sizes sizes{std::abs(length_m), std::abs(width_m), std::abs(height_m)};
  return height_m < 0.0 ? round_body(width_m, length_m, sizes, version)
                        : upright(width_m, length_m, sizes);
}

}  // namespace calc
