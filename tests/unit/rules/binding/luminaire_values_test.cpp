// What is required of luminaires as such: values that are known by hand, and what is said of them.
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace rules::luminaire_values_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string ies(const std::string& gammas, const std::string& candelas, int count) {
  return "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 -1 1 " +
         std::to_string(count) + " 1 1 2 0 0 0\n1 1 100\n" + gammas + "\n0\n" + candelas + "\n";
}

struct Bound {
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;

  const Requirement& at(std::size_t i) const { return requirements.at(i); }
};

// 'ball': 100 cd everywhere; 'wide': 0 cd straight down to 900 cd at 90 degrees, nothing above;
// 'spot': 800 cd straight down to 0 cd at 60 degrees and beyond.
Bound bind_plane(const std::string& beside, const std::string& require,
                 const std::string& plane = "origin='0 0 1' u='0 2 0' v='0 0 1' count='1 1'",
                 const std::string& room = "", const std::string& end_of_room = "") {
  const bool has_group = beside.find("group='g'") != std::string::npos;
  const std::string scenes = has_group ? "<scene id='half'><dim group='g' level='0.5'/></scene>"
                                         "<scene id='none'><dim group='g' level='0'/></scene>"
                                       : "";
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.5'><material id='m' reflectance='0.5'/>"
      "<luminaire-type id='ball' photometry='ball.ies'/>"
      "<luminaire-type id='wide' photometry='wide.ies'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/>" +
      scenes + room + beside + "<plane id='p' " + plane + ">" + require + "</plane>" + end_of_room +
      "</luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml},
                                      {"ball.ies", ies("0 180", "100 100", 2)},
                                      {"wide.ies", ies("0 90 90.0001 180", "0 900 0 0", 4)},
                                      {"spot.ies", ies("0 60 180", "800 0 0", 3)}});
  Bound bound;
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const auto& d : diagnostics.all()) bound.messages.push_back(format_diagnostic(d));
  if (judged) bound.requirements = std::move(judged->requirements);
  return bound;
}

// The plane's one point is (0, 1, 1.5) and looks along +x.
const std::string kBall = "<luminaire id='b' type='ball' position='4 4 5' group='g'/>";
const std::string kRoom = "<room id='r' size='10 10 6' ceiling='m' walls='m' floor='m'>";

TEST(LuminaireValue, UpwardShareIsOfNewLuminairesInTheScene) {
  const std::string wide = "<luminaire id='w' type='wide' position='4 4 5'/>";
  const std::string require =
      "<require quantity='ULR' at-most='5'/><require id='dim' quantity='ULR' at-most='5' "
      "scene='half'/>";
  const Bound bound = bind_plane(kBall + wide, require);
  EXPECT_THAT(bound.messages, IsEmpty());
  // 400 pi lm, half of them up; of 10 rad-wise linear candelas to 900 cd all goes down:
  // 2 pi (900 / (pi / 2)) times the integral of g sin g to pi / 2, which is 1.
  const double ball = 400.0 * M_PI, down = 2.0 * M_PI * 1800.0 / M_PI;
  EXPECT_NEAR(bound.at(0).of_space.value, 100.0 * 0.5 * ball / (ball + down), 1e-3);
  EXPECT_NEAR(bound.at(1).of_space.value, 100.0 * 0.25 * ball / (0.5 * ball + down), 1e-3);
  EXPECT_EQ(bound.at(0).state, LightState::initial);
  EXPECT_STREQ(unit_of(bound.at(0)), "%");
  EXPECT_THAT(bound.at(0).note.english(), HasSubstr("as mounted"));
}

TEST(LuminaireValue, IntensityIsTowardsThePointsAndSaysOfWhich) {
  const Bound bound = bind_plane(kBall + "<luminaire id='w' type='wide' position='3 1 1.5'/>",
                                 "<require quantity='intensity' at-most='500'/>");
  EXPECT_THAT(bound.messages, IsEmpty());
  // The point is at 90 degrees of the second one.
  EXPECT_NEAR(bound.at(0).of_space.value, 900.0, 1e-9);
  EXPECT_NEAR(bound.at(0).of_space.low, 900.0, 1e-9);
  EXPECT_STREQ(unit_of(bound.at(0)), "cd");
  EXPECT_THAT(bound.at(0).note.english(), HasSubstr("that of 'w' towards (0.00, 1.00, 1.50) m"));
  EXPECT_THAT(bound.at(0).note.english(), Not(HasSubstr("may hide")));
}

