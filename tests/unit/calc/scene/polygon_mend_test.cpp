// Outlines with spikes, doubled corners and keyholes: mended, their area and direction stay.

#include "calc/scene/polygon_mend.h"
#include "calc/scene/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace calc::polygon_mend_test {
namespace {

using Outline = std::vector<glm::dvec2>;
using Loop = std::vector<glm::dvec3>;

double area_of_triangles(const Outline& p, const MendedPolygon& mended) {
  double sum = 0.0;
  for (const glm::uvec3& t : mended.triangle) {
    const double part = signed_area({p[t.x], p[t.y], p[t.z]});
    EXPECT_GT(part * signed_area(p), 0.0);
    sum += part;
  }
  return sum;
}

double area_of_rings(const Outline& p, const MendedPolygon& mended) {
  double sum = 0.0;
  for (const std::vector<std::uint32_t>& ring : mended.ring) {
    Outline points;
    for (const std::uint32_t c : ring) points.push_back(p[c]);
    EXPECT_TRUE(is_simple_polygon(points));
    sum += signed_area(points);
  }
  return sum;
}

void expect_area(const Outline& broken, double area, const char* what) {
  const auto mended = mend_polygon(broken);
  ASSERT_TRUE(mended) << what;
  EXPECT_NEAR(area_of_triangles(broken, *mended) / area, 1.0, 1e-12) << what;
  EXPECT_NEAR(area_of_rings(broken, *mended) / area, 1.0, 1e-12) << what;
}

class RandomOutline {
 public:
  explicit RandomOutline(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  // A star around a centre: simple, rarely convex.
  Outline star(glm::dvec2 centre, double least, double most, std::size_t corners) {
    Outline outline;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * (static_cast<double>(i) + between(0.1, 0.9)) /
                           static_cast<double>(corners);
      outline.push_back(centre +
                        between(least, most) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
  }

  // There and back over one to three corners, anywhere on the outside or the inside.
  void insert_spike(Outline& outline) {
    const std::size_t i = below(outline.size());
    const std::size_t sides = 1 + below(3);
    Outline way;
    for (std::size_t k = 0; k < sides; ++k) {
      way.emplace_back(between(-9.0, 9.0), between(-9.0, 9.0));
    }
    Outline there_and_back = way;
    for (std::size_t k = 1; k < sides; ++k) there_and_back.push_back(way[sides - 1 - k]);
    there_and_back.push_back(outline[i]);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, there_and_back.begin(),
                   there_and_back.end());
  }

  void insert_double(Outline& outline) {
    const std::size_t i = below(outline.size());
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i), outline[i]);
  }

 private:
  std::mt19937 random_;
};

// A hole the other way round, joined by a doubled side from corner i to its corner 0.
void insert_keyhole(Outline& outline, std::size_t i, Outline hole) {
  std::reverse(hole.begin() + 1, hole.end());
  hole.push_back(hole[0]);
  hole.push_back(outline[i]);
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, hole.begin(), hole.end());
}

const Outline kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(PolygonMend, ASimplePolygonStaysAsItIs) {
  const Outline shape = {{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};
  const auto mended = mend_polygon(shape);
  ASSERT_TRUE(mended);
  EXPECT_FALSE(mended->mending.is_any());
  EXPECT_EQ(mended->triangle, triangulate_polygon(shape).value());
  EXPECT_EQ(mended->ring, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3, 4, 5}}));
}

TEST(PolygonMend, WhatWasWrongIsCounted) {
  const auto spike = mend_polygon(Outline{{0, 0}, {4, 0}, {7, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 4}});
  ASSERT_TRUE(spike);
  EXPECT_EQ(spike->mending.spikes, 1u);
  EXPECT_EQ(spike->mending.doubled, 1u);
  EXPECT_EQ(spike->mending.joints, 0u);
  EXPECT_DOUBLE_EQ(spike->mending.longest, 3.0);
  EXPECT_EQ(spike->mending.at, glm::dvec3(7, 0, 0));
  EXPECT_EQ(spike->mending.words(), "1 doubled corner, 1 spike");
  // Over several corners it is one spike; two from one corner are two.
  const auto long_one =
      mend_polygon(Outline{{0, 0}, {4, 0}, {6, 1}, {8, 5}, {6, 1}, {4, 0}, {4, 4}, {0, 4}});
  ASSERT_TRUE(long_one);
  EXPECT_EQ(long_one->mending.spikes, 1u);
  EXPECT_EQ(long_one->mending.doubled, 0u);
  const auto two =
      mend_polygon(Outline{{0, 0}, {4, 0}, {6, 1}, {4, 0}, {7, 2}, {4, 0}, {4, 4}, {0, 4}});
  ASSERT_TRUE(two);
  EXPECT_EQ(two->mending.spikes, 2u);
  // Across the end of the list.
  const auto across = mend_polygon(Outline{{9, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}});
  ASSERT_TRUE(across);
  EXPECT_EQ(across->mending.spikes, 1u);
  EXPECT_EQ(across->mending.doubled, 0u);
  EXPECT_EQ(across->ring[0].size(), 4u);
}

