#include "report/tools/pictures/room_pictures.h"

#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace room_pictures_test {
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
    settings.device.fault = fault;
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
  ASSERT_EQ(once.part.pictures.list.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const report::RoomPicture &a = once.part.pictures.list[k], &b = again.part.pictures.list[k];
    EXPECT_GT(a.png.size(), 1000u);
    EXPECT_EQ(a.png, b.png);
    EXPECT_EQ(a.labelled_png, b.labelled_png);
    EXPECT_EQ(a.exr, b.exr);
  }
  EXPECT_GT(once.part.pictures.highest_lx, 10.0);
  EXPECT_GT(once.part.pictures.error_share, 0.0);
}

// The calculation goes on with it.
TEST(RoomPictures, AreDrawnOnTheDeviceOfTheCalculation) {
  LUXGATE_NEEDS_OPENGL();
  Room own, shared;
  own.draw();
  const auto device = gl_device();
  shared.settings.device.open = device;
  shared.settings.device.choice.is_open = true;
  shared.settings.device.choice.device = 1000;  // not even asked for
  shared.draw();
  ASSERT_EQ(shared.part.pictures.problem, "");
  EXPECT_EQ(shared.part.pictures.list.at(0).png, own.part.pictures.list.at(0).png);
  EXPECT_EQ(shared.part.pictures.device, device->device().name());
  bool has_run = false;
  device->run([&](gpu::DeviceState&) { has_run = true; });
  EXPECT_TRUE(has_run);
}

TEST(RoomPictures, AreDrawnBySoftwareWhereAGpuFails) {
  LUXGATE_NEEDS_OPENGL();
  Room direct, fallen;
  direct.draw();
  std::vector<std::string> warnings;
  fallen.settings.device.choice = {1000, true, true, false, "sooner"};
  fallen.settings.device.warn = [&](const std::string& why) { warnings.push_back(why); };
  fallen.draw();
  ASSERT_EQ(fallen.part.pictures.problem, "");
  EXPECT_EQ(warnings.size(), 1u);
  EXPECT_EQ(fallen.part.pictures.list.at(0).png, direct.part.pictures.list.at(0).png);
  // While it draws: the other fails as well, and the room says so.
  Room lost;
  warnings.clear();
  lost.settings.device.choice = {0, true, true, false, "sooner"};
  lost.settings.device.warn = fallen.settings.device.warn;
  lost.draw(gpu::Fault::context_lost);
  EXPECT_THAT(lost.part.pictures.problem, HasSubstr("the device was reset"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("the device was reset"));
}

TEST(RoomPictures, AreCountedAsTheyAreDrawn) {
  check::ProjectPlan project;
  for (const std::size_t triangles : {12u, 0u, 200u, 1'000'000u}) {
    project.spaces.emplace_back().triangles = triangles;
  }
  const calc::DrawingWork work = cli::picture_work({project, project});
  EXPECT_EQ(work.rooms, 4.0);  // others have none
  EXPECT_GT(work.pixels, 4.0 * 2e6);
  EXPECT_GT(work.triangles, 4.0 * (12.0 + 200.0));
}

TEST(RoomPictures, MakeImagesOnlyIfAskedFor) {
  LUXGATE_NEEDS_OPENGL();
  Room room;
  room.settings.has_files = false;
  room.draw();
  ASSERT_EQ(room.part.pictures.list.size(), 3u);
  EXPECT_EQ(room.part.pictures.list[0].labelled_png, "");
  EXPECT_EQ(room.part.pictures.list[0].exr, "");
}

TEST(RoomPictures, HaveARenderedViewBesideTheFalseColours) {
  LUXGATE_NEEDS_OPENGL();
  Room room;
  room.draw();
  ASSERT_EQ(room.part.pictures.problem, "");
  const std::vector<report::RoomPicture>& list = room.part.pictures.list;
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].name, "corner");
  EXPECT_EQ(list[1].name, "rendered");
  EXPECT_EQ(list[2].name, "plan");
  EXPECT_FALSE(list[0].is_rendered);
  EXPECT_TRUE(list[1].is_rendered);
  EXPECT_EQ(list[1].title, list[0].title);
  // The same view, and smaller.
  EXPECT_LT(list[1].width, list[0].width);
  EXPECT_NEAR(static_cast<double>(list[1].width) / list[1].height,
              static_cast<double>(list[0].width) / list[0].height, 0.01);
  EXPECT_GT(list[1].labelled_png.size(), list[1].png.size() / 2);
  EXPECT_EQ(list[1].exr, "");
}

// Light and luminaires make it, not what planes there are.
TEST(RoomPictures, ShowNoPoints) {
  LUXGATE_NEEDS_OPENGL();
  Room few, many;
  for (int k = 1; k < 20; ++k) {
    report::PointRow& point = many.part.planes[0].points.emplace_back();
    point.position_m = {0.1 * k, 0.7, 0.0};
    point.measured = {900.0, 900.0, 900.0};
  }
  few.draw();
  many.draw();
  ASSERT_EQ(few.part.pictures.list.size(), 3u);
  ASSERT_EQ(many.part.pictures.list.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(few.part.pictures.list[k].png, many.part.pictures.list[k].png) << k;
  }
}

TEST(RoomPictures, HaveTheColoursAskedFor) {
  LUXGATE_NEEDS_OPENGL();
  Room safe, trade;
  trade.settings.map = report::ColourMap::false_colour;
  safe.draw();
  trade.draw();
  ASSERT_EQ(trade.part.pictures.list.size(), 3u);
  EXPECT_EQ(trade.part.pictures.map, report::ColourMap::false_colour);
  EXPECT_NE(safe.part.pictures.list[0].png, trade.part.pictures.list[0].png);
  EXPECT_EQ(safe.part.pictures.list[1].png, trade.part.pictures.list[1].png);
  EXPECT_EQ(safe.part.pictures.list[0].exr, trade.part.pictures.list[0].exr);
}

TEST(RoomPictures, SayWhyThereAreNone) {
  Room room;
  room.draw(gpu::Fault::no_egl);
  EXPECT_THAT(room.part.pictures.problem, HasSubstr("there is no EGL library"));
  EXPECT_TRUE(room.part.pictures.list.empty());
  room.scene.triangle.clear();
  room.draw();
  EXPECT_EQ(room.part.pictures.problem, "the room has no surfaces");
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
}  // namespace room_pictures_test
