#include "report/tools/geometry/geometry.h"
#include "tests/support/memory_file_reader.h"
#include "tests/support/mesh_samples.h"

#include <gtest/gtest.h>

#include <string>

namespace cli::geometry_test {
namespace {

// The cube 0..size as an OBJ file; the last `open` of its six sides are missing.
std::string cube(int size, int open = 0) {
  const char* const sides[] = {"1 2 4 3", "5 6 8 7", "1 2 6 5", "3 4 8 7", "1 3 7 5", "2 4 8 6"};
  std::string text = "o cube\nusemtl paint\n";
  for (int i = 0; i < 8; ++i) {
    text += fmt::format("v {} {} {}\n", size * (i & 1), size * (i >> 1 & 1), size * (i >> 2 & 1));
  }
  for (int side = 0; side < 6 - open; ++side) text += fmt::format("f {}\n", sides[side]);
  return text;
}

GeometryReport examine(const std::string& bytes, const std::string& units = "m") {
  GeometryOptions options;
  options.mesh_units = units;
  options.mesh_up = "z";
  return examine_geometry("dir/a.obj", calc::MemoryFileReader({{"dir/a.obj", bytes}}), options);
}

std::string ids(const GeometryReport& report) {
  std::string text;
  for (const calc::Diagnostic& d : report.diagnostics) text += calc::diagnostic_name(d.id) + " ";
  return text;
}

TEST(Geometry, NothingLeavesAClosedCube) {
  const GeometryReport report = examine(cube(3));
  ASSERT_EQ(report.surfaces.size(), 1u);
  const SurfaceReport& surface = report.surfaces[0];
  EXPECT_TRUE(surface.findings.is_watertight);
  EXPECT_DOUBLE_EQ(surface.escape.inside_share, 1.0);
  EXPECT_EQ(surface.escape.points, 4096u);
  EXPECT_EQ(surface.escape.share.value, 0.0);
  EXPECT_EQ(surface.escape.share.low, 0.0);
  EXPECT_NEAR(surface.escape.share.high, 3.84 / 4100.0, 1e-5);
  EXPECT_EQ(ids(report), "");
}

// By symmetry a sixth of the light from points spread over a cube meets each of its sides.
TEST(Geometry, ASixthLeavesACubeWithoutOneSide) {
  const GeometryReport report = examine(cube(3, 1));
  const Escape& escape = report.surfaces.at(0).escape;
  // Points near the open side, from which most directions lead out, do not count as inside.
  EXPECT_LT(escape.inside_share, 1.0);
  EXPECT_GT(escape.inside_share, 0.9);
  EXPECT_LT(escape.share.low, 1.0 / 6.0);
  EXPECT_GT(escape.share.high, 0.12);
  EXPECT_GT(escape.share.low, 0.11);
  // As all 32 rays of every point say: those that are left out change nothing.
  EXPECT_DOUBLE_EQ(escape.inside_share, 4096.0 / 4212.0);
  EXPECT_DOUBLE_EQ(escape.share.value, 659.0 / 4096.0);
  EXPECT_EQ(ids(report), "surface-leaks ");
}

// An L of 4 x 4 without a quarter: the notch is in the bounding box, but not in the room.
TEST(Geometry, TheNotchOfAnLIsNotInside) {
  const std::string project =
      "<luxgate version='1'><material id='w' reflectance='0.5'/>"
      "<room id='r' footprint='0 0  4 0  4 2  2 2  2 4  0 4' height='2.5' ceiling='w' walls='w' "
      "floor='w'/></luxgate>";
  const GeometryReport report =
      examine_geometry("p.xml", calc::MemoryFileReader({{"p.xml", project}}), GeometryOptions());
  EXPECT_NEAR(report.surfaces.at(0).escape.inside_share, 0.75, 0.02);
  EXPECT_EQ(report.surfaces[0].escape.share.value, 0.0);
}

TEST(Geometry, ASheetHasNoInside) {
  const GeometryReport report = examine(cube(3, 5));
  EXPECT_EQ(report.surfaces.at(0).escape.points, 0u);
  EXPECT_EQ(ids(report), "");
}

TEST(Geometry, UnitsMustBeGivenForFilesThatDoNotSayThem) {
  const GeometryReport report = examine(cube(3), "");
  EXPECT_FALSE(report.is_readable());
  EXPECT_EQ(calc::format_diagnostic(report.diagnostics.at(0)),
            "dir/a.obj: error[geometry-needs]: obj files do not say their unit: give --units m, "
            "cm, mm, in or ft");
  const GeometryReport gltf =
      examine_geometry("dir/t.gltf",
                       calc::MemoryFileReader({{"dir/t.gltf", calc::tests::kSquareGltf},
                                               {"dir/tile.bin", calc::tests::square_bytes()}}),
                       GeometryOptions());
  EXPECT_EQ(gltf.kind, "gltf");
  EXPECT_EQ(gltf.up, "y");
  EXPECT_DOUBLE_EQ(gltf.surfaces.at(0).findings.bounds_m.upper.z, 2.0);
}

TEST(Geometry, WrongUnitsAreSuspected) {
  EXPECT_EQ(ids(examine(cube(3000))), "surface-too-large surface-far-away ");
  EXPECT_EQ(ids(examine(cube(3), "mm")), "surface-too-small ");
  EXPECT_EQ(ids(examine(cube(3000), "mm")), "");
}

TEST(Geometry, RoomsOfProjectsAreClosed) {
  const std::string project =
      "<luxgate version='1'><material id='w' reflectance='0.5'/>"
      "<room id='r' name='Hall' size='4 3 2.5' ceiling='w' walls='w' floor='w'>"
      "<box id='b' size='1 1 1' position='1 1 0.5' material='w'/></room></luxgate>";
  const GeometryReport report =
      examine_geometry("p.xml", calc::MemoryFileReader({{"p.xml", project}}), GeometryOptions());
  EXPECT_EQ(report.kind, "project");
  ASSERT_EQ(report.surfaces.size(), 1u);
  EXPECT_EQ(report.surfaces[0].id, "r");
  EXPECT_TRUE(report.surfaces[0].is_room);
  EXPECT_TRUE(report.surfaces[0].findings.is_watertight);
  EXPECT_EQ(report.surfaces[0].findings.objects.size(), 7u);
  EXPECT_EQ(report.surfaces[0].escape.share.value, 0.0);
  EXPECT_NE(render_geometry_json({report}).find("\"watertight\": true"), std::string::npos);
}

}  // namespace
}  // namespace cli::geometry_test
