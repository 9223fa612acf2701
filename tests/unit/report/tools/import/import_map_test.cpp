#include "report/tools/import/import_map.h"

#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace import_map_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kMap = R"(
unit = "mm"
name = "House"
ignore = ["X-*"]
[[room]]
layer = "A-AREA"
height = 2.8
reflectances = [0.7, 0.5, 0.2]
[[luminaire]]
type = "LUM*"
photometry = "a.ies"
height = ["attribute:H", "z", 2.5]
flux-lm = 900
[[furniture]]
layer = "A-FURN"
height = 0.75
reflectance = 0.4
[[plane]]
layer = "P"
height = 0.75
[[route]]
layer = "R"
width = 2
)";

std::optional<cli::ImportMap> read(const std::string& text, std::string* messages = nullptr) {
  calc::Diagnostics diagnostics;
  auto map = cli::read_import_map(text, "map.toml", diagnostics);
  EXPECT_EQ(map.has_value(), !diagnostics.has_errors());
  if (messages == nullptr) return map;
  for (const calc::Diagnostic& one : diagnostics.all()) {
    *messages += calc::format_diagnostic(one) + "\n";
  }
  return map;
}

TEST(ImportMap, ReadsAllOfIt) {
  const auto map = read(kMap);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->unit, "mm");
  ASSERT_EQ(map->room.size(), 1u);
  EXPECT_EQ(map->room[0].names, "DLX_*DESC");
  EXPECT_EQ(map->room[0].walls, 0.5);
  EXPECT_EQ(map->room[0].line, 5);
  ASSERT_EQ(map->luminaire.size(), 1u);
  ASSERT_EQ(map->luminaire[0].height.size(), 3u);
  EXPECT_EQ(std::get<cli::FromAttribute>(map->luminaire[0].height[0]).name, "H");
  EXPECT_EQ(std::get<double>(map->luminaire[0].height[2]), 2.5);
  EXPECT_EQ(map->luminaire[0].flux_lm, 900.0);
  EXPECT_EQ(map->route[0].width_m, 2.0);
}

TEST(ImportMap, SaysWhereAndWhatIsAllowed) {
  std::string messages;
  EXPECT_FALSE(read("units = \"mm\"\n", &messages));
  EXPECT_THAT(messages, HasSubstr("map.toml:1"));
  EXPECT_THAT(messages, HasSubstr("did you mean 'unit'?"));
  messages.clear();
  EXPECT_FALSE(read("unit = \"km\"\n[[room]]\nheight = 0\n", &messages));
  EXPECT_THAT(messages, HasSubstr("'km' is not one of m, cm, mm, in or ft"));
  EXPECT_THAT(messages, HasSubstr("a number from 1 to 100 is needed"));
  EXPECT_THAT(messages, HasSubstr("setting 'reflectances': it is needed in each [[room]]"));
  messages.clear();
  EXPECT_FALSE(read("[[furniture]]\nheight = 1\nreflectance = 0.5\n", &messages));
  EXPECT_THAT(messages, HasSubstr("type, layer or both are needed"));
  messages.clear();
  EXPECT_FALSE(read("[room]\nheight = 2.8\n", &messages));
  EXPECT_THAT(messages, HasSubstr("[[room]] is needed"));
  messages.clear();
  EXPECT_FALSE(read("[[luminaire]]\ntype=\"a\"\nphotometry=\"b\"\nheight=\"top\"\n", &messages));
  EXPECT_THAT(messages, HasSubstr("\"z\" or \"attribute:NAME\" is needed"));
  messages.clear();
  EXPECT_FALSE(read("[[room]\n", &messages));
  EXPECT_THAT(messages, HasSubstr("not TOML"));
}

TEST(ImportMap, PatternsMatchWholeNames) {
  EXPECT_TRUE(cli::matches_name("lum_*", "LUM_600x600"));
  EXPECT_TRUE(cli::matches_name("*x*0", "LUM_600x600"));
  EXPECT_TRUE(cli::matches_name("B?ro", "Büro"));
  EXPECT_FALSE(cli::matches_name("LUM", "LUM_1"));
  EXPECT_FALSE(cli::matches_name("", "a"));
  EXPECT_TRUE(cli::matches_bound_name("A-WALL", "xref-house$0$A-WALL"));
  EXPECT_FALSE(cli::matches_bound_name("A-WALL", "xref-house-A-WALL"));
}

TEST(ImportMap, ManualHasEveryKey) {
  EXPECT_THAT(test_support::bytes_of(LUXGATE_MANUAL), HasSubstr(cli::import_map_reference()));
}

}  // namespace
}  // namespace import_map_test
