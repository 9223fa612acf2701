#include "rules/applicability/applicability.h"

#include "calc/base/names.h"
#include "calc/base/sentences.h"
#include "calc/base/xml_document.h"
#include "calc/scene/sensor_grid.h"
#include "rules/applicability/lost_points.h"
#include "rules/applicability/place_in_space.h"
#include "rules/binding/bind.h"
#include "rules/binding/judged_project.h"
#include "tests/support/memory_file_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace rules::applicability_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path kCorpus = LUXGATE_RULES_CORPUS;
const std::string kToday = "2026-11-22";
const std::string kIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";

struct Setting {
  std::string plane;     // attributes of the plane
  std::string require;   // attributes of the <require>
  std::string inside{};  // its children
  std::string room = "<room id='r' size='12 8 3' ceiling='m' walls='m' floor='m'>";
  std::string objects{};
  std::string root = "maintenance-factor='0.8'";
  std::string element = "plane";
  std::map<std::string, std::string> files{};
  std::string judged = "p";  // id of the plane
};

struct Fitted {
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;

  const Requirement& first() const { return requirements.at(0); }
  std::vector<std::string> aspects(const std::string& check) const {
    std::vector<std::string> names;
    for (const Requirement& requirement : requirements) {
      if (requirement.origin.check != check) continue;
      for (const Deviation& d : requirement.deviations) {
        names.emplace_back(calc::name_of(d.aspect));
      }
    }
    return names;
  }
};

Fitted fit(const Setting& setting) {
  const bool is_open = setting.room.empty();
  const std::string lamp = "<luminaire id='l' type='spot' position='6 4 2.9' group='e'/>" +
                           setting.objects + "<" + setting.element + " id='p' " + setting.plane +
                           "><require " + setting.require + ">" + setting.inside + "</require></" +
                           setting.element + ">";
  const std::string xml = "<luxgate version='1' " + setting.root +
                          "><material id='m' reflectance='0.5'/><luminaire-type id='spot' "
                          "photometry='spot.ies'/>" +
                          (is_open ? "" : setting.room) + lamp + (is_open ? "" : "</room>") +
                          "<scene id='em'><dim group='e' level='0.5'/></scene></luxgate>";
  calc::Diagnostics diagnostics;
  Fitted fitted;
  std::map<std::string, std::string> all = setting.files;
  all["p.xml"] = xml;
  all["spot.ies"] = kIes;
  const calc::MemoryFileReader files(all);
  const std::vector<RulePack> packs = builtin_rule_packs();
  if (const auto judged = load_judged_project(files, "p.xml", packs, diagnostics)) {
    const calc::Space& space = judged->project.spaces.at(0);
    const auto plane =
        std::find_if(space.planes.begin(), space.planes.end(),
                     [&](const calc::CalcPlane& one) { return one.id == setting.judged; });
    const auto grid = calc::make_sensor_grid(*plane, space, diagnostics);
    fitted.requirements = requirements_of_plane(judged->requirements, setting.judged);
    if (grid) {
      check_applicability(
          {judged->project, space, *plane, *grid, packs, kToday, judged->requirements},
          fitted.requirements);
    }
  }
  for (const auto& d : diagnostics.all()) fitted.messages.push_back(format_diagnostic(d));
  return fitted;
}

const std::string kDeskWork = "pack='en12464-1:2021' row='34.2'";
const std::string kWholeRoom = "height='0.75' margin='0.5'";

TEST(Applicability, APlaneOfTheStandardsOwnFits) {
  const Fitted fitted = fit({kWholeRoom, kDeskWork});
  ASSERT_EQ(fitted.requirements.size(), 2u) << testing::PrintToString(fitted.messages);
  for (const Requirement& requirement : fitted.requirements) {
    EXPECT_THAT(requirement.deviations, IsEmpty());
    EXPECT_EQ(requirement.problem, "");
    EXPECT_EQ(requirement.note, "");
  }
}

TEST(Applicability, OnePointIsNotTheStandardsGrid) {
  const Fitted fitted = fit({"height='0.75' margin='0.5' count='1 1'", kDeskWork});
  EXPECT_THAT(fitted.aspects("task.Em"), ElementsAre("grid"));
  EXPECT_EQ(fitted.first().problem,
            "the grid has 1 x 1 points; role 'task' of en12464-1:2021 requires 10 x 7 on this "
            "area (to accept it, add <deviation in=\"grid\">)");
}

// 11 m x 7 m: p = 0.2 * 5^log10(11) = 1.069 m, 10.29 and 6.55 cells: 10 x 7.
TEST(Applicability, AsManyPointsAsTheStandardsFitAndOneRowLessDoesNot) {
  const auto aspects = [](const std::string& count) {
    return fit({"height='0.75' margin='0.5' count='" + count + "'", kDeskWork}).aspects("task.Em");
  };
  EXPECT_THAT(aspects("10 7"), IsEmpty());
  EXPECT_THAT(aspects("30 21"), IsEmpty());
  EXPECT_THAT(aspects("9 7"), ElementsAre("grid"));
  EXPECT_THAT(aspects("10 6"), ElementsAre("grid"));
}

// EN 12464-1 leaves out a strip along walls. A desk counts up to its edge.
TEST(Applicability, AMarginIsOfWallsOnly) {
  const auto aspects = [](const std::string& plane) {
    return fit({plane, kDeskWork}).aspects("task.Em");
  };
  const std::string desk = "origin='5 3 0.75' u='1.6 0 0' v='0 1.4 0'";
  EXPECT_THAT(aspects(desk), IsEmpty());
  EXPECT_THAT(aspects(desk + " margin='0.5'"), ElementsAre("margin"));
  EXPECT_THAT(aspects(desk + " margin='0.05'"), ElementsAre("margin"));
  // Three sides of half the room are walls, and one is none.
  EXPECT_THAT(aspects("origin='0 0 0.75' u='6 0 0' v='0 8 0' margin='0.5'"), ElementsAre("margin"));
  // What the outline leaves out already is part of the strip.
  const std::string off_walls = "origin='0.3 0.3 0.75' u='11.4 0 0' v='0 7.4 0'";
  EXPECT_THAT(aspects(off_walls + " margin='0.2'"), IsEmpty());
  EXPECT_THAT(aspects(off_walls + " margin='0.25'"), ElementsAre("margin"));
  EXPECT_THAT(fit({desk + " margin='0.5'", kDeskWork}).first().problem.english(),
              HasSubstr("omits 0.5 m along walls, and parts of the outline run along no wall"));
}

TEST(Applicability, WhatTheMarginLeavesOfASpeckIsASpeck) {
  const auto note = [](const std::string& plane) {
    return fit({plane, kDeskWork}).first().note.english();
  };
  EXPECT_THAT(note("origin='0 0 0.75' u='1.1 0 0' v='0 1.1 0' margin='0.5'"), HasSubstr("0.01 m²"));
  EXPECT_EQ(note("origin='0 0 0.75' u='1.1 0 0' v='0 1.1 0'"), "");
}

std::string box_obj(double x, double y, double z) {
  return fmt::format(
      "v 0 0 0\nv {0} 0 0\nv {0} {1} 0\nv 0 {1} 0\nv 0 0 {2}\nv {0} 0 {2}\nv {0} {1} {2}\nv 0 {1} "
      "{2}\nf 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n",
      x, y, z);
}

Setting in_mesh(const std::string& plane, const std::string& require) {
  Setting setting{plane, require};
  setting.room = "<room id='r' file='box.obj' units='m' up='z' material='m'>";
  setting.files = {{"box.obj", box_obj(12, 8, 3)}};
  return setting;
}

