// The illuminance of a road's planes is that of EN 13201-3, point for point: by the same program's
// way through rays, and by the formula alone.
#include "calc/project/project_xml.h"
#include "calc/road/road_values.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/lighting_energy.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "tests/support/memory_file_reader.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace calc::road_plane_test {
namespace {

const std::string kHead =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 -1 1 5 3 1 2 0.4 0.3 0\n1 1 80\n0 30 60 75 90\n0 90 180\n"
    "2000 2500 3000 500 0\n2000 2800 4500 1500 0\n2000 900 200 50 0\n";

// Low heads far apart: most points have luminaires of the field beyond their own five heights.
TEST(RoadPlane, HasTheLightOfItsPointsLuminaires) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='head' "
      "photometry='head.ies'/><road id='a' origin='50 20 3' rotation='30' width='7' lanes='2' "
      "spacing='36' surface='R3'><luminaire-row id='r' type='head' side='right' height='4' "
      "tilt='5'/><luminaire-row id='l' type='head' side='left' height='6' shift='18'/>"
      "<strip id='s' side='left' gap='1' width='2'/></road></luxgate>";
  Diagnostics diagnostics;
  const MemoryFileReader files({{"p.xml", xml}, {"head.ies", kHead}});
  const auto project = load_project(files, "p.xml", diagnostics);
  ASSERT_TRUE(project.has_value());
  const Space& space = project->spaces.at(0);
  const RoadLayout layout = road_layout(*project, space, nullptr);
  const PreparedScene scene = prepare_scene(*project, space);
  std::size_t beyond = 0;
  for (const CalcPlane& plane : space.planes) {
    const auto grid = make_sensor_grid(plane, space, diagnostics);
    ASSERT_TRUE(grid.has_value());
    const PlaneField field = test_support::solve_with_paths(scene, *grid, 1, 1024).fields.at(0);
    for (std::size_t i = 0; i < grid->position_m.size(); ++i) {
      const glm::dvec3 on_road = glm::transpose(space.road->world_from_road) *
                                 (grid->position_m[i] - space.road->origin_m);
      const double expected = road_point_illuminance_lx(layout, glm::dvec2(on_road)) / 0.8;
      EXPECT_NEAR(test_support::total_lx(field, 0, i), expected, 1e-9 * (expected + 1.0))
          << plane.id << " " << i;
      for (const Luminaire& luminaire : space.luminaires) {
        const glm::dvec3 way = glm::transpose(space.road->world_from_road) *
                               (luminaire.position_m - grid->position_m[i]);
        if (std::abs(way.x) > 5.0 * way.z || std::abs(way.y) > 5.0 * way.z) ++beyond;
      }
    }
  }
  EXPECT_GT(beyond, 50u);  // else this shows nothing
}

// Its power is that of one field: one luminaire of each row. It has no floor, so that neither power
// density nor energy of buildings is made of it.
TEST(RoadPlane, HasThePowerOfOneField) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='head' "
      "photometry='head.ies' power-w='70'/><road id='a' width='7' lanes='2' spacing='20' "
      "surface='R3'><luminaire-row id='r' type='head' side='right' height='10'/><luminaire-row "
      "id='l' type='head' side='left' height='10'/></road><energy day-hours='2000' "
      "night-hours='2000' parasitic-kwh-m2='0'/></luxgate>";
  Diagnostics diagnostics;
  const MemoryFileReader files({{"p.xml", xml}, {"head.ies", kHead}});
  const auto project = load_project(files, "p.xml", diagnostics);
  ASSERT_TRUE(project.has_value());
  const InstalledPower power = installed_power(*project, project->spaces.at(0));
  EXPECT_GT(project->spaces[0].luminaires.size(), 8u);
  EXPECT_EQ(power.luminaires, 2);
  EXPECT_EQ(power.power_w, 140.0);
  EXPECT_FALSE(power.density_w_m2().has_value());
  const LightingEnergy energy = lighting_energy(*project, project->spaces[0], power);
  EXPECT_EQ(energy.problem, "the floor area of the space is not known");
}

}  // namespace
}  // namespace calc::road_plane_test
