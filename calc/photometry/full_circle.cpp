#include "calc/photometry/full_circle.h"

#include <algorithm>
#include <cmath>

namespace calc {
namespace {

constexpr double kSameAngle_deg = 1.0e-6;

bool same_angle(double a_deg, double b_deg) { return std::abs(a_deg - b_deg) <= kSameAngle_deg; }

// All images of the stored planes with C in [0, 360), ascending, one per angle.
std::vector<CirclePlane> images(const std::vector<double>& stored_c_deg, PlaneSymmetry symmetry) {
  std::vector<CirclePlane> planes;
  const auto add = [&](double c_deg, std::size_t i) {
    double wrapped = c_deg < 0.0 ? c_deg + 360.0 : c_deg;
    if (wrapped >= 360.0 - kSameAngle_deg) wrapped = 0.0;
    planes.push_back({wrapped, i, i, 0.0});
  };
  for (std::size_t i = 0; i < stored_c_deg.size(); ++i) {
    const double c = stored_c_deg[i];
    add(c, i);
    if (symmetry == PlaneSymmetry::c0_c180 || symmetry == PlaneSymmetry::quadrant)
      add(360.0 - c, i);
    if (symmetry == PlaneSymmetry::c90_c270 || symmetry == PlaneSymmetry::quadrant)
      add(180.0 - c, i);
    if (symmetry == PlaneSymmetry::quadrant) add(180.0 + c, i);
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const CirclePlane& a, const CirclePlane& b) { return a.c_deg < b.c_deg; });
  std::vector<CirclePlane> unique;
  for (const CirclePlane& plane : planes) {
    if (unique.empty() || !same_angle(unique.back().c_deg, plane.c_deg)) {
      unique.push_back(plane);
    } else if (symmetry == PlaneSymmetry::none) {  // planes 0 and 360
      unique.back().second = plane.first;
      unique.back().weight = 0.5;
    }
  }
  return unique;
}

// Whether the interval from the last image to C 360 is one the file could mean: bounded by a stored
// plane at 360, made by symmetry, or no wider than the steps that are stored.
bool closes(const std::vector<double>& stored_c_deg, PlaneSymmetry symmetry, double gap_deg) {
  if (symmetry != PlaneSymmetry::none) return true;
  if (same_angle(*std::max_element(stored_c_deg.begin(), stored_c_deg.end()), 360.0)) return true;
  double widest = 0.0;
  for (std::size_t i = 1; i < stored_c_deg.size(); ++i) {
    widest = std::max(widest, stored_c_deg[i] - stored_c_deg[i - 1]);
  }
  return gap_deg <= std::min(widest, 90.0) + kSameAngle_deg;
}

}  // namespace

std::vector<CirclePlane> full_circle(const std::vector<double>& stored_c_deg,
                                     PlaneSymmetry symmetry) {
  if (stored_c_deg.empty()) return {};
  if (symmetry == PlaneSymmetry::axial || stored_c_deg.size() == 1) return {{0.0, 0, 0, 0.0}};
  std::vector<CirclePlane> planes = images(stored_c_deg, symmetry);
  const double closing_gap_deg = planes.front().c_deg + 360.0 - planes.back().c_deg;
  if (!closes(stored_c_deg, symmetry, closing_gap_deg)) return {};
  if (planes.front().c_deg > kSameAngle_deg) {
    const double weight = (360.0 - planes.back().c_deg) / closing_gap_deg;
    planes.insert(planes.begin(), {0.0, planes.back().first, planes.front().first, weight});
  }
  planes.front().c_deg = 0.0;
  planes.push_back(planes.front());
  planes.back().c_deg = 360.0;
  return planes;
}

PlaneSymmetry symmetry_of_range(const std::vector<double>& c_deg) {
  if (c_deg.size() == 1) return PlaneSymmetry::axial;
  const double first = c_deg.front();
  const double last = c_deg.back();
  if (same_angle(first, 0.0) && same_angle(last, 90.0)) return PlaneSymmetry::quadrant;
  if (same_angle(first, 0.0) && same_angle(last, 180.0)) return PlaneSymmetry::c0_c180;
  if (same_angle(first, 90.0) && same_angle(last, 270.0)) return PlaneSymmetry::c90_c270;
  return PlaneSymmetry::none;
}

}  // namespace calc
