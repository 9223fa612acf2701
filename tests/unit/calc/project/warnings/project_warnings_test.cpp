// What is allowed but hardly meant: each warning just beyond its limit, and none just within.

#include "calc/project/warnings/project_warnings.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

namespace calc::tests::project_warnings_test {
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
            "dir/p.xml:6:1: warning[luminaires-coincide]: luminaire 'l' is at the place of 'k' of "
            "line 5, within 10 mm, with the same type and aim; was it pasted twice? delete one of "
            "them, or move it");
  EXPECT_THAT(with_second_luminaire(R"(position="2.009 1.5 2.5")"), HasSubstr("coincide"));
  EXPECT_EQ(with_second_luminaire(R"(position="2.011 1.5 2.5")"), "");
  EXPECT_EQ(with_second_luminaire(R"(position="2 1.5 2.5" aim="0 0 0")"), "");  // two heads
  // Nothing tells one turn of a round beam from another.
  EXPECT_THAT(with_second_luminaire(R"(position="2 1.5 2.5" rotation="180")"),
              HasSubstr("coincide"));
}

TEST(ProjectWarnings, OtherTypesAtOnePlaceAreOneLuminaireInTwoParts) {
  EXPECT_EQ(messages(in_room(R"(<luminaire id="k" type="up" position="2 1.5 2.5"/></room>
<luminaire-type id="up" photometry="spot.ies"/>
<room id="q" origin="9 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)")),
            "");
}

TEST(ProjectWarnings, OneHousingIsNotTwoLuminairesOfAlmostTheSameLight) {
  const auto two = [](const std::string& place, const std::string& type) {
    return messages_in_room(
        R"(<luminaire id="k" type="panel" position="1.5 1.5 2.4"/>
<luminaire id="m" )" +
        type + " position=\"" + place + R"("/></room>
<luminaire-type id="more" photometry="panel.ies" flux-lm="230"/>
<luminaire-type id="half" photometry="panel.ies" flux-lm="114"/>
<room id="z" origin="90 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)");
  };
  EXPECT_THAT(two("1.5 1.5 2.4", R"(type="more")"), HasSubstr("'k' of line"));
  EXPECT_THAT(two("1.5 1.515 2.4", R"(type="more")"), HasSubstr(", within 15 mm,"));
  EXPECT_THAT(two("1.5 1.8 2.4", R"(type="more")"), Not(HasSubstr("coincide")));
  EXPECT_THAT(two("1.5 1.5 2.4", R"(type="half")"), Not(HasSubstr("coincide")));
  EXPECT_THAT(two("1.5 1.5 2.4", R"(type="more" group="warm")"), Not(HasSubstr("coincide")));
}

