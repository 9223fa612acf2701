#include "report/images/room_picture.h"

#include "report/html/room/html_room.h"
#include "report/images/exr.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace room_picture_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Two pixels beside each other: one with a surface of 150 lx, one of which a quarter is covered.
report::DrawnRoom drawn() {
  report::DrawnRoom room{4, 2, std::vector<float>(8, -1.0F), std::vector<std::uint8_t>(32, 0)};
  for (const std::size_t i : {0u, 1u, 4u, 5u}) room.lx[i] = 150.0F;
  room.cover[4 * 2] = 100;
  room.cover[4 * 2 + 3] = 255;
  return room;
}

TEST(RoomPicture, PaintsBandsAndCover) {
  const report::Palette palette{{{10, 20, 30}, {40, 50, 60}}, 100.0F};
  const report::Raster raster = report::paint_room(drawn(), palette);
  EXPECT_EQ(raster.width, 2);
  EXPECT_EQ(raster.height, 1);
  EXPECT_THAT(raster.rgba, ::testing::ElementsAre(40, 50, 60, 255, 100, 0, 0, 64));
}

TEST(RoomPicture, WhatIsNoNumberHasNoColour) {
  report::DrawnRoom room{2, 2, std::vector<float>(4, std::numeric_limits<float>::quiet_NaN()),
                         std::vector<std::uint8_t>(16, 0)};
  const report::Palette palette{{{10, 20, 30}, {40, 50, 60}}, 100.0F};
  EXPECT_THAT(report::paint_room(room, palette).rgba, ::testing::ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(report::mean_values(room), ::testing::ElementsAre(-1.0F));
  room.lx[0] = std::numeric_limits<float>::infinity();
  room.lx[1] = 400.0F;
  EXPECT_EQ(report::room_scale({&room, 1}).high(), 400.0);
}

TEST(RoomPicture, MeanValuesLeaveOutWhatIsNotThere) {
  report::DrawnRoom room = drawn();
  room.lx[1] = -1.0F;
  room.lx[0] = 120.0F;
  EXPECT_THAT(report::mean_values(room), ::testing::ElementsAre(140.0F, -1.0F));
}

TEST(RoomPicture, ScaleBeginsAtZeroAndLeavesOutTheBrightestFew) {
  report::DrawnRoom room{100, 2, std::vector<float>(200, 400.0F), {}};
  room.lx[7] = 9000.0F;
  const report::ColourScale scale = report::room_scale({&room, 1});
  EXPECT_EQ(scale.low, 0.0);
  EXPECT_EQ(scale.high(), 400.0);
  EXPECT_EQ(scale.step, 50.0);
}

TEST(RoomPicture, LegendIsBelow) {
  const report::Raster plain = report::paint_room(
      {400, 200, std::vector<float>(80'000, 0.0F), std::vector<std::uint8_t>(320'000, 0)},
      {{{1, 2, 3}}, 1.0F});
  const report::Raster raster = report::with_legend(plain, {0.0, 100.0, 4});
  EXPECT_GT(raster.width, plain.width);
  EXPECT_GT(raster.height, plain.height + 30);
  const auto at = [&](int x, int y) {
    return std::array<int, 4>{raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x)],
                              raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x) + 1],
                              raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x) + 2],
                              raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x) + 3]};
  };
  EXPECT_EQ(at(0, 0), (std::array<int, 4>{255, 255, 255, 255}));
  EXPECT_EQ(at(24, 24), (std::array<int, 4>{1, 2, 3, 255}));
  const report::Rgb first = report::band_colour({0.0, 100.0, 4}, 0);
  EXPECT_EQ(at(40, plain.height + 52), (std::array<int, 4>{first.r, first.g, first.b, 255}));
}

// A title above and a note below move the picture and make room; outlines lie on it.
TEST(RoomPicture, FramesHaveTitleNoteAndOutlines) {
  report::Raster plain{400, 200, {}};
  plain.rgba.assign(std::size_t{4} * 400 * 200, 200);
  for (std::size_t k = 3; k < plain.rgba.size(); k += 4) plain.rgba[k] = 255;
  report::PictureFrame frame;
  const report::Raster bare = report::with_frame(plain, frame);
  EXPECT_EQ(bare.height, 200 + 2 * 24);
  frame.title = "Büro – Fläche";
  frame.note = "a note";
  frame.outlines = {{{100, 50}, {300, 50}, {300, 150}, {100, 150}}};
  const report::Raster framed = report::with_frame(plain, frame);
  EXPECT_GT(framed.height, bare.height + 50);
  EXPECT_EQ(framed.height - bare.height,
            report::with_legend(plain, {}, frame).height - report::with_legend(plain, {}).height);
  const auto dark = [&](int left, int top, int width, int height) {
    int count = 0;
    for (int y = top; y < top + height; ++y) {
      for (int x = left; x < left + width; ++x) {
        if (framed.rgba[4 * static_cast<std::size_t>(y * framed.width + x)] < 100) ++count;
      }
    }
    return count;
  };
  EXPECT_GT(dark(0, 0, framed.width, 55), 100);                    // the title
  EXPECT_GT(dark(0, 270, framed.width, framed.height - 270), 40);  // the note
  const int top = 24 + 36;
  EXPECT_GT(dark(24 + 110, top + 48, 180, 4), 300);  // upper side of the outline
  EXPECT_EQ(dark(24 + 110, top + 60, 180, 80), 0);   // inside
}

