#include "rules/binding/workplace.h"
#include "calc/scene/polygon.h"
#include "calc/scene/sensor_grid.h"
#include "calc/scene/zone_shapes.h"
#include "rules/binding/bind.h"
#include "rules/binding/judged_project.h"
#include "rules/catalogue/mask.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rules::workplace_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";

struct Made {
  calc::Project project;
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;

  const calc::Space& space() const { return project.spaces.at(0); }
  std::vector<std::string> ids() const {
    std::vector<std::string> ids;
    for (const calc::CalcPlane& plane : space().planes) ids.push_back(plane.id);
    return ids;
  }
  const calc::CalcPlane& plane(const std::string& id) const {
    for (const calc::CalcPlane& plane : space().planes) {
      if (plane.id == id) return plane;
    }
    ADD_FAILURE() << "no plane " << id << ": " << testing::PrintToString(messages);
    static const calc::CalcPlane none;
    return none;
  }
  const calc::PlanarArea& area(const std::string& id) const {
    return std::get<calc::PlanarArea>(plane(id).area);
  }
  calc::SensorGrid grid(const std::string& id) const {
    calc::Diagnostics diagnostics;
    const auto grid = calc::make_sensor_grid(plane(id), space(), diagnostics);
    EXPECT_THAT(diagnostics.all(), IsEmpty()) << id;
    return grid.value_or(calc::SensorGrid{});
  }
  double area_m2(const std::string& id) const {
    return calc::area_left(area(id).outline_m, area(id).holes_m);
  }
  double height_m(const std::string& id) const {
    return area(id).origin_m.z - space().shell->floor_z_m;
  }
};

// `lines` from line 5 on, in a room of 12 x 8 x 2.8 m whose corner is at (10, 20, 1), or with this
// shape.
Made make(const std::string& lines, const std::string& shape = "size='12 8 2.8'",
          const std::vector<RulePack>& packs = builtin_rule_packs()) {
  const std::string xml =
      "<luxgate version='1'>\n<material id='white' reflectance='0.7'/><luminaire-type id='spot' "
      "photometry='spot.ies'/>\n<scene id='night'/>\n<room id='r' origin='10 20 1' " +
      shape + " ceiling='white' walls='white' floor='white'>\n" + lines +
      "\n<luminaire id='l' type='spot' position='1 1 2.5'/></room></luxgate>";
  calc::Diagnostics diagnostics;
  Made made;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"spot.ies", kIes}});
  if (auto judged = load_judged_project(files, "p.xml", packs, diagnostics)) {
    made.requirements = std::move(judged->requirements);
    made.project = std::move(judged->project);
  }
  for (const auto& d : diagnostics.all()) made.messages.push_back(format_diagnostic(d));
  return made;
}

std::string workplace(const std::string& attributes, const std::string& children = "") {
  return "<workplace id='w' pack='en12464-1:2021' row='34.2' " + attributes + ">" + children +
         "</workplace>";
}

const std::string kDesk = "origin='4 3' size='2 1.5'";  // 0.5 m and more from every wall

std::vector<double> limits_of(const Made& made, const std::string& plane) {
  std::vector<double> limits;
  for (const Requirement& r : requirements_of_plane(made.requirements, plane)) {
    EXPECT_EQ(r.problem, "") << plane;
    EXPECT_EQ(r.note, "") << plane;
    limits.push_back(r.limit);
  }
  return limits;
}

TEST(Workplace, AGivenTaskHasAllZonesWithTheRowsLimits) {
  const Made made = make(workplace(kDesk));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(),
              ElementsAre("w.task", "w.surround", "w.background", "w.wall.1", "w.wall.2",
                          "w.wall.3", "w.wall.4", "w.ceiling", "w.cylinder", "w.modelling",
                          "w.observer.1", "w.observer.2", "w.observer.3", "w.observer.4"));
  EXPECT_THAT(limits_of(made, "w.task"), ElementsAre(500, 0.6));
  EXPECT_THAT(limits_of(made, "w.surround"), ElementsAre(300, 0.4));
  EXPECT_THAT(limits_of(made, "w.background"), ElementsAre(100, 0.1));
  EXPECT_THAT(limits_of(made, "w.wall.3"), ElementsAre(150, 0.1));
  EXPECT_THAT(limits_of(made, "w.ceiling"), ElementsAre(100, 0.1));
  EXPECT_THAT(limits_of(made, "w.cylinder"), ElementsAre(150, 0.1));
  EXPECT_EQ(made.plane("w.cylinder").kernel, calc::ReceiverKernel::cylindrical);
  EXPECT_EQ(made.plane("w.wall.2").name, "w: wall 2");
  EXPECT_EQ(made.plane("w.modelling").derived, calc::DerivedQuantity::modelling);
  const calc::CalcPlane& observer = made.plane("w.observer.3");
  EXPECT_EQ(observer.derived, calc::DerivedQuantity::ugr);
  EXPECT_NEAR(glm::length(observer.direction), 1.0, 1e-12);
  const auto glare = requirements_of_plane(made.requirements, "w.observer.3");
  ASSERT_EQ(glare.size(), 1u);
  EXPECT_EQ(glare[0].limit, 19);
  EXPECT_THAT(glare[0].note.english(), HasSubstr("not by the tabular method"));
  EXPECT_NEAR(made.height_m("w.observer.3"), 1.2, 1e-12);
}

TEST(Workplace, ZonesAreWhereTheStandardWantsThem) {
  const Made made = make(workplace(kDesk));
  EXPECT_NEAR(made.area_m2("w.task"), 3.0, 1e-9);
  EXPECT_NEAR(made.area_m2("w.surround"), 3.0 * 2.5 - 3.0, 1e-9);
  // 3 m around the surround, but 0.5 m from the walls: x 0.5 to 9.5, y 0.5 to 7.5.
  EXPECT_NEAR(made.area_m2("w.background"), 9.0 * 7.0 - 7.5, 1e-9);
  EXPECT_NEAR(made.area_m2("w.cylinder"), 7.5, 1e-9);
  EXPECT_DOUBLE_EQ(made.height_m("w.task"), 0.75);
  EXPECT_DOUBLE_EQ(made.height_m("w.surround"), 0.75);
  EXPECT_DOUBLE_EQ(made.height_m("w.background"), 0.0);
  EXPECT_NEAR(made.height_m("w.cylinder"), 1.2, 1e-12);
  EXPECT_EQ(made.area("w.wall.1").margin_m, 0.5);
  EXPECT_EQ(made.area("w.ceiling").margin_m, 0.5);
  EXPECT_EQ(made.area("w.task").margin_m, 0.0);
  EXPECT_EQ(made.area("w.ceiling").normal().z, -1.0);
  EXPECT_EQ(made.plane("w.surround").made_by,
            "workplace w, EN 12464-1:2021 34.2, surround: band of 0.5 m around the task, without "
            "0.5 m along the walls, 0.75 m above the floor");
  EXPECT_EQ(made.plane("w.surround").changed, "");
}

TEST(Workplace, EveryZoneHasPointsThatItsMaskCounts) {
  const Made made = make(workplace(kDesk));
  for (const calc::CalcPlane& plane : made.space().planes) {
    const calc::SensorGrid grid = made.grid(plane.id);
    EXPECT_GE(grid.position_m.size(), 8u) << plane.id;
    EXPECT_THAT(grid.rule.english(),
                HasSubstr("EN 12464-1:2021 [one public source] (p = 0.2 * 5^log10 d)"));
    for (const Requirement& r : requirements_of_plane(made.requirements, plane.id)) {
      const MaskedPoints masked = apply_mask(r.mask, grid);
      EXPECT_EQ(masked.problem, "") << plane.id;
      EXPECT_EQ(masked.points.size(), grid.position_m.size()) << plane.id;
    }
  }
  // All round the task, on all four sides.
  const calc::SensorGrid band = made.grid("w.surround");
  const auto has = [&](const auto& is_there) {
    return std::any_of(band.position_m.begin(), band.position_m.end(), is_there);
  };
  EXPECT_TRUE(has([](const glm::dvec3& p) { return p.x < 14; }));
  EXPECT_TRUE(has([](const glm::dvec3& p) { return p.x > 16; }));
  EXPECT_TRUE(has([](const glm::dvec3& p) { return p.y < 23; }));
  EXPECT_TRUE(has([](const glm::dvec3& p) { return p.y > 24.5; }));
}

