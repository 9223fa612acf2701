#include "rules/verdict/coverage.h"
#include "rules/binding/bind.h"
#include "rules/binding/colour_rendering.h"
#include "rules/binding/judged_project.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rules::coverage_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";

// "task met", "lamp not-possible", ... of what stands in a room of 12 m x 8 m, if every requirement
// gets this verdict.
struct Covered {
  std::vector<RowCoverage> rows;
  std::vector<std::string> planes;  // "w.task 2": with their number of requirements
  std::vector<std::string> roles(std::size_t row = 0) const {
    std::vector<std::string> words;
    for (const RoleCoverage& role : rows.at(row).roles) {
      words.push_back(role.role + " " + std::string(calc::name_of(role.state)));
    }
    return words;
  }
};

const std::string kRoom = "<room id='r' size='12 8 3' ceiling='m' walls='m' floor='m'>";

// room: "" for the open space.
Covered cover_in(const std::string& room, const std::string& inside, Verdict verdict,
                 const std::vector<RulePack>& packs, const std::string& today) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='1'><material id='m' reflectance='0.7'/>"
      "<luminaire-type id='spot' photometry='spot.ies'/><scene id='em'><dim group='e' level='1'/>"
      "</scene>" +
      room + inside + "<luminaire id='l' type='spot' position='6 4 2.9' group='e'/>" +
      (room.empty() ? "" : "</room>") + "</luxgate>";
  calc::Diagnostics diagnostics;
  Covered covered;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"spot.ies", kIes}});
  const auto judged = load_judged_project(files, "p.xml", packs, diagnostics);
  for (const auto& d : diagnostics.all()) {
    if (d.severity() == calc::Severity::error) ADD_FAILURE() << format_diagnostic(d);
  }
  if (!judged) return covered;
  const calc::Space& space = judged->project.spaces.at(0);
  const std::vector<const calc::CalcPlane*> asked = planes_asked(space, today);
  std::vector<std::vector<Finding>> findings(asked.size());
  std::vector<JudgedPlane> planes;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const bool is_left_out = k >= space.planes.size();
    for (const auto& requirement :
         is_left_out ? requirements_of_left_out(judged->project, space, *asked[k], packs)
                     : requirements_of_plane(judged->requirements, asked[k]->id)) {
      Finding& finding = findings[k].emplace_back();
      finding.requirement = requirement;
      finding.verdict = is_left_out ? Verdict::not_judged : verdict;
    }
    planes.push_back({&space, asked[k], &findings[k]});
    covered.planes.push_back(asked[k]->id + " " + std::to_string(findings[k].size()));
  }
  covered.rows =
      row_coverage(space, planes, packs, today,
                   [&](const std::string& scene, Comparison comparison, double limit) {
                     return rendering_problem(judged->project, space, scene, comparison, limit);
                   });
  return covered;
}

Covered cover(const std::string& inside, Verdict verdict = Verdict::pass,
              const std::vector<RulePack>& packs = builtin_rule_packs(),
              const std::string& today = "2027-01-01") {
  return cover_in(kRoom, inside, verdict, packs, today);
}

Covered cover_open(const std::string& inside) {
  return cover_in("", inside, Verdict::pass, builtin_rule_packs(), "2027-01-01");
}

const std::string kTask =
    "<plane id='t' height='0.75' margin='0.5'><require pack='en12464-1:2021' row='34.2'/></plane>";

TEST(RowCoverage, ATaskAloneIsNotTheRow) {
  const Covered covered = cover(kTask);
  ASSERT_EQ(covered.rows.size(), 1u);
  EXPECT_EQ(covered.rows[0].clause, "EN 12464-1:2021 34.2");
  EXPECT_FALSE(covered.rows[0].is_whole());
  EXPECT_FALSE(covered.rows[0].is_met());
  EXPECT_THAT(covered.roles(),
              ElementsAre("task met", "surround never-asked", "background never-asked",
                          "wall never-asked", "ceiling never-asked", "cylinder never-asked",
                          "observer never-asked", "lamp not-possible"));
}

