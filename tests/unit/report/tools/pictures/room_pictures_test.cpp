#include "report/tools/pictures/room_pictures.h"

#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace test_support;
using ::testing::HasSubstr;

struct Room {
  calc::PhotometricWeb web = lambert_web(500.0, 18, {calc::OpeningShape::rectangle, 0.6, 0.3, 0.0});
  calc::PreparedScene scene;
  calc::Space space;
  report::SpacePart part;
  cli::PictureSettings settings;

  Room() {
    add_box(scene, {0, 0, 0}, {3, 2, 2.5}, 0.5);
    add_luminaire(scene, web, {1.5, 1.0, 2.49});
    set_extent(scene);
    space.id = part.id = "room";
    space.shell = calc::RoomShell{{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0.0, 2.5};
    settings.has_files = true;
    report::PlanePart& plane = part.planes.emplace_back();
    plane.is_computed = true;
    plane.grid.columns = plane.grid.rows = 2;
    plane.outline_m = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
    for (const glm::dvec2 p : {glm::dvec2(1, 0.5), {2, 0.5}, {1, 1.5}, {2, 1.5}}) {
      report::PointRow& point = plane.points.emplace_back();
      point.position_m = {p, 0.0};
      point.measured = {100.0, 100.0, 100.0};
    }
  }
  void draw(gpu::Fault fault = gpu::Fault::none) {
    settings.gl_fault = fault;
    cli::PictureMaker maker(settings, {});
    maker.add_pictures("a.xml", space, scene, part);
  }
};

TEST(RoomPictures, AreTheSameBytesAgain) {
  LUXGATE_NEEDS_OPENGL();
  Room once, again;
  once.settings.jobs = 1;
  again.settings.jobs = 3;
  once.draw();
  again.draw();
  ASSERT_EQ(once.part.pictures.problem, "");
  ASSERT_EQ(once.part.pictures.list.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const report::RoomPicture &a = once.part.pictures.list[k], &b = again.part.pictures.list[k];
    EXPECT_GT(a.png.size(), 1000u);
    EXPECT_EQ(a.png, b.png);
    EXPECT_EQ(a.labelled_png, b.labelled_png);
    EXPECT_EQ(a.exr, b.exr);
  }
  EXPECT_GT(once.part.pictures.highest_lx, 10.0);
  EXPECT_GT(once.part.pictures.error_share, 0.0);
}

TEST(RoomPictures, MakeImagesOnlyIfAskedFor) {
  LUXGATE_NEEDS_OPENGL();
  Room room;
  room.settings.has_files = false;
  room.draw();
  ASSERT_EQ(room.part.pictures.list.size(), 2u);
  EXPECT_EQ(room.part.pictures.list[0].labelled_png, "");
  EXPECT_EQ(room.part.pictures.list[0].exr, "");
}

TEST(RoomPictures, SayWhyThereAreNone) {
  Room room;
  room.draw(gpu::Fault::no_egl);
  EXPECT_THAT(room.part.pictures.problem, HasSubstr("there is no EGL library"));
  EXPECT_TRUE(room.part.pictures.list.empty());
  room.scene.triangle.clear();
  room.draw();
  EXPECT_EQ(room.part.pictures.problem, "it has no surfaces");
  LUXGATE_NEEDS_OPENGL();
  Room lost;
  lost.draw(gpu::Fault::context_lost);
  EXPECT_THAT(lost.part.pictures.problem, HasSubstr("the device was reset"));
  EXPECT_TRUE(lost.part.pictures.list.empty());
}

TEST(RoomPictures, AreWantedWhereTheyCanBePut) {
  cli::OutputOptions options;
  EXPECT_FALSE(cli::wants_pictures(options));
  options.folder = "out";  // has report.html
  EXPECT_TRUE(cli::wants_pictures(options));
  options = {};
  options.formats = {{report::find_format("json"), "a.json"}};
  EXPECT_FALSE(cli::wants_pictures(options));
  options.formats = {{report::find_format("html"), ""}};
  EXPECT_TRUE(cli::wants_pictures(options));
}

TEST(RoomPictures, VerticesAreDrawn) {
  LUXGATE_NEEDS_OPENGL();
  const Room room;
  const calc::Tracer tracer(room.scene);
  const std::vector<calc::LightVertex> vertices{{{1, 1, 0}, 4.0f, {0, 0, 1}, 0}};
  const auto device = gl_device();
  const report::Raster with = cli::draw_vertices(*device, tracer, vertices, true);
  const report::Raster without = cli::draw_vertices(*device, tracer, {}, true);
  EXPECT_EQ(with.width, 1400);
  EXPECT_EQ(with.rgba.size(), without.rgba.size());
  EXPECT_NE(with.rgba, without.rgba);
}

}  // namespace
