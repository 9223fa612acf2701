#include "calc/scene/surface_contact.h"
#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::surface_contact_test {
namespace {

constexpr double kOffset_m = 1.0e-5;
constexpr glm::dvec3 kUp(0, 0, 1);

// A rectangle between two corners and an upright edge, or any parallelogram.
Body sheet(const std::string& id, glm::dvec3 origin, glm::dvec3 u, glm::dvec3 v) {
  Body body;
  body.id = id;
  body.vertex_m = {origin, origin + u, origin + u + v, origin + v};
  body.triangle = {{0, 1, 2}, {0, 2, 3}};
  return body;
}

SurfaceContact contact_of(const std::vector<Body>& bodies, const glm::dvec3& point_m,
                          const glm::dvec3& front = kUp,
                          ReceiverKernel kernel = ReceiverKernel::planar) {
  Space space;
  space.bodies = bodies;
  BoundingBox region;
  region.add(point_m);
  const NearTriangles near(space, region, kContactReach * kOffset_m);
  SurfaceContact contact = surface_contact(near, point_m, front, kernel, kOffset_m);
  // The space ends here.
  if (contact.body != nullptr) {
    for (const Body& body : bodies) {
      if (body.id == contact.body->id) contact.body = &body;
    }
  }
  return contact;
}

const Body kFloor = sheet("floor", {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
const Body kWall = sheet("wall", {0, 0, 0}, {0, 4, 0}, {0, 0, 3});      // x = 0
const Body kSide = sheet("side", {0, 0, 0}, {4, 0, 0}, {0, 0, 3});      // y = 0
const Body kScreen = sheet("screen", {2, 1, 0}, {0, 2, 0}, {0, 0, 2});  // x = 2, y from 1 to 3

TEST(SurfaceContact, APlaneOnAFloorOrInFreeAirTouchesNothing) {
  EXPECT_EQ(contact_of({kFloor}, {1, 1, 0}).body, nullptr);
  EXPECT_EQ(contact_of({kFloor, kWall}, {1, 1, 0.75}).body, nullptr);
  EXPECT_EQ(contact_of({kFloor, kWall}, {1, 0.1, 0}).body, nullptr);
  EXPECT_EQ(contact_of({kWall}, {0, 1, 1}, {1, 0, 0}).body, nullptr) << "on the wall";
  EXPECT_EQ(contact_of({kScreen}, {2, 2, 2}).body, nullptr) << "on its top: it does not rise";
}

TEST(SurfaceContact, AWallHasTwoSidesStraightOffIt) {
  const std::vector<Body> bodies{kWall};
  const SurfaceContact contact = contact_of(bodies, {0, 2, 1});
  ASSERT_NE(contact.body, nullptr);
  EXPECT_EQ(contact.body->id, "wall");
  ASSERT_EQ(contact.sides.size(), 2u);
  EXPECT_LT(contact.sides[0].shift_m.x * contact.sides[1].shift_m.x, 0.0);
  for (const SurfaceContact::Side& side : contact.sides) {
    EXPECT_TRUE(side.has_room);
    EXPECT_NEAR(std::abs(side.shift_m.x), 1.275 * kOffset_m, 1e-12);
    EXPECT_NEAR(side.shift_m.y, 0.0, 1e-12);
    EXPECT_NEAR(side.shift_m.z, 0.0, 1e-12);
  }
}

TEST(SurfaceContact, ACornerHasAnInsideInItsMiddleAndAnOutside) {
  const std::vector<Body> bodies{kWall, kSide};
  const SurfaceContact contact = contact_of(bodies, {0, 0, 1});
  ASSERT_EQ(contact.sides.size(), 2u);
  for (const SurfaceContact::Side& side : contact.sides) {
    EXPECT_TRUE(side.has_room);
    EXPECT_NEAR(side.shift_m.x, side.shift_m.y, 1e-12) << "the bisector";
  }
  EXPECT_LT(contact.sides[0].shift_m.x * contact.sides[1].shift_m.x, 0.0);
}

TEST(SurfaceContact, AScreenAtAWallMakesThreeSides) {
  const Body screen = sheet("screen", {0, 2, 0}, {3, 0, 0}, {0, 0, 2});
  EXPECT_EQ(contact_of({kWall, screen}, {0, 2, 1}).sides.size(), 3u);
  EXPECT_EQ(contact_of({kWall, screen}, {0, 2, 2}).sides.size(), 2u) << "above the screen";
}

TEST(SurfaceContact, AroundTheEndOfAScreenThereIsOneSide) {
  const std::vector<Body> bodies{kScreen};
  const SurfaceContact contact = contact_of(bodies, {2, 1, 1});
  ASSERT_NE(contact.body, nullptr);
  ASSERT_EQ(contact.sides.size(), 1u);
  EXPECT_LT(contact.sides[0].shift_m.y, 0.0) << "straight away from it";
  EXPECT_NEAR(contact.sides[0].shift_m.x, 0.0, 1e-12);
}

TEST(SurfaceContact, ASlopeCountsFromWhereRaysWouldMissIt) {
  const auto slope = [](double degrees) {
    const double rise = calc::tan(radians_from_degrees(degrees));
    return sheet("slope", {-1, -1, -rise}, {0, 2, 0}, {2, 0, 2.0 * rise});
  };
  EXPECT_EQ(contact_of({slope(20)}, {0, 0, 0}).body, nullptr);
  EXPECT_NE(contact_of({slope(60)}, {0, 0, 0}).body, nullptr);
  EXPECT_EQ(contact_of({slope(60)}, {0, 0, 0}).sides.size(), 2u);
}

TEST(SurfaceContact, ASharpCornerHasNoRoom) {
  const Body other = sheet("other", {0, 0, 0}, {0.2, 4, 0}, {0, 0, 3});
  const SurfaceContact contact = contact_of({kWall, other}, {0, 0, 1});
  ASSERT_EQ(contact.sides.size(), 1u) << "sharper than a twentieth of a turn";
  EXPECT_LT(contact.sides[0].shift_m.y, 0.0);
  const Body wider = sheet("wider", {0, 0, 0}, {2.0, 4, 0}, {0, 0, 3});
  EXPECT_EQ(contact_of({kWall, wider}, {0, 0, 1}).sides.size(), 2u);
}

TEST(SurfaceContact, OtherReceiversStandInFrontOfWhatLiesAcross) {
  for (const ReceiverKernel kernel : {ReceiverKernel::cylindrical, ReceiverKernel::scalar}) {
    const SurfaceContact on_floor = contact_of({kFloor}, {1, 1, 0}, kUp, kernel);
    ASSERT_EQ(on_floor.sides.size(), 1u);
    EXPECT_EQ(glm::normalize(on_floor.sides[0].shift_m), kUp);
    const SurfaceContact at_wall = contact_of({kFloor, kWall}, {0, 1, 0}, kUp, kernel);
    ASSERT_EQ(at_wall.sides.size(), 2u) << "both sides of the wall, above the floor";
    for (const SurfaceContact::Side& side : at_wall.sides) {
      EXPECT_TRUE(side.has_room);
      EXPECT_GT(std::abs(side.shift_m.x), 2.5 * kOffset_m);
      EXPECT_TRUE(side.shift_m.x < 0.0 || side.shift_m.z > 2.5 * kOffset_m) << "the floor";
    }
    EXPECT_EQ(contact_of({kScreen}, {2, 2, 1}, kUp, kernel).sides.size(), 2u);
  }
}

TEST(SurfaceContact, TurnedByAnyAngleTheSidesAreTheSame) {
  for (int k = 0; k < 24; ++k) {
    const double turn = 0.1 + k * 0.2617;
    const glm::dvec3 along(calc::cos(turn), calc::sin(turn), 0), across(-along.y, along.x, 0);
    const Body wall = sheet("wall", -2.0 * along, 4.0 * along, {0, 0, 3});
    const SurfaceContact contact = contact_of({wall}, {0, 0, 1});
    ASSERT_EQ(contact.sides.size(), 2u) << turn;
    for (const SurfaceContact::Side& side : contact.sides) {
      EXPECT_TRUE(side.has_room) << turn;
      EXPECT_GT(std::abs(glm::dot(side.shift_m, across)), 1.25 * kOffset_m) << turn;
    }
  }
}

TEST(NearTriangles, FindsWhatAScanOfAllFinds) {
  Space space;
  Body body;
  body.id = "hill";
  constexpr int kCells = 40;
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) {
      body.vertex_m.emplace_back(0.1 * x, 0.1 * y, 0.3 * calc::sin(0.7 * x) * calc::cos(0.5 * y));
    }
  }
  const auto at = [](int x, int y) { return static_cast<std::uint32_t>(y * (kCells + 1) + x); };
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      body.triangle.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      body.triangle.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  space.bodies = {body, kWall, sheet("roof", {-1, -1, -2}, {7, 0, 4}, {0, 7, 3})};
  const BoundingBox region{{0, 0, -1}, {4, 4, 1}};
  const NearTriangles near(space, region, 0.2);
  std::size_t total = 0;
  for (int i = 0; i < 500; ++i) {
    const auto part = [&](int step) { return ((i * step) % 101) / 100.0; };
    const glm::dvec3 place(4.0 * part(37), 4.0 * part(59), 2.0 * part(83) - 1.0);
    std::size_t expected = 0;
    for (const Body& one : space.bodies) {
      for (const glm::uvec3& t : one.triangle) {
        const Triangle corner{one.vertex_m[t.x], one.vertex_m[t.y], one.vertex_m[t.z]};
        if (distance_m(place, corner) <= 0.2) ++expected;
      }
    }
    EXPECT_EQ(near.within(place, 0.2).size(), expected);
    total += expected;
  }
  EXPECT_GT(total, 500u);
}

}  // namespace
}  // namespace calc::surface_contact_test
