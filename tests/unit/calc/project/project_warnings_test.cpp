// What is allowed but hardly meant: each warning just beyond its limit, and none just within.

#include "calc/project/project_warnings.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

namespace calc::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// 100 cd straight down from an opening of 0.6 m x 0.6 m.
const std::string kPanelIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0.6 0.6 0\n1 1 12\n0 90\n0\n100 0\n";

std::string messages(const std::string& xml) {
  MemoryFileReader files = project_files(xml);
  files.add("dir/panel.ies", kPanelIes);
  files.add("dir/up.csv", "x,y,z,nx,ny,nz\n1,1,1,0,0,-1\n2,1,1,0,0,-1\n");
  files.add("dir/mixed.csv", "x,y,z,nx,ny,nz\n1,1,1,0,0,-1\n2,1,1,0,0,1\n");
  return load(files).messages;
}

// With a luminaire type "panel" of an opening of 0.6 m x 0.6 m.
std::string messages_in_room(const std::string& lines) {
  return messages(
      in_room("</room><luminaire-type id=\"panel\" photometry=\"panel.ies\"/>\n"
              "<room id=\"q\" origin=\"10 0 0\" size=\"4 3 2.5\" ceiling=\"white\" "
              "walls=\"white\" floor=\"white\">\n" +
              lines));
}

std::string room_of_size(const std::string& size) {
  return messages(in_project(
      fmt::format("<room id=\"r\" size=\"{}\" ceiling=\"white\" walls=\"white\" floor=\"white\">\n"
                  "<luminaire id=\"l\" type=\"spot\" position=\"0.1 0.1 0.2\"/>\n"
                  "<plane id=\"task\" height=\"0.1\"/>\n</room>",
                  size)));
}

TEST(ProjectWarnings, ARoomOfUnusualSizeMayHaveTheWrongUnit) {
  EXPECT_EQ(room_of_size("4000 3 2.5"),
            "dir/p.xml:4:1: warning[room-size-unusual]: room 'r' is 4000 m x 3 m and 2.5 m high; "
            "usual are sides from 0.3 to 500 m and heights from 0.3 to 100 m: is the unit right?");
  EXPECT_THAT(room_of_size("500.1 3 2.5"), HasSubstr("room-size-unusual"));
  EXPECT_THAT(room_of_size("3 500.1 2.5"), HasSubstr("room-size-unusual"));
  EXPECT_THAT(room_of_size("3 3 100.1"), HasSubstr("room-size-unusual"));
  EXPECT_THAT(room_of_size("0.29 3 2.5"), HasSubstr("room-size-unusual"));
  EXPECT_THAT(room_of_size("3 3 0.29"), HasSubstr("room-size-unusual"));
  EXPECT_EQ(room_of_size("500 499.9 100"), "");
  EXPECT_EQ(room_of_size("0.3 0.31 0.3"), "");
}