// The cells of the formula would be 0.9 m: some sides of the band would stay empty.
TEST(Workplace, CellsOfABandAreNoLargerThanTheBandIsWide) {
  const Made made = make(workplace("origin='1.5 1.5' size='9 5'"));
  const calc::SensorGrid grid = made.grid("w.surround");
  EXPECT_LE(grid.spacing_u_m, 0.5 + 1e-9);
  EXPECT_THAT(grid.rule.english(), HasSubstr("p = 0.5 m, the largest allowed value"));
}

TEST(Workplace, WithoutAnAreaTheTaskIsTheRoomLessItsMargin) {
  const Made made = make(workplace(""));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(), ElementsAre("w.task", "w.wall.1", "w.wall.2", "w.wall.3", "w.wall.4",
                                      "w.ceiling", "w.cylinder", "w.modelling", "w.observer.1",
                                      "w.observer.2", "w.observer.3", "w.observer.4"));
  EXPECT_EQ(made.area("w.task").margin_m, 0.5);
  EXPECT_NEAR(made.area_m2("w.task"), 96.0, 1e-9);
  EXPECT_EQ(made.area("w.cylinder").margin_m, 0.5);
  ASSERT_EQ(made.space().notes.size(), 1u);
  EXPECT_EQ(
      made.space().notes[0],
      "workplace w, EN 12464-1:2021 34.2: no plane for surround (the task covers the whole "
      "room), background (the task covers the whole room), room (judged at observers: luminaire "
      "'l' has no luminous area, so its luminance is not known)");
}

TEST(Workplace, WhereTheTaskReachesIntoTheWallZoneItsSurroundGoesToTheWall) {
  const Made made = make(workplace("origin='0.3 3' size='2 1'"));
  // x 0 to 2.8, y 2.5 to 4.5, less the task.
  EXPECT_NEAR(made.area_m2("w.surround"), 2.8 * 2 - 2, 1e-9);
  EXPECT_THAT(made.plane("w.surround").made_by.english(), HasSubstr("up to the walls"));
  // 0.5 to 5.8 and 0.5 to 7.5, less what is inside (from 0.5 on).
  EXPECT_NEAR(made.area_m2("w.background"), 5.3 * 7 - 2.3 * 2, 1e-9);
}

TEST(Workplace, AConcaveRoomCutsItsZones) {
  const Made made = make(workplace("origin='3.5 1' size='2 2'"),
                         "footprint='0 0  8 0  8 4  4 4  4 8  0 8' height='2.8'");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_NEAR(made.area_m2("w.surround"), 9 - 4, 1e-9);  // x 3 to 6, y 0.5 to 3.5
  // x 0.5 to 7.5, y 0.5 to 6.5, without what is beyond (3.5, 3.5).
  EXPECT_NEAR(made.area_m2("w.background"), 7 * 6 - 4 * 3 - 9, 1e-9);
  for (const glm::dvec3& point : made.grid("w.background").position_m) {
    EXPECT_GE(calc::distance_to_boundary(made.space().shell->footprint_m, glm::dvec2(point)),
              0.5 - 1e-9);
  }
  EXPECT_GT(made.grid("w.ceiling").position_m.size(), 20u);
  EXPECT_EQ(apply_mask(requirements_of_plane(made.requirements, "w.ceiling").at(0).mask,
                       made.grid("w.ceiling"))
                .problem,
            "");
}

TEST(Workplace, RolesForWhichTheRowHasNothingAreNotMade) {
  const Made made = make("<workplace id='w' pack='en12464-1:2021' row='14.1'/>");
  EXPECT_THAT(made.ids(), ElementsAre("w.task", "w.wall.1", "w.wall.2", "w.wall.3", "w.wall.4",
                                      "w.cylinder", "w.modelling", "w.observer.1", "w.observer.2",
                                      "w.observer.3", "w.observer.4"));
  EXPECT_THAT(made.space().notes.at(0).english(),
              HasSubstr("ceiling (row 14.1 specifies no value for it)"));
}

TEST(Workplace, SomeRowsAreAboutFloors) {
  const Made made = make("<workplace id='w' pack='en12464-1:2021' row='9.4' " + kDesk + "/>");
  EXPECT_EQ(made.height_m("w.task"), 0.0);
  EXPECT_EQ(made.height_m("w.surround"), 0.0);
  EXPECT_EQ(made.plane("w.task").changed, "");
}

// A corridor 1.6 m wide keeps 0.24 m of each side free, and so do the masks; from 3 m on it is 0.5
// m.
TEST(Workplace, NarrowRoomsHaveNarrowMargins) {
  const auto margin = [](const std::string& size) {
    const Made made =
        make("<workplace id='w' pack='en12464-1:2021' row='9.1'/>", "size='" + size + "'");
    EXPECT_THAT(made.messages, IsEmpty());
    for (const Requirement& r : requirements_of_plane(made.requirements, "w.cylinder")) {
      EXPECT_DOUBLE_EQ(r.mask.operations.at(0).metres, made.area("w.task").margin_m);
    }
    return made.area("w.task").margin_m;
  };
  EXPECT_NEAR(margin("12 1.6 2.8"), 0.24, 1e-12);
  EXPECT_NEAR(margin("1.6 12 2.8"), 0.24, 1e-12);
  EXPECT_NEAR(margin("12 2.99 2.8"), 0.15 * 2.99, 1e-12);
  EXPECT_DOUBLE_EQ(margin("12 3 2.8"), 0.5);
  EXPECT_NEAR(margin("12 1.01 2.8"), 0.15 * 1.01, 1e-12);
  // The largest circle in a corridor round a corner has a diameter of (4 - sqrt(8)) times its
  // width.
  const Made bent = make("<workplace id='w' pack='en12464-1:2021' row='9.1'/>",
                         "footprint='0 0  9 0  9 2  2 2  2 9  0 9' height='2.8'");
  EXPECT_NEAR(bent.area("w.task").margin_m, 0.15 * 2.0 * (4.0 - std::sqrt(8.0)), 1e-3);
  // Masks of planes of one's own, too.
  const Made own = make(
      "<plane id='p' height='1.2' quantity='cylindrical'><require pack='en12464-1:2021' row='9.1' "
      "role='cylinder'/></plane>",
      "size='12 1.6 2.8'");
  ASSERT_EQ(own.requirements.size(), 2u);
  for (const Requirement& r : own.requirements) {
    EXPECT_NEAR(r.mask.operations.at(0).metres, 0.24, 1e-12);
  }
}

std::string upright(const std::string& attributes, const std::string& children = "") {
  return "<workplace id='w' pack='en12464-1:2021' row='44.4.1' " + attributes + ">" + children +
         "</workplace>";
}

