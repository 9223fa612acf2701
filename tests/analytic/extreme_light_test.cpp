// Extreme reflectances and luminaires, each against a closed form or an estimate of its own.
#include "calc/proofs/skips.h"
#include "tests/analytic/extreme_reference.h"

namespace extreme_light_test {
namespace {

using namespace extreme;

const glm::dvec3 kUp(0, 0, 1), kDown(0, 0, -1);

// Light between two gamma angles only.
calc::PhotometricWeb zone_web(double cd, double from_rad, double to_rad) {
  return calc::PhotometricWeb::make({0.0}, {from_rad, to_rad}, {cd, cd}, {}, {});
}

// Midpoints of n x n cells on the six faces of a box, normals inwards, with the cells' areas.
struct Faces {
  calc::SensorGrid grid;
  std::vector<double> area_m2;
};

Faces faces_of(const glm::dvec3& size, int n) {
  Faces faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int k = 0; k < 2 * n * n; ++k) {
      const int side = k / (n * n), cell = k % (n * n);
      glm::dvec3 p(0.0), normal(0.0);
      p[axis] = side * size[axis];
      p[a] = (cell % n + 0.5) / n * size[a];
      p[b] = (cell / n + 0.5) / n * size[b];
      normal[axis] = side == 0 ? 1.0 : -1.0;
      faces.grid.position_m.push_back(p);
      faces.grid.normal.push_back(normal);
      faces.area_m2.push_back(size[a] * size[b] / (n * n));
    }
  }
  return faces;
}

TEST(ExtremeReflectance, ZeroLeavesExactlyTheDirectLight) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.0);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  const calc::SensorGrid grid = points_of({{2, 1.5, 0.75}, {0.001, 1.5, 0.75}}, {kUp, kUp});
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = 64;
  settings.skips.forbid_all();  // the samples must say zero themselves
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::SpaceSolution sampled = calc::solve_illuminance(
      scene, {{"plane", &grid}}, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
  const calc::SpaceSolution exact = solve_with_paths(scene, grid, 1, 64);
  EXPECT_TRUE(exact.fields[0].is_exact());
  for (std::size_t i = 0; i < 2; ++i) {
    const double truth = direct_lx(scene.luminaires[0], grid.position_m[i], kUp);
    EXPECT_NEAR(exact.fields[0].direct_exact_lx[i] / truth, 1.0, 1e-6);
    for (const double lx : replicates_at(sampled.fields[0], i)) {
      EXPECT_NEAR(lx / truth, 1.0, 1e-6);
    }
  }
}

// sum (1 - rho) E A = Phi for a room that absorbs a thousandth of its light at each reflection.
TEST(ExtremeReflectance, ThousandReflectionsKeepTheFlux) {
  const glm::dvec3 size(4, 3, 2.5);
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, size, 0.999);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  const Faces faces = faces_of(size, 4);
  const calc::SpaceSolution solution = solve_with_paths(scene, faces.grid, 3, 128);
  const calc::PlaneField& field = solution.fields[0];
  ASSERT_EQ(field.problem, "");
  std::vector<double> absorbed_lm(field.replicates, 0.0);
  for (std::size_t r = 0; r < field.replicates; ++r) {
    for (std::size_t i = 0; i < field.points; ++i) {
      absorbed_lm[r] += 0.001 * total_lx(field, r, i) * faces.area_m2[i];
    }
  }
  expect_right(absorbed_lm, {web.flux_lm(), 1e-4 * web.flux_lm()}, 0.02);
}