// Whatever the turn: two cannot hang there, and six would be green at a sixth of the light.
TEST(ProjectWarnings, PanelsInOneAnotherAreNamed) {
  const auto second = [](const std::string& rest) {
    return messages_in_room(R"(<luminaire id="k" type="panel" position="1.5 1.5 2.4"/>
<luminaire id="m" )" + rest +
                            R"(/></room>
<luminaire-type id="half" photometry="panel.ies" flux-lm="114"/>
<room id="z" origin="90 0 0" size="4 3 2.5" ceiling="white" walls="white" floor="white">)");
  };
  const auto overlaps = HasSubstr("warning[luminaires-overlap]: luminaire 'm' covers ");
  for (const char* rest :
       {R"(type="panel" position="1.5 1.5 2.4" rotation="20")",
        R"(type="panel" position="1.5 1.5 2.4" rotation="180")",
        R"(type="panel" position="1.5 1.5 2.4" rotation="90")",
        R"(type="panel" position="1.7 1.5 2.4")", R"(type="panel" position="1.5 1.7 2.4")",
        R"(type="panel" position="1.7 1.5 2.36")", R"(type="half" position="1.7 1.5 2.4")",
        R"(type="panel" position="1.5 1.5 2.4" rotation="45" aim="1.6 1.5 0")"}) {
    EXPECT_THAT(second(rest), overlaps) << rest;
  }
  for (const char* rest :
       {R"(type="panel" position="2.1 1.5 2.4")",                                // beside
        R"(type="panel" position="1.7 1.5 2.3")",                                // below
        R"(type="panel" position="1.5 1.5 2.4" rotation="60" aim="1.9 1.5 0")",  // likewise
        R"(type="panel" position="1.5 1.5 2.4" aim="1.5 1.5 9")",                // the other way
        R"(type="half" position="1.5 1.5 2.4" rotation="90")",  // the other part of one
        R"(type="half" position="1.7 1.5 2.4" group="warm")"}) {
    EXPECT_THAT(second(rest), Not(HasSubstr("luminaires-overlap"))) << rest;
  }
  const auto grid = [](const char* id, const char* turn) {
    return fmt::format(
        "<luminaire-grid id=\"{}\" type=\"panel\" origin=\"0 0 2.4\" size=\"4 3\" "
        "rows=\"2\" columns=\"3\" rotation=\"{}\"/>\n",
        id, turn);
  };
  EXPECT_THAT(messages_in_room(grid("g", "0") + grid("h", "90")),
              HasSubstr("luminaires of this space likewise), and the light of both counts"));
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
            "reaches 0.2 m out of room 'q', and the light of that part is missing; move it, or "
            "check its size with 'luxgate photometry'");
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
              HasSubstr("warning[efficacy-unusual]: luminaire type 't': 2510 lm for 10 W are 251 "
                        "lm/W, and 5 to 250 are usual; check flux and power"));
  EXPECT_THAT(with_type(R"(flux-lm="49" power-w="10")"), HasSubstr("efficacy-unusual"));
  EXPECT_EQ(with_type(R"(flux-lm="2490" power-w="10")"), "");
  // A slip in what might be taken would win every search for the least power.
  EXPECT_THAT(with_type(R"(><package article="P-1" flux-lm="3000" power-w="2.3"/></luminaire-type>
<material id="other" reflectance="0.5")"),
              HasSubstr("luminaire type 't' with 'P-1': 3000 lm for 2.3 W are 1.3e+03 lm/W"));
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
  EXPECT_THAT(text,
              HasSubstr("dir/p.xml:5:1: warning[plane-faces-away]: plane 'p' faces away "
                        "from every luminaire of its space, and only reflected light reaches"));
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

std::string room_at(const std::string& id, const std::string& origin, const std::string& size) {
  return fmt::format(
      "<room id='{}' origin='{}' size='{}' ceiling='white' walls='white' floor='white'/>\n", id,
      origin, size);
}

TEST(ProjectWarnings, RoomsThatShareSpaceDoNotSeeEachOther) {
  const auto of_two = [](const std::string& origin, const std::string& size) {
    return messages(in_project(room_at("a", "0 0 0", "6 4 3") + room_at("b", origin, size)));
  };
  EXPECT_THAT(of_two("5.9 1 0", "4 2 3"), HasSubstr("rooms 'b' and 'a' overlap;"));
  EXPECT_THAT(of_two("1 1 1", "1 1 1"), HasSubstr("rooms-overlap"));
  for (const char* beside : {"6 0 0", "5.995 0 0", "0 4 0", "0 0 3", "0 0 2.995"}) {
    EXPECT_THAT(of_two(beside, "6 4 3"), Not(HasSubstr("rooms-overlap"))) << beside;
  }
  // In the corner of an L there is room for another.
  const std::string l_room =
      "<room id='l' footprint='0 0 6 0 6 2 2 2 2 6 0 6' height='3' ceiling='white' walls='white' "
      "floor='white'/>\n";
  EXPECT_THAT(messages(in_project(l_room + room_at("b", "2 2 0", "4 4 3"))),
              Not(HasSubstr("rooms-overlap")));
  EXPECT_THAT(messages(in_project(l_room + room_at("b", "1.9 2 0", "4 4 3"))),
              HasSubstr("rooms-overlap"));
}

TEST(ProjectWarnings, ObjectsOfTheOpenSpaceThatReachIntoARoom) {
  const auto with = [](const std::string& object) {
    return messages(in_project(object + room_at("a", "0 0 0", "6 4 3")));
  };
  // A deck over the whole room whose middle lies outside; a wall across; a box around all of it.
  EXPECT_THAT(with("<quad id='d' origin='-1 -1 1.5' u='30 0 0' v='0 8 0' material='white'/>\n"),
              HasSubstr("object 'd' is in the open space but within room 'a'"));
  EXPECT_THAT(with("<quad id='d' origin='3 -9 -1' u='0 30 0' v='0 0 9' material='white'/>\n"),
              HasSubstr("object-inside-room"));
  EXPECT_THAT(with("<box id='d' position='-1 -1 -1' size='30 30 30' material='white'/>\n"),
              HasSubstr("object-inside-room"));
  // The ground, a slab, a neighbour's wall.
  EXPECT_THAT(with("<quad id='d' origin='-9 -9 0' u='30 0 0' v='0 30 0' material='white'/>\n"),
              Not(HasSubstr("object-inside-room")));
  EXPECT_THAT(with("<box id='d' position='-1 -1 3' size='8 6 0.3' material='white'/>\n"),
              Not(HasSubstr("object-inside-room")));
  EXPECT_THAT(with("<quad id='d' origin='6 -9 0' u='0 30 0' v='0 0 3' material='white'/>\n"),
              Not(HasSubstr("object-inside-room")));
}

