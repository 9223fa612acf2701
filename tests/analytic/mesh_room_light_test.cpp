// Light in rooms from meshes: the same as in the prism of the same triangles, whichever way the
// faces look; and in a closed sphere what the closed form says.
#include "calc/project/project_xml.h"
#include "tests/support/facet_grid.h"
#include "tests/support/memory_file_reader.h"
#include "tests/support/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace mesh_room_light_test {
namespace {

using namespace test_support;

// 100 cd in all directions.
constexpr const char* kLampIes =
    "IESNA:LM-63-2002\n[TEST] t\n[TESTLAB] t\n[ISSUEDATE] t\n[MANUFAC] t\nTILT=NONE\n"
    "1 -1 1 3 1 1 2 0 0 0\n1 1 10\n0 90 180\n0\n100 100 100\n";

std::optional<calc::Project> load(const std::string& room, const std::string& obj, double rho) {
  const calc::MemoryFileReader files(
      {{"p.xml", fmt::format(R"(<luxgate version="1" maintenance-factor="1">)"
                             R"(<material id="m" reflectance="{}"/>)"
                             R"(<luminaire-type id="lamp" photometry="lamp.ies"/>{}</luxgate>)",
                             rho, room)},
       {"lamp.ies", kLampIes},
       {"hall.obj", obj}});
  calc::Diagnostics diagnostics;
  std::optional<calc::Project> project = calc::load_project(files, "p.xml", diagnostics);
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    ADD_FAILURE() << calc::format_diagnostic(diagnostic);
  }
  return project;
}

// The triangles in their order, each with its own three vertices.
std::string obj_of(const std::vector<glm::dvec3>& vertex, const std::vector<glm::uvec3>& triangle,
                   bool turned) {
  std::string text;
  std::size_t next = 1;
  for (const glm::uvec3& t : triangle) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& p = vertex[t[i]];
      text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    }
    text += turned ? fmt::format("f {} {} {}\n", next, next + 2, next + 1)
                   : fmt::format("f {} {} {}\n", next, next + 1, next + 2);
    next += 3;
  }
  return text;
}

constexpr const char* kInside = R"(<luminaire id="l" type="lamp" position="1.4 1.1 1.9"/>)"
                                R"(<plane id="task" height="0.75" count="4 3"/>)";

struct Solved {
  calc::SensorGrid grid;
  calc::SpaceSolution solution;
};

Solved solve(const calc::Project& project) {
  const calc::Space& space = project.spaces.at(0);
  calc::Diagnostics diagnostics;
  const auto grid = calc::make_sensor_grid(space.planes.at(0), space, diagnostics);
  Solved solved{grid.value(), {}};
  solved.solution = solve_with_paths(calc::prepare_scene(project, space), solved.grid, 3, 8192);
  return solved;
}

