#include "calc/scene/box_shelf.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace calc::box_shelf_test {
namespace {

bool overlap(const BoundingBox& a, const BoundingBox& b, double tolerance_m) {
  for (int i = 0; i < 3; ++i) {
    if (a.lower[i] > b.upper[i] + tolerance_m || b.lower[i] > a.upper[i] + tolerance_m)
      return false;
  }
  return true;
}

// A wall as long as everything, one empty box, and small ones of different sizes.
std::vector<BoundingBox> boxes() {
  std::vector<BoundingBox> list{{{0, 0, 0}, {40, 0.1, 3}}, {}};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 low((i * 37) % 40, (i * 11) % 7, (i * 5) % 3);
    list.push_back({low, low + glm::dvec3(0.25 * (i % 5), 0.5, 0.5)});
  }
  return list;
}

TEST(BoxShelf, FindsWhatLookingAtAllFinds) {
  const std::vector<BoundingBox> all = boxes();
  BoxShelf shelf(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 3 != 2) shelf.add(i);
  }
  shelf.sort();
  std::size_t found = 0;
  for (const BoundingBox& box : all) {
    for (const double tolerance_m : {0.0, 0.5}) {
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % 3 != 2 && !all[i].is_empty() && !box.is_empty() &&
            overlap(box, all[i], tolerance_m)) {
          expected.push_back(i);
        }
      }
      EXPECT_EQ(shelf.near(box, tolerance_m), expected);
      found += expected.size();
    }
  }
  EXPECT_GT(found, 500u);  // the searches are not all empty
}

TEST(BoxShelf, OfNothingIsNothing) {
  const std::vector<BoundingBox> none;
  BoxShelf shelf(none);
  shelf.sort();
  EXPECT_TRUE(shelf.near({{0, 0, 0}, {1, 1, 1}}, 0.0).empty());
}

}  // namespace
}  // namespace calc::box_shelf_test