TEST(LuminaireValue, WhatMayBeHiddenOrBehindCannotFail) {
  const std::string require = "<require quantity='intensity' at-most='50'/>";
  const Bound behind = bind_plane("<luminaire id='b' type='ball' position='-4 4 5'/>", require);
  EXPECT_EQ(behind.at(0).of_space.high, 100.0);
  EXPECT_EQ(behind.at(0).of_space.low, 0.0);
  EXPECT_THAT(behind.at(0).note.english(), HasSubstr("behind the plane of the points"));
  const Bound wall =
      bind_plane(kBall + "<box id='x' size='1 1 3' position='2 2 0' material='m'/>", require);
  EXPECT_EQ(wall.at(0).of_space.high, 100.0);
  EXPECT_EQ(wall.at(0).of_space.low, 0.0);
  EXPECT_THAT(wall.at(0).note.english(), HasSubstr("may hide luminaires"));
  const Bound ground = bind_plane(
      kBall + "<quad id='x' origin='-9 -9 0' u='30 0 0' v='0 30 0' material='m'/>", require);
  EXPECT_EQ(ground.at(0).of_space.low, 100.0);
}

TEST(LuminaireValue, GlareIntensityIsOfLuminairesOfAHeight) {
  const std::string lights =
      "<luminaire id='low' type='ball' position='4 4 2.49'/>"
      "<luminaire id='mid' type='wide' position='4 4 2.5'/>"
      "<luminaire id='high' type='ball' position='4 4 3'/>";
  const Bound bound =
      bind_plane(lights,
                 "<require id='a' quantity='glare-intensity' to='2.5' at-most='500'/>"
                 "<require id='b' quantity='glare-intensity' from='2.5' to='3' at-most='900'/>"
                 "<require id='c' quantity='glare-intensity' from='3' at-most='900'/>"
                 "<require id='d' quantity='glare-intensity' at-most='900'/>"
                 "<require id='e' quantity='glare-intensity' from='4' at-most='900'/>",
                 "height='1' count='1 1'", kRoom, "</room>");
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_NEAR(bound.at(0).of_space.value, 100.0, 1e-9);
  EXPECT_THAT(
      bound.at(0).note.english(),
      HasSubstr("'low', 2.49 m above the highest floor near it; luminaires in this range: 1"));
  EXPECT_NEAR(bound.at(1).of_space.value, 900.0, 1e-9);
  EXPECT_NEAR(bound.at(2).of_space.value, 100.0, 1e-9);
  EXPECT_NEAR(bound.at(3).of_space.high, 900.0, 1e-9);
  EXPECT_THAT(bound.at(3).note.english(), HasSubstr("luminaires in this range: 3"));
  EXPECT_EQ(bound.at(4).problem,
            "no lit luminaire is at 4 m or higher; the highest is 3 m above the floor");
}

// A downlight that dazzles nobody on a level way does so on a stair below it. Turned on its side it
// shines along the way as well.
TEST(LuminaireValue, PeakIntensityIsOfAllDirections) {
  const std::string require =
      "<require id='a' quantity='glare-intensity' to='3' at-most='500'/>"
      "<require id='b' quantity='peak-intensity' to='3' at-most='500'/>"
      "<require id='c' quantity='peak-intensity' from='3' at-most='500'/>";
  const Bound bound = bind_plane("<luminaire id='l' type='spot' position='4 4 2.5'/>", require,
                                 "height='1' count='1 1'", kRoom, "</room>");
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_NEAR(bound.at(0).of_space.high, 0.0, 1e-9);
  EXPECT_NEAR(bound.at(1).of_space.low, 800.0, 1e-9);
  EXPECT_NEAR(bound.at(1).of_space.high, 800.0, 1e-9);
  EXPECT_EQ(bound.at(2).problem,
            "no lit luminaire is at 3 m or higher; the highest is 2.5 m above the floor");
  const Bound turned =
      bind_plane("<luminaire id='l' type='spot' position='4 4 2.5' aim='9 4 2.5'/>", require,
                 "height='1' count='1 1'", kRoom, "</room>");
  EXPECT_THAT(turned.messages, IsEmpty());
  EXPECT_NEAR(turned.at(0).of_space.value, 800.0, 1e-9);
  EXPECT_NEAR(turned.at(1).of_space.value, 800.0, 1e-9);
}