// Walls that absorb nothing, over a floor that does: all light ends in the floor.
TEST(ExtremeReflectance, OneIsRightWhereSomethingElseAbsorbs) {
  const glm::dvec3 size(4, 3, 2.5);
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, size, 1.0);
  scene.reflectance[0] = scene.reflectance[1] = 0.2;  // the floor is the first quad
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  Faces faces = faces_of(size, 12);  // the floor is the fifth face
  const std::size_t cells = 144, first = 4 * cells;
  const calc::SensorGrid floor = points_of(
      {faces.grid.position_m.begin() + first, faces.grid.position_m.begin() + first + cells},
      std::vector<glm::dvec3>(cells, kUp));
  const calc::SpaceSolution solution = solve_with_paths(scene, floor, 3, 2048);
  ASSERT_EQ(solution.fields[0].problem, "");
  const double mean_lx = web.flux_lm() / (0.8 * size.x * size.y);
  expect_right(replicate_averages(solution.fields[0]), {mean_lx, 2.5e-4 * mean_lx}, 0.05);
}

TEST(ExtremeReflectance, NextToNothingAbsorbedIsRefused) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 1.0 - 1e-6);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  const calc::SensorGrid grid = points_of({{2, 1.5, 0.75}}, {kUp});
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 16, 4);
  EXPECT_NE(solution.fields[0].problem.english().find("no steady state"), std::string::npos);
}

TEST(ExtremeReflectance, OneWhiteWallInABlackRoom) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.0);
  scene.reflectance[8] = scene.reflectance[9] = 0.9;  // x = 0
  add_luminaire(scene, web, {1.4, 1.1, 1.9});
  set_extent(scene);
  const OneReflection wall(scene, {0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}, {1, 0, 0}, 0.9);
  const calc::SensorGrid grid =
      points_of({{3, 1.5, 0.75}, {0.01, 1.5, 0.0}, {0.5, 1.0, 1.0}, {2, 1.5, 1.2}},
                {kUp, kUp, {-1, 0, 0}, kDown});
  const calc::SpaceSolution solution = solve_in_looks(scene, grid, 3, 4096);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const glm::dvec3 &x = grid.position_m[i], &n = grid.normal[i];
    expect_right(solution.fields[0], i, {direct_lx(scene.luminaires[0], x, n) + wall.lx(x, n), 0.0},
                 0.02);
  }
}

// Half the intensity 4 degrees off the axis.
calc::PhotometricWeb spot_web() {
  std::vector<double> gamma_rad, cd;
  for (int k = 0; k <= 24; ++k) {
    const double degrees = 0.5 * k;
    gamma_rad.push_back(calc::radians_from_degrees(degrees));
    cd.push_back(k == 24 ? 0.0 : 50000.0 * std::pow(0.5, degrees * degrees / 16.0));
  }
  return calc::PhotometricWeb::make({0.0}, gamma_rad, cd, {}, {});
}

TEST(ExtremeLuminaire, NarrowSpotOverADisc) {
  const calc::PhotometricWeb web = spot_web();
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {6, 6, 5.5}, 0.0);
  scene.reflectance[0] = scene.reflectance[1] = 0.5;  // floor
  add_luminaire(scene, web, {3, 3, 5});
  set_extent(scene);
  calc::SensorGrid grid = points_of({{3, 3, 0}}, {kUp});
  for (int ring = 1; ring <= 2; ++ring) {
    for (int k = 0; k < 6 * ring; ++k) {
      const double angle = 2.0 * calc::kPi * k / (6 * ring);
      grid.position_m.emplace_back(3 + 0.125 * ring * std::cos(angle),
                                   3 + 0.125 * ring * std::sin(angle), 0.0);
      grid.normal.push_back(kUp);
    }
  }
  const std::size_t on_disc = grid.position_m.size();
  for (const glm::dvec3& p :
       {glm::dvec3(4, 3, 2), glm::dvec3(3.5, 3, 0.3), glm::dvec3(5.9, 0.1, 1)})
    grid.position_m.push_back(p);
  grid.normal.resize(grid.position_m.size(), kDown);
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 4096);
  const calc::PlaneField& field = solution.fields[0];
  for (std::size_t i = 0; i < on_disc; ++i) {
    const double offset = glm::length(glm::dvec2(grid.position_m[i]) - glm::dvec2(3, 3));
    const double gamma = std::atan2(offset, 5.0), step = calc::radians_from_degrees(0.5);
    const auto k = static_cast<std::size_t>(gamma / step);
    const double part = gamma / step - static_cast<double>(k);
    const double cd = (1 - part) * web.table_cd(0, k) + part * web.table_cd(0, k + 1);
    const double truth = cd * std::pow(std::cos(gamma), 3) / 25.0;  // nothing reflects onto it
    for (const double lx : replicates_at(field, i)) EXPECT_NEAR(lx / truth, 1.0, 1e-6);
  }
  // The web has corners at every half degree: 4 cm on the floor.
  const OneReflection floor(scene, {0, 0, 0}, {6, 0, 0}, {0, 6, 0}, kUp, 0.5, 0.02);
  for (std::size_t i = on_disc; i < grid.position_m.size(); ++i) {
    expect_right(field, i, {floor.lx(grid.position_m[i], kDown), 0.0}, 0.02);
  }
}

