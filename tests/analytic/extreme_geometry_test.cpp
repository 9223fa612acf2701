// Extreme shapes, sizes and places, each against brute force in double precision or a closed form.
#include "calc/scene/project.h"
#include "tests/analytic/extreme_reference.h"

#include <array>

namespace extreme_geometry_test {
namespace {

using namespace extreme;

const glm::dvec3 kUp(0, 0, 1), kDown(0, 0, -1);
const glm::dvec3 kRoom(4, 3, 2.5), kLamp(1.4, 1.1, 1.9);

calc::PreparedScene plain_room(const calc::PhotometricWeb& web, double rho) {
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, kRoom, rho);
  add_luminaire(scene, web, kLamp);
  set_extent(scene);
  return scene;
}

// Every point of the grid, computed in `scene`, is right by brute force in `simple`.
void expect_all_right(const calc::PreparedScene& scene, const calc::PreparedScene& simple,
                      const calc::SensorGrid& grid, std::uint64_t paths, double widest,
                      int reference_paths = 60000) {
  const calc::SpaceSolution solution = solve_in_looks(scene, grid, 3, paths);
  EXPECT_EQ(solution.balance.escaped_lm.value, 0.0);
  const PathReference reference(simple);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    SCOPED_TRACE(i);
    expect_right(
        solution.fields[0], i,
        reference.total(grid.position_m[i] - scene.origin_m, grid.normal[i], reference_paths),
        widest);
  }
}

TEST(ExtremePoint, OneMillimetreFromACorner) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = plain_room(web, 0.6);
  expect_all_right(scene, scene,
                   points_of({{0.001, 0.001, 0.001}, {3.999, 2.999, 0.001}}, {kUp, {-1, 0, 0}}),
                   4096, 0.03);
}

TEST(ExtremePoint, ExactlyOnASurface) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = plain_room(web, 0.6);
  expect_all_right(
      scene, scene,
      points_of({{2, 1.5, 0}, {0, 1.5, 1.2}, {4, 0.001, 1}}, {kUp, {1, 0, 0}, {-1, 0, 0}}), 4096,
      0.02);
  // The outer side of a wall is dark, and not by chance.
  const calc::SensorGrid outside = points_of({{0, 1.5, 1.2}}, {{-1, 0, 0}});
  for (const double lx : replicates_at(solve_with_paths(scene, outside, 3, 256).fields[0], 0)) {
    EXPECT_EQ(lx, 0.0);
  }
}

// Half of what such a point sees lies behind the floor and is dark; the wall in front is not.
TEST(ExtremePoint, ExactlyOnTheFloorFacingAWall) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = plain_room(web, 0.6);
  const double off_m = 3.0 * scene.ray_offset_m();  // as make_sensor_grid() shifts it
  expect_all_right(scene, scene, points_of({{0.001, 1.5, off_m}}, {{-1, 0, 0}}), 4096, 0.03);
}

TEST(ExtremePoint, ASingleOneAndNone) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = plain_room(web, 0.6);
  expect_all_right(scene, scene, points_of({{2, 1.5, 0.75}}, {kUp}), 4096, 0.01);
  const calc::SpaceSolution none = solve_with_paths(scene, points_of({}, {}), 3, 256);
  ASSERT_EQ(none.fields.size(), 1u);
  EXPECT_EQ(none.fields[0].points, 0u);
  EXPECT_TRUE(none.fields[0].direct_exact_lx.empty());
}

// A wall with a slit of 1 cm between a lit room and a dark one.
calc::PreparedScene two_rooms(const calc::PhotometricWeb& web) {
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {6, 3, 2.5}, 0.5);
  add_quad(scene, {3, 0, 0}, {0, 1.5, 0}, {0, 0, 2.5}, 0.5);
  add_quad(scene, {3, 1.51, 0}, {0, 1.49, 0}, {0, 0, 2.5}, 0.5);
  add_luminaire(scene, web, {1, 0.7, 1.8});
  set_extent(scene);
  return scene;
}

TEST(ExtremeOpening, LightThroughASlitOfOneCentimetre) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = two_rooms(web);
  expect_all_right(scene, scene, points_of({{4.5, 1.0, 0.75}}, {kUp}), 32768, 0.25, 600000);
}

TEST(ExtremeOpening, TooFewPathsForASlitAreNotTakenForDarkness) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene scene = two_rooms(web);
  const calc::SensorGrid grid = points_of({{4.5, 1.0, 0.75}, {5.5, 2.5, 0.75}}, {kUp, kUp});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const calc::SpaceSolution solution = solve_with_paths(scene, grid, seed, 16, 4);
    const calc::PlaneField& field = solution.fields[0];
    for (std::size_t i = 0; i < 2; ++i) {
      const double lx = calc::replicate_mean(replicates_at(field, i)).mean;
      EXPECT_TRUE(lx > 0.0 ? field.largest_share[i] > 0.1f : field.unseen[i] == 1)
          << "seed " << seed << ": " << lx << " lx";
    }
  }
}

