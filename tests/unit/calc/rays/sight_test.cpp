// Proofs of free and of hidden sight against many rays.
#include "calc/rays/sight.h"
#include "calc/radiosity/sampling/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace sight_test {
namespace {

using calc::RandomKey;
using calc::Sight;

constexpr double kMargin_m = 2e-6, kClear_m = 1e-5;

struct Model {
  std::vector<glm::vec3> vertex_m;
  std::vector<glm::uvec3> corners;

  void add_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(vertex_m.size());
    for (const glm::vec3& p : {a, b, c}) vertex_m.push_back(p);
    corners.emplace_back(first, first + 1, first + 2);
  }
  void add_quad(const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v) {
    add_triangle(origin, origin + u, origin + u + v);
    add_triangle(origin, origin + u + v, origin + v);
  }
  calc::TriangleTree tree() const { return {vertex_m, corners}; }
};

class Draw {
 public:
  explicit Draw(RandomKey key) : key_(key) {}
  double in(double low, double high) { return low + (high - low) * key_.with(n_++).uniform(); }
  glm::dvec3 place(double reach_m) {
    const double x = in(-reach_m, reach_m), y = in(-reach_m, reach_m);
    return {x, y, in(-reach_m, reach_m)};
  }

 private:
  RandomKey key_;
  std::uint64_t n_ = 0;
};

calc::SightQuery random_query(Draw& draw) {
  calc::SightQuery query{draw.place(1.0), {}, kMargin_m, kClear_m};
  const glm::dvec3 origin = draw.place(1.0);
  const double size_m = draw.in(0.01, 1.5);
  const glm::dvec3 u = size_m * draw.place(0.5), v = size_m * draw.place(0.5);
  query.corner_m = {origin, origin + u, origin + u + v, origin + v};
  return query;
}

// On the way from the point to the middle of the parallelogram.
glm::dvec3 place_between(const calc::SightQuery& query, double share) {
  return glm::mix(query.from_m, 0.5 * (query.corner_m[0] + query.corner_m[2]), share);
}

glm::dvec3 place_on(const calc::SightQuery& query, double s, double t) {
  const auto& c = query.corner_m;
  return c[0] + s * (c[1] - c[0]) + t * (c[3] - c[0]);
}

// Of rays to many places, ends moved by up to the margin: how many are blocked.
struct Truth {
  int blocked = 0, all = 0;
};

Truth truth_of(const calc::TriangleTree& tree, const calc::SightQuery& query, Draw& draw) {
  Truth truth;
  for (int i = 0; i < 25; ++i) {
    std::vector<calc::Ray> rays(16);
    for (calc::Ray& ray : rays) {
      // Corners and sides are where proofs go wrong.
      const auto edge = [&] { return std::clamp(draw.in(-0.3, 1.3), 0.0, 1.0); };
      const double s = edge(), t = edge();
      ray.origin = glm::vec3(query.from_m);
      ray.direction = glm::vec3(place_on(query, s, t) + draw.place(0.2 * kMargin_m)) - ray.origin;
      ray.most = 1.0f;
    }
    std::uint32_t mask = tree.blocked(rays);
    for (; mask != 0; mask &= mask - 1) ++truth.blocked;
    truth.all += 16;
  }
  return truth;
}

struct Count {
  int free = 0, free_proved = 0, hidden = 0, hidden_proved = 0;
};

void check(const Model& model, const calc::SightQuery& query, Draw& draw, Count& count) {
  const calc::TriangleTree tree = model.tree();
  const Sight sight = calc::sight_of(tree, query);
  const Truth truth = truth_of(tree, query, draw);
  if (sight == Sight::free) {
    EXPECT_EQ(truth.blocked, 0);
  }
  if (sight == Sight::hidden) {
    EXPECT_EQ(truth.blocked, truth.all);
  }
  count.free += truth.blocked == 0 ? 1 : 0;
  count.hidden += truth.blocked == truth.all ? 1 : 0;
  count.free_proved += sight == Sight::free ? 1 : 0;
  count.hidden_proved += sight == Sight::hidden ? 1 : 0;
}

TEST(Sight, OfSmallTrianglesIsProvedAndNeverWrong) {
  Count count;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Draw draw(RandomKey(1).with(seed));
    Model model;
    const int triangles = 1 + static_cast<int>(seed % 12);
    for (int k = 0; k < triangles; ++k) {
      const glm::dvec3 a = draw.place(1.0);
      const double size_m = draw.in(0.02, 0.6);
      model.add_triangle(glm::vec3(a), glm::vec3(a + size_m * draw.place(1.0)),
                         glm::vec3(a + size_m * draw.place(1.0)));
    }
    check(model, random_query(draw), draw, count);
  }
  EXPECT_GT(count.free, 1000);
  // Rays miss a few corners that stand in the way.
  EXPECT_GT(count.free_proved, 0.97 * count.free);
  EXPECT_LE(count.free_proved, count.free);
}

TEST(Sight, BehindAWallOfTwoTrianglesIsNone) {
  Count count;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Draw draw(RandomKey(2).with(seed));
    const calc::SightQuery query = random_query(draw);
    const double size_m = draw.in(0.1, 6.0);
    const glm::dvec3 at = place_between(query, draw.in(0.2, 0.8));
    const glm::dvec3 u = size_m * draw.place(1.0), v = size_m * draw.place(1.0);
    Model model;
    model.add_quad(glm::vec3(at - 0.5 * (u + v)), glm::vec3(u), glm::vec3(v));
    check(model, query, draw, count);
  }
  EXPECT_GT(count.hidden, 500);
  EXPECT_GT(count.hidden_proved, 0.9 * count.hidden);
}

