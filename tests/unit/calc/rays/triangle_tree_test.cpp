// The tree against every triangle tried one by one: the same answers, to the bit. ctest runs these
// under every instruction set that the processor has.

#include "calc/rays/triangle_tree.h"
#include "calc/base/triangle.h"
#include "calc/rays/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace triangle_tree_test {
namespace {

using calc::Ray;
using calc::TriangleHit;
using calc::TriangleTree;

struct Soup {
  std::string name;
  std::vector<glm::vec3> vertex_m;
  std::vector<glm::uvec3> triangle;

  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(vertex_m.size());
    vertex_m.insert(vertex_m.end(), {a, b, c});
    triangle.emplace_back(first, first + 1, first + 2);
  }
  void add_box(const glm::vec3& low, const glm::vec3& high) {
    const auto corner = [&](int k) {
      return glm::vec3((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                       (k & 4) != 0 ? high.z : low.z);
    };
    for (const std::array<int, 4>& face : {std::array{0, 1, 3, 2},
                                           {4, 5, 7, 6},
                                           {0, 1, 5, 4},
                                           {2, 3, 7, 6},
                                           {0, 2, 6, 4},
                                           {1, 3, 7, 5}}) {
      add(corner(face[0]), corner(face[1]), corner(face[2]));
      add(corner(face[0]), corner(face[2]), corner(face[3]));
    }
  }
  TriangleTree tree() const { return {vertex_m, triangle}; }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine_);
  }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  glm::vec3 point(float reach) {
    return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
  }

 private:
  std::mt19937 engine_;
};

Soup random_triangles(float reach, float size, int count) {
  Soup soup{"random triangles", {}, {}};
  Random random(1);
  for (int n = 0; n < count; ++n) {
    const glm::vec3 a = random.point(reach);
    soup.add(a, a + random.point(size), a + random.point(size));
  }
  return soup;
}

// A furnished room: faces along the axes, faces in one plane, faces that lie on each other,
// screens.
Soup room(float scale, const glm::vec3& shift) {
  Soup soup{"room", {}, {}};
  const auto at = [&](float x, float y, float z) { return scale * glm::vec3(x, y, z) + shift; };
  soup.add_box(at(-5, -4, 0), at(5, 4, 2.8f));
  for (int k = 0; k < 6; ++k) {
    const float x = -4.0f + 1.5f * static_cast<float>(k);
    soup.add_box(at(x, -1, 0), at(x + 0.8f, 1, 0.72f));
    soup.add_box(at(x, -1, 0.72f), at(x + 0.8f, 1, 0.75f));
    soup.add(at(x, 1, 0.3f), at(x + 0.8f, 1, 0.3f), at(x + 0.8f, 1, 1.4f));
  }
  return soup;
}

Soup needles() {
  Soup soup{"needles", {}, {}};
  Random random(2);
  for (int n = 0; n < 300; ++n) {
    const glm::vec3 a = random.point(5), along = random.point(4);
    soup.add(a, a + along, a + 0.5f * along + random.point(1e-4f));
  }
  return soup;
}

// Flat, but in no plane along axes: a sloped grid, and triangles all in z = x + y, with corners
// whose every bit counts. Rays between them run in the plane.
Soup sloped_grid() {
  Soup soup{"sloped grid", {}, {}};
  const auto at = [](int x, int y) {
    return glm::vec3(4.0f * static_cast<float>(x), 4.0f * static_cast<float>(y),
                     2.0f * static_cast<float>(x) + 3.0f * static_cast<float>(y));
  };
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      soup.add(at(x, y), at(x + 1, y), at(x, y + 1));
      soup.add(at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
    }
  }
  return soup;
}

Soup one_oblique_plane() {
  Soup soup{"one oblique plane", {}, {}};
  Random random(6);
  const auto point = [&] {
    const float unit = 0x1p-20f;
    const float x = unit * static_cast<float>(random.below(1u << 22));
    const float y = unit * static_cast<float>(random.below(1u << 22));
    return glm::vec3(x, y, x + y);
  };
  for (int n = 0; n < 60; ++n) soup.add(point(), point(), point());
  return soup;
}

// Corners nearly on one line through the origin, two of them very near to it.
Soup slivers() {
  Soup soup{"slivers", {}, {}};
  Random random(8);
  for (int n = 0; n < 60; ++n) {
    const glm::vec3 a = random.point(5);
    const auto near = [&] {
      const float share = std::exp2(-random.between(6, 24)) * random.between(-1, 1);
      return share * a;
    };
    const glm::vec3 b = near(), c = near();
    if (glm::length(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a))) > 0.0) soup.add(a, b, c);
  }
  return soup;
}

