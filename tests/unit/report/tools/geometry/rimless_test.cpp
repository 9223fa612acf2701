// Surfaces with and without a rim, where edges lie on each other only in part.

#include "report/tools/geometry/rimless.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cli::rimless_test {
namespace {

void add_quad(calc::SurfaceModel& model, const glm::dvec3& a, const glm::dvec3& u,
              const glm::dvec3& v) {
  const auto first = static_cast<std::uint32_t>(model.vertex_m.size());
  for (const glm::dvec3& p : {a, a + u, a + u + v, a + v}) model.vertex_m.push_back(p);
  model.triangle.emplace_back(first, first + 1, first + 2);
  model.triangle.emplace_back(first, first + 2, first + 3);
}

// A box of 4 x 3 x 2.5 m; its wall y = 0 comes from the caller.
calc::SurfaceModel box_without_a_wall() {
  calc::SurfaceModel model;
  add_quad(model, {0, 0, 0}, {4, 0, 0}, {0, 3, 0});
  add_quad(model, {0, 0, 2.5}, {4, 0, 0}, {0, 3, 0});
  add_quad(model, {0, 3, 0}, {4, 0, 0}, {0, 0, 2.5});
  add_quad(model, {0, 0, 0}, {0, 3, 0}, {0, 0, 2.5});
  add_quad(model, {4, 0, 0}, {0, 3, 0}, {0, 0, 2.5});
  return model;
}

// Four strips around a window, which fills the hole or not.
calc::SurfaceModel box_with_window(bool is_filled, double gap_m = 0.0) {
  calc::SurfaceModel model = box_without_a_wall();
  add_quad(model, {0, 0, 0}, {4, 0, 0}, {0, 0, 0.9});
  add_quad(model, {0, 0, 2.1}, {4, 0, 0}, {0, 0, 2.5 - 2.1});
  add_quad(model, {0, 0, 0.9}, {1.1 - gap_m, 0, 0}, {0, 0, 2.1 - 0.9});
  add_quad(model, {2.7, 0, 0.9}, {4 - 2.7, 0, 0}, {0, 0, 2.1 - 0.9});
  if (is_filled) add_quad(model, {1.1, 0, 0.9}, {2.7 - 1.1, 0, 0}, {0, 0, 2.1 - 0.9});
  return model;
}

TEST(Rimless, ABoxIs) {
  calc::SurfaceModel model = box_without_a_wall();
  EXPECT_FALSE(is_rimless(model));
  add_quad(model, {0, 0, 0}, {4, 0, 0}, {0, 0, 2.5});
  EXPECT_TRUE(is_rimless(model));
}

TEST(Rimless, AWindowMustFillItsHole) {
  EXPECT_TRUE(is_rimless(box_with_window(true)));
  EXPECT_FALSE(is_rimless(box_with_window(false)));
  EXPECT_TRUE(is_rimless(box_with_window(true, 1e-6)));
  EXPECT_FALSE(is_rimless(box_with_window(true, 1e-3)));
}

// Two sheets on one another cancel out edge by edge; a fin standing in the room does not.
TEST(Rimless, AFinHasARim) {
  calc::SurfaceModel model = box_with_window(true);
  add_quad(model, {1, 1, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_FALSE(is_rimless(model));
  add_quad(model, {1, 1, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_TRUE(is_rimless(model));
}

TEST(Rimless, WhatIsNotKnownIsNotRimless) {
  EXPECT_FALSE(is_rimless({}));
  calc::SurfaceModel model = box_with_window(true);
  model.vertex_m[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_rimless(model));
}

}  // namespace
}  // namespace cli::rimless_test