// 2500 mm of a project in mm are 2500 m of a requirement. Of a row, other ranges hold what hangs.
TEST(LuminaireValue, HeightsThatHoldNoLuminaireAreNotJudged) {
  const std::string lamp = "<luminaire id='l' type='ball' position='4 4 2.5'/>";
  const auto bind_in_room = [&](const std::string& require) {
    return bind_plane(lamp, require, "height='1' count='1 1'", kRoom, "</room>");
  };
  const Bound own = bind_in_room(
      "<require id='a' quantity='glare-intensity' to='2' at-most='5'/>"
      "<require id='b' quantity='peak-intensity' from='2500' to='3000' at-most='5'/>");
  EXPECT_EQ(own.at(0).problem,
            "no lit luminaire is below 2 m; the lowest is 2.5 m above the floor");
  EXPECT_EQ(own.at(1).problem,
            "no lit luminaire is from 2500 to 3000 m high; all are 2.5 to 2.5 m above the floor");
  const Bound row = bind_plane("<luminaire id='l' type='ball' position='4 4 2.5' group='g'/>",
                               "<require pack='en1838:2024' role='glare' scene='half'/>",
                               "height='0' count='1 1'", kRoom, "</room>");
  ASSERT_EQ(row.requirements.size(), 6u) << testing::PrintToString(row.messages);
  EXPECT_THAT(row.at(0).note.english(), HasSubstr("no lit luminaire is in this height range"));
  for (const Requirement& one : row.requirements) EXPECT_EQ(one.problem, "") << one.id;
}

// The floor of a room is where the room is.
TEST(LuminaireValue, HeightsAreAboveTheFloor) {
  const std::string raised =
      "<room id='r' origin='0 0 7' size='10 10 6' ceiling='m' walls='m' floor='m'>";
  const Bound bound = bind_plane("<luminaire id='l' type='ball' position='4 4 2.4'/>",
                                 "<require quantity='glare-intensity' to='2.5' at-most='500'/>",
                                 "height='1' count='1 1'", raised, "</room>");
  EXPECT_NEAR(bound.at(0).of_space.value, 100.0, 1e-9);
}

// Whether people walk on the podium or beside it, nobody knows: it may be in both ranges.
TEST(LuminaireValue, OverAPodiumTheHeightIsOpen) {
  const Bound bound = bind_plane(
      "<box id='podium' size='2 2 1' position='3 3 0' material='m'/>"
      "<luminaire id='l' type='ball' position='4 4 3.4'/>",
      "<require id='a' quantity='glare-intensity' to='2.5' at-most='50'/>"
      "<require id='b' quantity='glare-intensity' from='3' at-most='50'/>"
      "<require id='c' quantity='glare-intensity' from='3.5' at-most='50'/>"
      "<require id='d' quantity='glare-intensity' at-most='50'/>",
      "origin='0 0 0' u='1 0 0' v='0 1 0' count='1 1'", kRoom, "</room>");
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(bound.at(i).of_space.high, 100.0, 1e-9) << i;
    EXPECT_EQ(bound.at(i).of_space.low, 0.0) << i;
    EXPECT_THAT(bound.at(i).note.english(), HasSubstr("have several heights"));
  }
  EXPECT_THAT(bound.at(2).problem.english(), HasSubstr("no lit luminaire is at 3.5 m or higher"));
  EXPECT_NEAR(bound.at(3).of_space.low, 100.0, 1e-9);
  // On the podium itself: a plane there says that people walk on it, wherever the luminaire is.
  const Bound beside = bind_plane(
      "<box id='podium' size='2 2 1' position='3 3 0' material='m'/>"
      "<luminaire id='l' type='ball' position='2.9 4 3.4'/>",
      "<require quantity='glare-intensity' to='2.5' at-most='50'/>",
      "origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1'", kRoom, "</room>");
  EXPECT_NEAR(beside.at(0).of_space.high, 100.0, 1e-9);
  // A ceiling that a luminaire is in is nothing that people walk on.
  const Bound recessed =
      bind_plane("<luminaire id='l' type='ball' position='4 4 5.99'/>",
                 "<require quantity='glare-intensity' from='4.5' at-most='50'/>",
                 "origin='0 0 0' u='1 0 0' v='0 1 0' count='1 1'", kRoom, "</room>");
  EXPECT_NEAR(recessed.at(0).of_space.low, 100.0, 1e-9);
}