// Behind a closed partition without thickness, beside where it meets floor, wall and both. What
// passes is within rounding of its edges: less than 1e-5 of the 100 lx before it.
TEST(ExtremeOpening, NoLightPassesAClosedPartition) {
  const calc::PhotometricWeb web = isotropic_web(1000.0);
  calc::PreparedScene scene;
  add_box(scene, {-3, -1.5, -1.25}, {6, 3, 2.5}, 0.5);
  add_quad(scene, {0, -1.5, -1.25}, {0, 3, 0}, {0, 0, 2.5}, 0.5);
  add_luminaire(scene, web, {-2, -0.8, 0.55});
  set_extent(scene);
  const calc::SensorGrid grid = points_of(
      {{0.001, 0, -1.249}, {0.001, -1.499, 0}, {0.001, -1.499, -1.249}, {0.0001, 1.4999, 0}},
      {{-1, 0, 0}, kUp, kUp, {-1, 0, 0}});
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 4096);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    EXPECT_LT(calc::replicate_mean(replicates_at(solution.fields[0], i)).mean, 1e-3) << i;
  }
}

TEST(ExtremeSurface, CoincidentWallsCountOnce) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene simple = plain_room(web, 0.6);
  calc::PreparedScene scene = simple;
  add_box(scene, {0, 0, 0}, kRoom, 0.6);
  // Once more with the other winding.
  add_triangle(scene, {0, 0, 0}, {4, 3, 0}, {4, 0, 0}, 0.6);
  add_triangle(scene, {0, 0, 0}, {0, 3, 0}, {4, 3, 0}, 0.6);
  expect_all_right(scene, simple, points_of({{2, 1.5, 0.75}, {0.005, 1.5, 0.005}}, {kUp, kUp}),
                   4096, 0.02);
}

TEST(ExtremeSurface, ASheetOfOneMillimetreHasTwoSides) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene = plain_room(web, 0.6);
  add_box(scene, {1, 0.7, 1.2}, {1, 1, 0.001}, 0.4);
  const calc::SensorGrid grid =
      points_of({{1.5, 1.2, 1.201}, {1.5, 1.2, 1.2}, {1.5, 1.2, 1.199}, {1.3, 1.0, 1.195}},
                {kUp, kDown, kUp, kUp});
  expect_all_right(scene, scene, grid, 4096, 0.06);
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 16);
  EXPECT_GT(solution.fields[0].direct_exact_lx[0], 100.0);
  EXPECT_EQ(solution.fields[0].direct_exact_lx[2], 0.0);
}

// Floor and one wall of 7500 and 6250 strips, 4 m and 3 m by 0.4 mm.
TEST(ExtremeSurface, NeedlesTenThousandTimesLongerThanWide) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene simple = plain_room(web, 0.6);
  calc::PreparedScene scene;
  add_luminaire(scene, web, kLamp);
  for (std::size_t t = 2; t < simple.triangle.size(); ++t) {
    if (t == 8 || t == 9) continue;  // without the floor and the wall x = 0
    const glm::uvec3& c = simple.triangle[t];
    add_triangle(scene, simple.vertex_m[c.x], simple.vertex_m[c.y], simple.vertex_m[c.z], 0.6);
  }
  for (int k = 0; k < 7500; ++k) {
    add_quad(scene, {0, 3.0 * k / 7500, 0}, {4, 0, 0}, {0, 3.0 / 7500, 0}, 0.6);
  }
  for (int k = 0; k < 6250; ++k) {
    add_quad(scene, {0, 0, 2.5 * k / 6250}, {0, 3, 0}, {0, 0, 2.5 / 6250}, 0.6);
  }
  set_extent(scene);
  expect_all_right(
      scene, simple,
      points_of({{2, 1.5, 0.75}, {2, 1.5, 0.001}, {0.002, 1.5, 0.002}}, {kUp, kDown, kUp}), 4096,
      0.03);
}

// The plain room as a project, moved away from the origin.
struct RoomProject {
  calc::Project project;

  explicit RoomProject(const glm::dvec3& shift, bool is_messy) {
    project.materials.push_back({"grey", 0.6, {}});
    project.webs.push_back(isotropic_web(100.0));
    project.luminaire_types.emplace_back();
    calc::Space space;
    calc::Body body;
    for (int k = 0; k < 8; ++k) {
      body.vertex_m.push_back(shift + kRoom * glm::dvec3(k & 1, (k >> 1) & 1, k >> 2));
    }
    for (const glm::uvec4& q : {glm::uvec4(0, 1, 3, 2),
                                {4, 5, 7, 6},
                                {0, 1, 5, 4},
                                {2, 3, 7, 6},
                                {0, 2, 6, 4},
                                {1, 3, 7, 5}}) {
      body.triangle.emplace_back(q.x, q.y, q.z);
      body.triangle.emplace_back(q.x, q.z, q.w);
    }
    if (is_messy) {
      body.triangle.emplace_back(3, 3, 5);  // a corner twice
      body.vertex_m.push_back(0.5 * (body.vertex_m[0] + body.vertex_m[1]));
      body.triangle.emplace_back(0, 8, 1);  // on one line
      for (std::size_t k = 0; k < 4; ++k) body.triangle.push_back(body.triangle[3 * k]);
    }
    body.material_of.assign(body.triangle.size(), 0);
    space.bodies.push_back(body);
    calc::Luminaire luminaire;
    luminaire.position_m = shift + kLamp;
    luminaire.world_from_luminaire = glm::dmat3(1.0);
    space.luminaires.push_back(luminaire);
    project.spaces.push_back(space);
  }