// Of every area that the row is asked of; without, glare would be that of the best one.
TEST(RowCoverage, GlareOutdoorsIsOfAllAreas) {
  const std::string row = "<require pack='en12464-2' row='5.9-medium'/>";
  const std::string glare =
      "<require pack='en12464-2' row='5.9-medium' role='observer' reflectance='0.1'/>";
  const auto area = [](const std::string& id, const std::string& x, const std::string& inside) {
    return "<plane id='" + id + "' origin='" + x + " 0 0' u='8 0 0' v='0 8 0'>" + inside +
           "</plane>";
  };
  const Covered both = cover_open(area("p", "0", row + glare) + area("q", "9", row + glare));
  EXPECT_THAT(both.roles(), ElementsAre("task met", "observer met", "lamp not-possible"));
  const Covered one = cover_open(area("p", "0", row) + area("q", "9", row + glare));
  EXPECT_THAT(one.roles(), ElementsAre("task met", "observer asked-in-part", "lamp not-possible"));
  EXPECT_EQ(one.rows.at(0).roles.at(1).words, "not required of p, although the row is");
  EXPECT_FALSE(one.rows[0].is_whole());
  EXPECT_FALSE(one.rows[0].is_met());
}

// Each task of a row has surroundings of its own, and they may be dark.
TEST(RowCoverage, OneSurroundIsNotThatOfTwoTasks) {
  const std::string row = "<require pack='en12464-1:2021' row='34.2'";
  const auto task = [&](const std::string& id, const std::string& x) {
    return "<plane id='" + id + "' origin='" + x + " 2 0.75' u='1 0 0' v='0 1 0'>" + row +
           "/></plane>";
  };
  const std::string around_t =
      "<plane id='s' points='1.5 1.5 0.75 3.5 1.5 0.75 3.5 3.5 0.75 1.5 3.5 0.75'><hole "
      "points='2 2 0.75 3 2 0.75 3 3 0.75 2 3 0.75'/>" +
      row + " role='surround'/></plane>";
  const std::string cylinder =
      "<plane id='c' origin='1.5 1.5 1.2' u='2 0 0' v='0 2 0' "
      "quantity='cylindrical'>" +
      row + " role='cylinder'/></plane>";
  EXPECT_THAT(cover(task("t", "2") + around_t).roles(), Contains("surround met"));
  const Covered two = cover(task("t", "2") + task("u", "8") + around_t + cylinder);
  EXPECT_THAT(two.roles(), Contains("surround asked-in-part"));
  EXPECT_THAT(two.roles(), Contains("cylinder asked-in-part"));
  EXPECT_EQ(two.rows.at(0).roles.at(1).words, "not required of u, although the row is");
  const std::string around_u =
      "<plane id='v' points='7.5 1.5 0.75 9.5 1.5 0.75 9.5 3.5 0.75 7.5 3.5 0.75'><hole "
      "points='8 2 0.75 9 2 0.75 9 3 0.75 8 3 0.75'/>" +
      row + " role='surround'/></plane>";
  EXPECT_THAT(cover(task("t", "2") + task("u", "8") + around_t + around_u).roles(),
              Contains("surround met"));
}

// Drawn in pieces, and one of them too narrow to be judged by itself: it belongs to the wall.
TEST(RowCoverage, APieceOfAStraightWallIsNoWallThatIsTooNarrow) {
  const auto roles = [](const std::string& footprint, const std::vector<int>& walls) {
    std::string inside;
    for (const int wall : walls) {
      inside += "<plane id='w" + std::to_string(wall) + "' on='wall" + std::to_string(wall) +
                "' margin='0.5'><require pack='en12464-1:2021' row='34.2' role='wall'/></plane>";
    }
    return cover_in("<room id='r' footprint='" + footprint +
                        "' height='3' ceiling='m' walls='m' floor='m'>",
                    inside, Verdict::pass, builtin_rule_packs(), "2027-01-01")
        .roles();
  };
  const std::string in_line = "0 0 8.1 0 9 0 9 8 0 8", jog = "0 0 8.1 0 8.1 0.003 9 0.003 9 8 0 8";
  EXPECT_THAT(roles(in_line, {1, 3, 4, 5}), Contains("wall asked-in-part"));
  EXPECT_THAT(roles(jog, {1, 4, 5, 6}), Contains("wall asked-in-part"));
  // Of a bay it is a wall by itself, and too narrow.
  EXPECT_THAT(roles("0 0 8.1 0 8.1 1 9 1 9 8 0 8", {1, 2, 4, 5, 6}), Contains("wall met"));
}