TEST(MeshRoomLight, IsThatOfThePrism) {
  const auto prism = load(fmt::format(R"(<room id="r" size="4 3 2.5" ceiling="m" walls="m" )"
                                      R"(floor="m">{}</room>)",
                                      kInside),
                          "v 0 0 0", 0.6);
  ASSERT_TRUE(prism);
  const Solved expected = solve(*prism);
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  for (const calc::Body& body : prism->spaces[0].bodies) {
    const auto first = static_cast<std::uint32_t>(vertex_m.size());
    vertex_m.insert(vertex_m.end(), body.vertex_m.begin(), body.vertex_m.end());
    for (const glm::uvec3& t : body.triangle) triangle.push_back(t + first);
  }
  const double phi = 400.0 * calc::kPi;
  for (const bool turned : {false, true}) {
    SCOPED_TRACE(turned);
    const auto project = load(fmt::format(R"(<room id="r" file="hall.obj" units="m" up="z" )"
                                          R"(material="m">{}</room>)",
                                          kInside),
                              obj_of(vertex_m, triangle, turned), 0.6);
    ASSERT_TRUE(project);
    EXPECT_FALSE(project->spaces[0].shell);
    EXPECT_TRUE(project->spaces[0].bodies.at(0).encloses_room);
    const Solved found = solve(*project);
    ASSERT_EQ(found.grid.position_m, expected.grid.position_m);
    const calc::PlaneField &a = expected.solution.fields[0], &b = found.solution.fields[0];
    ASSERT_EQ(b.problem, "");
    if (!turned) {
      EXPECT_EQ(a.direct_exact_lx, b.direct_exact_lx);
      EXPECT_EQ(a.indirect_lx, b.indirect_lx);
    }
    for (std::size_t i = 0; i < b.points; ++i) {
      std::vector<double> of_prism, of_mesh;
      for (std::size_t r = 0; r < b.replicates; ++r) {
        of_prism.push_back(total_lx(a, r, i));
        of_mesh.push_back(total_lx(b, r, i));
      }
      const calc::Estimate one = calc::t_interval(of_prism, 0.999);
      const calc::Estimate other = calc::t_interval(of_mesh, 0.999);
      EXPECT_LE(one.low, other.high);
      EXPECT_LE(other.low, one.high);
      EXPECT_NEAR(other.value / one.value, 1.0, 0.02);
    }
    EXPECT_EQ(found.solution.balance.escaped_lm.value, 0.0);
    EXPECT_NEAR(found.solution.balance.emitted_lm, phi, 1e-6 * phi);
    EXPECT_NEAR(found.solution.balance.absorbed_lm.value / phi, 1.0, 2e-3);
  }
}

// E = Phi / (A (1 - rho)) in the mean over all of the inside, and what arrives there times
// (1 - rho) is all that is sent.
TEST(MeshRoomLight, OfASphereIsThatOfTheClosedForm) {
  for (const double rho : {0.0, 0.5, 0.9}) {
    SCOPED_TRACE(rho);
    calc::PreparedScene sphere;
    add_sphere(sphere, 1.5, 1, rho);
    const std::vector<glm::dvec3> vertex_m(sphere.vertex_m.begin(), sphere.vertex_m.end());
    for (const bool turned : {false, true}) {
      const auto project =
          load(R"(<room id="r" file="hall.obj" units="m" up="z" material="m">)"
               R"(<luminaire id="l" type="lamp" position="0 0 0"/>)"
               R"(<plane id="p" origin="-0.1 -0.1 -0.5" u="0.2 0 0" v="0 0.2 0"/></room>)",
               obj_of(vertex_m, sphere.triangle, turned), rho);
      ASSERT_TRUE(project);
      const calc::Space& space = project->spaces[0];
      ASSERT_EQ(space.bodies.size(), 1u);
      EXPECT_TRUE(space.bodies[0].encloses_room);
      EXPECT_TRUE(space.outline_m.empty());  // it stands on a tip or an edge
      const calc::PreparedScene scene = calc::prepare_scene(*project, space);
      const FacetGrid facets = facet_grid(scene);
      const calc::SpaceSolution solution = solve_with_paths(scene, facets.grid, 11, 512);
      ASSERT_EQ(solution.fields[0].problem, "");
      const double phi = 400.0 * calc::kPi;
      const double truth = phi / (surface_area_m2(scene) * (1.0 - rho));
      const calc::Estimate mean = facet_mean(facets, solution.fields[0]);
      EXPECT_LE(mean.low, truth * 1.0005);
      EXPECT_GE(mean.high, truth * 0.9995);
      EXPECT_NEAR(mean.value / truth, 1.0, 4e-3);
      EXPECT_EQ(solution.balance.escaped_lm.value, 0.0);
      EXPECT_NEAR(mean.value * (1.0 - rho) * surface_area_m2(scene) / phi, 1.0, 4e-3);
    }
  }
}

}  // namespace
}  // namespace mesh_room_light_test