std::vector<Soup> soups() {
  Soup same{"forty times the same triangle", {}, {}};
  for (int n = 0; n < 40; ++n) same.add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  Soup one{"one triangle", {}, {}};
  one.add({-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 2, 0.5f});
  Soup far = room(1, {3000, -5000, 40}), tiny = room(1e-4f, {0, 0, 0}), site = room(200, {0, 0, 0});
  far.name = "room far from the origin", tiny.name = "room of a millimetre";
  site.name = "room of two kilometres";
  return {random_triangles(5, 2, 300),
          random_triangles(5, 0.05f, 300),
          room(1, {0, 0, 0}),
          far,
          tiny,
          site,
          needles(),
          same,
          one,
          sloped_grid(),
          one_oblique_plane(),
          slivers()};
}

// Rays between places of the soup, and where numbers are least certain: at corners and along
// edges, in the planes of triangles, along the axes, from far outside.
std::vector<Ray> rays_for(const Soup& soup, int count) {
  Random random(3);
  glm::vec3 low = soup.vertex_m.front(), high = low;
  for (const glm::vec3& v : soup.vertex_m) low = glm::min(low, v), high = glm::max(high, v);
  const float reach = glm::length(high - low);
  const glm::vec3 middle = 0.5f * (low + high);
  const auto vertex = [&] { return soup.vertex_m[random.below(soup.vertex_m.size())]; };
  const auto inside = [&] {
    const glm::uvec3 t = soup.triangle[random.below(soup.triangle.size())];
    const float u = random.between(0, 1), v = random.between(0, 1 - u);
    return soup.vertex_m[t.x] + u * (soup.vertex_m[t.y] - soup.vertex_m[t.x]) +
           v * (soup.vertex_m[t.z] - soup.vertex_m[t.x]);
  };
  std::vector<Ray> rays;
  for (int n = 0; n < count; ++n) {
    glm::vec3 from = middle + random.point(reach), to = inside();
    switch (n % 9) {
      case 0:  // from a surface to a surface
        from = inside();
        break;
      case 1:  // to a corner
        to = vertex();
        break;
      case 2:  // between two corners: along edges, in planes, through corners
        from = vertex(), to = vertex();
        break;
      case 3:  // along an axis
        to = from;
        to[static_cast<glm::length_t>(random.below(3))] += random.between(-reach, reach);
        break;
      case 4:  // from far outside
        from = middle + 1000.0f * random.point(reach);
        break;
      case 5: {  // in a plane along two axes, through a corner
        from = vertex();
        to = from + random.point(reach);
        const auto axis = static_cast<glm::length_t>(random.below(3));
        to[axis] = from[axis];
        break;
      }
      case 6:  // nearly along a surface
        from = inside();
        to = from + random.point(reach);
        to.z = from.z + random.between(-1e-5f, 1e-5f) * reach;
        break;
      case 7: {  // in the plane of a triangle, beyond its corners as well
        const glm::uvec3 t = soup.triangle[random.below(soup.triangle.size())];
        const glm::vec3 a = soup.vertex_m[t.x], u = soup.vertex_m[t.y] - a,
                        v = soup.vertex_m[t.z] - a;
        from = a + random.between(-2, 3) * u + random.between(-2, 3) * v;
        to = a + random.between(-2, 3) * u + random.between(-2, 3) * v;
        break;
      }
      default:
        break;
    }
    const glm::vec3 way = to - from;
    if (!(glm::length(way) > 0.0f)) continue;
    const float margin = 1e-6f * reach / glm::length(way);
    Ray ray{from, way, margin, 1.0f - margin};
    if (n % 3 == 0) ray = {from, glm::normalize(way), 0.0f, std::numeric_limits<float>::infinity()};
    if (ray.least < ray.most) rays.push_back(ray);
  }
  return rays;
}

bool first_by_trying_all(const TriangleTree& tree, const Ray& ray, TriangleHit& first) {
  first = {};
  for (std::size_t k = 0; k < tree.size(); ++k) {
    TriangleHit hit;
    hit.triangle = static_cast<std::uint32_t>(k);
    if (calc::meets(ray, tree.triangle(k), hit) && hit.is_before(first)) first = hit;
  }
  return first.t < std::numeric_limits<double>::infinity();
}