  calc::PreparedScene prepared() const {
    return calc::prepare_scene(project, project.spaces.front());
  }
};

TEST(ExtremeSurface, DegenerateAndRepeatedTrianglesChangeNothing) {
  const RoomProject room({0, 0, 0}, true), simple({0, 0, 0}, false);
  const calc::PreparedScene scene = room.prepared();
  EXPECT_EQ(scene.degenerate_triangles, 2u);
  EXPECT_EQ(scene.triangle.size(), 16u);
  expect_all_right(scene, simple.prepared(),
                   points_of({{2, 1.5, 0.75}, {0.005, 1.5, 0.005}}, {kUp, kUp}), 4096, 0.02);
}

TEST(ExtremePlace, AThousandKilometresFromTheOrigin) {
  const glm::dvec3 shift(1e6, -1e6, 1e6);
  const RoomProject here({0, 0, 0}, false), there(shift, false);
  calc::SensorGrid grid = points_of({{2, 1.5, 0.75}, {0.005, 1.5, 0.005}}, {kUp, kUp});
  const calc::PreparedScene near = here.prepared(), far = there.prepared();
  expect_all_right(near, near, grid, 4096, 0.02);
  const calc::SpaceSolution expected = solve_with_paths(near, grid, 3, 4096);
  for (glm::dvec3& p : grid.position_m) p += shift;
  expect_all_right(far, near, grid, 4096, 0.02);
  const calc::SpaceSolution moved = solve_with_paths(far, grid, 3, 4096);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(moved.fields[0].direct_exact_lx[i] / expected.fields[0].direct_exact_lx[i], 1.0,
                1e-6);
  }
}

// A room of 4 km, as a file in millimetres becomes when its unit is forgotten: the same light
// spread over a million times the area, and the other way round.
TEST(ExtremePlace, RoomsAThousandTimesLargerAndSmaller) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  const calc::PreparedScene simple = plain_room(web, 0.6);
  const PathReference reference(simple);
  for (const double scale : {1000.0, 0.001}) {
    SCOPED_TRACE(scale);
    calc::PreparedScene scene;
    add_box(scene, {0, 0, 0}, scale * kRoom, 0.6);
    add_luminaire(scene, web, scale * kLamp);
    set_extent(scene);
    const std::array<glm::dvec3, 2> point{glm::dvec3(2, 1.5, 0.75), glm::dvec3(0.005, 1.5, 0.005)};
    const calc::SpaceSolution solution = solve_with_paths(
        scene, points_of({scale * point[0], scale * point[1]}, {kUp, kUp}), 3, 4096);
    for (std::size_t i = 0; i < 2; ++i) {
      Reference truth = reference.total(point[i], kUp, 60000);
      truth.lx /= scale * scale;
      truth.standard_error_lx /= scale * scale;
      expect_right(solution.fields[0], i, truth, 0.02);
    }
  }
}

// A square kilometre with a slab of 1 cm lying 1 cm above the ground, and a post of 1 cm.
calc::PreparedScene site(const calc::PhotometricWeb& web) {
  calc::PreparedScene scene;
  add_quad(scene, {-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0}, 0.3);
  add_box(scene, {200, 100, 0.01}, {0.5, 0.5, 0.01}, 0.5);
  add_box(scene, {210, 100, 0}, {0.01, 0.01, 1.0}, 0.5);
  add_luminaire(scene, web, {205, 100, 8});
  add_luminaire(scene, web, {-400, 300, 8});
  set_extent(scene);
  return scene;
}

void expect_right_on_site(const calc::SensorGrid& grid, double widest) {
  const calc::PhotometricWeb web = isotropic_web(2000.0);
  const calc::PreparedScene scene = site(web);
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 16384);
  const PathReference reference(scene);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NEAR(solution.fields[0].direct_exact_lx[i],
                reference.direct(grid.position_m[i], grid.normal[i]),
                1e-5 * solution.fields[0].direct_exact_lx[i]);
    expect_right(solution.fields[0], i, reference.total(grid.position_m[i], grid.normal[i], 200000),
                 widest);
  }
}

TEST(ExtremePlace, CentimetresOnASiteOfOneKilometre) {
  // On the slab, in the shadow of the post, above the ground, and above the slab.
  expect_right_on_site(
      points_of(
          {{200.25, 100.25, 0.02}, {210.06, 100.005, 0.5}, {203, 100, 1.5}, {200.25, 100.25, 0.5}},
          {kUp, {-1, 0, 0}, kDown, kDown}),
      0.15);
}

}  // namespace
}  // namespace extreme_geometry_test