TEST(LuminaireValue, ARoomHasNoSkyAndItsOwnLuminairesAlone) {
  const std::string lights =
      "<luminaire id='in' type='ball' position='9 9 3'/>"
      "<luminaire id='out' type='ball' position='-1 1 3'/>"
      "<luminaire id='above' type='ball' position='1 1 7'/>";
  const Bound bound = bind_plane(
      lights,
      "<require quantity='ULR' at-most='5'/><require quantity='luminaire-distance' at-most='2'/>",
      "origin='0 0 1' u='2 0 0' v='0 2 0' count='1 1'", kRoom, "</room>");
  EXPECT_THAT(bound.at(0).problem.english(), HasSubstr("luminaires in the open space"));
  EXPECT_NEAR(bound.at(1).of_space.value, 8.0 * std::sqrt(2.0), 1e-9);
  EXPECT_THAT(bound.at(1).note.english(), HasSubstr("to 'in'"));
}

TEST(LuminaireValue, TheNearestLuminaireIsInPlanAndOn) {
  const std::string lights =
      "<luminaire id='near' type='ball' position='1 1 9' group='g'/>"
      "<luminaire id='far' type='ball' position='0 4 2'/>";
  const Bound bound =
      bind_plane(lights,
                 "<require quantity='luminaire-distance' at-most='2'/>"
                 "<require id='dark' quantity='luminaire-distance' at-most='2' scene='none'/>");
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_DOUBLE_EQ(bound.at(0).of_space.value, 1.0);
  EXPECT_DOUBLE_EQ(bound.at(1).of_space.value, 3.0);
  EXPECT_STREQ(unit_of(bound.at(1)), "m");
  EXPECT_THAT(bound.at(1).note.english(), HasSubstr("from (0.00, 1.00, 1.50) m to 'far'"));
}

// At curfew all is off: nothing goes up, and nothing shines to anybody.
TEST(LuminaireValue, WhatASceneSwitchesOffMeetsEveryLimitFromAbove) {
  for (const std::string quantity : {"ULR", "intensity", "glare-intensity", "peak-intensity"}) {
    const Bound dark =
        bind_plane(kBall, "<require quantity='" + quantity + "' at-most='5' scene='none'/>");
    EXPECT_EQ(dark.at(0).problem, "") << quantity;
    EXPECT_EQ(dark.at(0).of_space.value, 0.0) << quantity;
    EXPECT_EQ(dark.at(0).of_space.high, 0.0) << quantity;
    EXPECT_EQ(dark.at(0).note, "scene 'none' switches every luminaire off, so nothing is lit");
    const Bound least =
        bind_plane(kBall, "<require quantity='" + quantity + "' at-least='5' scene='none'/>");
    EXPECT_THAT(least.at(0).problem.english(), HasSubstr("no luminaire is on")) << quantity;
    // One that no scene names stays on.
    const Bound other =
        bind_plane(kBall + "<luminaire id='x' type='ball' position='4 4 5'/>",
                   "<require quantity='" + quantity + "' at-most='5' scene='none'/>");
    EXPECT_THAT(other.at(0).note.english(), Not(HasSubstr("switches every"))) << quantity;
  }
  const Bound distance =
      bind_plane(kBall, "<require quantity='luminaire-distance' at-most='5' scene='none'/>");
  EXPECT_THAT(distance.at(0).problem.english(), HasSubstr("no luminaire is on"));
}