TEST(PolygonMend, ASpikeNeedNotComeBackToWhereItBegan) {
  expect_area({{0, 0}, {4, 0}, {4, 6}, {4, 4}, {0, 4}}, 16.0, "beyond the corner");
  expect_area({{0, 0}, {4, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 16.0, "along its own side");
  expect_area({{0, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}, 16.0, "a side that is too long");
}

TEST(PolygonMend, AKeyholeIsAHole) {
  Outline room = kSquare;
  insert_keyhole(room, 0, {{1, 1}, {3, 1}, {3, 3}, {1, 3}});
  const auto mended = mend_polygon(room);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->ring.size(), 2u);
  EXPECT_EQ(mended->mending.joints, 1u);
  EXPECT_EQ(mended->mending.spikes, 0u);
  EXPECT_NEAR(mended->mending.longest, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(area_of_triangles(room, *mended), 12.0, 1e-12);
  const glm::dvec2 inside_hole(2, 2);
  for (const glm::uvec3& t : mended->triangle) {
    EXPECT_FALSE(contains_point({room[t.x], room[t.y], room[t.z]}, inside_hole));
  }
}

TEST(PolygonMend, ManyKeyholes) {
  Outline room = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  double area = 100.0;
  for (int k = 0; k < 3; ++k) {
    const double x = 1.0 + 3.0 * k;
    const Outline hole = {{x, 2 + 0.3 * k}, {x + 1, 2 + 0.3 * k}, {x + 1, 4}, {x, 4}};
    area -= signed_area(hole);
    insert_keyhole(room, 0, hole);
  }
  expect_area(room, area, "three from one corner");
  // One behind another.
  Outline chain = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  insert_keyhole(chain, 0, {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  insert_keyhole(chain, 3, {{4, 4}, {5, 4}, {5, 5}, {4, 5}});
  expect_area(chain, 98.0, "chain");
}

// Its joint ends in the middle of a side, where no corner is.
TEST(PolygonMend, AKeyholeFromTheMiddleOfASide) {
  expect_area({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {3, 2}, {2, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}},
              15.0, "corner on the side");
  // The way back passes a corner that the way there has.
  expect_area(
      {{0, 0}, {2, 0}, {2, 0.5}, {2, 1}, {1, 2}, {3, 2}, {2, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}},
      15.0, "divided joint");
}

TEST(PolygonMend, PartsThatTouchAreBothThere) {
  expect_area({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}, 6.0, "a corner on a side");
  expect_area({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, 8.0, "two squares");
  expect_area({{0, 0}, {2, 0}, {1, 1}, {3, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 15.0, "a hole");
  // Two squares and the way between them.
  expect_area({{0, 0},
               {1, 0},
               {1, 1},
               {3, 1},
               {3, 0},
               {4, 0},
               {4, 2},
               {3, 2},
               {3, 1},
               {1, 1},
               {1, 2},
               {0, 2}},
              4.0, "a doubled side between them");
}

TEST(PolygonMend, WhatCouldMeanTwoThingsIsNotMended) {
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {2, 2}, {2, 0}, {0, 2}})) << "bow tie";
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {5, 0}, {5, 1}, {1, -2}, {0, 4}})) << "crossing";
  EXPECT_FALSE(
      mend_polygon(Outline{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}))
      << "twice around";
  EXPECT_FALSE(
      mend_polygon(Outline{{0, 0}, {6, 0}, {6, 4}, {2, 4}, {2, 1}, {4, 1}, {4, 5}, {0, 5}}))
      << "a curl over itself: triangles of its signed area exist";
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {4, 0}, {2, 0}})) << "no area";
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {4, 0}, {4, 0}, {0, 0}})) << "no area";
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {4, 0}}));
  EXPECT_FALSE(mend_polygon(Outline{{0, 0}, {4, 0}, {4, std::nan("")}}));
  EXPECT_FALSE(mend_polygon(
      Outline{{0, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}))
      << "a part in a part: enclosed twice";
  // A hole that lies outside.
  Outline outside = kSquare;
  insert_keyhole(outside, 1, {{5, 1}, {6, 1}, {6, 2}, {5, 2}});
  EXPECT_FALSE(mend_polygon(outside));
}

