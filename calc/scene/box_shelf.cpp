#include "calc/scene/box_shelf.h"

#include <algorithm>

namespace calc {
namespace {

constexpr double kLongShare = 1.0 / 16.0;  // of all boxes together

bool overlaps(const BoundingBox& a, const BoundingBox& b, double tolerance_m) {
  return glm::all(glm::lessThanEqual(a.lower, b.upper + tolerance_m)) &&
         glm::all(glm::lessThanEqual(b.lower, a.upper + tolerance_m));
}

}  // namespace

BoxShelf::BoxShelf(const std::vector<BoundingBox>& box) : box_(box) {
  BoundingBox all;
  for (const BoundingBox& one : box) {
    if (one.is_empty()) continue;
    all.add(one.lower);
    all.add(one.upper);
  }
  if (all.is_empty()) return;
  const glm::dvec3 size_m = all.upper - all.lower;
  for (const glm::length_t axis : {1, 2}) {
    if (size_m[axis] > size_m[axis_]) axis_ = axis;
  }
  length_m_ = size_m[axis_];
}

void BoxShelf::sort() {
  for (const std::size_t index : all_) {
    if (box_[index].is_empty()) continue;
    const double width_m = box_[index].upper[axis_] - box_[index].lower[axis_];
    if (width_m > kLongShare * length_m_) {
      long_.push_back(index);
      continue;
    }
    sorted_.push_back(index);
    widest_m_ = std::max(widest_m_, width_m);
  }
  std::stable_sort(sorted_.begin(), sorted_.end(), [&](std::size_t a, std::size_t b) {
    return box_[a].lower[axis_] < box_[b].lower[axis_];
  });
}

std::vector<std::size_t> BoxShelf::near(const BoundingBox& box, double tolerance_m) const {
  std::vector<std::size_t> found;
  if (box.is_empty()) return found;
  for (const std::size_t index : long_) {
    if (overlaps(box, box_[index], tolerance_m)) found.push_back(index);
  }
  auto it =
      std::lower_bound(sorted_.begin(), sorted_.end(), box.lower[axis_] - widest_m_ - tolerance_m,
                       [&](std::size_t index, double m) { return box_[index].lower[axis_] < m; });
  for (; it != sorted_.end() && box_[*it].lower[axis_] <= box.upper[axis_] + tolerance_m; ++it) {
    if (overlaps(box, box_[*it], tolerance_m)) found.push_back(*it);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace calc