// Before their end they may give anything.
TEST(LuminaireValue, WhatBatteriesGiveIsNotKnownFromAnEndInTheDark) {
  const Bound dark = bind_plane("<luminaire id='l' type='ball' position='4 4 2.4' group='g'/>",
                                "<require pack='en1838' role='glare' scene='none'/>",
                                "height='1' count='1 1'", kRoom, "</room>");
  EXPECT_THAT(dark.at(0).problem.english(), HasSubstr("no luminaire is on"));
}

TEST(LuminaireValue, WithoutLightNothingIsJudged) {
  for (const std::string quantity : {"ULR", "intensity", "glare-intensity", "luminaire-distance"}) {
    const Bound empty = bind_plane("", "<require quantity='" + quantity + "' at-most='5'/>");
    EXPECT_THAT(empty.at(0).problem.english(), HasSubstr("no luminaire is on")) << quantity;
  }
}

TEST(LuminaireValue, OfARoadIsNotJudged) {
  for (const std::string quantity : {"ULR", "intensity", "glare-intensity", "luminaire-distance"}) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='ball' "
        "photometry='ball.ies'/><road id='a' width='7' lanes='2' spacing='40' surface='R3'>"
        "<luminaire-row id='r' type='ball' side='right' height='8'/><require quantity='" +
        quantity + "' at-most='55'/></road></luxgate>";
    calc::Diagnostics diagnostics;
    const calc::MemoryFileReader files({{"p.xml", xml}, {"ball.ies", ies("0 180", "100 100", 2)}});
    const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    ASSERT_TRUE(judged.has_value());
    EXPECT_THAT(judged->requirements.at(0).problem.english(),
                HasSubstr("its luminaire rows have no end"))
        << quantity;
  }
}

TEST(LuminaireValueMessage, AttributesThatMeanNothing) {
  const auto messages = [](const std::string& require) {
    return bind_plane(kBall, require).messages;
  };
  EXPECT_THAT(messages("<require quantity='intensity' at-most='5' state='maintained'/>"),
              ElementsAre(HasSubstr("'state' has no meaning")));
  EXPECT_THAT(messages("<require quantity='intensity' at-most='5' unit='fc'/>"),
              ElementsAre(HasSubstr("'unit' has no meaning")));
  EXPECT_THAT(messages("<require quantity='intensity' at-most='5' from='2'/>"),
              ElementsAre(HasSubstr("'from' has no meaning")));
  EXPECT_THAT(messages("<require quantity='glare-intensity' at-most='5' from='3' to='2'/>"),
              ElementsAre(HasSubstr("'to'")));
  EXPECT_THAT(messages("<require quantity='glare-intensity' at-most='5' from='3' to='3'/>"),
              ElementsAre(HasSubstr("'to'")));
  EXPECT_THAT(messages("<require quantity='ULR' at-most='5' light='direct'/>"),
              ElementsAre(HasSubstr("'light' has no meaning")));
}

