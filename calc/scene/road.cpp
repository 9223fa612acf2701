#include "calc/scene/road.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

// A length that is a multiple but for how it was written down needs no further point.
int points_for(double length_m, double most_m, int least) {
  constexpr double kNoise = 1.0e-9;
  return std::max(least, static_cast<int>(std::ceil(length_m / most_m - kNoise)));
}

}  // namespace

int road_points_along(double spacing_m) {
  constexpr double kMost_m = 3.0;
  constexpr int kLeast = 10;
  return points_for(spacing_m, kMost_m, kLeast);
}

int road_points_across(double width_m) {
  constexpr double kMost_m = 1.5;
  constexpr int kLeast = 3;
  return points_for(width_m, kMost_m, kLeast);
}

}  // namespace calc
