#include "report/check/scene_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace scene_levels_test {
namespace {

using check::SceneLevels;
using testing::HasSubstr;

constexpr const char* kProject = R"(<luxgate version="1">
  <!-- <scene id="night"/> is no element -->
  <scene id="night"><dim group='a' level = '0.2'/></scene>
  <scene id="empty"/>
  <room id="room">
    <luminaire id="L1" type="t" group="a"/>
    <luminaire-line id="L2" type="t"/>
    <plane id="desk"><require at-least="300"/><require at-most="60" scene="night"/>
      <require quantity="power-density" at-most="9"/></plane>
  </room>
</luxgate>
)";

std::string changed(const SceneLevels& levels) {
  calc::Diagnostics diagnostics;
  const auto text = check::with_scene_levels(kProject, "p.xml", levels, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return text ? text->text : "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SceneLevels, ReplacesAndAdds) {
  std::string wanted = with(kProject, "level = '0.2'", "level = '0.35'");
  wanted = with(wanted, "<scene id=\"night\">",
                "<scene id=\"night\"><dim group=\"b &amp; c\" level=\"0\"/>");
  EXPECT_EQ(changed({"night", false, {{"a", 0.35}, {"b & c", 0.0}}, ""}), wanted);
}

TEST(SceneLevels, FillsASceneWithoutLevels) {
  EXPECT_EQ(changed({"empty", false, {{"a", 1.0}}, ""}),
            with(kProject, "<scene id=\"empty\"/>",
                 "<scene id=\"empty\"><dim group=\"a\" level=\"1\"/></scene>"));
}

TEST(SceneLevels, MakesASceneOfFullOutput) {
  std::string wanted = with(kProject, "<luxgate version=\"1\">",
                            "<luxgate version=\"1\"><scene id=\"advised\"><dim group=\"a\" "
                            "level=\"0.5\"/><dim group=\"others\" level=\"0.25\"/></scene>");
  wanted = with(wanted, "<require at-least=\"300\"", "<require at-least=\"300\" scene=\"advised\"");
  wanted = with(wanted, "<luminaire-line id=\"L2\" type=\"t\"",
                "<luminaire-line id=\"L2\" type=\"t\" group=\"others\"");
  // The other scene keeps what it asks, and power hangs on no scene.
  EXPECT_EQ(changed({"advised", true, {{"a", 0.5}, {"", 0.25}}, "others"}), wanted);
}

TEST(SceneLevels, RefusesWhatIsNoXml) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(check::with_scene_levels("<luxgate", "p.xml", {"s", false, {}, ""}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace scene_levels_test