TEST(ProjectWarnings, RoomsThrowNoShadowInTheOpenSpace) {
  const std::string site =
      "<luminaire id='mast' type='spot' position='20 2 8'/>\n"
      "<plane id='p' points='-10 0 0  -5 0 0  -5 5 0  -10 5 0'/>\n";
  EXPECT_THAT(messages(in_project(site + room_at("a", "0 0 0", "6 4 3"))),
              HasSubstr("room 'a' is among the luminaires and planes of the open space"));
  EXPECT_THAT(messages(in_project(site + room_at("a", "0 40 0", "6 4 3"))),
              Not(HasSubstr("room-in-open-space")));
}

TEST(ProjectWarnings, GroupsThatDifferInCaseOnly) {
  const auto of_groups = [](const std::string& a, const std::string& b) {
    return messages(
        in_room(fmt::format("<luminaire id='1' type='spot' position='1 1 2' group='{}'/>\n"
                            "<luminaire id='2' type='spot' position='2 1 2' group='{}'/>",
                            a, b)));
  };
  EXPECT_THAT(of_groups("main", "Main"), HasSubstr("groups 'Main' and 'main' differ only in case"));
  EXPECT_THAT(of_groups("main", " main "), Not(HasSubstr("groups-alike")));
  EXPECT_THAT(of_groups("main", "side"), Not(HasSubstr("groups-alike")));
}

TEST(ProjectWarnings, ALuminaireThatIsPartlyInASolid) {
  const auto at = [](const std::string& position) {
    return messages_in_room(
        "<box id='beam' position='12 0 2' size='0.4 3 0.5' material='white'/>\n"
        "<luminaire id='cut' type='panel' position='" +
        position + "'/>");
  };
  EXPECT_THAT(at("11.8 1 2.2"), HasSubstr("luminaire-partly-in-solid"));
  EXPECT_THAT(at("12.2 1 2.2"), HasSubstr("luminaire-in-solid"));
  EXPECT_THAT(at("12.2 1 1.9995"), Not(HasSubstr("in-solid"))) << "below it";
  EXPECT_THAT(at("11.7 1 2.2"), Not(HasSubstr("in-solid"))) << "beside it";
}

TEST(ProjectWarnings, ALuminousSurfaceThatFacesOutOfItsRoom) {
  const auto ceiling = [](const std::string& u, const std::string& v, const std::string& z) {
    return messages(in_room("<quad id='sky' origin='1 1 " + z + "' u='" + u + "' v='" + v +
                            "' material='white' luminous-exitance='500'/>"));
  };
  EXPECT_THAT(ceiling("1 0 0", "0 1 0", "2.5"),
              HasSubstr("the luminous surface 'sky' faces out of room 'r'"));
  EXPECT_THAT(ceiling("0 1 0", "1 0 0", "2.5"), Not(HasSubstr("faces-out")));
  EXPECT_THAT(ceiling("1 0 0", "0 1 0", "2.4"), Not(HasSubstr("faces-out")));
}

TEST(ProjectWarnings, TheSameSurfaceOrTheSameFileTwice) {
  const auto quad = [](const std::string& id) {
    return "<quad id='" + id +
           "' origin='1 1 2' u='1 0 0' v='0 -1 0' material='white' luminous-exitance='500'/>\n";
  };
  EXPECT_THAT(messages(in_room(quad("a") + quad("b"))), HasSubstr("luminaires-coincide"));
  EXPECT_THAT(messages(in_project("<luminaire-type id='again' photometry='spot.ies'/>\n"
                                  "<luminaire id='1' type='spot' position='1 1 2'/>\n"
                                  "<luminaire id='2' type='again' position='1 1 2'/>")),
              HasSubstr("luminaires-coincide"));
}

}  // namespace
}  // namespace calc::tests::project_warnings_test