TEST(Workplace, ABoardIsOnItsWallWithABandAroundIt) {
  const Made made = make(upright("wall='2' along='1.5 4.5' heights='0.9 2.1'"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(),
              ElementsAre("w.task", "w.surround", "w.wall.1", "w.wall.2", "w.wall.3", "w.wall.4",
                          "w.ceiling", "w.cylinder", "w.modelling", "w.observer.1", "w.observer.2",
                          "w.observer.3", "w.observer.4"));
  const calc::PlanarArea& task = made.area("w.task");
  // The wall at x = 12 from y = 8 on, as seen from the room.
  EXPECT_EQ(task.origin_m, glm::dvec3(22.0, 26.5, 1.9));
  EXPECT_EQ(task.u, glm::dvec3(0, -1, 0));
  EXPECT_EQ(task.normal(), glm::dvec3(-1, 0, 0));
  EXPECT_NEAR(made.area_m2("w.task"), 3.0 * 1.2, 1e-12);
  EXPECT_NEAR(made.area_m2("w.surround"), 4.0 * 2.2 - 3.0 * 1.2, 1e-12);
  EXPECT_EQ(made.area("w.surround").normal(), task.normal());
  std::vector<double> limits;
  for (const char* plane : {"w.task", "w.surround"}) {
    for (const Requirement& r : requirements_of_plane(made.requirements, plane)) {
      limits.push_back(r.limit);
    }
  }
  EXPECT_THAT(limits, ElementsAre(500, 0.7, 300, 0.4));
  EXPECT_THAT(made.plane("w.task").made_by.english(),
              HasSubstr("on wall 2, 0.9 m to 2.1 m above the floor"));
  EXPECT_THAT(calc::texts(made.space().notes),
              ElementsAre(HasSubstr("background (the task area is upright")));
  // What the row asks of the room is asked of all of it.
  EXPECT_NEAR(made.area_m2("w.cylinder"), 12.0 * 8.0, 1e-9);
}

TEST(Workplace, TheBandAroundAnUprightTaskEndsWhereTheRoomEnds) {
  // 0.25 m of the wall left and right of it, 0.2 m above it, and the floor below.
  const Made made = make(upright("wall='2' along='0.25 7.75' heights='0 2.6'"));
  EXPECT_NEAR(made.area_m2("w.surround"), 8.0 * 2.8 - 7.5 * 2.6, 1e-9);
  const Made whole = make(upright("wall='2'"));
  EXPECT_THAT(whole.messages, IsEmpty());
  EXPECT_NEAR(whole.area_m2("w.task"), 8.0 * 2.8, 1e-9);
  EXPECT_THAT(calc::texts(whole.space().notes),
              ElementsAre(HasSubstr("surround (the room has no area left")));
}

// Who knows where the background is may say so.
TEST(Workplace, TheBackgroundOfAnUprightTaskIsWhereTheProjectSays) {
  const Made made = make(upright("wall='2'", "<zone role='background' origin='6 1' size='5 6'/>"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_NEAR(made.area_m2("w.background"), 30.0, 1e-9);
  EXPECT_EQ(made.area("w.background").normal(), glm::dvec3(0, 0, 1));
  EXPECT_NEAR(made.height_m("w.background"), 0.0, 1e-12);
}

TEST(Workplace, FacesStandInTheRoomAndEndAtItsWalls) {
  const std::string face = "face='2 3 11.8 3' heights='0.5 2'";
  const Made made = make(upright(face));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_EQ(made.area("w.task").origin_m, glm::dvec3(12, 23, 1.5));
  EXPECT_EQ(made.area("w.task").normal(), glm::dvec3(0, -1, 0));
  EXPECT_NEAR(made.area_m2("w.surround"), (0.5 + 9.8 + 0.2) * 2.5 - 9.8 * 1.5, 1e-9);
  const Made back = make(upright("face='11.8 3 2 3' heights='0.5 2'"));
  EXPECT_EQ(back.area("w.task").normal(), glm::dvec3(0, 1, 0));
  // An arm of the room, 2 m wide: the face across it goes no further.
  const Made arm = make(upright("face='6.5 6 7.5 6' heights='0.5 1'"),
                        "footprint='0 0 12 0 12 4 8 4 8 8 6 8 6 4 0 4' height='2.8'");
  EXPECT_THAT(arm.messages, IsEmpty());
  EXPECT_NEAR(arm.area_m2("w.surround"), 2.0 * 1.5 - 1.0 * 0.5, 1e-9);
}

TEST(Workplace, AFaceThatLeansIsLongerThanItIsHigh) {
  const Made made = make(upright("face='2 3 4 3' heights='0.5 1.5' lean='60'"));
  EXPECT_THAT(made.messages, IsEmpty());
  const calc::PlanarArea& task = made.area("w.task");
  EXPECT_NEAR(made.area_m2("w.task"), 2.0 * 2.0, 1e-9);
  const glm::dvec3 upper = task.origin_m + task.outline_m[3].y * task.v;
  EXPECT_NEAR(upper.z - 1.0, 1.5, 1e-12);
  EXPECT_NEAR(upper.y, 23.0 + std::sqrt(3.0), 1e-12);  // away from who looks at it
  EXPECT_NEAR(task.normal().z, std::sin(std::acos(0.5)), 1e-12);
  EXPECT_THAT(made.plane("w.task").made_by.english(), HasSubstr("tilted back by 60 degrees"));
}

TEST(WorkplaceGrid, CopiesOfAFaceLieInTheRoom) {
  const auto grid = [](const std::string& step) {
    return make(
        "<workplace-grid id='w' pack='en12464-1:2021' row='13.6' face='2 1 10 1' "
        "heights='0 2' repeat='1 3' step='" +
        step + "'/>");
  };
  const Made made = grid("0 2.5");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_EQ(made.area("w[0,2].task").origin_m, glm::dvec3(12, 26, 1));
  EXPECT_THAT(grid("0 3.6").messages,
              ElementsAre(HasSubstr("copy 'w[0,2]': its face is not within room 'r'")));
  // The last copy lies on the far wall, and looks at the room; the other way it looks out of it.
  EXPECT_THAT(grid("0 3.5").messages, IsEmpty());
  EXPECT_THAT(make("<workplace-grid id='w' pack='en12464-1:2021' row='13.6' face='10 1 2 1' "
                   "heights='0 2' repeat='1 3' step='0 3.5'/>")
                  .messages,
              ElementsAre(HasSubstr("copy 'w[0,2]': its face is not within room 'r'")));
}

// Its Ra would be judged nowhere, and the room would look as if it passed.
TEST(WorkplaceMessage, ARowOfColourAloneIsRefused) {
  for (const char* row : {"37.3", "40"}) {
    const std::string text =
        std::string("<workplace id='w' pack='en12464-1:2021' row='") + row + "'></workplace>";
    EXPECT_THAT(make(text).messages,
                ElementsAre(HasSubstr(std::string("row '") + row +
                                      "' requires nothing of the role 'task'; remove the "
                                      "workplace, and require what it does have with "
                                      "<require role=\"lamp\" .../> in a <plane>")));
  }
}

TEST(WorkplaceMessage, UprightTasksAreWhereTheyCanBe) {
  const auto message = [](const std::string& attributes, const std::string& children = "") {
    return make(upright(attributes, children)).messages;
  };
  EXPECT_THAT(message(""),
              ElementsAre(HasSubstr("the task of row '44.4.1' is upright; state its place")));
  EXPECT_THAT(message(kDesk), ElementsAre(HasSubstr("the task of row '44.4.1' is upright")));
  EXPECT_THAT(message("wall='5'"),
              ElementsAre(HasSubstr("the number of a wall of the room, 1 to 4")));
  EXPECT_THAT(message("wall='0'"), ElementsAre(HasSubstr("'wall'")));
  EXPECT_THAT(message("wall='2' along='1 8.1'"),
              ElementsAre(HasSubstr("two ascending numbers from 0 to the wall's length 8")));
  EXPECT_THAT(message("wall='2' along='3 3'"), ElementsAre(HasSubstr("two ascending numbers")));
  EXPECT_THAT(message("wall='2' heights='0 2.9'"),
              ElementsAre(HasSubstr("from 0 to the room's height 2.8")));
  EXPECT_THAT(message("wall='2' lean='5'"), ElementsAre(HasSubstr("'lean'")));
  EXPECT_THAT(message("wall='2' height='1'"), ElementsAre(HasSubstr("'height'")));
  EXPECT_THAT(message("wall='2' face='1 1 2 1' heights='0 1'"), ElementsAre(HasSubstr("'face'")));
  EXPECT_THAT(message("wall='2' " + kDesk), ElementsAre(HasSubstr("'size'")));
  EXPECT_THAT(message("heights='0 1'"),
              ElementsAre(HasSubstr("needs 'wall' or 'face' beside 'heights'")));
  EXPECT_THAT(message("face='1 1 2 1'"), ElementsAre(HasSubstr("'heights'")));
  EXPECT_THAT(message("face='1 1 1 1' heights='0 1'"),
              ElementsAre(HasSubstr("two different points")));
  for (const char* face : {"1 1 13 1", "0 0 12 0", "2 8 -1 8"}) {
    EXPECT_THAT(message(std::string("heights='0 1' face='") + face + "'"),
                ElementsAre(HasSubstr("a face within the room that looks into the room")))
        << face;
  }
  EXPECT_THAT(message("wall='2'", "<zone role='surround' height='1'/>"),
              ElementsAre(HasSubstr("'height' has no meaning")));
  EXPECT_THAT(message("wall='2'", "<zone role='task' margin='0.3'/>"),
              ElementsAre(HasSubstr("'margin' has no meaning")));
  EXPECT_THAT(message("wall='2'", "<zone role='task' origin='1 1' size='1 1'/>"),
              ElementsAre(HasSubstr("'footprint' or 'size' has no meaning")));
  // From one end to the other it leaves the room.
  EXPECT_THAT(make(upright("face='1 5 11 5' heights='0 1'"),
                   "footprint='0 0 12 0 12 8 8 8 8 4 4 4 4 8 0 8' height='2.8'")
                  .messages,
              ElementsAre(HasSubstr("a face within the room that looks into the room")));
}

TEST(Workplace, ANarrowWallIsNotMade) {
  const Made made =
      make(workplace(""), "footprint='0 0  8 0  8 4  7.2 4  7.2 8  0 8' height='2.8'");
  EXPECT_THAT(made.space().notes.at(0).english(),
              HasSubstr("wall.3 (the surface is 0.8 m wide, and 0.5 m along each edge does not "
                        "count)"));
}

const std::string kNarrowWall = "footprint='0 0  8 0  8 4  7.2 4  7.2 8  0 8' height='2.8'";

TEST(WorkplaceMessage, AWallThatIsNotCheckedIsWarnedOf) {
  EXPECT_THAT(make(workplace(""), kNarrowWall).messages,
              ElementsAre(HasSubstr("warning[zone-not-checked]: workplace 'w': not checked: "
                                    "wall.3 (the surface is 0.8 m wide, and 0.5 m along each "
                                    "edge does not count); give")));
  const Made said = make(
      workplace("", "<without role='wall.3' because='a pier' by='A. Meier' until='2099-12-31'/>"),
      kNarrowWall);
  EXPECT_THAT(said.messages, IsEmpty());
  EXPECT_THAT(said.space().notes.at(0).english(),
              HasSubstr("omitted: wall.3 (a pier, by A. Meier until 2099-12-31)"));
  const Made judged = make(workplace("", "<zone role='wall.3' margin='0.1'/>"), kNarrowWall);
  EXPECT_THAT(judged.messages, IsEmpty());
  EXPECT_THAT(judged.ids(), testing::Contains("w.wall.3"));
  EXPECT_FALSE(judged.grid("w.wall.3").position_m.empty());
}

// A side of 8 m that a drawing has bent by half a millimetre, in ten pieces of 0.8 m.
TEST(WorkplaceMessage, AWallInBentPiecesIsNotLost) {
  std::string footprint = "footprint='0 0  8 0";
  for (int i = 0; i <= 10; ++i) {
    const double x = 8.0 - 0.8 * i, bend = 0.0005 * (1.0 - (x - 4.0) * (x - 4.0) / 16.0);
    footprint += "  " + std::to_string(x) + " " + std::to_string(4.0 + bend);
  }
  EXPECT_THAT(make(workplace(""), footprint + "' height='2.8'").messages,
              testing::Contains(AllOf(HasSubstr("error[zone-vanishes]"),
                                      HasSubstr("pieces of a wall of 8.00 m"))));
}

TEST(WorkplaceMessage, ManyWallsThatAreNotCheckedAreCounted) {
  // Two niches of 0.8 x 0.4 m: six walls.
  EXPECT_THAT(make(workplace(""),
                   "footprint='0 0  12 0  12 8  9 8  9 8.4  8.2 8.4  8.2 8  4 8  4 8.4  3.2 8.4  "
                   "3.2 8  0 8' height='2.8'")
                  .messages,
              ElementsAre(testing::AllOf(HasSubstr("not checked: wall.4 (the surface is 0.4 m"),
                                         HasSubstr("wall.8 (the surface is 0.4 m"),
                                         HasSubstr(" and 2 more; "))));
}

TEST(Workplace, EverythingCanBeChangedAndTheReportSaysSo) {
  const Made made = make(
      workplace(kDesk + " height='1.1' level='modified' name='Bench'",
                "<zone role='cylinder' height='1.6' margin='0' because='standing'/>"
                "<zone role='background' origin='0 0' size='12 8' spacing='1'/>"
                "<zone role='surround' rounding='up'/>"
                "<zone role='wall' margin='0.3'/><zone role='wall.2' margin='0.1'/>"
                "<without role='wall.3' because='glass' by='A. Meier' until='2099-12-31'/><without "
                "role='ceiling' because='open' by='A. Meier' until='2099-12-31'/>"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(),
              ElementsAre("w.task", "w.surround", "w.background", "w.wall.1", "w.wall.2",
                          "w.wall.4", "w.cylinder", "w.modelling", "w.observer.1", "w.observer.2",
                          "w.observer.3", "w.observer.4"));
  EXPECT_EQ(made.plane("w.task").name, "Bench: task");
  EXPECT_EQ(made.plane("w.task").changed, "height 1.1 m instead of 0.75 m");
  EXPECT_NEAR(made.height_m("w.surround"), 1.1, 1e-12) << "at the task's height";
  EXPECT_EQ(made.plane("w.surround").changed, "different rounding of the grid");
  EXPECT_THAT(made.grid("w.surround").rule.english(), HasSubstr("rounded up"));
  EXPECT_NEAR(made.height_m("w.cylinder"), 1.6, 1e-12);
  EXPECT_EQ(made.plane("w.cylinder").changed,
            "height 1.6 m instead of 1.2 m, margin 0 m instead of 0.5 m (standing)");
  EXPECT_NEAR(made.area_m2("w.background"), 96 - 7.5, 1e-9);
  EXPECT_EQ(made.plane("w.background").changed, "area set by the project, grid set by the project");
  EXPECT_EQ(made.grid("w.background").rule, "spacing");
  EXPECT_EQ(made.area("w.wall.1").margin_m, 0.3);
  EXPECT_EQ(made.area("w.wall.2").margin_m, 0.1);
  EXPECT_THAT(made.space().notes.at(0).english(),
              HasSubstr("omitted: wall.3 (glass, by A. Meier until 2099-12-31), ceiling (open, by "
                        "A. Meier until 2099-12-31); no plane for"));
  EXPECT_EQ(requirements_of_plane(made.requirements, "w.task").at(0).limit, 1000);
}

TEST(Workplace, GridsOfAPackAreUsed) {
  calc::Diagnostics diagnostics;
  const auto pack = parse_rule_pack(
      "<rule-pack id='own' edition='1' title='Own' version='1' kind='company' status='published' "
      "licence='internal' role='place'><parameter id='E' unit='lx' meaning='m'/>"
      "<grid id='g' method='fixed-spacing' count='up' spacing='2 1'/>"
      "<plane role='place' orientation='horizontal-up' grid='g' area='task' height='0'/>"
      "<row ref='a' name='a' trust='confirmed'><value of='E' required='10'/></row>"
      "<check id='c' role='place' quantity='planar' statistic='average' at-least='row(E)'/>"
      "</rule-pack>",
      "own.xml", diagnostics);
  ASSERT_TRUE(pack);
  const Made made = make("<workplace id='w' pack='own' row='a' origin='0 0' size='4 6'/>",
                         "size='12 8 2.8'", {*pack});
  const calc::SensorGrid grid = made.grid("w.place");
  EXPECT_EQ(grid.columns, 4) << "1 m along the shorter side";
  EXPECT_EQ(grid.rows, 3);
  EXPECT_EQ(grid.rule, "Own:1: at most 1 x 2 m");
}

// What looks somewhere looks along the room's axes.
TEST(Workplace, PointsThatLookAroundHaveAPlaneForEachDirection) {
  calc::Diagnostics diagnostics;
  const auto pack = parse_rule_pack(
      "<rule-pack id='own' edition='1' title='Own' version='1' kind='company' status='published' "
      "licence='internal' role='face'><parameter id='E' unit='lx' meaning='m'/>"
      "<plane role='face' orientation='free' area='task-and-band' width='0' height='1.2'/>"
      "<row ref='a' name='a' trust='confirmed'><value of='E' required='10'/></row>"
      "<check id='c' role='face' quantity='semicylindrical' statistic='minimum' "
      "at-least='row(E)'/></rule-pack>",
      "own.xml", diagnostics);
  ASSERT_TRUE(pack);
  const Made made = make(
      "<workplace id='w' pack='own' row='a' origin='2 2' size='4 3'><without role='face.4' "
      "because='nobody' by='A. Meier' until='2099-12-31'/></workplace>",
      "size='12 8 2.8'", {*pack});
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(), ElementsAre("w.face.1", "w.face.2", "w.face.3"));
  const glm::dvec3 first = made.plane("w.face.1").direction;
  EXPECT_NEAR(std::abs(first.x), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(made.plane("w.face.2").direction.y), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(first, made.plane("w.face.3").direction), -1.0, 1e-12);
  EXPECT_NEAR(made.area_m2("w.face.2"), 12.0, 1e-9);
  EXPECT_THAT(made.plane("w.face.1").made_by.english(), HasSubstr(", direction of view ("));
  EXPECT_EQ(requirements_of_plane(made.requirements, "w.face.3").at(0).problem, "");
}

bool has_point_in(const calc::SensorGrid& grid, glm::dvec2 lower, glm::dvec2 upper) {
  return std::any_of(grid.position_m.begin(), grid.position_m.end(), [&](const glm::dvec3& p) {
    return p.x > lower.x && p.y > lower.y && p.x < upper.x && p.y < upper.y;
  });
}

// Between the rows of the bounding rectangle, 0.3 m of it count.
TEST(Workplace, AnArmOfTheRoomHasPoints) {
  const Made made =
      make(workplace(""), "footprint='0 0  20 0  20 1.3  10 1.3  10 10  0 10' height='2.8'");
  EXPECT_THAT(made.messages, IsEmpty());
  const calc::SensorGrid grid = made.grid("w.task");
  EXPECT_TRUE(has_point_in(grid, {21, 20}, {30, 21.3}));
  EXPECT_TRUE(has_point_in(grid, {28, 20}, {30, 21.3})) << "to its end";
  EXPECT_THAT(grid.rule.english(), HasSubstr("each cell divided into"));
}

TEST(Workplace, AnArmThatIsAllMarginIsNamed) {
  const Made made =
      make(workplace(""), "footprint='0 0  20 0  20 0.9  10 0.9  10 10  0 10' height='2.8'");
  EXPECT_THAT(made.plane("w.task").made_by.english(),
              HasSubstr("m² of the room are not judged: these parts are at most"));
  EXPECT_THAT(make(workplace("")).plane("w.task").made_by.english(),
              testing::Not(HasSubstr("are not judged")));
}

// 10 x 2 m, turned by 45 degrees: the grid is that of the same room along the axes.
TEST(Workplace, GridsAreTurnedWithTheRoom) {
  const Made straight = make(workplace(""), "size='10 2 2.8'");
  const Made turned = make(workplace(""),
                           "footprint='0 0  7.0710678118654755 7.0710678118654755  "
                           "5.6568542494923806 8.4852813742385695  -1.4142135623730951 "
                           "1.4142135623730951' height='2.8'");
  EXPECT_THAT(turned.messages, IsEmpty());
  for (const char* id : {"w.task", "w.ceiling", "w.cylinder"}) {
    const calc::SensorGrid a = straight.grid(id), b = turned.grid(id);
    EXPECT_EQ(a.position_m.size(), b.position_m.size()) << id;
    EXPECT_EQ(a.columns * a.rows, b.columns * b.rows) << id;
    EXPECT_NEAR(std::abs(b.u.x), std::sqrt(0.5), 1e-9) << id;
    EXPECT_NEAR(glm::cross(b.u, b.v).z, glm::cross(a.u, a.v).z, 1e-12) << id;
    for (const glm::dvec3& p : b.position_m) {
      EXPECT_GE(calc::distance_to_boundary(turned.space().shell->footprint_m, glm::dvec2(p)),
                0.15 * 2.0 - 1e-9);
    }
  }
}

TEST(Workplace, ZonesRoundATurnedTaskAreTurned) {
  // A square of 2 m on its corner, in the middle of the room.
  const Made made = make(workplace("footprint='6 2.5  7.5 4  6 5.5  4.5 4'"));
  EXPECT_THAT(made.messages, IsEmpty());
  const double side_m = std::sqrt(4.5);
  EXPECT_NEAR(made.area_m2("w.surround"), std::pow(side_m + 1.0, 2) - 4.5, 1e-9);
  EXPECT_NEAR(std::abs(made.grid("w.surround").u.x), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(made.grid("w.task").dropped.size(), 0u);
}

TEST(Workplace, AStraightWallInPiecesIsOneWall) {
  const Made made = make(workplace(kDesk),
                         "footprint='0 0  1 0  2 0  3 0  4 0  5 0  6 0  7 0  8 0  9 0  10 0  12 0  "
                         "12 8  0 8' height='2.8'");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.ids(), testing::Contains("w.wall.1"));
  EXPECT_THAT(made.ids(), testing::Not(testing::Contains("w.wall.2")));
  EXPECT_NEAR(made.area_m2("w.wall.1"), 12 * 2.8, 1e-9);
  for (const glm::dvec3& p : made.grid("w.wall.1").position_m) {
    EXPECT_GE(p.x, 10.5);
    EXPECT_LE(p.x, 21.5);
    EXPECT_NEAR(p.y, 20.0, 1e-9);
  }
  EXPECT_GT(made.grid("w.wall.1").position_m.size(), 20u);
}

TEST(Workplace, APieceOfAWallWithItsOwnZoneStaysOne) {
  const Made made =
      make(workplace(kDesk,
                     "<without role='wall.2' because='window' by='A. Meier' until='2099-12-31'/>"),
           "footprint='0 0  4 0  8 0  12 0  12 8  0 8' height='2.8'");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_NEAR(made.area_m2("w.wall.1"), 4 * 2.8, 1e-9);
  EXPECT_NEAR(made.area_m2("w.wall.3"), 4 * 2.8, 1e-9);
}

std::string round_room() {
  std::string corners;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 24;
    corners += std::to_string(3.5 * std::cos(angle)) + " " + std::to_string(3.5 * std::sin(angle));
    corners += " ";
  }
  return "footprint='" + corners + "' height='2.8'";
}

TEST(WorkplaceMessage, WallsThatAreAllTooNarrow) {
  EXPECT_THAT(
      make(workplace(""), round_room()).messages,
      ElementsAre(HasSubstr("nothing is left of the zone 'wall' (wall.1 (the surface is 0.91")));
  EXPECT_THAT(
      make(workplace("", "<without role='wall' because='round' by='A. Meier' until='2099-12-31'/>"),
           round_room())
          .messages,
      IsEmpty());
}

TEST(Workplace, AMarginOfTheProjectHoldsForTheMaskToo) {
  const Made made = make(workplace("", "<zone role='wall' margin='0.1'/>"), round_room());
  EXPECT_THAT(made.messages, IsEmpty());
  const calc::SensorGrid grid = made.grid("w.wall.7");
  const Requirement required = requirements_of_plane(made.requirements, "w.wall.7").at(0);
  EXPECT_EQ(apply_mask(required.mask, grid).points.size(), grid.position_m.size());
  const Requirement ceiling = requirements_of_plane(made.requirements, "w.ceiling").at(0);
  EXPECT_EQ(ceiling.mask.operations.at(0).metres, 0.5) << "as the pack says";
}

// Desk top from 0.73 to 0.76 m, and a task at 0.75 m that is a little larger.
TEST(Workplace, ADeskTopThatSwallowsTheTaskIsNotJudged) {
  const auto grid_with = [](const std::string& desk, calc::Diagnostics& diagnostics) {
    const Made made = make("<box id='desk' material='white' " + desk + "/>" +
                           workplace("origin='4 3' size='2 1.5'"));
    EXPECT_THAT(made.messages, IsEmpty());
    return calc::make_sensor_grid(made.plane("w.task"), made.space(), diagnostics);
  };
  calc::Diagnostics most, few, none;
  EXPECT_FALSE(grid_with("position='4.2 3.2 0.73' size='1.6 1.1 0.03'", most));
  ASSERT_EQ(most.all().size(), 1u);
  EXPECT_THAT(format_diagnostic(most.all()[0]), HasSubstr("inside solids, the first in 'desk'"));
  EXPECT_THAT(format_diagnostic(most.all()[0]), HasSubstr("set a 'height' above it"));
  EXPECT_TRUE(grid_with("position='4 3 0.73' size='0.3 0.3 0.03'", few));
  ASSERT_EQ(few.all().size(), 1u);
  EXPECT_THAT(format_diagnostic(few.all()[0]), HasSubstr("'desk'"));
  EXPECT_TRUE(grid_with("position='4 3 0.7' size='2 1.5 0.03'", none));
  EXPECT_THAT(none.all(), IsEmpty());
}

TEST(Workplace, PointsThatLookAroundGoByTheLongestWall) {
  const Made made =
      make(workplace(kDesk), "footprint='0.3 0  12 0  12 8  0 8  0 0.3' height='2.8'");
  EXPECT_THAT(made.messages, ElementsAre(HasSubstr("not checked: wall.5 (the surface is 0.42")));
  EXPECT_NEAR(std::abs(made.plane("w.observer.1").direction.x), 1.0, 1e-12);
  const Made cut = make(workplace(kDesk), "footprint='0 0.3  0.3 0  12 0  12 8  0 8' height='2.8'");
  EXPECT_NEAR(std::abs(cut.plane("w.observer.1").direction.x), 1.0, 1e-12);
}

// Its sides cannot be moved by the margin.
TEST(Workplace, ANicheDoesNotBreakTheZones) {
  const Made made = make(workplace(kDesk),
                         "footprint='0 0  12 0  12 8  8 8  8 8.4  7.2 8.4  7.2 8  0 8' "
                         "height='2.8'");
  EXPECT_THAT(made.messages,
              ElementsAre(HasSubstr("not checked: wall.4 (the surface is 0.4 m wide")));
  EXPECT_NEAR(made.area_m2("w.surround"), 3.0 * 2.5 - 3.0, 1e-9);
  EXPECT_THAT(made.plane("w.surround").made_by.english(),
              HasSubstr("without 0.5 m along the walls"));
  // As without the niche, less what its corners take at most.
  EXPECT_NEAR(made.area_m2("w.background"), 9.0 * 7.0 - 7.5, 0.5);
  for (const glm::dvec3& point : made.grid("w.background").position_m) {
    EXPECT_GE(calc::distance_to_boundary(made.space().shell->footprint_m, glm::dvec2(point)),
              0.5 - 1e-9);
  }
}

TEST(Workplace, CorridorsOfWarehousesAreFloors) {
  EXPECT_EQ(make("<workplace id='w' pack='en12464-1:2021' row='13.7'/>").height_m("w.task"), 0.0);
  EXPECT_EQ(make("<workplace id='w' pack='en12464-1:2011' row='5.1.4'/>").height_m("w.task"), 0.0);
}

TEST(WorkplaceMessage, MorePointsThanFitIntoMemory) {
  EXPECT_THAT(
      make(workplace(kDesk, "<zone role='wall' count='1000 1000'/>")).messages,
      ElementsAre(HasSubstr("at most 4000 planes and 4e+06 points for all workplaces together")));
}

TEST(WorkplaceMessage, UnknownPackRowSceneAndRole) {
  EXPECT_THAT(make("<workplace id='w' pack='en' row='1'/>").messages,
              ElementsAre(HasSubstr("p.xml:5:19: error[unknown-reference]: attribute 'pack' of "
                                    "<workplace>: there is no rule pack 'en'; allowed: ")));
  EXPECT_THAT(make("<workplace id='w' pack='en12464-1' row='34.9'/>").messages,
              ElementsAre(HasSubstr("p.xml:5:36: error[unknown-reference]: attribute 'row' of "
                                    "<workplace>: there is no row '34.9'; allowed: 9.1, ")));
  EXPECT_THAT(make(workplace("scene='day'")).messages,
              ElementsAre(HasSubstr("there is no scene 'day'; allowed: night")));
  EXPECT_THAT(
      make(workplace("", "<without role='sealing' because='x' by='A. Meier' until='2099-12-31'/>"))
          .messages,
      ElementsAre(
          HasSubstr("attribute 'role' of <without>: there is no zone 'sealing'; allowed: "
                    "task, surround, background, wall, wall.1, wall.2, wall.3, wall.4, "
                    "ceiling, cylinder, modelling, observer, observer.1, observer.2, observer.3 or "
                    "observer.4; did you mean 'ceiling'?")));
  EXPECT_THAT(make(workplace("", "<zone role='wall.5' margin='0'/>")).messages,
              ElementsAre(HasSubstr("there is no zone 'wall.5'")));
}

TEST(WorkplaceMessage, AWorkplaceWithoutItsTask) {
  EXPECT_THAT(
      make(workplace("", "<without role='task' because='x' by='A. Meier' until='2099-12-31'/>"))
          .messages,
      ElementsAre(HasSubstr("error[workplace-without-task]: workplace 'w': it needs its task "
                            "'task'; change the task with <zone role=\"task\" .../>, waive its "
                            "checks with <waiver checks=\"task.Em task.Uo colour\" ")));
}

TEST(Workplace, WhatIsLeftOutHasOwnerAndLastDay) {
  const Made made = make(workplace(
      kDesk,
      "<without role='observer' because='tables' by='A. Meier' until='2099-12-31'/><without "
      "role='wall' because='glass' by='B. Roe' until='2098-12-31'/><zone role='wall.2' "
      "margin='0.2'/>"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.space().notes.at(0).english(),
              HasSubstr("omitted: wall.1 (glass, by B. Roe until 2098-12-31), wall.3 (glass, by "
                        "B. Roe until 2098-12-31), wall.4 (glass, by B. Roe until 2098-12-31), "
                        "observer (tables, by A. Meier until 2099-12-31)"));
  std::vector<std::string> left_out;
  for (const calc::LeftOutPlane& one : made.space().left_out) left_out.push_back(one.plane.id);
  EXPECT_THAT(left_out, ElementsAre("w.wall.1", "w.wall.3", "w.wall.4", "w.observer.1",
                                    "w.observer.2", "w.observer.3", "w.observer.4"));
}

TEST(WorkplaceMessage, ABandThatVanishes) {
  // From wall zone to wall zone.
  EXPECT_THAT(
      make(workplace("origin='0.5 0.5' size='11 7'")).messages,
      ElementsAre(HasSubstr("p.xml:5:1: error[zone-vanishes]: workplace 'w': nothing is left of "
                            "the zone 'surround' (band of 0.5 m around the task, without 0.5 m "
                            "along the walls)")));
  const Made left_out =
      make(workplace("origin='0.5 0.5' size='11 7'",
                     "<without role='surround' because='none' by='A. Meier' until='2099-12-31'/>"));
  EXPECT_THAT(left_out.messages, IsEmpty());
  EXPECT_THAT(left_out.space().notes.at(0).english(),
              HasSubstr("background (the room has no area left around the surround)"));
}

TEST(WorkplaceMessage, AMarginThatLeavesNothingOfTheRoom) {
  EXPECT_THAT(make(workplace("", "<zone role='task' margin='4'/>")).messages,
              ElementsAre(HasSubstr("nothing is left of the zone 'task' (the room is 8 m wide, "
                                    "and 4 m along each wall does not count)")));
}

TEST(WorkplaceMessage, AZoneAboveTheCeiling) {
  EXPECT_THAT(make(workplace(""), "size='12 8 1.1'").messages,
              testing::Contains(HasSubstr("'cylinder' (a height of 1.2 m above the floor is not "
                                          "below the ceiling)")));
}

TEST(WorkplaceMessage, SurfacesStayWhereTheyAre) {
  EXPECT_THAT(make(workplace("", "<zone role='wall.1' height='1'/>")).messages,
              ElementsAre(HasSubstr("<zone>: 'height' has no meaning together with "
                                    "'role=\"wall.1\"'")));
}

const std::string kGrid =
    "<workplace-grid id='g' name='Desk' pack='en12464-1:2021' row='34.2' origin='2 1.5' "
    "size='1.6 1.4' repeat='3 2' step='3.2 3'";

TEST(WorkplaceGrid, WallsAndCeilingAreMadeOnce) {
  const Made made = make(kGrid + "/>");
  EXPECT_THAT(made.messages, IsEmpty());
  const std::vector<std::string> ids = made.ids();
  const auto count = [&](const std::string& part) {
    return std::count_if(ids.begin(), ids.end(),
                         [&](const std::string& id) { return id.find(part) != std::string::npos; });
  };
  EXPECT_EQ(count(".task"), 6);
  EXPECT_EQ(count(".surround"), 6);
  EXPECT_EQ(count(".wall."), 4);
  EXPECT_EQ(count(".ceiling"), 1);
  EXPECT_EQ(made.area("g[2,1].task").origin_m, glm::dvec3(10 + 2 + 6.4, 20 + 1.5 + 3, 1.75));
  EXPECT_EQ(made.plane("g[2,1].task").name, "Desk [2,1]: task");
  // One finding for all six, and it says for whom.
  EXPECT_THAT(limits_of(made, "g[0,0].wall.2"), ElementsAre(150, 0.1));
  const calc::CalcPlane& wall = made.plane("g[0,0].wall.2");
  EXPECT_EQ(wall.name, "wall 2");
  EXPECT_THAT(wall.made_by.english(),
              HasSubstr("; the same for g[1,0], g[2,0], g[0,1] and 2 more"));
  EXPECT_EQ(requirements_of_plane(made.requirements, wall.id).at(0).origin.workplaces.size(), 6u);
}

TEST(Workplace, ASurfaceThatTwoRowsAskForIsJudgedByBoth) {
  const Made made =
      make(workplace(kDesk) +
           "<workplace id='v' pack='en12464-1:2021' row='34.7' origin='8 5' size='2 1'/>");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(limits_of(made, "w.ceiling"), ElementsAre(100, 0.1, 50, 0.1));
  const auto requirements = requirements_of_plane(made.requirements, "w.ceiling");
  EXPECT_EQ(requirements.at(0).origin.workplaces, std::vector<std::string>{"w"});
  EXPECT_EQ(requirements.at(2).origin.workplaces, std::vector<std::string>{"v"});
  EXPECT_EQ(requirements.at(2).id, "average-2");
}

// A shared surface has those of the first; who else asks is known of each requirement.
TEST(Workplace, PlanesHaveItsTags) {
  const Made made = make(
      "<workplace id='w' pack='en12464-1:2021' row='34.2' origin='2 2' size='2 1' tags='north'/>"
      "<workplace id='v' pack='en12464-1:2021' row='34.7' origin='8 5' size='2 1' tags='b "
      "north'/>");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(made.plane("w.task").tags, ElementsAre("north"));
  EXPECT_THAT(made.plane("v.task").tags, ElementsAre("b", "north"));
  EXPECT_THAT(made.plane("w.ceiling").tags, ElementsAre("north"));
}

// Nothing is shared that is not the same: other points, another level, scene or deviation.
TEST(Workplace, WhatDiffersIsNotShared) {
  const auto ceilings = [](const std::string& attributes, const std::string& children) {
    const Made made = make(workplace(kDesk) +
                           "<workplace id='v' pack='en12464-1:2021' row='34.2' origin='8 5' "
                           "size='2 1' " +
                           attributes + ">" + children + "</workplace>");
    EXPECT_THAT(made.messages, IsEmpty());
    std::size_t planes = 0;
    for (const std::string& id : made.ids()) planes += id.find("ceiling") != std::string::npos;
    return std::pair(planes, requirements_of_plane(made.requirements, "w.ceiling").size());
  };
  EXPECT_EQ(ceilings("", ""), std::pair(std::size_t{1}, std::size_t{2}));
  EXPECT_EQ(ceilings("scene='night'", ""), std::pair(std::size_t{1}, std::size_t{4}));
  EXPECT_EQ(ceilings("level='modified'", ""), std::pair(std::size_t{1}, std::size_t{4}));
  EXPECT_EQ(ceilings("",
                     "<deviation role='ceiling' in='grid' because='b' by='m' "
                     "until='2999-01-01'/>"),
            std::pair(std::size_t{1}, std::size_t{4}));
  EXPECT_EQ(ceilings("", "<zone role='ceiling' margin='0.2' because='b'/>"),
            std::pair(std::size_t{2}, std::size_t{2}));
}

// Limit, and whether it is easier than the row's.
std::vector<std::pair<double, bool>> weakened(const Made& made, const std::string& plane) {
  std::vector<std::pair<double, bool>> limits;
  for (const Requirement& r : requirements_of_plane(made.requirements, plane)) {
    limits.emplace_back(r.limit, r.origin.is_weakened);
  }
  return limits;
}

std::string notes_of(const Made& made, const std::string& plane) {
  std::string notes;
  for (const Requirement& r : requirements_of_plane(made.requirements, plane)) {
    notes += "[" + r.note.english() + "]";
  }
  return notes;
}

TEST(Workplace, WhereTheTaskIsUnknownTheWholeRoomHasTheUniformityForThat) {
  const Made made = make(workplace("task-place='unknown'"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(weakened(made, "w.task"), ElementsAre(std::pair(500.0, false), std::pair(0.4, true)));
  EXPECT_EQ(notes_of(made, "w.task"),
            "[][one public source; the place of the task is not known; 0.4 over the whole area "
            "replaces the row's 0.6. Check this again when the place is known]");
  EXPECT_THAT(weakened(made, "w.ceiling"),
              ElementsAre(std::pair(100.0, false), std::pair(0.1, false)));
  EXPECT_EQ(notes_of(made, "w.ceiling"), "[][]");
  EXPECT_THAT(
      calc::texts(made.space().notes),
      testing::Contains(HasSubstr("34.2: the task may be anywhere in the room; no plane for ")));
  // A row that asks for no more loses nothing by it, one that asks for less has to do more.
  const auto of_row = [](const std::string& row) {
    return weakened(make("<workplace id='w' pack='en12464-1:2021' task-place='unknown' row='" +
                         row + "'/>"),
                    "w.task")
        .at(1);
  };
  EXPECT_EQ(of_row("34.7"), std::pair(0.4, false));
  EXPECT_EQ(weakened(make("<workplace id='w' pack='en12464-1:2011' task-place='unknown' "
                          "row='5.26.2'/>"),
                     "w.task")
                .at(1),
            std::pair(0.4, true));
}

TEST(WorkplaceMessage, WhoGivesAnAreaSaysWhereTheTaskIs) {
  const std::string unknown = "task-place='unknown' ";
  EXPECT_THAT(make(workplace(unknown + kDesk)).messages,
              ElementsAre(HasSubstr("error[attribute-without-meaning]: <workplace>: 'task-place' "
                                    "has no meaning together with 'size'")));
  EXPECT_THAT(make(workplace(unknown + "footprint='1 1 3 1 3 3'")).messages,
              ElementsAre(HasSubstr("'task-place' has no meaning together with 'footprint'")));
  EXPECT_THAT(make(workplace(unknown + "wall='1'")).messages,
              ElementsAre(HasSubstr("'task-place' has no meaning together with 'wall'")));
  EXPECT_THAT(make(workplace(unknown + "face='1 1 3 1' heights='0 2'")).messages,
              ElementsAre(HasSubstr("'task-place' has no meaning together with 'face'")));
  EXPECT_THAT(make(workplace(unknown, "<zone role='task' margin='2'/>")).messages,
              ElementsAre(HasSubstr("<zone>: 'margin' has no meaning together with 'role=\"task\" "
                                    "and 'task-place' of <workplace>'")));
  EXPECT_THAT(make(workplace("task-place='known'")).messages,
              ElementsAre(HasSubstr("attribute 'task-place' of <workplace>: unknown value 'known'; "
                                    "allowed: unknown")));
  EXPECT_THAT(make(kGrid + " task-place='unknown'/>").messages,
              ElementsAre(HasSubstr("unknown attribute 'task-place' of <workplace-grid>")));
}

TEST(Workplace, WallsBesidesTheOneInFrontMayBeDarker) {
  const Made made = make(workplace(kDesk + " front-wall='2'"));
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(weakened(made, "w.wall.2"),
              ElementsAre(std::pair(150.0, false), std::pair(0.1, false)));
  EXPECT_EQ(notes_of(made, "w.wall.2"), "[][]");
  for (const char* wall : {"w.wall.1", "w.wall.3", "w.wall.4"}) {
    EXPECT_THAT(weakened(made, wall), ElementsAre(std::pair(75.0, true), std::pair(0.1, false)));
    EXPECT_EQ(notes_of(made, wall),
              "[one public source; the project states that this is not the wall in front; 75 lx "
              "replaces the row's 150 lx, which may be accepted; in cellular offices, by one "
              "manufacturer's page][]");
  }
  EXPECT_THAT(calc::texts(made.space().notes),
              testing::Contains(HasSubstr("34.2: the person at the workplace faces wall 2")));
  EXPECT_THAT(limits_of(make(workplace(kDesk)), "w.wall.1"), ElementsAre(150, 0.1));
}

// Each is asked for the wall that somebody looks at.
TEST(Workplace, AWallThatIsInFrontOfOneIsAskedByBoth) {
  const Made made = make(workplace(kDesk + " front-wall='1'") +
                         "<workplace id='v' pack='en12464-1:2021' row='34.2' origin='8 5' "
                         "size='2 1' front-wall='2'/>");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(weakened(made, "w.wall.1"),
              ElementsAre(std::pair(150.0, false), std::pair(0.1, false), std::pair(75.0, true),
                          std::pair(0.1, false)));
  EXPECT_THAT(weakened(made, "w.wall.3"),
              ElementsAre(std::pair(75.0, true), std::pair(0.1, false)));
}

TEST(Workplace, APieceOfAWallInFrontStandsForTheWholeOfIt) {
  const Made made = make(workplace("origin='4 3' size='2 1.5' front-wall='2'"),
                         "footprint='0 0  5 0  12 0  12 8  0 8' height='2.8'");
  EXPECT_THAT(made.messages, IsEmpty());
  EXPECT_THAT(weakened(made, "w.wall.1"),
              ElementsAre(std::pair(150.0, false), std::pair(0.1, false)));
  EXPECT_THAT(weakened(made, "w.wall.3"),
              ElementsAre(std::pair(75.0, true), std::pair(0.1, false)));
}

TEST(WorkplaceMessage, TheWallInFrontIsOneThatIsJudged) {
  EXPECT_THAT(make(workplace(kDesk + " front-wall='5'")).messages,
              ElementsAre(HasSubstr("attribute 'front-wall' of <workplace>: 5 is not allowed; "
                                    "expected the number of a wall of the room, 1 to 4")));
  EXPECT_THAT(make("<workplace id='w' pack='en12464-1:2021' row='34.7' front-wall='1'/>").messages,
              ElementsAre(HasSubstr("<workplace>: 'front-wall' has no meaning together with "
                                    "'row=\"34.7\" of en12464-1:2021'")));
  const auto niche = make(workplace(kDesk + " front-wall='3'"),
                          "footprint='0 0  12 0  12 4  11.4 4  11.4 8  0 8' height='2.8'");
  EXPECT_THAT(niche.messages, testing::Contains(HasSubstr(
                                  "attribute 'front-wall' of <workplace>: 3 is not allowed; "
                                  "expected a wall that is wide enough to be judged")));
}

// Whoever has no shelves misses none.
TEST(Workplace, NobodyIsToldOfShelves) {
  const Made made = make(workplace(kDesk));
  EXPECT_THAT(calc::texts(made.space().notes), testing::Not(testing::Contains(HasSubstr("shelf"))));
  EXPECT_THAT(calc::texts(made.space().notes), testing::Contains(HasSubstr("no plane for")));
}

TEST(Workplace, ASurfaceThatTheFirstLeavesOutTheSecondHas) {
  const Made made =
      make(workplace(kDesk, "<without role='ceiling' because='open' by='m' until='2999-01-01'/>") +
           "<workplace id='v' pack='en12464-1:2021' row='34.2' origin='8 5' "
           "size='2 1'/>");
  EXPECT_THAT(limits_of(made, "v.ceiling"), ElementsAre(100, 0.1));
}

TEST(WorkplaceGridMessage, AnErrorOfTheElementIsSaidOnce) {
  EXPECT_THAT(make(kGrid + " scene='day'/>").messages,
              ElementsAre(HasSubstr("error[unknown-reference]: attribute 'scene' of "
                                    "<workplace-grid>: there is no scene 'day'")));
  EXPECT_THAT(make(kGrid + "><zone role='wal' margin='1'/></workplace-grid>").messages,
              ElementsAre(HasSubstr("there is no zone 'wal'")));
  EXPECT_THAT(make(kGrid + "><deviation in='grid' because='b' by='m' "
                           "until='2026-02-30' role='task'/></workplace-grid>")
                  .messages,
              testing::SizeIs(1));
}

TEST(WorkplaceMessage, AnIdThatIsTaken) {
  EXPECT_THAT(make("<plane id='w.task' height='1'/>\n" + workplace(kDesk)).messages,
              ElementsAre(HasSubstr("p.xml:6:1: error[duplicate-id]: the plane 'w.task' is given "
                                    "twice, also in line 5")));
}

TEST(WorkplaceMessage, APackThatMakesNoWorkplaces) {
  EXPECT_THAT(make("<workplace id='w' pack='en12464-2' row='5.1-walkways'/>").messages,
              ElementsAre(HasSubstr(
                  "rule pack 'en12464-2:2014' does not say where the planes of a workplace are, "
                  "for row '5.1-walkways' or any other; write every <plane> with its <require>")));
}

// A luminaire whose type has an error has none: nothing may be asked of it, and the error is said.
TEST(Workplace, OfAProjectWithAnErrorInATypeAsksNothingOfLuminaires) {
  const std::string xml =
      "<luxgate version='1'><material id='m' reflectance='0.5'/><luminaire-type id='t' "
      "photomtry='spot.ies'/><room id='r' size='5 4 3' floor='m' ceiling='m' walls='m'><luminaire "
      "id='l' type='t' position='2 2 2.5'/><workplace id='w' pack='en12464-1:2021' row='34.2'/>"
      "</room></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"spot.ies", kIes}});
  EXPECT_FALSE(load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics));
  ASSERT_FALSE(diagnostics.all().empty());
  EXPECT_THAT(format_diagnostic(diagnostics.all()[0]), HasSubstr("unknown attribute 'photomtry'"));
}

}  // namespace
}  // namespace rules::workplace_test
