#pragma once
// What some metrics need beside the light. kMetrics says which metric has which of them.

#include "calc/base/field.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>
#include <variant>

namespace rules {

struct Percentile {
  double percent = 0.0;  // [0, 100], see compute_metric()
  bool operator==(const Percentile&) const = default;
};

// point_m: world coordinates; empty: nobody has said where, and nothing is judged. facing: the way
// that the point looks, unit; empty: as it does.
struct PointOfValue {
  std::optional<glm::dvec3> point_m, facing;
};

// lx, or plain as the points' values are, 0 or more; both ends belong to it.
struct ValueRange {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  bool operator==(const ValueRange&) const = default;
};

// Above the floor, of the luminaires that count, 0 or more; the upper end does not belong to it.
struct HeightRange {
  double from_m = 0.0;
  double to_m = std::numeric_limits<double>::infinity();
  bool operator==(const HeightRange&) const = default;
};

// Installed in the plane's space, 0 or more.
struct SpacePower {
  double density_w_m2 = 0.0;
};

// That glare is rated on.
struct LitField {
  double reflectance = 0.0;        // (0, 1]; 0: not stated
  calc::Estimate veiling_cd_m2{};  // of the luminaires, 0 or more; known once it is bound
};

using MetricArguments = std::variant<std::monostate, Percentile, PointOfValue, ValueRange,
                                     HeightRange, SpacePower, LitField>;

}  // namespace rules
