#pragma once
// Boxes by where they begin along one axis, so that of many only those nearby are looked at.

#include "calc/scene/solids.h"

#include <cstddef>
#include <vector>

namespace calc {

class BoxShelf {
 public:
  // All boxes that may be added; they must outlive it.
  explicit BoxShelf(const std::vector<BoundingBox>& box);
  BoxShelf(const BoxShelf&) = delete;
  BoxShelf& operator=(const BoxShelf&) = delete;

  void add(std::size_t index) { all_.push_back(index); }
  void sort();  // once, after all were added
  // Those that have a place in common with `box`, or as near as that: ascending. Empty boxes: none.
  std::vector<std::size_t> near(const BoundingBox& box, double tolerance_m) const;
  const std::vector<std::size_t>& all() const { return all_; }  // ascending if added so

 private:
  const std::vector<BoundingBox>& box_;
  glm::length_t axis_ = 0;  // the longest of all boxes together
  double length_m_ = 0.0;   // along it
  std::vector<std::size_t> all_;
  // Those that are long themselves would make every search long: they are looked at one by one.
  std::vector<std::size_t> sorted_, long_;
  double widest_m_ = 0.0;  // of the sorted ones
};

}  // namespace calc
