#pragma once
// Boxes sorted by their start along one axis, so that searches look at nearby boxes only.

#include "calc/scene/solids.h"

#include <cstddef>
#include <vector>

namespace calc {

class BoxShelf {
 public:
  // box: all boxes that may be added; they must outlive it.
  explicit BoxShelf(const std::vector<BoundingBox>& box);
  BoxShelf(const BoxShelf&) = delete;
  BoxShelf& operator=(const BoxShelf&) = delete;

  void add(std::size_t index) { all_.push_back(index); }
  void sort();  // once, after all were added
  // Returns the boxes that meet `box` within the tolerance: ascending; never empty boxes.
  std::vector<std::size_t> near(const BoundingBox& box, double tolerance_m) const;
  const std::vector<std::size_t>& all() const { return all_; }  // ascending if added so

 private:
  const std::vector<BoundingBox>& box_;
  glm::length_t axis_ = 0;  // the longest of all boxes together
  double length_m_ = 0.0;   // along it
  std::vector<std::size_t> all_;
  // Long boxes are tested one by one, because they would make every search long.
  std::vector<std::size_t> sorted_, long_;
  double widest_m_ = 0.0;  // of the sorted ones
};

}  // namespace calc