// The wall behind it carries half of the reflected light in a spot of 5 cm.
TEST(ExtremeLuminaire, ThreeCentimetresFromAWall) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.0);
  scene.reflectance[8] = scene.reflectance[9] = 0.8;  // x = 0
  add_luminaire(scene, web, {0.03, 1.5, 1.5});
  set_extent(scene);
  const OneReflection wall(scene, {0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}, {1, 0, 0}, 0.8);
  const calc::SensorGrid grid = points_of(
      {{2, 1.5, 0.75}, {0.06, 1.5, 1.4}, {0.005, 1.5, 1.45}, {0.1, 1.5, 1.5}, {0.001, 0.5, 0.0}},
      {kUp, kUp, kUp, {-1, 0, 0}, kUp});
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 8192);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    const glm::dvec3 &x = grid.position_m[i], &n = grid.normal[i];
    // 4e-4: ray ends stand off surfaces by 6 um, a share of the distances here; and the wall's dark
    // end beside the last point is lit by few paths.
    const double truth = direct_lx(scene.luminaires[0], x, n) + wall.lx(x, n);
    expect_right(solution.fields[0], i, {truth, 1e-4 * truth}, 0.01);
  }
}

TEST(ExtremeLuminaire, InsideAnOpenBox) {
  const calc::PhotometricWeb web = isotropic_web(100.0);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.6);
  const std::size_t before = scene.triangle.size();
  add_box(scene, {1, 1, 0.8}, {1.2, 1.0, 0.7}, 0.7);
  const auto remove = [before](auto& list) {  // its top
    list.erase(list.begin() + before + 2, list.begin() + before + 4);
  };
  remove(scene.triangle);
  remove(scene.reflectance);
  remove(scene.body);
  add_luminaire(scene, web, {1.6, 1.5, 1.2});
  set_extent(scene);
  const calc::SensorGrid grid =
      points_of({{3.0, 1.5, 0.75}, {1.6, 1.5, 0.4}, {1.7, 1.5, 2.4}, {1.05, 1.2, 0.801}},
                {kUp, kUp, kDown, kUp});
  const calc::SpaceSolution solution = solve_in_looks(scene, grid, 3, 8192);
  EXPECT_EQ(solution.fields[0].direct_exact_lx[0], 0.0);
  EXPECT_EQ(solution.fields[0].direct_exact_lx[1], 0.0);
  EXPECT_EQ(solution.balance.escaped_lm.value, 0.0);
  const PathReference reference(scene);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    expect_right(solution.fields[0], i, reference.total(grid.position_m[i], grid.normal[i], 100000),
                 0.12);
  }
}