TEST(TriangleTree, AnswersAreThoseOfTryingEveryTriangle) {
  RecordProperty("instruction_set", std::string(calc::instruction_set()));
  for (const Soup& soup : soups()) {
    const TriangleTree tree = soup.tree();
    const std::vector<Ray> rays = rays_for(soup, 20000);
    std::size_t hits = 0;
    for (std::size_t begin = 0; begin < rays.size(); begin += TriangleTree::kRays) {
      const std::size_t count = std::min(TriangleTree::kRays, rays.size() - begin);
      const std::span<const Ray> some(rays.data() + begin, count);
      std::array<TriangleHit, TriangleTree::kRays> found;
      const std::uint32_t blocked = tree.blocked(some);
      const std::uint32_t met = tree.first_hits(some, found);
      for (std::size_t k = 0; k < count; ++k) {
        TriangleHit first;
        const bool is_met = first_by_trying_all(tree, some[k], first);
        ASSERT_EQ(((blocked >> k) & 1u) != 0, is_met) << soup.name << ", ray " << begin + k;
        ASSERT_EQ(((met >> k) & 1u) != 0, is_met) << soup.name << ", ray " << begin + k;
        if (!is_met) continue;
        ++hits;
        ASSERT_EQ(found[k].triangle, first.triangle) << soup.name << ", ray " << begin + k;
        ASSERT_EQ(found[k].t, first.t);
        ASSERT_EQ(found[k].u, first.u);
        ASSERT_EQ(found[k].v, first.v);
      }
    }
    EXPECT_GT(hits, 0u) << soup.name << ": rays that test nothing";
    EXPECT_LT(hits, rays.size()) << soup.name << ": rays that test nothing";
  }
}

TEST(TriangleTree, NothingIsInAnEmptyTree) {
  const TriangleTree tree(std::span<const glm::vec3>{}, std::span<const glm::uvec3>{});
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  TriangleHit hit;
  EXPECT_TRUE(tree.is_empty());
  EXPECT_EQ(tree.blocked({&ray, 1}), 0u);
  EXPECT_EQ(tree.first_hits({&ray, 1}, {&hit, 1}), 0u);
  tree.visit_near({0, 0, 0}, 10.0, [](std::uint32_t) {
    ADD_FAILURE();
    return 0.0;
  });
}

// A ball of many triangles, hit from its middle exactly at corners and along edges.
TEST(TriangleTree, NoRayLeavesAClosedBall) {
  Soup ball{"ball", {}, {}};
  constexpr int kSteps = 48;
  const auto point = [](int i, int j) {
    const double theta = 3.14159265358979 * i / kSteps, phi = 2 * 3.14159265358979 * j / kSteps;
    if (i == 0 || i == kSteps) return glm::vec3(0, 0, i == 0 ? 1 : -1);
    return glm::vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                     std::cos(theta));
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const int next = (j + 1) % kSteps;
      if (i > 0) ball.add(point(i, j), point(i, next), point(i + 1, next));
      if (i + 1 < kSteps) ball.add(point(i, j), point(i + 1, next), point(i + 1, j));
      if (i + 1 == kSteps) ball.add(point(i, j), point(i, next), point(kSteps, 0));
    }
  }
  const TriangleTree tree = ball.tree();
  Random random(5);
  int leaves = 0;
  for (int n = 0; n < 100000; ++n) {
    const glm::uvec3 t = ball.triangle[random.below(ball.triangle.size())];
    const glm::vec3 a = ball.vertex_m[t.x], b = ball.vertex_m[t.y];
    const glm::vec3 to = n % 2 == 0 ? a : a + random.between(0, 1) * (b - a);
    const glm::vec3 from = 0.01f * random.point(1);
    const Ray ray{from, to - from};
    TriangleHit hit;
    if (tree.first_hits({&ray, 1}, {&hit, 1}) == 0) ++leaves;
  }
  EXPECT_EQ(leaves, 0);
}

TEST(TriangleTree, TheNearestTriangleIsAmongThoseVisited) {
  for (const Soup& soup : soups()) {
    const TriangleTree tree = soup.tree();
    Random random(4);
    float reach = 0.0f;
    for (const glm::vec3& v : soup.vertex_m) reach = std::max(reach, glm::length(v));
    for (int n = 0; n < 500; ++n) {
      const glm::dvec3 point(n % 2 == 0 ? random.point(1.5f * reach)
                                        : soup.vertex_m[random.below(soup.vertex_m.size())]);
      double nearest_m = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < tree.size(); ++k) {
        nearest_m = std::min(nearest_m, calc::distance_m(point, tree.triangle(k)));
      }
      double found_m = std::numeric_limits<double>::infinity();
      std::size_t visits = 0;
      tree.visit_near(point, found_m, [&](std::uint32_t k) {
        ++visits;
        found_m = std::min(found_m, calc::distance_m(point, tree.triangle(k)));
        return found_m;
      });
      ASSERT_EQ(found_m, nearest_m) << soup.name;
      ASSERT_LE(visits, tree.size()) << soup.name;
    }
  }
}

}  // namespace
}  // namespace triangle_tree_test