TEST(ProjectWarnings, OfManyUnusualRoomsThreeAreNamed) {
  std::string rooms;
  for (int k = 0; k < 7; ++k) {
    rooms += fmt::format(
        "<room id=\"r{}\" size=\"4000 3 2.5\" ceiling=\"white\" walls=\"white\" "
        "floor=\"white\"/>\n",
        k);
  }
  const std::string text = messages(in_room("</room>" + rooms + R"(<room id="q" size="4 3 2.5"
 ceiling="white" walls="white" floor="white">)"));
  EXPECT_THAT(text, HasSubstr("room 'r2' (and 4 more rooms) is 4000 m"));
  EXPECT_THAT(text, Not(HasSubstr("room 'r3'")));
}

std::string with_second_luminaire(const std::string& rest) {
  return messages(in_room("<luminaire id=\"k\" type=\"spot\" " + rest + "/>"));
}

TEST(ProjectWarnings, ALuminaireThatWasPastedTwiceIsNamedWithTheFirst) {
  EXPECT_EQ(with_second_luminaire(R"(position="2 1.5 2.5")"),
            "dir/p.xml:6:1: warning[luminaires-coincide]: luminaire 'l' stands where 'k' of line 5 "
            "does, within 10 mm, with the same type and aim: pasted twice? delete one of them, or "
            "move it");
  EXPECT_THAT(with_second_luminaire(R"(position="2.009 1.5 2.5")"), HasSubstr("coincide"));
  EXPECT_EQ(with_second_luminaire(R"(position="2.011 1.5 2.5")"), "");
  EXPECT_EQ(with_second_luminaire(R"(position="2 1.5 2.5" aim="0 0 0")"), "");  // two heads
}

TEST(ProjectWarnings, OtherTypesAtOnePlaceAreOneLuminaireInTwoParts) {
  EXPECT_EQ(messages(in_room(R"(<luminaire id="k" type="up" position="2 1.5 2.5"/></room>
<luminaire-type id="up" photometry="spot.ies"/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)")),
            "");
}

TEST(ProjectWarnings, FurtherPastedLuminairesAreCounted) {
  const std::string grid =
      R"(<luminaire-grid id="g" type="spot" origin="0 0 2" size="4 3" rows="2" columns="3"/>)";
  EXPECT_THAT(messages(in_room(grid + "\n<!-- -->" + grid.substr(0, 20) + "h" + grid.substr(21))),
              HasSubstr("same type and aim (and 5 more luminaires of this space likewise)"));
}

TEST(ProjectWarnings, ALuminaireInASolidIsNamedWithIt) {
  const std::string lines =
      R"(<box id="beam" size="1 1 0.2" position="0.5 0.5 2.3" material="white"/>)";
  EXPECT_THAT(messages(in_room(lines + R"(<luminaire id="k" type="spot" position="1 1 2.4"/>)")),
              HasSubstr("warning[luminaire-in-solid]: luminaire 'k' is inside the solid 'beam'"));
  // Flush with it.
  EXPECT_THAT(messages(in_room(lines + R"(<luminaire id="k" type="spot" position="1 1 2.3"/>)")),
              Not(HasSubstr("luminaire-in-solid")));
}

TEST(ProjectWarnings, AnOpeningThatReachesThroughAWallIsToldFromOneThatTouchesIt) {
  const auto panel_at = [](const char* x_m) {
    return messages_in_room(
        fmt::format("<luminaire id=\"k\" type=\"panel\" position=\"{} 1 2.5\"/>\n", x_m));
  };
  EXPECT_EQ(panel_at("0.1"),
            "dir/p.xml:7:1: warning[luminaire-partly-outside]: luminaire 'k': its luminous opening "
            "reaches 0.2 m out of room 'q', and the light of that part is missing in the results; "
            "move it, or see in 'luxgate photometry' whether its size is right");
  EXPECT_THAT(panel_at("0.298"), HasSubstr("luminaire-partly-outside"));
  EXPECT_EQ(panel_at("0.2995"), "");
  EXPECT_EQ(panel_at("0.3"), "");
  // Wholly outside is another message.
  EXPECT_THAT(panel_at("-0.1"), Not(HasSubstr("partly")));
}

std::string with_type(const std::string& attributes) {
  return messages(
      in_room("<luminaire id=\"k\" type=\"t\" position=\"1 1 2.5\"/></room>"
              "<luminaire-type id=\"t\" photometry=\"spot.ies\" " +
              attributes + R"(/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)"));
}

TEST(ProjectWarnings, FluxAndPowerMustMakeAUsualEfficacy) {
  EXPECT_THAT(with_type(R"(flux-lm="2510" power-w="10")"),
              HasSubstr("warning[efficacy-unusual]: luminaire type 't': 2510 lm for 10 W make 251 "
                        "lm/W, where 5 to 250 are usual: are flux and power right?"));
  EXPECT_THAT(with_type(R"(flux-lm="49" power-w="10")"), HasSubstr("efficacy-unusual"));
  EXPECT_EQ(with_type(R"(flux-lm="2490" power-w="10")"), "");
  EXPECT_EQ(with_type(R"(flux-lm="51" power-w="10")"), "");
}

TEST(ProjectWarnings, ATypeThatNobodyUsesIsNotLookedAt) {
  EXPECT_EQ(messages(in_room(R"(</room>
<luminaire-type id="t" photometry="spot.ies" flux-lm="9999" power-w="1"/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)")),
            "");
}

std::string with_reflectance(const std::string& reflectance) {
  return messages(in_room(fmt::format(R"(</room><material id="m" reflectance="{}"/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)",
                                      reflectance)));
}

TEST(ProjectWarnings, ReflectancesThatNoPaintHasAreUnusualButZeroIsOnPurpose) {
  EXPECT_THAT(with_reflectance("0.91"), HasSubstr("reflectance-very-high"));
  EXPECT_EQ(with_reflectance("0.9"), "");
  EXPECT_THAT(with_reflectance("0.049"), HasSubstr("reflectance-very-low"));
  EXPECT_EQ(with_reflectance("0.05"), "");
  EXPECT_EQ(with_reflectance("0"), "");
}

TEST(ProjectWarnings, APlaneThatFacesAwayFromEveryLuminaireGetsReflectedLightOnly) {
  const std::string text =
      messages(in_room(R"(<plane id="p" origin="1 1 1" u="0 1 0" v="1 0 0"/>)"));
  EXPECT_THAT(text, HasSubstr("dir/p.xml:5:1: warning[plane-faces-away]: plane 'p' faces away "
                              "from every luminaire of its space: only reflected light reaches"));
  EXPECT_EQ(messages(in_room(R"(<plane id="p" origin="1 1 1" u="1 0 0" v="0 1 0"/>)")), "");
  // Upright, with the luminaire at x = 2 m.
  EXPECT_EQ(messages(in_room(R"(<plane id="p" origin="1.99 1 1" u="0 1 0" v="0 0 1"/>)")), "");
  EXPECT_THAT(messages(in_room(R"(<plane id="p" origin="2.01 1 1" u="0 1 0" v="0 0 1"/>)")),
              HasSubstr("plane-faces-away"));
}

TEST(ProjectWarnings, ALevelPanelDoesNotLightWhatIsAboveItHoweverWideItIs) {
  const auto above = [](double z) {
    return messages(in_project(fmt::format(
        "<luminaire-type id=\"panel\" photometry=\"panel.ies\"/>\n"
        "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">\n"
        "<luminaire id=\"l\" type=\"panel\" position=\"2 1.5 2\"/>\n"
        "<plane id=\"p\" origin=\"1 1 {}\" u=\"1 0 0\" v=\"0 1 0\"/>\n</room>",
        z)));
  };
  EXPECT_THAT(above(2.1), HasSubstr("plane-faces-away"));
  EXPECT_EQ(above(1.9), "");
}

TEST(ProjectWarnings, WhatIsInASurfaceOrSeesAllAroundFacesNowhereByMistake) {
  EXPECT_EQ(messages(in_room(R"(<plane id="p" on="ceiling"/>)")), "");
  EXPECT_EQ(messages(in_room(
                R"(<plane id="p" origin="1 1 1" u="0 1 0" v="1 0 0" quantity="cylindrical"/>)")),
            "");
}

TEST(ProjectWarnings, APointListFacesAwayOnlyIfAllItsPointsDo) {
  EXPECT_THAT(messages(in_room(R"(<plane id="p" file="up.csv"/>)")), HasSubstr("faces-away"));
  EXPECT_EQ(messages(in_room(R"(<plane id="p" file="mixed.csv"/>)")), "");
}

}  // namespace
}  // namespace calc::testing