TEST(ExtremeLuminaire, UplightOnly) {
  const calc::PhotometricWeb web = zone_web(200.0, calc::kPi / 2, calc::kPi);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, {4, 3, 2.5}, 0.7);
  add_luminaire(scene, web, {1, 1, 2});
  set_extent(scene);
  const calc::SensorGrid grid = points_of({{2, 1.5, 0.75}, {1, 1, 1.9}}, {kUp, kUp});
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 4096);
  const PathReference reference(scene);
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    EXPECT_EQ(solution.fields[0].direct_exact_lx[i], 0.0);
    expect_right(solution.fields[0], i, reference.total(grid.position_m[i], kUp, 60000), 0.02);
  }
  scene.reflectance.assign(scene.reflectance.size(), 0.0);
  const calc::SpaceSolution black = solve_with_paths(scene, grid, 3, 64);
  EXPECT_TRUE(black.fields[0].is_exact());  // a true zero, and said to be one
  EXPECT_EQ(black.fields[0].direct_exact_lx[0], 0.0);
}

// The small ones must not drown: they have a channel of their own.
TEST(ExtremeLuminaire, AMillionLumensAmongAThousandLuminaires) {
  const calc::PhotometricWeb web = isotropic_web(1000.0 / (4.0 * calc::kPi));
  calc::PreparedScene scene;
  add_quad(scene, {0, 0, 0}, {80, 0, 0}, {0, 50, 0}, 0.3);
  for (int k = 0; k < 1000; ++k) {
    add_luminaire(scene, web, {1.0 + 2 * (k % 40), 1.0 + 2 * (k / 40), 6.0});
  }
  scene.channels = {{"small", 1.0}, {"large", 1.0}};
  scene.luminaires[420].flux_scale = 1000.0;
  scene.luminaires[420].channel = 1;
  set_extent(scene);
  const calc::SensorGrid grid =
      points_of({{41, 21, 3}, {70, 10, 3}, {70, 10, 0.75}}, {kDown, kDown, kUp});
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 3, 4096);
  const calc::PlaneField& field = solution.fields[0];
  const OneReflection floor(scene, {0, 0, 0}, {80, 0, 0}, {0, 50, 0}, kUp, 0.3);
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<double> lx;
      for (std::size_t r = 0; r < field.replicates; ++r) {
        lx.push_back(field.indirect_lx[(r * 2 + c) * field.points + i]);
      }
      const auto channel = static_cast<std::uint32_t>(c);
      expect_right(lx, {floor.lx(grid.position_m[i], kDown, channel), 0.0}, 0.25);
    }
    double direct = 0.0;
    for (const calc::PlacedLuminaire& l : scene.luminaires) {
      if (l.channel == c) direct += direct_lx(l, grid.position_m[2], kUp);
    }
    EXPECT_NEAR(field.direct_exact_lx[c * field.points + 2] / direct, 1.0, 1e-6);
  }
}

// A channel so weak that its weights vanish in single precision takes no light from the others.
TEST(ExtremeLuminaire, AChannelOfNextToNothingLeavesTheOthersAlone) {
  const calc::PhotometricWeb web = isotropic_web(1000.0 / (4.0 * calc::kPi));
  for (const double weak : {1e-20, 1e-36, 1e-38, 1e-41}) {
    calc::PreparedScene scene;
    add_quad(scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0.5);
    add_luminaire(scene, web, {1, 2, 3});
    add_luminaire(scene, web, {3, 2, 3});
    scene.channels = {{"usual", 1.0}, {"weak", 1.0}};
    scene.luminaires[1].channel = 1;
    scene.luminaires[1].flux_scale = weak;
    set_extent(scene);
    const calc::SensorGrid grid = points_of({{2, 2, 2}}, {kDown});
    const calc::PlaneField field = solve_with_paths(scene, grid, 1, 4096).fields[0];
    const OneReflection floor(scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, kUp, 0.5);
    std::vector<double> lx;
    for (std::size_t r = 0; r < field.replicates; ++r) lx.push_back(field.indirect_at(r, 0, 0));
    expect_right(lx, {floor.lx(grid.position_m[0], kDown, 0), 0.0}, 0.25);
  }
}

}  // namespace
}  // namespace extreme_light_test