TEST(PolygonMend, AreaAndDirectionStayWhateverIsInserted) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomOutline random(seed);
    const glm::dvec2 place(random.between(-50.0, 50.0), random.between(-50.0, 50.0));
    Outline outline = random.star(place, 3.0, 6.0, 5 + random.below(20));
    double area = signed_area(outline);
    const Outline hole = random.star(place, 0.5, 1.2, 3 + random.below(6));
    if (seed % 2 == 0) {
      // The way from its own corner to the centre is free in a star; to a hole around it, too.
      std::size_t corner = random.below(outline.size());
      std::size_t nearest = 0;
      const auto angle = [&](const glm::dvec2& a, const glm::dvec2& b) {
        return -glm::dot(glm::normalize(a - place), glm::normalize(b - place));
      };
      for (std::size_t k = 1; k < hole.size(); ++k) {
        if (angle(hole[k], outline[corner]) < angle(hole[nearest], outline[corner])) nearest = k;
      }
      Outline turned = hole;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(nearest),
                  turned.end());
      Outline with_hole = outline;
      insert_keyhole(with_hole, corner, turned);
      if (mend_polygon(with_hole)) {  // else the way crosses a side: see below
        outline = with_hole;
        area -= signed_area(hole);
      }
    }
    for (std::size_t k = random.below(6); k > 0; --k) random.insert_spike(outline);
    for (std::size_t k = random.below(6); k > 0; --k) random.insert_double(outline);
    if (seed % 3 == 0) {
      std::reverse(outline.begin(), outline.end());
      area = -area;
    }
    expect_area(outline, area, std::to_string(seed).c_str());
  }
}

// How many of the random keyholes above are whole ones: the test is not empty.
TEST(PolygonMend, RandomKeyholesAreMended) {
  unsigned mended = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomOutline random(seed);
    Outline outline = random.star({0, 0}, 3.0, 6.0, 8 + random.below(20));
    const Outline hole = random.star({0, 0}, 0.5, 1.2, 16);
    const double area = signed_area(outline) - signed_area(hole);
    const std::size_t corner = random.below(outline.size());
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < hole.size(); ++k) {
      if (glm::length(hole[k] - outline[corner]) < glm::length(hole[nearest] - outline[corner]))
        nearest = k;
    }
    Outline turned = hole;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(nearest),
                turned.end());
    insert_keyhole(outline, corner, turned);
    const auto found = mend_polygon(outline);
    if (!found) continue;
    ++mended;
    EXPECT_NEAR(area_of_triangles(outline, *found) / area, 1.0, 1e-12) << seed;
  }
  EXPECT_GT(mended, 190u);
}

TEST(PolygonMend, InSpace) {
  const glm::dvec3 u(0.6, 0.8, 0.0), v(0.0, 0.0, 1.0), origin(100, -50, 3);
  const Outline flat = {{0, 0}, {4, 0}, {4, 0}, {4, 3}, {4, 5}, {4, 3}, {0, 3}};
  Loop corners;
  for (const glm::dvec2& p : flat) corners.push_back(origin + p.x * u + p.y * v);
  corners[4] += glm::dvec3(0.3, 0.2, 0.0);  // a spike may stand off the plane
  const auto mended = mend_polygon(corners);
  ASSERT_TRUE(mended);
  EXPECT_LT(mended->deviation, 1e-12);
  EXPECT_EQ(mended->mending.words(), "1 doubled corner, 1 spike");
  EXPECT_EQ(mended->mending.at, corners[4]);
  glm::dvec3 sum(0.0);
  for (const glm::uvec3& t : mended->triangle) {
    sum += 0.5 * glm::cross(corners[t.y] - corners[t.x], corners[t.z] - corners[t.x]);
  }
  EXPECT_NEAR(glm::length(sum - 12.0 * glm::cross(u, v)), 0.0, 1e-11);
  corners[6] += glm::dvec3(0.008, -0.006, 0.0);  // 1 cm of 5 m
  const auto bent = mend_polygon(corners);
  ASSERT_TRUE(bent);
  EXPECT_GT(bent->deviation, 2e-4);
  EXPECT_LT(bent->deviation, 1e-3);
}

TEST(PolygonMend, EnclosedAreaCountsWhatCrosses) {
  EXPECT_NEAR(enclosed_area(Outline{{0, 0}, {2, 2}, {2, 0}, {0, 2}}), 2.0, 1e-12);
  EXPECT_NEAR(enclosed_area(kSquare), 16.0, 1e-12);
  EXPECT_EQ(enclosed_area(Outline{{0, 0}, {1, 1}}), 0.0);
  EXPECT_NEAR(enclosed_area(Loop{{0, 0, 1}, {2, 2, 1}, {2, 0, 1}, {0, 2, 1}}), 2.0, 1e-12);
  EXPECT_EQ(enclosed_area(Loop{{0, 0, 1}, {2, 2, 1}, {1, 1, 1}}), 0.0);
}

}  // namespace
}  // namespace calc::polygon_mend_test