// A file that ends in the light leaves open what its luminaires send beyond, while they are on.
TEST(LuminaireValue, LightBeyondATableIsMissing) {
  const auto missing = [](const std::string& gammas, const std::string& candelas, int count) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='1'><luminaire-type id='t' photometry='t.ies'/>"
        "<scene id='off'><dim group='g' level='0'/></scene>"
        "<luminaire id='l' type='t' position='0 0 3' group='g'/>"
        "<plane id='p' origin='0 0 0' u='1 0 0' v='0 1 0'>"
        "<require id='a' quantity='maximum' at-most='5'/>"
        "<require id='b' quantity='maximum' at-most='5' scene='off'/>"
        "<require id='c' quantity='ULR' at-most='5'/>"
        "<require id='d' quantity='luminaire-distance' at-most='5'/></plane></luxgate>";
    calc::Diagnostics diagnostics;
    const calc::MemoryFileReader files({{"p.xml", xml}, {"t.ies", ies(gammas, candelas, count)}});
    const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    std::vector<std::string> words;
    for (const Requirement& one : judged->requirements)
      words.push_back(one.missing_light.english());
    return words;
  };
  const std::string kCut =
      "the photometric table of luminaire type 't' ends while its intensity is still 50 % of the "
      "maximum; the light beyond is not known, so there may be more light";
  EXPECT_THAT(missing("0 60", "100 50", 2), ElementsAre(kCut, "", kCut, ""));
  EXPECT_THAT(missing("0 60", "100 0", 2), ElementsAre("", "", "", "")) << "it ends in the dark";
  EXPECT_THAT(missing("0 90", "100 50", 2), ElementsAre("", "", "", "")) << "by LM-63 dark above";
}

// A flux of one's own makes light of a part of the table: it may be less as well.
TEST(LuminaireValue, AFluxForAPartOfATableMakesAllOfItUnsure) {
  const auto unsure = [](const std::string& flux, const std::string& candelas) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='1'><luminaire-type id='t' photometry='t.ies'" +
        flux +
        "/><luminaire id='l' type='t' position='0 0 3'/>"
        "<plane id='p' origin='0 0 0' u='1 0 0' v='0 1 0'>"
        "<require quantity='minimum' at-least='5'/></plane></luxgate>";
    calc::Diagnostics diagnostics;
    const calc::MemoryFileReader files({{"p.xml", xml}, {"t.ies", ies("0 60", candelas, 2)}});
    const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    return judged->requirements.at(0).unsure_light.english();
  };
  EXPECT_THAT(unsure(" flux-lm='1000'", "100 50"), HasSubstr("share of it is not known"));
  EXPECT_EQ(unsure(" flux-lm='1000'", "100 0"), "");
  EXPECT_EQ(unsure("", "100 50"), "");
}

// What is known to be missing of a lit luminaire, and what is there of an unlit one.
TEST(LuminaireValue, LightOfLuminairesThatAreNotInTheirRoomIsMissing) {
  const auto missing = [](const std::string& luminaire, const std::string& scene = "") {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='1'><material id='m' reflectance='0.5'/>"
        "<luminaire-type id='t' photometry='t.ies'/>"
        "<scene id='off'><dim group='g' level='0'/></scene>"
        "<room id='r' size='4 4 3' floor='m' ceiling='m' walls='m'>"
        "<luminaire id='in' type='t' position='2 2 2.9' group='g'/>"
        "<box id='cupboard' size='1 1 2' position='3 3 0' material='m'/>" +
        luminaire +
        "<plane id='p' origin='1 1 0.5' u='1 0 0' v='0 1 0'>"
        "<require quantity='maximum' at-most='5'" +
        scene + "/></plane></room></luxgate>";
    calc::Diagnostics diagnostics;
    const calc::MemoryFileReader files({{"p.xml", xml}, {"t.ies", ies("0 90", "100 50", 2)}});
    const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    return judged->requirements.at(0).missing_light.english();
  };
  EXPECT_EQ(missing(""), "");
  const std::string above = "<luminaire id='l' type='t' position='2 2 3.01' group='g'/>";
  EXPECT_THAT(missing(above), HasSubstr("luminaire 'l' is wholly or partly outside the room"));
  EXPECT_EQ(missing(above, " scene='off'"), "");
  EXPECT_THAT(missing("<luminaire id='l' type='t' position='3.5 3.5 1'/>"), HasSubstr("'l'"));
  EXPECT_THAT(missing("<quad id='q' origin='1 0 1' u='1 0 0' v='0 0 1' material='m' "
                      "luminous-exitance='100'/>"),
              HasSubstr("'q'"))
      << "in the wall, and shines out";
}