TEST(RowCoverage, AWorkplaceAsksTheWholeRow) {
  const Covered covered = cover("<workplace id='w' pack='en12464-1:2021' row='34.2'/>");
  ASSERT_EQ(covered.rows.size(), 1u);
  EXPECT_TRUE(covered.rows[0].is_whole());
  EXPECT_TRUE(covered.rows[0].is_met());
  EXPECT_EQ(covered.rows[0].workplace, "w");
  EXPECT_THAT(covered.roles(), ElementsAre("task met", "surround not-made", "background not-made",
                                           "wall met", "ceiling met", "cylinder met",
                                           "observer met", "room not-made", "lamp not-possible"));
  EXPECT_FALSE(covered.rows[0].asks_all()) << "nobody knows the colour rendering";
  EXPECT_EQ(
      covered.rows[0].roles.back().words,
      "Ra is not calculated, and the manufacturers' data do not decide it: the photometry file "
      "of luminaire type 'spot' states no Ra");
}

// Nobody has looked then whether the makers state it.
TEST(RowCoverage, ColourIsNeverAskedWhereTheTaskIsNot) {
  const Covered covered = cover(
      "<plane id='s' on='wall1' margin='0.5'><require pack='en12464-1:2021' row='34.2' "
      "role='wall'/></plane>");
  EXPECT_THAT(covered.roles(), Contains("lamp never-asked"));
  EXPECT_THAT(covered.roles(), Contains("task never-asked"));
}

// Nobody says where the background of a board is: until the project does, the row is not whole.
TEST(RowCoverage, ABackgroundWithoutAPlaceIsMissed) {
  const auto of_board = [](const std::string& children) {
    return cover(
        "<workplace id='w' pack='en12464-1:2021' row='44.4.1' wall='2' along='1 4' "
        "heights='1 2'>" +
        children + "</workplace>");
  };
  const Covered board = of_board("");
  EXPECT_FALSE(board.rows.at(0).is_whole());
  EXPECT_THAT(board.roles(), Contains("background never-asked"));
  EXPECT_THAT(board.roles(), Contains("surround met"));
  EXPECT_TRUE(of_board("<zone role='background' origin='8 1' size='3 6'/>").rows.at(0).is_whole());
  EXPECT_TRUE(of_board("<without role='background' because='x' by='y' until='2028-01-01'/>")
                  .rows.at(0)
                  .is_whole());
}

TEST(RowCoverage, SaysWhatSomebodyLeftOut) {
  const Covered covered = cover(
      "<workplace id='w' pack='en12464-1:2021' row='34.2'><without role='ceiling' because='open' "
      "by='A. Meier' until='2099-12-31'/>"
      "<without role='wall.1' because='glass' by='A. Meier' until='2099-12-31'/></workplace>");
  EXPECT_TRUE(covered.rows[0].is_whole());
  const std::vector<RoleCoverage>& roles = covered.rows[0].roles;
  EXPECT_EQ(roles[3].state, RoleState::met);
  EXPECT_EQ(roles[3].words, "wall.1: glass, by A. Meier until 2099-12-31");
  EXPECT_EQ(roles[4].state, RoleState::left_out);
  EXPECT_EQ(roles[4].words, "open, by A. Meier until 2099-12-31");
  ASSERT_EQ(roles[4].left_out.size(), 1u);
  EXPECT_EQ(roles[4].left_out[0].zone, "ceiling");
  EXPECT_EQ(roles[4].left_out[0].by.owner, "A. Meier");
  EXPECT_FALSE(roles[4].left_out[0].has_ended);
}

Covered with_end(const std::string& role, const std::string& today) {
  return cover("<workplace id='w' pack='en12464-1:2021' row='34.2'><without role='" + role +
                   "' because='glass' by='A. Meier' until='2026-12-31'/></workplace>",
               Verdict::pass, builtin_rule_packs(), today);
}

TEST(RowCoverage, WhatWasLeftOutUpToADayIsAskedForAfterIt) {
  const Covered before = with_end("ceiling", "2026-12-31");
  EXPECT_TRUE(before.rows.at(0).is_accepted());
  EXPECT_TRUE(before.rows.at(0).has_exceptions());
  EXPECT_FALSE(before.rows.at(0).is_met());
  const Covered ended = with_end("ceiling", "2027-01-01");
  EXPECT_FALSE(ended.rows.at(0).is_whole());
  EXPECT_FALSE(ended.rows.at(0).is_accepted());
  EXPECT_EQ(ended.planes.back(), "w.ceiling 2");
  const RoleCoverage& ceiling = ended.rows[0].roles.at(4);
  EXPECT_EQ(ceiling.state, RoleState::left_out_ended);
  EXPECT_EQ(ceiling.words, "the omission ended on 2026-12-31 (by A. Meier): glass");
  EXPECT_TRUE(ceiling.left_out.at(0).has_ended);
}

