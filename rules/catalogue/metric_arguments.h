#pragma once
// Arguments that some metrics need beside the light. kMetrics lists them for each metric.

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

// point_m: world coordinates; empty: not given, and nothing is judged. facing: unit direction of
// the point; empty: that of the plane's point.
struct PointOfValue {
  std::optional<glm::dvec3> point_m, facing;
};

// A range in lx, or in the unit of the points' values, 0 or more; both ends belong to it.
struct ValueRange {
  double from = 0.0;
  double to = std::numeric_limits<double>::infinity();
  bool operator==(const ValueRange&) const = default;
};

// Heights of the counted luminaires above the floor, 0 or more; the upper end does not belong to
// it.
struct HeightRange {
  double from_m = 0.0;
  double to_m = std::numeric_limits<double>::infinity();
  bool operator==(const HeightRange&) const = default;
};

// Power installed in the plane's space, 0 or more.
struct SpacePower {
  double density_w_m2 = 0.0;
};

// The field on which glare is rated.
struct LitField {
  double reflectance = 0.0;        // (0, 1]; 0: not stated
  calc::Estimate veiling_cd_m2{};  // of the luminaires, 0 or more; known once it is bound
};

using MetricArguments = std::variant<std::monostate, Percentile, PointOfValue, ValueRange,
                                     HeightRange, SpacePower, LitField>;

}  // namespace rules