TEST(RoomPicture, LongTitlesAreCut) {
  const report::Raster raster = report::with_frame({}, {std::string(300, 'W'), {}, "lx", {}});
  EXPECT_EQ(raster.width, 480 + 48);
  for (int y = 0; y < raster.height; ++y) {
    for (int x = raster.width - 20; x < raster.width; ++x) {
      EXPECT_EQ(raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x)], 255);
    }
  }
}

// Of a scale with long numbers as many as have room, with blanks between them.
TEST(RoomPicture, LegendHasNumbersThatCanBeRead) {
  const report::Raster raster = report::with_legend({}, {0.0, 0.012345678, 12});
  const auto is_ink = [&](int x, int y) {
    return raster.rgba[4 * static_cast<std::size_t>(y * raster.width + x)] < 128;
  };
  // Below the bar there is nothing but the numbers.
  int numbers = 0, blank = 0;
  bool was_ink = false;
  for (int x = 0; x < raster.width; ++x) {
    bool has_ink = false;
    for (int y = raster.height - 42; y < raster.height; ++y) has_ink = has_ink || is_ink(x, y);
    if (has_ink && (!was_ink || blank >= 8)) ++numbers;
    was_ink = was_ink || has_ink;
    blank = has_ink ? 0 : blank + 1;
  }
  EXPECT_GE(numbers, 4);
  EXPECT_LE(numbers, 12);
}

TEST(RoomPicture, ExrHoldsLux) {
  const std::string bytes =
      report::render_room_exr("a.xml", "room", "seen from above", 2, 1, {12.5F, -1.0F});
  EXPECT_THAT(bytes, HasSubstr("luxgate.picture"));
  EXPECT_EQ(bytes,
            report::render_room_exr("a.xml", "room", "seen from above", 2, 1, {12.5F, -1.0F}));
  EXPECT_THROW(report::render_room_exr("a.xml", "r", "t", 0, 0, {}), std::runtime_error);
}

TEST(HtmlRoom, ShowsPicturesOrSaysWhyNot) {
  report::SpacePart space;
  space.id = "r<1>";
  EXPECT_EQ(report::html_room({}, space), "");
  space.pictures.problem = "no <GL>";
  EXPECT_THAT(report::html_room({}, space), HasSubstr("No pictures of this room: no &lt;GL&gt;."));
  space.pictures = {};
  report::RoomPicture picture;
  picture.title = "seen from above";
  picture.width = 10;
  picture.height = 20;
  picture.png = "abc";
  space.pictures.list.push_back(picture);
  space.pictures.step_lx = 100.0;
  space.pictures.bands = 5;
  space.pictures.highest_lx = 1234.0;
  space.pictures.error_share = 0.012;
  space.pictures.device = "OpenGL <1>";
  const std::string html = report::html_room({}, space);
  EXPECT_THAT(html, HasSubstr("base64,YWJj\" width=\"10\" height=\"20\" alt=\"r&lt;1&gt; seen"));
  EXPECT_THAT(html, HasSubstr("reach 1234 lx"));
  EXPECT_THAT(html, HasSubstr("Colour scale from 0 to 500 lx"));
  EXPECT_THAT(html, HasSubstr("fill=\"#00204d\""));
  EXPECT_THAT(html, Not(HasSubstr("Rendered view")));
  EXPECT_THAT(html, HasSubstr("sharpness of shadows. Drawn by OpenGL &lt;1&gt;.</figcaption>"));
  picture.is_rendered = true;
  space.pictures.list.push_back(picture);
  space.pictures.map = report::ColourMap::false_colour;
  const std::string both = report::html_room({}, space);
  EXPECT_THAT(both, HasSubstr("r&lt;1&gt; seen from above, rendered view\""));
  EXPECT_THAT(both, HasSubstr("Rendered view: the same light as luminance of matt grey surfaces"));
  EXPECT_THAT(both, HasSubstr("fill=\"#1428b4\""));
  // Pages for clients have what is common to all rooms once.
  const std::string brief = report::html_room({}, space, true);
  EXPECT_THAT(brief,
              HasSubstr("on surfaces, sampling error 1.2 %. The brightest places reach 1234"));
  EXPECT_THAT(brief, Not(HasSubstr("shadows")));
  EXPECT_THAT(brief, Not(HasSubstr("Drawn by")));
  // Two digits, and never less than it is.
  space.pictures.error_share = 0.12477;
  EXPECT_THAT(report::html_room({}, space, true), HasSubstr("sampling error 13 %."));
  space.pictures.error_share = 0.01234;
  EXPECT_THAT(report::html_room({}, space, true), HasSubstr("sampling error 1.3 %."));
}

}  // namespace
}  // namespace room_picture_test
