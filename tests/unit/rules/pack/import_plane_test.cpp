#include "rules/pack/import_plane.h"

#include <gtest/gtest.h>

namespace rules::import_plane_test {
namespace {

void expect_plane(const char* text, bool is_upright, double lowest_m, double highest_m) {
  const std::optional<TaskPlane> plane = parse_task_plane(text);
  ASSERT_TRUE(plane.has_value()) << text;
  EXPECT_EQ(plane->is_upright, is_upright) << text;
  ASSERT_TRUE(plane->heights_m.has_value()) << text;
  EXPECT_NEAR(plane->heights_m->lowest_m, lowest_m, 1e-12) << text;
  EXPECT_NEAR(plane->heights_m->highest_m, highest_m, 1e-12) << text;
}

TEST(ImportPlane, FloorsAreAsInTheShippedPacks) {
  for (const char* text : {"floor", "Floor", " on the  floor", "on_the_floor", "ground"}) {
    expect_plane(text, false, 0.0, 0.2);
  }
  expect_plane("floor 0 to 0.1 m", false, 0.0, 0.1);
}

TEST(ImportPlane, DesksHaveTheHeightOfTheRole) {
  for (const char* text : {"", "desk", "horizontal task plane", "Horizontal", "task-area"}) {
    const std::optional<TaskPlane> plane = parse_task_plane(text);
    ASSERT_TRUE(plane.has_value()) << text;
    EXPECT_FALSE(plane->is_upright) << text;
    EXPECT_FALSE(plane->heights_m.has_value()) << text;
  }
}

TEST(ImportPlane, UprightOnesMayHaveAHeight) {
  for (const char* text : {"vertical", "shelf", "Board", "rack face", "upright"}) {
    const std::optional<TaskPlane> plane = parse_task_plane(text);
    ASSERT_TRUE(plane.has_value()) << text;
    EXPECT_TRUE(plane->is_upright) << text;
    EXPECT_FALSE(plane->heights_m.has_value()) << text;
  }
  expect_plane("vertical at 1.6 m", true, 1.6, 1.6);
  expect_plane("board 0.8-2 m", true, 0.8, 2.0);
}

TEST(ImportPlane, HeightsHaveAUnit) {
  expect_plane("1.6 m", false, 1.6, 1.6);
  expect_plane("at 1.1m above the floor", false, 1.1, 1.1);
  expect_plane("85 cm", false, 0.85, 0.85);
  expect_plane("0.4 to 0.6 m", false, 0.4, 0.6);
  for (const char* text : {"1.6", "floor 1.6", "2 to 1 m", "1.6 km", "the moon", "1.2.3 m",
                           "sideways 1 m", "1 to m", "0.5 ft", "-1 m", "upright -1 m"}) {
    EXPECT_FALSE(parse_task_plane(text).has_value()) << text;
  }
}

TEST(ImportPlane, ChoicesAreUnderstood) {
  EXPECT_EQ(task_plane_choices(), "desk, floor, vertical, a height such as '1.1 m', or both");
}

TEST(ImportPlane, WordsNameWhatIsAllowed) {
  const std::string words = task_plane_words();
  for (const char* word : {"floor", "vertical", "desk", "1.1 m"}) {
    EXPECT_NE(words.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace rules::import_plane_test