// The room is 8 m high, between a lamp and the path behind it.
TEST(LuminaireValue, RoomsInTheWayOfLightMakeItUnsure) {
  const auto unsure = [](const std::string& lamp, const std::string& plane) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='1'><material id='m' reflectance='0.5'/>"
        "<luminaire-type id='t' photometry='t.ies'/>"
        "<room id='house' size='10 20 8' origin='0 -10 0' floor='m' ceiling='m' walls='m'/>"
        "<luminaire id='l' type='t' position='" +
        lamp + "'/><plane id='p' origin='" + plane +
        "' u='2 0 0' v='0 4 0'><require quantity='minimum' at-least='5'/></plane></luxgate>";
    calc::Diagnostics diagnostics;
    const calc::MemoryFileReader files({{"p.xml", xml}, {"t.ies", ies("0 180", "100 100", 2)}});
    const auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    return judged->requirements.at(0).unsure_light.english();
  };
  EXPECT_THAT(unsure("-6 0 6", "11 -2 0.01"), HasSubstr("room 'house' is between"));
  EXPECT_EQ(unsure("-6 0 6", "-8 -2 0.01"), "") << "before it";
  EXPECT_EQ(unsure("0 0 4", "-8 -2 0.01"), "") << "on its wall";
  EXPECT_EQ(unsure("5 0 60", "14 -2 0.01"), "") << "above its roof, and down beside it";
}

// Of zones the limit is the row's, and of emergency a luminaire is 2 m away at most.
TEST(LuminaireValue, RowsAskForThem) {
  const Bound zone = bind_plane(kBall,
                                "<require pack='en12464-2' row='E2' role='window'/>"
                                "<require pack='en12464-2' row='E2' role='bystander'/>"
                                "<require pack='en12464-2' row='E2' role='site'/>");
  ASSERT_EQ(zone.requirements.size(), 3u) << testing::PrintToString(zone.messages);
  EXPECT_EQ(zone.at(0).metric, Metric::maximum);
  EXPECT_EQ(zone.at(0).limit, 5.0);
  EXPECT_EQ(zone.at(0).state, LightState::initial);
  EXPECT_EQ(zone.at(1).metric, Metric::intensity);
  EXPECT_EQ(zone.at(1).limit, 7500.0);
  EXPECT_EQ(zone.at(2).metric, Metric::upward_share);
  EXPECT_EQ(zone.at(2).limit, 5.0);
  const Bound item = bind_plane(kBall, "<require pack='en1838' role='safety-item' scene='half'/>");
  ASSERT_EQ(item.requirements.size(), 2u) << testing::PrintToString(item.messages);
  EXPECT_EQ(item.at(1).metric, Metric::luminaire_distance);
  EXPECT_EQ(item.at(1).limit, 2.0);
  EXPECT_EQ(item.at(1).of_space.value, 5.0);
  // Its group is named in the scene; else nobody knows whether it is on in an emergency.
  const Bound unnamed = bind_plane(kBall + "<luminaire id='x' type='ball' position='0 1 3'/>",
                                   "<require pack='en1838' role='emphasis' scene='half'/>");
  EXPECT_THAT(unnamed.at(0).problem.english(), HasSubstr("does not say what"));
}

// The scene has the levels of the end; before it luminaires may give more.
TEST(LuminaireValue, GlareInAnEmergencyIsUpToFullOutput) {
  const Bound bound = bind_plane("<luminaire id='l' type='ball' position='4 4 2.4' group='g'/>",
                                 "<require pack='en1838' role='glare' scene='half'/>",
                                 "height='1' count='1 1'", kRoom, "</room>");
  ASSERT_EQ(bound.requirements.size(), 6u) << testing::PrintToString(bound.messages);
  EXPECT_EQ(bound.at(0).limit, 500.0);
  EXPECT_EQ(bound.at(0).state, LightState::end_of_duration);
  EXPECT_NEAR(bound.at(0).of_space.low, 50.0, 1e-9);
  EXPECT_NEAR(bound.at(0).of_space.high, 100.0, 1e-9);
  EXPECT_THAT(bound.at(0).note.english(), HasSubstr("to full output"));
  for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(bound.at(i).of_space.high, 0.0) << i;
}

}  // namespace
}  // namespace rules::luminaire_values_test