// A task with a quarter of its light that somebody waives is not met, and nor is its row.
TEST(RowCoverage, WhatIsWaivedIsAcceptedAndNotMet) {
  using enum Outcome;
  EXPECT_EQ(state_of(pass, false), RoleState::met);
  EXPECT_EQ(state_of(pass, true), RoleState::waived);
  EXPECT_EQ(state_of(waived, true), RoleState::waived);
  EXPECT_EQ(state_of(fail, true), RoleState::failed);
  RowCoverage row{
      "w", calc::Message::words("EN 12464-1:2021 34.2"), {{"task", RoleState::met, {}}}};
  EXPECT_TRUE(row.is_met());
  row.roles.push_back({"wall", RoleState::waived, {}});
  EXPECT_TRUE(row.is_whole());
  EXPECT_TRUE(row.is_accepted());
  EXPECT_FALSE(row.is_met());
  row.roles.back() = {"wall", RoleState::met, {}, {}, {{"wall.1", {}, false}}};
  EXPECT_TRUE(row.is_accepted());
  EXPECT_FALSE(row.is_met());
}

// The other walls pass, and the role must not.
TEST(RowCoverage, OneWallThatIsNoLongerLeftOutIsEnough) {
  const Covered ended = with_end("wall.2", "2027-01-01");
  EXPECT_FALSE(ended.rows.at(0).is_whole());
  EXPECT_EQ(ended.roles().at(3), "wall left-out-ended");
  EXPECT_EQ(with_end("wall.2", "2026-12-31").roles().at(3), "wall met");
}

TEST(RowCoverage, ARoleThatIsLeftOutAsAWholeIsToldOnce) {
  const Covered covered = with_end("observer", "2026-12-31");
  EXPECT_EQ(covered.rows.at(0).roles.at(6).words, "glass, by A. Meier until 2026-12-31");
  EXPECT_EQ(covered.rows[0].roles[6].left_out.size(), 1u);
  const Covered ended = with_end("observer", "2027-01-01");
  EXPECT_THAT(std::vector<std::string>(ended.planes.end() - 4, ended.planes.end()),
              ElementsAre("w.observer.1 1", "w.observer.2 1", "w.observer.3 1", "w.observer.4 1"));
}

// Rows are about what counts; the plane is asked for all the same.
TEST(RowCoverage, AdviceThatIsNoLongerLeftOutIsNotOfTheRow) {
  const Covered ended = with_end("modelling", "2027-01-01");
  EXPECT_TRUE(ended.rows.at(0).is_met());
  EXPECT_EQ(ended.planes.back(), "w.modelling 2");
}

// Walls and ceiling are there once, and each workplace has asked for them.
TEST(RowCoverage, EachOfSeveralWorkplacesHasItsWholeRow) {
  const std::string grid =
      "<workplace-grid id='g' pack='en12464-1:2021' row='34.2' origin='2 2' size='1.6 1.4' "
      "repeat='2 1' step='4 0'/>";
  const std::string other =
      "<workplace id='w' pack='en12464-1:2021' row='34.7' origin='8 5' size='2 1'/>";
  const Covered covered = cover(grid + other);
  ASSERT_EQ(covered.rows.size(), 3u);
  EXPECT_EQ(covered.rows[0].workplace, "g[0,0]");
  EXPECT_EQ(covered.rows[1].workplace, "g[1,0]");
  EXPECT_EQ(covered.rows[2].workplace, "w");
  EXPECT_EQ(covered.rows[2].clause, "EN 12464-1:2021 34.7");
  for (const RowCoverage& row : covered.rows) EXPECT_TRUE(row.is_whole()) << row.workplace;
  EXPECT_EQ(covered.roles(1), covered.roles(0));
}