// Two triangles with one edge that are folded towards the point, or look like an arrowhead: what
// lies between their outer corners is not hidden.
TEST(Sight, PastAnArrowheadIsNotHidden) {
  Count count;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Draw draw(RandomKey(3).with(seed));
    const calc::SightQuery query = random_query(draw);
    const glm::dvec3 at = place_between(query, 0.5);
    const auto corner = [&] { return glm::vec3(at + draw.place(1.5)); };
    const glm::vec3 a = corner(), b = corner();
    Model model;
    model.add_triangle(a, b, corner());
    model.add_triangle(b, a, corner());
    check(model, query, draw, count);
  }
  EXPECT_GT(count.hidden, 30);
}

TEST(Sight, EndsInSurfacesAreNotInTheWay) {
  Model model;  // a floor under the point, a ceiling over the opening
  model.add_quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0});
  model.add_quad({-3, -3, 3}, {6, 0, 0}, {0, 6, 0});
  const double off_m = 1e-5;
  calc::SightQuery query{{1, 1, off_m}, {}, kMargin_m, kClear_m};
  const double z = 3.0 - off_m;
  query.corner_m = {glm::dvec3(-1, -1, z), {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  EXPECT_EQ(calc::sight_of(model.tree(), query), Sight::free);
  query.from_m.z = 3.5;  // above the ceiling
  EXPECT_EQ(calc::sight_of(model.tree(), query), Sight::hidden);
  query.from_m = {1, 1, z};  // in the opening's plane, on its corner
  EXPECT_NE(calc::sight_of(model.tree(), query), Sight::hidden);
  query.from_m = {2, 0, 1};
  model.add_quad({0.8f, -0.2f, 2.0f}, {0.4f, 0, 0}, {0, 0.4f, 0});  // a lamp's shade
  EXPECT_EQ(calc::sight_of(model.tree(), query), Sight::unknown);
}

// Two boxes apart from each other, overlapping or flat, among small triangles.
TEST(SightBetweenBoxes, IsNeverClaimedWhereSomethingStands) {
  int proved = 0, free = 0;
  const auto random_box = [](Draw& draw, bool is_flat) {
    const glm::dvec3 low = draw.place(1.5);
    glm::dvec3 size(draw.in(0.0, 0.8), draw.in(0.0, 0.8), draw.in(0.0, 0.8));
    if (is_flat) size.z = 0.0;
    return calc::SightBox{low, low + size};
  };
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Draw draw(RandomKey(4).with(seed));
    const calc::SightBox one = random_box(draw, false), other = random_box(draw, seed % 2 == 0);
    Model model;
    for (std::uint64_t k = 0; k <= seed % 10; ++k) {
      const glm::dvec3 a = draw.place(1.5);
      const double size_m = draw.in(0.02, 0.8);
      model.add_triangle(glm::vec3(a), glm::vec3(a + size_m * draw.place(1.0)),
                         glm::vec3(a + size_m * draw.place(1.0)));
    }
    const calc::TriangleTree tree = model.tree();
    const auto place_in = [&draw](const calc::SightBox& box) {
      glm::dvec3 p;
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double share = std::clamp(draw.in(-0.3, 1.3), 0.0, 1.0);
        p[axis] = box.low_m[axis] + share * (box.high_m[axis] - box.low_m[axis]);
      }
      return glm::vec3(p + draw.place(0.2 * kMargin_m));
    };
    int blocked = 0;
    for (int i = 0; i < 25; ++i) {
      std::vector<calc::Ray> rays(16);
      for (calc::Ray& ray : rays) {
        ray.origin = place_in(one);
        ray.direction = place_in(other) - ray.origin;
        ray.most = 1.0f;
      }
      blocked += tree.blocked(rays) != 0 ? 1 : 0;
    }
    const bool is_free = calc::is_free_between(tree, one, other, kMargin_m);
    if (is_free) {
      EXPECT_EQ(blocked, 0) << seed;
      ++proved;
    }
    free += blocked == 0 ? 1 : 0;
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(proved, 0.8 * free);  // triangles are not told from their boxes past the planes
}

TEST(SightBetweenBoxes, OfAHallIsFreeBesideItsPillar) {
  Model model;
  model.add_quad({0, 0, 0}, {20, 0, 0}, {0, 20, 0});
  model.add_quad({0, 0, 6}, {20, 0, 0}, {0, 20, 0});
  model.add_quad({9, 10, 0}, {2, 0, 0}, {0, 0, 6});
  const calc::TriangleTree tree = model.tree();
  const calc::SightBox floor{{9, 2, 1e-5}, {10, 3, 1e-5}};
  const auto lamp = [](double x, double y) {
    return calc::SightBox{{x, y, 6 - 1e-5}, {x + 1.2, y + 0.3, 6 - 1e-5}};
  };
  EXPECT_TRUE(calc::is_free_between(tree, floor, lamp(9, 5), kMargin_m));
  EXPECT_TRUE(calc::is_free_between(tree, floor, lamp(1, 15), kMargin_m));
  EXPECT_TRUE(calc::is_free_between(tree, floor, lamp(16, 15), kMargin_m));
  EXPECT_FALSE(calc::is_free_between(tree, floor, lamp(9, 15), kMargin_m));
  EXPECT_FALSE(calc::is_free_between(tree, floor, {{9, 5, 6}, {10, 6, 6}}, kMargin_m));
}

}  // namespace
}  // namespace sight_test
