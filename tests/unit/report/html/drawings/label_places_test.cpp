// Labels of drawings cover nothing.
#include "report/html/drawings/label_places.h"

#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace report::label_places_test {
namespace {

using Outline = std::vector<glm::dvec2>;

Outline rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

LabelPlaces paper() { return LabelPlaces({{0, 0}, {180, 200}}); }

bool is_inside(const LabelBox& box, double x, double y, double width, double height) {
  return box.low.x >= x && box.low.y >= y && box.high.x <= x + width && box.high.y <= y + height;
}

TEST(LabelPlaces, TakeTheFirstSizeThatFitsInTheMiddle) {
  LabelPlaces places = paper();
  const Outline room = rectangle(20, 20, 30, 10);
  places.take_outline(room);
  const std::optional<LabelPlace> place = places.put_inside(room, {{40, 4}, {12, 4}, {2, 2}});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->form, 1U);
  EXPECT_EQ(place->middle, glm::dvec2(35, 25));
}

TEST(LabelPlaces, KeepAwayFromWhatIsTaken) {
  LabelPlaces places = paper();
  const Outline room = rectangle(20, 20, 30, 10);
  places.take_outline(room);
  const LabelBox lamp = box_around({35, 25}, {3, 3});
  places.take(lamp);
  const std::optional<LabelPlace> place = places.put_inside(room, {{12, 4}});
  ASSERT_TRUE(place);
  const LabelBox box = box_around(place->middle, {12, 4});
  EXPECT_FALSE(box.meets(lamp));
  EXPECT_TRUE(is_inside(box, 20, 20, 30, 10));
}

// Of both ways up, and where they begin and end beside the paper.
TEST(LabelPlaces, LabelsKeepAwayFromLinesThatLean) {
  for (const double slope : {0.02, 0.7, 1.0, 3.0, -0.3, -9.0}) {
    LabelPlaces places = paper();
    const glm::dvec2 way(1.0, slope), middle(90, 100);
    places.take_line(middle - 400.0 * way, middle + 400.0 * way);
    for (double x = 1.0; x < 179.0; x += 0.37) {
      const glm::dvec2 on(x, middle.y + slope * (x - middle.x));
      if (on.y < 1.0 || on.y > 199.0) continue;
      EXPECT_FALSE(places.is_free(box_around(on, {0.1, 0.1}))) << slope << " at " << x;
      EXPECT_TRUE(
          places.is_crossed(on - glm::dvec2(-0.1 * slope, 0.1), on + glm::dvec2(-0.1 * slope, 0.1)))
          << slope << " at " << x;
    }
  }
}

TEST(LabelPlaces, AnLHasItsLabelInOneOfItsArms) {
  LabelPlaces places = paper();
  const Outline room{{20, 20}, {80, 20}, {80, 30}, {30, 30}, {30, 80}, {20, 80}};
  places.take_outline(room);
  const std::optional<LabelPlace> place = places.put_inside(room, {{20, 5}});
  ASSERT_TRUE(place);
  EXPECT_TRUE(is_inside(box_around(place->middle, {20, 5}), 20, 20, 60, 10));
}

// Its area is a rounding error, by which its centroid is 1e17 mm away.
TEST(LabelPlaces, AnOutlineThatCrossesItselfEndsSoon) {
  LabelPlaces places = paper();
  const Outline crossed{{0, 0}, {5, 47}, {71, 33}, {68.9, 76.7}};
  places.take_outline(crossed);
  const std::optional<LabelPlace> place = places.put_inside(crossed, {{2, 1}});
  ASSERT_TRUE(place);
  EXPECT_TRUE(is_inside(box_around(place->middle, {2, 1}), 0, 0, 71, 76.7));
}

TEST(LabelPlaces, NothingFitsIntoATooSmallRoom) {
  LabelPlaces places = paper();
  const Outline room = rectangle(20, 20, 4, 4);
  places.take_outline(room);
  EXPECT_FALSE(places.put_inside(room, {{5, 2}}));
  EXPECT_FALSE(places.put_inside({{20, 20}, {30, 20}}, {{1, 1}}));
}

TEST(LabelPlaces, BesideIsOutsideWithALeader) {
  LabelPlaces places = paper();
  const Outline room = rectangle(90, 90, 4, 4);
  places.take_outline(room);
  const std::optional<LeaderPlace> place = places.put_beside(room, {8, 3});
  ASSERT_TRUE(place);
  const LabelBox box = box_around(place->middle, {8, 3});
  EXPECT_FALSE(box.meets({{90, 90}, {94, 94}}));
  EXPECT_EQ(place->to, glm::dvec2(92, 92));
  EXPECT_EQ(place->from, glm::clamp(place->to, box.low, box.high));
}

TEST(LabelPlaces, NoLabelsOverlapOnCrowdedPaper) {
  LabelPlaces places = paper();
  std::vector<Outline> rooms;
  for (int i = 0; i < 240; ++i) {
    rooms.push_back(rectangle(8 + 11 * (i % 15), 8 + 11 * (i / 15), 5 + i % 6, 5 + i % 5));
    places.take_outline(rooms.back());
  }
  const std::vector<glm::dvec2> sizes{{12, 5}, {9, 3}, {3, 9}, {6, 3}};
  std::vector<LabelBox> boxes;
  std::size_t inside = 0;
  for (const Outline& room : rooms) {
    if (const auto place = places.put_inside(room, sizes)) {
      boxes.push_back(box_around(place->middle, sizes[place->form]));
      EXPECT_TRUE(is_inside(boxes.back(), room[0].x, room[0].y, room[2].x - room[0].x,
                            room[2].y - room[0].y));
      ++inside;
    } else if (const auto beside = places.put_beside(room, sizes.back())) {
      boxes.push_back(box_around(beside->middle, sizes.back()));
    }
  }
  EXPECT_GT(inside, 100U);
  EXPECT_GT(boxes.size(), inside);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].meets(boxes[j])) << i << " " << j;
  }
}

TEST(LabelPlaces, WaysThroughWallsAreCrossed) {
  LabelPlaces places = paper();
  places.take_line({50, 0}, {50, 100});
  EXPECT_TRUE(places.is_crossed({40, 50}, {60, 52}));
  EXPECT_FALSE(places.is_crossed({40, 50}, {49, 52}));
  EXPECT_FALSE(places.is_crossed({40, 150}, {60, 152}));
}

TEST(LabelPlaces, HugeBoxesDoNoHarm) {
  LabelPlaces places = paper();
  places.take({{-1e300, 50}, {1e300, 52}});
  places.take_line({-1e6, 80}, {1e6, 80});
  EXPECT_FALSE(places.is_free(box_around({90, 51}, {2, 2})));
  EXPECT_FALSE(places.is_free(box_around({90, 80}, {2, 2})));
  EXPECT_TRUE(places.is_free(box_around({90, 60}, {2, 2})));
  EXPECT_FALSE(places.is_free(box_around({179.5, 60}, {2, 2})));  // beyond the paper
}

}  // namespace
}  // namespace report::label_places_test