// A pack whose workplaces make the desks, and cannot know where the board hangs.
std::vector<RulePack> school() {
  const std::string xml =
      "<rule-pack id='school' edition='1' title='School' version='1' kind='contract' "
      "status='published' licence='internal' role='task'>"
      "<parameter id='E' unit='lx' meaning='m'/>"
      "<plane role='task' orientation='horizontal-up' area='task' height='0.75'/>"
      "<plane role='board' orientation='vertical'/>"
      "<row ref='class' name='c' trust='confirmed'><value of='E' required='300'/></row>"
      "<check id='task.Em' role='task' quantity='planar' statistic='average' at-least='row(E)' "
      "trust='confirmed'/>"
      "<check id='board.Em' role='board' quantity='planar' statistic='average' at-least='row(E)' "
      "trust='confirmed'/></rule-pack>";
  calc::Diagnostics diagnostics;
  std::vector<RulePack> packs{parse_rule_pack(xml, "own.xml", diagnostics).value_or(RulePack{})};
  for (const auto& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  return packs;
}

TEST(RowCoverage, APlaneOfTheProjectIsPartOfTheRowOfAWorkplaceThatLacksIt) {
  const std::string desks = "<workplace id='w' pack='school' row='class'/>";
  const std::string board =
      "<plane id='b' origin='1 0.1 1' u='-1 0 0' v='0 0 1'><require pack='school' row='class' "
      "role='board'/></plane>";
  EXPECT_THAT(cover(desks, Verdict::pass, school()).roles(),
              ElementsAre("task met", "board never-asked"));
  const Covered both = cover(desks + board, Verdict::pass, school());
  ASSERT_EQ(both.rows.size(), 1u);
  EXPECT_EQ(both.rows[0].workplace, "w");
  EXPECT_THAT(both.roles(), ElementsAre("task met", "board met"));
  EXPECT_THAT(cover(desks + board, Verdict::fail, school()).roles(),
              ElementsAre("task failed", "board failed"));
  // In another scene it says nothing about this one.
  const std::string elsewhere =
      "<plane id='b' origin='1 0.1 1' u='-1 0 0' v='0 0 1'><require pack='school' row='class' "
      "role='board' scene='em'/></plane>";
  const Covered apart = cover(desks + elsewhere, Verdict::pass, school());
  ASSERT_EQ(apart.rows.size(), 2u);
  EXPECT_THAT(apart.roles(), ElementsAre("task met", "board never-asked"));
  EXPECT_EQ(apart.rows[1].clause, "School:1 class, scene em");
  // A second task is nothing that the workplace lacks.
  const std::string task =
      "<plane id='t' height='0.75'><require pack='school' row='class'/></plane>";
  EXPECT_EQ(cover(desks + task, Verdict::pass, school()).rows.size(), 2u);
}

TEST(RowCoverage, ARoleIsWhatItsGravestFindingIs) {
  EXPECT_EQ(cover(kTask, Verdict::fail).roles()[0], "task failed");
  EXPECT_EQ(cover(kTask, Verdict::undecided).roles()[0], "task undecided");
  EXPECT_EQ(cover(kTask, Verdict::not_judged).roles()[0], "task not-judged");
}

// The row has no value for the ceiling, and so nothing is missing there.
TEST(RowCoverage, WhatARowDoesNotRequireIsNotMissed) {
  const Covered covered = cover(
      "<plane id='t' height='0.75' margin='0.5'><require pack='en12464-1:2021' "
      "row='14.1'/></plane>");
  for (const std::string& role : covered.roles()) {
    EXPECT_FALSE(role.starts_with("ceiling")) << role;
    EXPECT_FALSE(role.starts_with("modelling")) << "advice";
  }
}

std::string wall_plane(const std::string& on) {
  return "<plane id='" + on + "' on='" + on +
         "' margin='0.5'><require pack='en12464-1:2021' row='34.2' role='wall'/></plane>";
}

const RoleCoverage& role_of(const Covered& covered, const std::string& role) {
  const auto& roles = covered.rows.at(0).roles;
  return *std::find_if(roles.begin(), roles.end(),
                       [&](const RoleCoverage& one) { return one.role == role; });
}

// All that 34.2 asks for but for the walls.
const std::string kAllButWalls =
    kTask +
    "<plane id='s' height='0.75' margin='0.5'><require pack='en12464-1:2021' row='34.2' "
    "role='surround'/></plane>"
    "<plane id='b' height='0' margin='0.5'><require pack='en12464-1:2021' row='34.2' "
    "role='background'/></plane>"
    "<plane id='c' on='ceiling' margin='0.5'><require pack='en12464-1:2021' row='34.2' "
    "role='ceiling'/></plane>"
    "<plane id='z' height='1.2' margin='0.5' quantity='cylindrical'><require "
    "pack='en12464-1:2021' row='34.2' role='cylinder'/></plane>"
    "<plane id='e' height='1.2' margin='0.5' quantity='ugr' direction='1 0 0'><require "
    "pack='en12464-1:2021' row='34.2' role='observer'/></plane>"
    "<plane id='f' height='1.2' margin='0.5' quantity='ugr' direction='0 -1 0'><require "
    "pack='en12464-1:2021' row='34.2' role='observer'/></plane>";

TEST(RowCoverage, OneWallIsNotAllWalls) {
  const Covered one = cover(kAllButWalls + wall_plane("wall1") + wall_plane("wall3"));
  EXPECT_EQ(role_of(one, "wall").state, RoleState::asked_in_part);
  EXPECT_EQ(role_of(one, "wall").words, "without the walls r.wall2, r.wall4");
  EXPECT_EQ(role_of(one, "wall").of.size(), 4u);
  EXPECT_FALSE(one.rows.at(0).is_whole());
  EXPECT_FALSE(one.rows.at(0).is_met());
  const Covered all = cover(kAllButWalls + wall_plane("wall1") + wall_plane("wall2") +
                            wall_plane("wall3") + wall_plane("wall4"));
  EXPECT_EQ(role_of(all, "wall").state, RoleState::met) << role_of(all, "wall").words;
  EXPECT_TRUE(all.rows.at(0).is_whole());
  EXPECT_TRUE(all.rows.at(0).is_met());
}

// A plane that is asked for something else, or in another row, covers no wall of this one.
TEST(RowCoverage, AWallOfAnotherRowIsNotOfThisOne) {
  const std::string other =
      "<plane id='o' on='wall2' margin='0.5'><require pack='en12464-1:2021' row='34.7' "
      "role='wall'/></plane>";
  const Covered covered = cover(wall_plane("wall1") + other);
  EXPECT_EQ(role_of(covered, "wall").words, "without the walls r.wall2, r.wall3, r.wall4");
}

TEST(RowCoverage, OutdoorsItIsNotKnownWhatWallsThereAre) {
  const Covered covered = cover_open(
      "<plane id='p' origin='0 0 0' u='0 0 3' v='4 0 0'><require pack='en12464-1:2021' row='34.2' "
      "role='wall'/></plane>");
  EXPECT_EQ(role_of(covered, "wall").state, RoleState::asked_in_part);
  EXPECT_EQ(role_of(covered, "wall").words, "the walls are not known");
}

// Whoever lets eyes look one way only has chosen it; what no eye sees was not rated.
TEST(RowCoverage, EyesThatLookOneWayAreNotAll) {
  const auto eyes = [](const std::string& id, const std::string& way) {
    return "<plane id='" + id + "' height='1.2' margin='0.5' quantity='ugr' direction='" + way +
           "'><require pack='en12464-1:2021' row='34.2' role='observer'/></plane>";
  };
  const Covered one = cover(eyes("a", "1 0 0"));
  EXPECT_EQ(role_of(one, "observer").state, RoleState::asked_in_part);
  EXPECT_EQ(role_of(one, "observer").words, "observers look in one direction only");
  EXPECT_EQ(role_of(cover(eyes("a", "1 0 0") + eyes("b", "0 1 0")), "observer").state,
            RoleState::met);
  EXPECT_EQ(role_of(cover(eyes("a", "1 0 0"), Verdict::fail), "observer").state, RoleState::failed);
}

TEST(RowCoverage, HowLargeTheCeilingOfTheOpenIsNobodyKnows) {
  const Covered covered = cover_open(
      "<plane id='p' origin='0 4 3' u='4 0 0' v='0 -4 0'><require pack='en12464-1:2021' row='34.2' "
      "role='ceiling'/></plane>");
  EXPECT_EQ(role_of(covered, "ceiling").state, RoleState::asked_in_part);
}

TEST(RowCoverage, RowsAndWorkplacesAreApart) {
  const Covered covered = cover(kTask +
                                "<workplace id='w' pack='en12464-1:2021' row='34.2' "
                                "origin='4 3' size='2 1.5'/>"
                                "<workplace id='w.b' pack='en12464-1:2021' row='34.7'/>");
  ASSERT_EQ(covered.rows.size(), 3u);
  EXPECT_EQ(covered.rows[0].workplace, "w");
  EXPECT_EQ(covered.rows[1].workplace, "w.b");
  EXPECT_EQ(covered.rows[1].clause, "EN 12464-1:2021 34.7");
  EXPECT_EQ(covered.rows[2].workplace, "");
}

TEST(RowCoverage, PacksWithoutRowsAndOwnLimitsHaveNone) {
  EXPECT_THAT(
      cover("<plane id='t' height='0' travel='1 0 0'><require pack='en1838:2024' scene='em'/>"
            "<require quantity='average' at-least='1'/></plane>")
          .rows,
      IsEmpty());
}

}  // namespace
}  // namespace rules::coverage_test