// In a mesh nobody names walls: what is upright beside the plane is one, and nothing else.
TEST(Applicability, OfAMeshTheMarginIsBesideWhatIsUpright) {
  const auto aspects = [](const std::string& plane) {
    return fit(in_mesh(plane, kDeskWork)).aspects("task.Em");
  };
  EXPECT_THAT(aspects("origin='0 0 0.75' u='12 0 0' v='0 8 0' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("origin='5 3 0.75' u='1.6 0 0' v='0 1.4 0' margin='0.5'"),
              ElementsAre("margin"));
}

TEST(Applicability, AWallOfAMeshIsASurfaceAndNoPlaneInTheAir) {
  const std::string wall = kDeskWork + " role='wall'", ceiling = kDeskWork + " role='ceiling'";
  const Fitted on = fit(in_mesh("origin='0 0 0' u='0 8 0' v='0 0 3' margin='0.5'", wall));
  EXPECT_THAT(on.aspects("wall.Em"), IsEmpty()) << on.first().problem;
  EXPECT_THAT(on.first().note.english(),
              HasSubstr("the walls and the ceiling of this space are not known"));
  EXPECT_THAT(
      fit(in_mesh("origin='4 2 0.5' u='0 2 0' v='0 0 2' margin='0.5'", wall)).aspects("wall.Em"),
      ElementsAre("place"));
  EXPECT_THAT(fit(in_mesh("origin='0 8 3' u='12 0 0' v='0 -8 0' margin='0.5'", ceiling))
                  .aspects("ceiling.Em"),
              IsEmpty());
  EXPECT_THAT(fit(in_mesh("origin='4 4 1' u='2 0 0' v='0 -2 0' margin='0.5'", ceiling))
                  .aspects("ceiling.Em"),
              ElementsAre("place"));
}

// Cells of 0.9 m whose centres lie in the strip that does not count leave 0.85 m without a point.
TEST(Applicability, PointsStandForAllThatTheMaskLeaves) {
  const auto aspects = [](const std::string& plane) {
    Setting setting{plane, "pack='en1838:2024' role='open-area' scene='em'"};
    setting.room = "<room id='r' size='9 8 3' ceiling='m' walls='m' floor='m'>";
    return fit(setting).aspects("open.min");
  };
  EXPECT_THAT(aspects("height='0'"), ElementsAre("grid"));
  EXPECT_THAT(aspects("height='0' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("height='0' spacing='0.4'"), IsEmpty());
  // The strip is along walls: a plane without it is not cut twice.
  EXPECT_THAT(aspects("origin='0.5 0.5 0' u='8 0 0' v='0 7 0'"), IsEmpty());
}

TEST(Applicability, PointsOfARouteStandForAllOfItsWidthThatCounts) {
  const auto aspects = [](const std::string& route) {
    Setting setting{route, "pack='en1838:2024' scene='em'"};
    setting.room = "<room id='r' size='20 4 3' ceiling='m' walls='m' floor='m'>";
    setting.element = "route";
    return fit(setting).aspects("route.min");
  };
  const std::string way = "points='0.2 2 0 19.8 2 0' width='4'";
  EXPECT_THAT(aspects(way), IsEmpty());
  EXPECT_THAT(aspects(way + " spacing='1'"), ElementsAre("grid"));
}

TEST(Applicability, AFieldOfARoadHasAtLeastSoManyPoints) {
  const auto aspects = [](const std::string& count) {
    Setting setting{"origin='0 0 0' u='6 0 0' v='0 1.5 0' count='" + count + "'",
                    "pack='en13201-2' row='C3' role='carriageway'"};
    setting.room = "";
    return fit(setting).aspects("C.average");
  };
  EXPECT_THAT(aspects("2 1"), ElementsAre("grid"));
  EXPECT_THAT(aspects("10 2"), ElementsAre("grid"));
  EXPECT_THAT(aspects("10 3"), IsEmpty());
}

const std::string kTask =
    "<plane id='t' origin='2 2 0.75' u='2 0 0' v='0 2 0'><require " + kDeskWork + "/></plane>";

// Four corners of a plane at such a height, whose hole has four others: "points='...'><hole .../".
std::string frame(double low, double high, double z, double hole_low, double hole_high) {
  const auto square = [z](double from, double to) {
    return fmt::format("{0} {0} {2} {1} {0} {2} {1} {1} {2} {0} {1} {2}", from, to, z);
  };
  return fmt::format("points='{}'><hole points='{}'/", square(low, high),
                     square(hole_low, hole_high));
}

// Whoever draws the surround must draw it around the task of the row, and all of it.
TEST(Applicability, ASurroundIsAroundATask) {
  const auto fitted = [](const std::string& plane, bool has_task = true) {
    Setting setting{plane, kDeskWork + " role='surround'"};
    if (has_task) setting.objects = kTask;
    return fit(setting);
  };
  const auto aspects = [&](const std::string& plane, bool has_task = true) {
    return fitted(plane, has_task).aspects("surround.Em");
  };
  EXPECT_THAT(aspects(frame(1.5, 4.5, 0.75, 2, 4)), IsEmpty());
  EXPECT_THAT(aspects(frame(1, 5, 0.75, 2, 4)), IsEmpty());  // the band has a least width
  const std::string piece = "origin='4 2 0.75' u='0.5 0 0' v='0 2 0'";
  EXPECT_THAT(aspects(piece), ElementsAre("place"));
  EXPECT_EQ(fitted(piece).first().problem,
            "role 'surround' of en12464-1:2021 applies to the whole band of 0.5 m around the "
            "task; the counted part of this plane covers only 20 % of that (to accept it, add "
            "<deviation in=\"place\">)");
  EXPECT_THAT(aspects("origin='2 2 0.75' u='2 0 0' v='0 2 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects("origin='8 5 0.75' u='0.5 0 0' v='0 2 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects(piece, false), IsEmpty());
}

// A band ends at walls and at the next task.
TEST(Applicability, OfABandOnlyWhatIsThereIsAskedFor) {
  Setting setting{"points='0.5 2 0.75 1.5 2 0.75 1.5 3 0.75 0.5 3 0.75'",
                  kDeskWork + " role='surround'"};
  // Between two tasks that fill the room but for this square, less the strip along walls.
  setting.room = "<room id='r' size='2 5 3' ceiling='m' walls='m' floor='m'>";
  setting.objects = "<plane id='s' origin='0 0 0.75' u='2 0 0' v='0 2 0'><require " + kDeskWork +
                    "/></plane><plane id='t' origin='0 3 0.75' u='2 0 0' v='0 2 0'><require " +
                    kDeskWork + "/></plane>";
  EXPECT_THAT(fit(setting).aspects("surround.Em"), ElementsAre("place"));
  setting.plane = "points='0 2 0.75 2 2 0.75 2 3 0.75 0 3 0.75'";
  EXPECT_THAT(fit(setting).aspects("surround.Em"), IsEmpty());
}

TEST(Applicability, ABackgroundAndACylinderAreAllAroundTheTaskToo) {
  const auto aspects = [](const std::string& plane, const std::string& role) {
    Setting setting{plane, kDeskWork + " role='" + role + "'"};
    setting.objects = kTask;
    return fit(setting).aspects(role + ".Em");
  };
  EXPECT_THAT(aspects("origin='4.5 2 0' u='3 0 0' v='0 2 0'", "background"), ElementsAre("place"));
  EXPECT_THAT(aspects(frame(0.5, 7.5, 0, 1.5, 4.5), "background"), IsEmpty());
  const std::string upright = " quantity='cylindrical'";
  EXPECT_THAT(aspects("origin='2 2 1.2' u='0.5 0 0' v='0 0.5 0'" + upright, "cylinder"),
              ElementsAre("place"));
  EXPECT_THAT(aspects("origin='1.5 1.5 1.2' u='3 0 0' v='0 3 0'" + upright, "cylinder"), IsEmpty());
  EXPECT_THAT(aspects("height='1.2' margin='0.5'" + upright, "cylinder"), IsEmpty());
}

// An area that a project gives to a zone of a workplace is looked at as one that it draws.
TEST(Applicability, AZoneWithAnAreaOfItsOwnIsAroundItsTask) {
  const auto aspects = [](const std::string& area) {
    Setting setting{kWholeRoom, "quantity='average' at-least='1'"};
    setting.objects = "<workplace id='w' " + kDeskWork +
                      " origin='2 2' size='2 2'><zone role='surround' " + area +
                      "/></workplace><workplace id='v' " + kDeskWork + " origin='8 4' size='2 2'/>";
    setting.judged = "w.surround";
    return fit(setting).aspects("surround.Em");
  };
  EXPECT_THAT(aspects("origin='1.5 1.5' size='3 3'"), IsEmpty());
  EXPECT_THAT(aspects("origin='4 2' size='0.5 2'"), ElementsAre("place"));
  EXPECT_THAT(aspects("origin='7.5 3.5' size='3 3'"), ElementsAre("place"));  // that of the other
}

TEST(Applicability, OutdoorsASurroundIsAroundItsTaskToo) {
  const auto aspects = [](const std::string& plane) {
    Setting setting{plane, "pack='en12464-2' row='5.1-crossings' role='surround'"};
    setting.room = "";
    setting.objects =
        "<plane id='t' origin='2 2 0' u='2 0 0' v='0 2 0'><require pack='en12464-2' "
        "row='5.1-crossings'/></plane>";
    return fit(setting).aspects("surround.Em");
  };
  EXPECT_THAT(aspects("origin='2.5 2.5 0' u='1 0 0' v='0 1 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects("origin='4 2 0' u='2 0 0' v='0 2 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects(frame(0, 6, 0, 2, 4)), IsEmpty());
}

TEST(Applicability, TheTotalAreaHoldsThePrincipalOne) {
  const auto aspects = [](const std::string& plane) {
    Setting setting{plane, "pack='en12193' row='football-III' role='ta'"};
    setting.room = "";
    setting.objects =
        "<plane id='t' origin='5 5 0' u='10 0 0' v='0 10 0'><require pack='en12193' "
        "row='football-III'/></plane>";
    return fit(setting).aspects("ta.Em");
  };
  EXPECT_THAT(aspects("origin='9 9 0' u='1 0 0' v='0 1 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects("origin='20 5 0' u='10 0 0' v='0 10 0'"), ElementsAre("place"));
  EXPECT_THAT(aspects("origin='4 4 0' u='12 0 0' v='0 12 0'"), IsEmpty());
}

// Towards a luminaire 3 m to the side a desk that leans by 14 degrees has 40 % more light than one
// that is level.
TEST(Applicability, NothingLeansThatLiesOnNothing) {
  const auto aspects = [](const std::string& u, const std::string& objects = "") {
    Setting setting{"origin='3 3 0.75' u='" + u + "' v='0 0.6 0'", kDeskWork};
    setting.objects = objects;
    return fit(setting).aspects("task.Em");
  };
  EXPECT_THAT(aspects("0.6 0 0.0005"), IsEmpty());  // 0.05 degrees
  EXPECT_THAT(aspects("0.6 0 0.0025"), ElementsAre("orientation"));
  EXPECT_THAT(aspects("0.582177 0 0.145153"), ElementsAre("orientation"));
  const std::string board = "<quad id='b' origin='2 2 0.64' u='3 0 0.15' v='0 3 0' material='m'/>";
  EXPECT_THAT(aspects("0.6 0 0.03", board), IsEmpty());
  EXPECT_THAT(aspects("0.6 0 -0.03", board), ElementsAre("orientation"));
}

TEST(Applicability, UprightIsUprightAndNoLittleLess) {
  const auto aspects = [](const std::string& v) {
    Setting setting{"origin='3 3 1' u='-2 0 0' v='" + v + "'",
                    "pack='en12464-2' row='E2' role='window'"};
    setting.room = "";
    return fit(setting).aspects("window");
  };
  EXPECT_THAT(aspects("0 0 1"), IsEmpty());
  EXPECT_THAT(aspects("0 0.2 1"), ElementsAre("orientation"));
}

// 8 m x 1 m, at 45 degrees to x and y: cells of 0.2 m, and not those of the square around it.
TEST(Applicability, AGridIsThatOfTheAreasOwnSides) {
  const std::string strip =
      "1.429289322 1.070710678 0.75 1.570710678 1.070710678 0.75 "
      "7.156854249 6.656854249 0.75 6.449747468 7.363961031 0.75 "
      "0.792893219 1.707106781 0.75";
  const auto fitted = [&](const std::string& more) {
    return fit({"points='" + strip + "'" + more, kDeskWork});
  };
  EXPECT_THAT(fitted("").aspects("task.Em"), IsEmpty());
  EXPECT_THAT(fitted(" spacing='0.7'").aspects("task.Em"), ElementsAre("grid"));
  EXPECT_THAT(fitted(" spacing='0.19'").aspects("task.Em"), IsEmpty());
}

// The light beside a post is that of its cell; a column takes the light of the cell with it.
TEST(Applicability, APostOnAPointTakesNoDarkCellAway) {
  const auto aspects = [](double side, const std::string& check) {
    Setting setting{"origin='3 3 0.75' u='2 0 0' v='0 2 0' count='9 9'", kDeskWork};
    setting.objects =
        fmt::format("<box id='post' size='{0} {0} 2' position='{1} {1} 0' material='m'/>", side,
                    4 - 0.5 * side);
    return fit(setting).aspects(check);
  };
  EXPECT_THAT(aspects(0.02, "task.Uo"), ElementsAre("points"));
  EXPECT_THAT(aspects(0.02, "task.Em"), IsEmpty());
  EXPECT_THAT(aspects(0.15, "task.Uo"), IsEmpty());
}

// What is cut out of a task is another task, whose dark part somebody has left out. A column may
// stand in it.
TEST(Applicability, HolesTakeNoMoreThanBodiesMay) {
  const auto aspects = [](double side) {
    return fit({frame(1, 7, 0.75, 4 - 0.5 * side, 4 + 0.5 * side), kDeskWork}).aspects("task.Em");
  };
  EXPECT_THAT(aspects(1.5), IsEmpty());
  EXPECT_THAT(aspects(2.5), ElementsAre("grid"));
}

// A limit from above is met by every plane that no light can meet.
TEST(Applicability, NothingIsProvedByAPlaneThatLightCannotMeet) {
  const auto aspects = [](double y, const std::string& more, const std::string& scene = "") {
    Setting setting{fmt::format("origin='6 {} 1' u='-1 0 0' v='0 0 1'", y),
                    "pack='lai' row='residential-night'" + scene};
    setting.room = "";
    setting.objects = more;
    return fit(setting).aspects("window.Ev");
  };
  EXPECT_THAT(aspects(1.0, ""), IsEmpty());  // the lamp is at y = 4, and it faces that way
  EXPECT_THAT(aspects(5.0, ""), ElementsAre("orientation"));
  const std::string decoy = "<luminaire id='d' type='spot' position='6 9 2.9' group='d'/>";
  EXPECT_THAT(aspects(5.0, decoy), IsEmpty());
  const std::string off = "<scene id='dark'><dim group='d' level='0'/></scene>";
  EXPECT_THAT(aspects(5.0, decoy + off, " scene='dark'"), ElementsAre("orientation"));
  const std::string weak = "<scene id='dark'><dim group='d' level='0.0005'/></scene>";
  EXPECT_THAT(aspects(5.0, decoy + weak, " scene='dark'"), ElementsAre("orientation"));
  const std::string facade = "<quad id='f' origin='0 1 0' u='12 0 0' v='0 0 6' material='m'/>";
  EXPECT_THAT(aspects(0.999, facade), ElementsAre("orientation"));
  EXPECT_THAT(aspects(1.001, facade), IsEmpty());
}

TEST(Applicability, ASpeckOfARouteIsTold) {
  const auto note = [](const std::string& points) {
    Setting setting{"points='" + points + "' width='0.2'", "pack='en1838:2024' scene='em'"};
    setting.element = "route";
    return fit(setting).first().note.english();
  };
  EXPECT_THAT(note("2 2 0 2.1 2 0"), HasSubstr("the route has only 0.02 m²"));
  EXPECT_THAT(note("2 2 0 4 2 0"), testing::Not(HasSubstr("has only")));
}

// The standard limits intensities from 60 degrees on of level ways, and in all directions of
// others.
TEST(Applicability, GlareOfLevelWaysIsOfNoStairs) {
  const auto aspects = [](const std::string& u, const std::string& role, const std::string& check) {
    return fit({"origin='0 0 0' u='" + u + "' v='0 2 0'",
                "pack='en1838:2024' scene='em' role='" + role + "'"})
        .aspects(check);
  };
  EXPECT_THAT(aspects("4 0 0", "glare", "glare.1"), IsEmpty());
  EXPECT_THAT(aspects("4 0 1.5", "glare", "glare.1"), ElementsAre("height"));
  EXPECT_THAT(aspects("4 0 1.5", "glare-stairs", "stairs.1"), IsEmpty());
}

TEST(Applicability, WhoStandsOnAPlatformIsTold) {
  const auto note = [](const std::string& size) {
    Setting setting{"height='1.45' margin='0.5'", kDeskWork};
    setting.objects = "<box id='podium' size='" + size + "' position='0.2 0.2 0' material='m'/>";
    return fit(setting).first().note.english();
  };
  EXPECT_THAT(note("11.6 7.6 0.7"), HasSubstr("is above 'podium', 0.7 m above the floor"));
  EXPECT_EQ(note("2 2 0.7"), "");
  EXPECT_EQ(note("11.6 7.6 0.05"), "");
}

TEST(Applicability, AStatedDeviationIsKeptAndTheNumberIsCompared) {
  const Fitted fitted =
      fit({"height='0.75' count='1 1'", kDeskWork,
           "<deviation in='grid' because='as measured' by='A. Meier' until='2026-11-22'/>"});
  ASSERT_EQ(fitted.requirements.size(), 2u) << testing::PrintToString(fitted.messages);
  for (const Requirement& requirement : fitted.requirements) {
    EXPECT_EQ(requirement.problem, "");
    ASSERT_EQ(requirement.deviations.size(), 1u);
    EXPECT_TRUE(requirement.deviations[0].is_accepted);
    EXPECT_EQ(requirement.deviations[0].stated->owner, "A. Meier");
  }
}

// Outdoors glare is rated on the area of the row, and what keeps the one from being judged keeps
// the other; each has its own deviations.
TEST(Applicability, GlareOutdoorsIsOfAnAreaThatFits) {
  const auto fitted = [](const std::string& plane, const std::string& of_glare = "") {
    return fit({plane,
                "pack='en12464-2' row='5.9-medium'/><require pack='en12464-2' row='5.9-medium' "
                "role='observer' reflectance='0.1'",
                of_glare, ""});
  };
  const std::string low = "origin='0 0 0' u='20 0 0' v='0 10 0'";
  const std::string high = "origin='0 0 2' u='20 0 0' v='0 10 0'";
  EXPECT_THAT(fitted(low).aspects("glare"), IsEmpty());
  EXPECT_THAT(fitted(low + " count='2 2'").aspects("glare"), ElementsAre("grid"));
  const Fitted refused = fitted(high);
  EXPECT_THAT(refused.aspects("task.Em"), ElementsAre("height"));
  EXPECT_THAT(refused.aspects("glare"), ElementsAre("height"));
  ASSERT_EQ(refused.requirements.size(), 3u);
  for (const Requirement& requirement : refused.requirements) EXPECT_NE(requirement.problem, "");
  const Fitted stated =
      fitted(high, "<deviation in='height' because='a deck' by='A. Meier' until='2026-12-01'/>");
  ASSERT_EQ(stated.requirements.size(), 3u);
  EXPECT_NE(stated.requirements[0].problem, "");  // it is stated of the glare alone
  EXPECT_EQ(stated.requirements[2].problem, "");
}

TEST(Applicability, AStatedDeviationEnds) {
  const Fitted fitted =
      fit({"height='0.75' count='1 1'", kDeskWork,
           "<deviation in='grid' because='as measured' by='A. Meier' until='2026-11-21'/>"});
  EXPECT_FALSE(fitted.first().deviations.at(0).is_accepted);
  EXPECT_THAT(fitted.first().problem.english(),
              HasSubstr("(accepted by A. Meier, but only until 2026-11-21)"));
}

TEST(Applicability, AnotherDeviationThanTheStatedOneCounts) {
  const Fitted fitted =
      fit({"height='1.8' margin='0.5'", kDeskWork,
           "<deviation in='grid' because='as measured' by='A. Meier' until='2030-01-01'/>"});
  EXPECT_THAT(fitted.first().problem.english(), HasSubstr("0.72 to 0.85 m above the floor"));
  EXPECT_EQ(fitted.first().note, "the project states a deviation in grid, but there is none");
}

TEST(Applicability, WhatIsStatedMustBeWhole) {
  const auto messages = [](const std::string& deviation) {
    return testing::PrintToString(fit({kWholeRoom, kDeskWork, deviation}).messages);
  };
  EXPECT_THAT(messages("<deviation in='grid' by='A' until='2030-01-01'/>"), HasSubstr("because"));
  EXPECT_THAT(messages("<deviation in='grid' because='x' until='2030-01-01'/>"), HasSubstr("'by'"));
  EXPECT_THAT(messages("<deviation in='grid' because='x' by='A'/>"), HasSubstr("until"));
  EXPECT_THAT(messages("<deviation in='light' because='x' by='A' until='2030-01-01'/>"),
              HasSubstr("allowed: orientation, place, height, grid, margin or points"));
  EXPECT_THAT(messages("<deviation in='grid' because='x' by='A' until='2030-02-30'/>"),
              HasSubstr("is not a date"));
  EXPECT_THAT(messages("<deviation in='grid' because='x' by='A' until='2030-01-01'/>"
                       "<deviation in='grid' because='y' by='B' until='2031-01-01'/>"),
              HasSubstr("given twice"));
  EXPECT_THAT(messages("<deviation in='grid' role='task' because='x' by='A' until='2030-01-01'/>"),
              HasSubstr("'role' has no meaning"));
}

TEST(Applicability, ALimitOfItsOwnHasNoDeviation) {
  const Fitted fitted = fit({kWholeRoom, "quantity='average' at-least='1'",
                             "<deviation in='grid' because='x' by='A' until='2030-01-01'/>"});
  EXPECT_THAT(testing::PrintToString(fitted.messages),
              HasSubstr("this <require> has its own limit"));
}

TEST(Applicability, ALimitOfItsOwnIsFree) {
  const Fitted fitted = fit({"height='1.8' count='1 1'", "quantity='average' at-least='1'"});
  EXPECT_EQ(fitted.first().problem, "");
  EXPECT_EQ(fitted.first().note, "");
  EXPECT_THAT(fitted.messages, IsEmpty());
}

TEST(Applicability, MaintainedLightNeedsAMaintenanceFactor) {
  Setting setting{kWholeRoom, kDeskWork};
  setting.root = "";
  const Fitted fitted = fit(setting);
  EXPECT_EQ(fitted.first().problem,
            "the requirement is for a maintained value; luminaire type 'spot' states no "
            "maintenance factor");
  EXPECT_THAT(fitted.messages, IsEmpty()) << "not judged is said with the requirement";
}

TEST(Applicability, OwnLimitsWarnOfAMissingMaintenanceFactor) {
  Setting setting{kWholeRoom, "quantity='average' at-least='1'"};
  setting.root = "";
  EXPECT_THAT(testing::PrintToString(fit(setting).messages), HasSubstr("maintenance-not-stated"));
  setting.require += " state='initial'";
  EXPECT_THAT(fit(setting).messages, IsEmpty());
}

TEST(Applicability, PointsThatAreLostAreNamedWithEveryRequirement) {
  Setting setting{kWholeRoom, "quantity='average' at-least='1'"};
  setting.objects = "<box id='desk' size='1 1 0.8' position='5 2.5 0' material='m'/>";
  const Fitted own = fit(setting);
  EXPECT_THAT(own.first().note.english(), HasSubstr("points are omitted: 1 inside 'desk'"));
  EXPECT_EQ(own.first().problem, "");
  setting.require = kDeskWork;
  const Fitted few = fit(setting);
  EXPECT_EQ(few.first().problem, "") << "a point in seventy is no harm, and is named";
  EXPECT_THAT(few.first().note.english(), HasSubstr("inside 'desk'"));
  setting.objects = "<box id='desk' size='6 5 0.8' position='2 2 0' material='m'/>";
  EXPECT_THAT(fit(setting).aspects("task.Em"), ElementsAre("points"));
}

// Of a plane that a project draws itself it is known where the rack is.
TEST(Applicability, ABandThatIsDrawnDoesNotEndAtARack) {
  Setting setting{"height='0.75' margin='0.5'", "pack='en12464-1:2021' row='34.2' role='surround'"};
  setting.objects = "<box id='b' size='6 8 2' position='0 0 0' material='m'/>";
  EXPECT_THAT(fit(setting).aspects("surround.Em"), ElementsAre("points"));
}

TEST(Applicability, AListMayNotFaceElsewhere) {
  calc::CalcPlane list;
  list.area = calc::PointList{"", {{0, 0, 1}, {1, 0, 1}}, {{1, 0, 0}, {0, 0, 1}}, {}};
  calc::SensorGrid grid;
  grid.position_m = std::get<calc::PointList>(list.area).position_m;
  Requirement requirement;
  requirement.origin = {"rp-8:2014", "vertical.min", "medium", {}, {}};
  std::vector<Requirement> requirements{requirement};
  const std::vector<RulePack> packs = builtin_rule_packs();
  check_applicability({calc::Project{}, calc::Space{}, list, grid, packs, kToday}, requirements);
  EXPECT_THAT(requirements[0].problem.english(),
              HasSubstr("role 'vertical' of rp-8:2014 requires the orientation vertical; this "
                        "plane has another"));
  EXPECT_THAT(requirements[0].problem.english(), HasSubstr("the points are a list"));
}

// 1.5 m above the pavement: that is the middle of an upright plane, which is not tall.
TEST(Applicability, AnUprightPlaneIsAtTheOneHeightOfItsRole) {
  const std::string vertical = "pack='rp-20' row='lot-enhanced' role='vertical'";
  EXPECT_THAT(fit({"origin='2 2 1' u='2 0 0' v='0 0 1'", vertical}).aspects("vertical.min"),
              IsEmpty());
  EXPECT_THAT(fit({"origin='2 2 0' u='2 0 0' v='0 0 1'", vertical}).first().problem.english(),
              HasSubstr("planes of role 'vertical' of rp-20:1998 are 1.5 m above the floor; this "
                        "plane is at 0 to 1 m"));
  for (const char* elsewhere :
       {"origin='2 2 1.5' u='2 0 0' v='0 0 1'", "origin='2 2 0.5' u='2 0 0' v='0 0 1'",
        "origin='2 2 0.9' u='2 0 0' v='0 0 1.2'", "origin='2 2 0' u='2 0 0' v='0 0 3'"}) {
    EXPECT_THAT(fit({elsewhere, vertical}).aspects("vertical.min"), ElementsAre("height"))
        << elsewhere;
  }
}

// What is laid a little above the floor is on it; rows have heights of their own.
TEST(Applicability, ARowAboutAFloorSaysSo) {
  const std::string row = "pack='en12464-1:2021' row='9.4'";
  EXPECT_THAT(fit({"height='0.02' margin='0.5'", row}).aspects("task.Em"), IsEmpty());
  EXPECT_THAT(fit({kWholeRoom, row}).first().problem.english(),
              HasSubstr("planes of role 'task' of en12464-1:2021 are 0 to 0.2 m above the floor "
                        "in row 9.4; this plane is at 0.75 m"));
}

TEST(Applicability, HeightsHaveSomeLatitude) {
  const auto aspects = [](const std::string& height, const std::string& require) {
    return fit({"height='" + height + "' margin='0.5'", require}).aspects("task.Em");
  };
  EXPECT_THAT(aspects("0.9", kDeskWork), IsEmpty());
  EXPECT_THAT(aspects("0.91", kDeskWork), ElementsAre("height"));
  EXPECT_THAT(aspects("0.67", kDeskWork), IsEmpty());
  EXPECT_THAT(aspects("0", kDeskWork), ElementsAre("height"));
  EXPECT_THAT(aspects("0", "pack='en12464-1:2021' row='9.4'"), IsEmpty());
  EXPECT_THAT(aspects("0.75", "pack='en12464-1:2021' row='9.4'"), ElementsAre("height"));
}

// In the open space the ground is what lies below, or z = 0.
TEST(Applicability, HeightsOutdoorsAreAboveTheGroundBelow) {
  Setting setting{"origin='4 2 0.0' u='8 0 0' v='0 2 0'", "pack='en13201-2' row='P4'"};
  setting.room = "";
  EXPECT_THAT(fit(setting).aspects("P.average"), IsEmpty());
  setting.plane = "origin='4 2 1.5' u='8 0 0' v='0 2 0'";
  EXPECT_THAT(fit(setting).aspects("P.average"), ElementsAre("height"));
  setting.objects = "<quad id='deck' origin='0 0 1.48' u='20 0 0' v='0 20 0' material='m'/>";
  EXPECT_THAT(fit(setting).aspects("P.average"), IsEmpty());
  setting.plane = "origin='4 2 0.02' u='8 0 0' v='0 2 0'";
  EXPECT_THAT(fit(setting).aspects("P.average"), IsEmpty()) << "below the deck, on the ground";
}

TEST(Applicability, ALimitFromAboveNeedsLightFromThatSide) {
  Setting setting{"origin='4 2 0.0' u='8 0 0' v='0 2 0'", "pack='en13201-2' row='P4'"};
  setting.room = "";
  EXPECT_THAT(fit(setting).aspects("P.not-too-much"), IsEmpty());
  setting.plane = "origin='4 2 5' u='8 0 0' v='0 2 0'";  // above the only luminaire
  EXPECT_THAT(fit(setting).aspects("P.not-too-much"), ElementsAre("orientation", "height"));
}

const std::string kEmergency = "pack='en1838:2013' scene='em'";

Fitted fit_route(const std::string& route, const std::string& require = kEmergency,
                 const std::string& objects = "") {
  Setting setting{route, require};
  setting.objects = objects;
  setting.element = "route";
  return fit(setting);
}

TEST(ApplicabilityOfRoute, FollowsItsLineAndTheFloor) {
  const Fitted fitted = fit_route("points='1 1 0  9 1 0  9 6 0' width='1.5'");
  EXPECT_THAT(fitted.messages, IsEmpty());
  ASSERT_EQ(fitted.requirements.size(), 3u);
  for (const Requirement& requirement : fitted.requirements) {
    EXPECT_THAT(requirement.deviations, IsEmpty());
    EXPECT_EQ(requirement.problem, "");
    EXPECT_THAT(requirement.note.english(), testing::Not(HasSubstr("omitted")));
  }
}

// The pack allows 1 m. The second leg is 5.75 m long at its outer edge.
TEST(ApplicabilityOfRoute, NeedsThePacksPointsOnEveryLeg) {
  const Fitted coarse = fit_route("points='1 1 0  9 1 0  9 6 0' width='1.5' spacing='1.5 0.5'");
  EXPECT_THAT(coarse.aspects("route.line"), ElementsAre("grid"));
  EXPECT_EQ(coarse.first().problem,
            "the grid has 6 x 3 points along and across leg 1 of the route; role 'route' of "
            "en1838:2013 requires 9 x 2 (to accept it, add <deviation in=\"grid\">)");
  const Fitted narrow = fit_route("points='1 1 0  9 1 0' width='1.5' spacing='0.5 2'");
  EXPECT_THAT(narrow.aspects("route.line"), ElementsAre("grid"));
  EXPECT_THAT(fit_route("points='1 1 0  9 1 0' width='1.5' spacing='1'").aspects("route.line"),
              IsEmpty());
}

TEST(ApplicabilityOfRoute, ItsHeightIsWhatItStates) {
  const std::string line = "points='1 1 0.2  9 1 0.2' width='1.5' height=";
  EXPECT_THAT(fit_route(line + "'0.2'").aspects("route.line"), IsEmpty());
  const Fitted high = fit_route(line + "'0.5'");
  EXPECT_THAT(high.aspects("route.line"), ElementsAre("height"));
  EXPECT_THAT(high.first().problem.english(),
              HasSubstr("above the floor; the points of this route are at 0.5 m"));
}

TEST(ApplicabilityOfRoute, IsNoUprightPlane) {
  const Fitted fitted = fit_route("points='1 1 0  9 1 0' width='1.5'",
                                  "pack='en1838:2024' role='safety-item' scene='em'");
  EXPECT_THAT(fitted.first().problem.english(),
              HasSubstr("requires the orientation vertical; the points of a route face up"));
}

// 16 stations and 5 rows: a table of half the width leaves a way, whatever its length; one across
// the whole width leaves none.
TEST(ApplicabilityOfRoute, ATableInTheWayIsNamedAndWhatItTakesCounts) {
  const auto with_table = [](const std::string& size) {
    return fit_route("points='1 1 0  9 1 0' width='1.5'", kEmergency,
                     "<box id='table' size='" + size + " 0.72' position='3 0 0' material='m'/>");
  };
  const Fitted small = with_table("1 0.9");
  EXPECT_EQ(small.first().problem, "");
  EXPECT_THAT(small.first().note.english(), HasSubstr("4 of 80 points are omitted: 4 at 'table'"));
  const Fitted large = with_table("4 0.9");
  EXPECT_THAT(large.aspects("route.line"), ElementsAre("points"));
  EXPECT_THAT(large.first().problem.english(),
              HasSubstr("16 of 80 points are omitted: 16 at 'table'"));
  const Fitted across = with_table("0.5 2");
  EXPECT_THAT(across.aspects("route.line"), ElementsAre("points"));
  EXPECT_THAT(across.first().problem.english(),
              HasSubstr("nobody can pass at (3.25, 0.4, 0) m: 'table' takes the whole width; 5 "
                        "of 80 points are omitted"));
}

// No point lies in it.
TEST(ApplicabilityOfRoute, NobodyGoesThroughAWall) {
  const auto barred = [](const std::string& objects) {
    const Fitted fitted = fit_route("points='1 1 0  9 1 0' width='1.5'", kEmergency, objects);
    return fitted.first().problem.english().substr(0, fitted.first().problem.english().find(" m:"));
  };
  EXPECT_EQ(barred("<box id='wall' size='0.1 8 3' position='4.95 0 0' material='m'/>"),
            "nobody can pass at (4.75, 0.4, 0)");
  EXPECT_EQ(barred("<quad id='door' origin='5 0 0' u='0 8 0' v='0 0 3' material='m'/>"),
            "nobody can pass at (4.75, 0.4, 0)");
  EXPECT_EQ(barred("<quad id='lintel' origin='5 0 2' u='0 8 0' v='0 0 1' material='m'/>"), "");
  EXPECT_EQ(barred("<quad id='wing' origin='5 0 0' u='0 1.1 0' v='0 0 3' material='m'/>"), "")
      << "there is a way past it";
}

// A line that climbs where there is no stair: from 0.5 m on nothing is below it.
TEST(ApplicabilityOfRoute, AMissingStairIsNoFloor) {
  const Fitted fitted = fit_route("points='1 1 0  9 1 2' width='1.5'");
  EXPECT_THAT(fitted.aspects("route.line"), ElementsAre("points"));
  EXPECT_THAT(fitted.first().problem.english(),
              HasSubstr("60 of 80 points are omitted: 60 without a floor"));
}

TEST(ApplicabilityOfRoute, SaysThatPointsCountAlikeInAShare) {
  const std::string share = "quantity='percentile' percent='50' at-least='1'";
  EXPECT_THAT(fit_route("points='1 1 0  9 1 0  9 6 0' width='1.5'", share).first().note.english(),
              HasSubstr("all points have equal weight, although cells at bends differ in area"));
  EXPECT_EQ(fit_route("points='1 1 0  9 1 0' width='1.5'", share).first().note, "");
}

TEST(Applicability, AFloatingPlaneIsNoWall) {
  const std::string wall = kDeskWork + " role='wall'";
  EXPECT_THAT(fit({"on='wall1' margin='0.5'", wall}).aspects("wall.Em"), IsEmpty());
  EXPECT_THAT(
      fit({"origin='0.5 0.04 0.5' u='0 0 2' v='11 0 0' margin='0.5'", wall}).aspects("wall.Em"),
      ElementsAre("place"))
      << "a little before it, and its own edges do not count";
  EXPECT_THAT(fit({"origin='0 0.04 0' u='0 0 3' v='12 0 0' margin='0.5'", wall}).aspects("wall.Em"),
              IsEmpty())
      << "a little before it";
  EXPECT_THAT(fit({"origin='2 2 0.5' u='0 0 2' v='4 0 0' margin='0.5'", wall}).aspects("wall.Em"),
              ElementsAre("place"));
  EXPECT_THAT(fit({"height='1' margin='0.5'", wall}).aspects("wall.Em"),
              ElementsAre("orientation"));
}

TEST(Applicability, CylindersOfALyingPlaneStandUprightAndOthersDoNot) {
  const std::string cylinder = kDeskWork + " role='cylinder'";
  const std::string lying = "origin='2 2 1.2' u='8 0 0' v='0 2.4 0'";
  const std::string over = "origin='2 2 1.2' u='0 2.4 0' v='8 0 0'";
  const std::string upright = "origin='2 2 1.2' u='8 0 0' v='0 0 0.4'";
  const std::string leaning = "origin='2 2 1.2' u='8 0 0' v='0 0.4 0.2'";
  const std::string quantity = " quantity='cylindrical'";
  EXPECT_THAT(fit({lying + quantity, cylinder}).aspects("cylinder.Em"), IsEmpty());
  EXPECT_THAT(fit({over + quantity, cylinder}).aspects("cylinder.Em"), IsEmpty())
      << "either end of a cylinder may be up";
  EXPECT_THAT(fit({upright + quantity, cylinder}).aspects("cylinder.Uo"),
              ElementsAre("orientation"));
  EXPECT_THAT(fit({leaning + quantity, cylinder}).aspects("cylinder.Em"),
              ElementsAre("orientation"));
  EXPECT_THAT(fit({upright + " quantity='cylindrical'", cylinder}).first().problem.english(),
              HasSubstr("role 'cylinder' of en12464-1:2021 requires vertical cylinders; those of "
                        "this plane lean 90 degrees from vertical"));
  EXPECT_THAT(fit({leaning + " quantity='cylindrical'", cylinder}).first().problem.english(),
              HasSubstr("lean 27 degrees"));
}

// A square metre of the wall is no wall, wherever it lies: its own edges do not count, either.
TEST(Applicability, APartOfAWallIsNotTheWall) {
  const std::string wall = kDeskWork + " role='wall'", ceiling = kDeskWork + " role='ceiling'";
  const auto of_wall = [&](const std::string& plane) { return fit({plane, wall}); };
  const Fitted patch = of_wall("origin='2.5 0 1' u='-1 0 0' v='0 0 1'");
  EXPECT_THAT(patch.aspects("wall.Em"), ElementsAre("place", "grid"));
  EXPECT_THAT(patch.first().problem.english(),
              HasSubstr("role 'wall' of en12464-1:2021 applies to a whole wall; the counted part "
                        "of this plane covers only 0 % of the 22 m² of 'r.wall1' (0.5 m along "
                        "the edges do not count in either area)"));
  // Two thirds; a speck between two of the places where it is measured; one in a corner.
  EXPECT_THAT(of_wall("origin='8 0 0' u='-8 0 0' v='0 0 3' margin='0.5'").first().problem.english(),
              HasSubstr("64 % of the 22 m² of 'r.wall1'"));
  EXPECT_THAT(of_wall("origin='2.501 0 1' u='-0.001 0 0' v='0 0 0.001'").aspects("wall.Uo"),
              testing::Contains("place"));
  EXPECT_THAT(of_wall("origin='0.3 0 0' u='-0.3 0 0' v='0 0 0.3'").aspects("wall.Uo"),
              testing::Contains("place"));
  // A tenth may lack, as of points.
  EXPECT_THAT(of_wall("origin='11.5 0 0' u='-11.5 0 0' v='0 0 3' margin='0.5'").aspects("wall.Em"),
              IsEmpty());
  EXPECT_THAT(of_wall("origin='10.8 0 0' u='-10.8 0 0' v='0 0 3' margin='0.5'").aspects("wall.Em"),
              ElementsAre("place"));
  EXPECT_THAT(fit({"points='12 8 3  12 0 3  0 0 3'", ceiling}).aspects("ceiling.Em"),
              testing::Contains("place"))
      << "half of the ceiling";
  EXPECT_THAT(fit({"on='ceiling' margin='0.5'", ceiling}).aspects("ceiling.Em"), IsEmpty());
}

TEST(Applicability, APartOfAWallIsJudgedIfSomebodyStatesIt) {
  const std::string stated =
      "<deviation in='place' because='the rest is glass' by='A. Meier' until='2027-12-31'/>";
  const Fitted fitted =
      fit({"origin='8 0 0' u='-8 0 0' v='0 0 3' margin='0.5'", kDeskWork + " role='wall'", stated});
  EXPECT_EQ(fitted.first().problem, "");
  EXPECT_THAT(fitted.first().deviations.at(0).words.english(), HasSubstr("64 %"));
}

// Two pieces of one straight side: each by itself, or both together.
TEST(Applicability, AWallInPiecesIsCoveredPieceByPiece) {
  const std::string room =
      "<room id='r' height='3' footprint='0 0  7 0  12 0  12 8  0 8' "
      "ceiling='m' walls='m' floor='m'>";
  const auto aspects = [&](const std::string& plane) {
    return fit({plane, kDeskWork + " role='wall'", "", room}).aspects("wall.Em");
  };
  EXPECT_THAT(aspects("on='wall1' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("on='wall2' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("origin='12 0 0' u='-12 0 0' v='0 0 3' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("origin='10 0 0' u='-10 0 0' v='0 0 3' margin='0.5'"), ElementsAre("place"));
}

// The surfaces of a room are cut where a window lies in them, and are still those surfaces.
TEST(Applicability, AWallWithAWindowDrawnInItIsAWall) {
  const std::string room =
      "<material id='glass' reflectance='0.1'/><room id='r' size='12 8 3' ceiling='m' walls='m' "
      "floor='m'><quad id='w' origin='1 0 1' u='9 0 0' v='0 0 1' material='glass'/>";
  const auto aspects = [&](const std::string& plane) {
    return fit({plane, kDeskWork + " role='wall'", "", room}).aspects("wall.Em");
  };
  EXPECT_THAT(aspects("on='wall1' margin='0.5'"), IsEmpty());
  EXPECT_THAT(aspects("origin='8 0 0' u='-8 0 0' v='0 0 3' margin='0.5'"), ElementsAre("place"));
}

TEST(Applicability, ASpeckIsSaid) {
  EXPECT_EQ(fit({"origin='2 2 0.75' u='0.02 0 0' v='0 0.02 0'", kDeskWork}).first().note,
            "the plane has only 0.0004 m²");
  EXPECT_EQ(fit({"origin='2 2 0.75' u='0.4 0 0' v='0 0.3 0'", kDeskWork}).first().note, "");
  EXPECT_EQ(fit({"origin='2 2 0.75' u='0.02 0 0' v='0 0.02 0'", "quantity='average' at-least='1'"})
                .first()
                .note,
            "");
}

// The formula gives what a mask leaves a closer grid than the whole.
TEST(Applicability, TheGridIsThatOfWhatTheMaskLeaves) {
  const Fitted fitted = fit({"on='wall1'", kDeskWork + " role='wall'"});
  EXPECT_THAT(fitted.aspects("wall.Em"), ElementsAre("grid"));
  EXPECT_THAT(fitted.first().problem.english(),
              HasSubstr("the mask leaves 26 x 5 points; role 'wall' of en12464-1:2021 requires "
                        "33 x 6 on the remaining 11.1 x 2.14 m"));
  EXPECT_THAT(fit({"on='wall1' count='40 12'", kDeskWork + " role='wall'"}).aspects("wall.Em"),
              IsEmpty());
}

// What fits, and how each aspect is spoilt, by role. In a room of 12 m x 8 m x 3 m.
struct RolePlane {
  std::string fits, turned, lifted, drawn;
  double top_m = 3.0;      // of what swallows points
  double margin_m = 0.75;  // too wide for the role, and leaves something
};

RolePlane plane_of(const std::string& role) {
  const auto flat = [](double z) {
    return fmt::format("origin='2 2 {}' u='8 0 0' v='0 2.4 0'", z);
  };
  const auto turned = [](double z) {
    return fmt::format("origin='2 2 {}' u='0 2.4 0' v='8 0 0'", z);
  };
  const std::string upright = "origin='2 2 0.4' u='4 0 0' v='0 0 2'";
  const std::string apart = "origin='2 2 0.5' u='0 0 2' v='4 0 0'";
  if (role == "wall") return {"on='wall1' margin='0.5'", flat(1), "", apart};
  if (role == "ceiling") {
    return {"on='ceiling' margin='0.5'", flat(1), "", "origin='2 2 2' u='0 2 0' v='4 0 0'"};
  }
  if (role == "vertical") {
    return {"origin='2 2 1' u='4 0 0' v='0 0 1'",
            flat(1.5),
            "origin='2 2 2' u='4 0 0' v='0 0 0.9'",
            "",
            3.0,
            0.4};
  }
  if (role == "safety-item" || role == "shelf") {
    return {upright, flat(1.5), "origin='2 2 2' u='4 0 0' v='0 0 0.9'", ""};
  }
  if (role == "window") {  // an upper limit: it looks at the luminaires
    return {"origin='6 2 0.4' u='-4 0 0' v='0 0 2'", flat(1.5), "", ""};
  }
  if (role == "ground") {
    const std::string quantity = " quantity='hemispherical'";
    // In the floor itself it would have no point left.
    return {flat(0) + quantity, turned(0.05) + quantity, flat(1) + quantity, "", 0.4};
  }
  if (role == "faces") {  // half-cylinders look sideways on any plane
    const std::string quantity = " quantity='semicylindrical' direction='1 0 0'";
    return {flat(1.5) + quantity, "", flat(0.2) + quantity, "", 1.8};
  }
  if (role == "ambient") return {flat(0.76), turned(0.76), flat(1.8), "", 1.1};
  if (role == "task" || role == "surround") return {flat(0.75), turned(0.75), flat(1.8), "", 1.1};
  if (role == "cylinder") {
    const std::string quantity = " quantity='cylindrical'";
    const std::string lying = "origin='2 2 1.2' u='8 0 0' v='0 0 0.3'";
    return {flat(1.2) + quantity, lying + quantity, flat(0.2) + quantity, "", 1.5};
  }
  if (role == "modelling") {
    const std::string quantity = " quantity='modelling'";
    return {flat(1.2) + quantity, turned(1.2) + quantity, flat(0.2) + quantity, "", 1.5};
  }
  if (role == "observer") {
    const std::string quantity = " quantity='ugr' direction='1 0 0'";
    return {flat(1.2) + quantity, turned(1.2) + quantity, flat(0.2) + quantity, "", 1.5};
  }
  return {flat(0), turned(0), flat(1), "", 0.4};
}

Setting spoilt(const Setting& whole, const RolePlane& plane, const std::string& aspect) {
  Setting setting = whole;
  if (aspect == "orientation") setting.plane = plane.turned;
  if (aspect == "height") setting.plane = plane.lifted;
  if (aspect == "place") setting.plane = plane.drawn;
  if (aspect == "grid") setting.plane += " count='1 1'";
  if (aspect == "margin") {
    const std::size_t own = setting.plane.find(" margin=");
    if (own != std::string::npos) setting.plane.resize(own);
    setting.plane += fmt::format(" margin='{}'", plane.margin_m);
  }
  if (aspect == "points") {  // less than 0.5 m above the plane: no rack, where a band would end
    setting.objects =
        fmt::format("<box id='b' size='8 3 {}' position='3.3 0 0' material='m'/>", plane.top_m);
  }
  if (aspect == "maintenance") setting.root = "";
  return setting;
}

std::string attribute(const calc::XmlElement& element, const char* name) {
  const calc::XmlAttribute* found = element.find(name);
  return found == nullptr ? "" : found->value;
}

bool is_refused(const Fitted& fitted, const std::string& check, const std::string& aspect) {
  return std::any_of(fitted.requirements.begin(), fitted.requirements.end(), [&](const auto& r) {
    if (r.origin.check != check || r.problem.empty()) return false;
    if (aspect == "maintenance")
      return r.problem.english().find("maintained value") != std::string::npos;
    return std::any_of(r.deviations.begin(), r.deviations.end(),
                       [&](const Deviation& d) { return calc::name_of(d.aspect) == aspect; });
  });
}

// What somebody has let into the zone is held against the grid as it is asked, not as the pack has
// it: 0.3 m along the edges in place of 0.5 m.
TEST(Applicability, AMaskThatIsNarrowedIsHeldAgainstItsOwnGrid) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><material id='m' reflectance='0.5'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/>"
      "<room id='r' size='8 5 3' ceiling='m' walls='m' floor='m'>"
      "<luminaire id='l' type='spot' position='4 2 2.9'/>"
      "<workplace id='w' pack='en12464-1:2021' row='34.2' origin='2 2' size='2 1.5'>"
      "<zone role='wall' margin='0.3'/></workplace></room></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"spot.ies", kIes}});
  const std::vector<RulePack> packs = builtin_rule_packs();
  const auto judged = load_judged_project(files, "p.xml", packs, diagnostics);
  ASSERT_TRUE(judged.has_value());
  const calc::Space& space = judged->project.spaces.at(0);
  int walls = 0;
  for (const calc::CalcPlane& plane : space.planes) {
    if (!plane.id.starts_with("w.wall")) continue;
    const auto grid = calc::make_sensor_grid(plane, space, diagnostics);
    std::vector<Requirement> requirements = requirements_of_plane(judged->requirements, plane.id);
    check_applicability({judged->project, space, plane, *grid, packs, kToday}, requirements);
    for (const Requirement& r : requirements) EXPECT_EQ(r.problem, "") << plane.id;
    walls += static_cast<int>(requirements.size());
  }
  EXPECT_EQ(walls, 8);
}

TEST(Applicability, HolesThatOverlapAreTakenOffOnce) {
  calc::CalcPlane plane;
  calc::PlanarArea area;
  area.outline_m = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  area.holes_m = {{{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}}, {{0.5, 0}, {1.5, 0}, {1.5, 1}, {0.5, 1}}};
  plane.area = area;
  const calc::SensorGrid grid;
  EXPECT_EQ(small_task_words(plane, grid), "");
  area.holes_m[0] = {{0, 0}, {1.95, 0}, {1.95, 1}, {0, 1}};
  plane.area = area;
  EXPECT_EQ(small_task_words(plane, grid), calc::say<calc::Sentence::speck>(0.05));
}

// One point may stand where no luminaire shines to.
TEST(Applicability, OfBystandersTheGridIsTheRules) {
  const Setting few{"origin='0 2 1' u='12 0 0' v='0 0 2' count='1 1'",
                    "pack='en12464-2:2014' row='E3' role='bystander'", "", ""};
  EXPECT_THAT(fit(few).aspects("bystander"), ElementsAre("grid"));
  Setting enough = few;
  enough.plane = "origin='0 2 1' u='12 0 0' v='0 0 2'";
  EXPECT_THAT(fit(enough).aspects("bystander"), IsEmpty());
}

// tests/rules_corpus says of every check in what a plane may be unfit for it: unfit="...", worked
// out from what is known of the standards, not from the packs. A plane that is unfit in one of them
// is refused for it; one that fits is not; nothing else refuses.
TEST(ApplicabilityCorpus, EveryCheckRefusesWhatItIsNotAbout) {
  const std::vector<RulePack> packs = builtin_rule_packs();
  std::size_t cases = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kCorpus)) {
    if (entry.path().extension() != ".xml") continue;
    if (entry.path().filename().string().starts_with("together.")) continue;
    SCOPED_TRACE(entry.path().string());
    std::ifstream file(entry.path(), std::ios::binary);
    calc::Diagnostics diagnostics;
    const auto root = calc::parse_xml({std::istreambuf_iterator<char>(file), {}},
                                      entry.path().string(), diagnostics);
    ASSERT_TRUE(root.has_value());
    const std::string pack_id = attribute(*root, "pack"), check_id = attribute(*root, "check");
    const auto pack = std::find_if(packs.begin(), packs.end(),
                                   [&](const RulePack& p) { return p.full_id() == pack_id; });
    ASSERT_NE(pack, packs.end());
    const RuleCheck* check = pack->find_check(check_id);
    ASSERT_NE(check, nullptr);
    ASSERT_NE(root->find("unfit"), nullptr) << "say in what a plane may be unfit, or unfit=\"\"";
    if (!check->quantity->kernel) {
      EXPECT_EQ(attribute(*root, "unfit"), "") << "it is not about planes";
      continue;
    }
    std::string require = fmt::format("pack='{}' role='{}'", pack_id, check->role);
    const std::string row = attribute(root->children.at(0), "row");
    if (!row.empty()) require += fmt::format(" row='{}'", row);
    if (!pack->facts.empty()) require += " facts='task-illuminance=500 lx'";
    if (check->sources == LightSources::emergency) require += " scene='em'";
    // Outdoors, and in rows about corridors, the task is on the ground.
    const RuleRow* of_row = pack->find_row(row);
    const bool is_low =
        (of_row != nullptr && of_row->task_heights_m) || pack_id == "en12464-2:2014";
    const bool is_task = check->role == "task" || check->role == "surround";
    const RolePlane of_role = plane_of(is_low && is_task ? "floor" : check->role);
    const Setting whole{of_role.fits, require};
    const Fitted fits = fit(whole);
    ASSERT_FALSE(fits.requirements.empty()) << testing::PrintToString(fits.messages);
    EXPECT_THAT(fits.aspects(check_id), IsEmpty());

    std::istringstream words(attribute(*root, "unfit"));
    std::set<std::string> stated;
    for (std::string word; words >> word;) stated.insert(word);
    for (const std::string aspect :
         {"orientation", "place", "height", "grid", "margin", "points", "maintenance"}) {
      const Setting setting = spoilt(whole, of_role, aspect);
      if (setting.plane.empty()) {
        EXPECT_FALSE(stated.contains(aspect));
        continue;
      }
      const bool refused = is_refused(fit(setting), check_id, aspect);
      EXPECT_EQ(refused, stated.contains(aspect)) << aspect;
      ++cases;
    }
  }
  EXPECT_GT(cases, 300u);
}

}  // namespace
}  // namespace rules::applicability_test
