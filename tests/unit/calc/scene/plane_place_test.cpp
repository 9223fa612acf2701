// Which luminaires are in front of a plane: by what is seen of their openings, not by their
// centres.

#include "calc/scene/plane_place.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace calc::tests::plane_place_test {
namespace {

// Turned by 30 degrees about x: its axis leans towards -y.
Luminaire tilted() {
  Luminaire luminaire;
  const double c = std::sqrt(0.75), s = 0.5;
  luminaire.world_from_luminaire =
      glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, c, s), glm::dvec3(0, -s, c));
  return luminaire;
}

LuminousOpening opening(OpeningShape shape) { return {shape, 0.6, 0.8, 0.2}; }

TEST(OpeningReach, IsHowFarTheShapeGoesThatWay) {
  Luminaire level;
  level.world_from_luminaire = glm::dmat3(1.0);
  const glm::dvec3 up(0, 0, 1), x(1, 0, 0), y(0, 1, 0);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::point), level, x), 0.0);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::rectangle), level, x), 0.3);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::rectangle), level, -y), 0.4);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::rectangle), level, up), 0.0);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::box), level, up), 0.1);
  const glm::dvec3 slanted(0.6, 0.8, 0.0);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::rectangle), level, slanted), 0.5);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::disk), level, slanted),
                   std::hypot(0.18, 0.32));
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::cylinder), level, up), 0.1);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::cylinder_c0), level, slanted),
                   0.18 + 0.32);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::cylinder_c90), level, {0, 0.6, 0.8}),
                   0.24 + 0.08);
  EXPECT_DOUBLE_EQ(opening_reach_m(opening(OpeningShape::ellipsoid), level, {0, 0.6, 0.8}),
                   std::hypot(0.24, 0.08));
}

TEST(OpeningReach, TurnsWithTheLuminaire) {
  EXPECT_NEAR(opening_reach_m(opening(OpeningShape::rectangle), tilted(), {0, 0, 1}), 0.2, 1e-12);
  EXPECT_NEAR(opening_reach_m(opening(OpeningShape::box), tilted(), {0, 0, 1}),
              0.2 + 0.1 * std::sqrt(0.75), 1e-12);
}

// The luminaire of in_room() is a point at 2 m, 1.5 m.
bool away(const std::string& plane) {
  const Loaded loaded = load(project_files(in_room(plane)));
  const Space& space = loaded.project->spaces.at(0);
  return faces_away(*loaded.project, space, space.planes.at(0));
}

TEST(FacesAway, APointInThePlaneItselfLightsNothing) {
  const auto upright = [](double x) {
    return fmt::format(R"(<plane id="p" origin="{} 1 1" u="0 1 0" v="0 0 1"/>)", x);
  };
  EXPECT_FALSE(away(upright(1.99)));
  EXPECT_TRUE(away(upright(2.0)));
  EXPECT_TRUE(away(upright(2.01)));
}

}  // namespace
}  // namespace calc::tests::plane_place_test
