#include "report/document/row_uses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace report::row_uses_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kDesk = "EN 12464-1:2021 34.2", kWay = "EN 12464-1:2021 9.1";

struct Asked {
  std::string plane, id;
  rules::Verdict verdict = rules::Verdict::pass;
  double margin = 0.1;
  rules::Severity severity = rules::Severity::shall;
  double limit = 500.0;
};

// A room in which one workplace asks the row on these planes. is_whole: else a role is missing.
SpacePart room(const std::string& id, const std::string& clause, const std::vector<Asked>& asked,
               bool is_whole = true) {
  SpacePart space;
  space.id = id;
  rules::RoleCoverage task;
  task.role = "task";
  task.state = rules::RoleState::met;
  for (const Asked& one : asked) {
    PlanePart plane;
    plane.id = one.plane;
    rules::Finding finding;
    finding.requirement.id = one.id;
    finding.requirement.limit = one.limit;
    finding.requirement.severity = one.severity;
    finding.verdict = one.verdict;
    finding.margin = one.margin;
    plane.findings = {finding};
    space.planes.push_back(plane);
    task.of.push_back({one.plane, one.id});
  }
  rules::RowCoverage row{"place", calc::Message::words(clause), {task}};
  if (!is_whole) row.roles.push_back({"wall", rules::RoleState::never_asked, {}});
  space.coverage = {row};
  return space;
}

ProjectPart project_of(std::vector<SpacePart> spaces) {
  ProjectPart project;
  project.spaces = std::move(spaces);
  return project;
}

TEST(RowUses, AreOverAllRoomsWithTheSmallestMargin) {
  const std::vector<RowUse> uses = row_uses(project_of(
      {room("a", kDesk, {{"a.1", "Em", rules::Verdict::pass, 0.3}}),
       room("way", kWay, {{"way.1", "Em", rules::Verdict::fail, -0.2}}),
       room("b", kDesk,
            {{"b.1", "Em", rules::Verdict::pass, 0.05}, {"b.2", "Uo", rules::Verdict::pass, 0.2}},
            false)}));
  ASSERT_THAT(uses, SizeIs(2));
  EXPECT_EQ(uses[0].clause, kDesk);
  EXPECT_THAT(uses[0].rooms, ElementsAre("a", "b"));
  EXPECT_EQ(uses[0].times, 2);
  EXPECT_EQ(uses[0].whole, 1);
  EXPECT_EQ(uses[0].requirements, 3);
  EXPECT_EQ(uses[0].met, 3);
  EXPECT_EQ(uses[0].outcome, rules::Outcome::pass);
  EXPECT_EQ(uses[0].margin, 0.05);
  EXPECT_EQ(uses[0].room + "/" + uses[0].plane + "/" + uses[0].requirement, "b/b.1/Em");
  EXPECT_THAT(uses[1].rooms, ElementsAre("way"));
  EXPECT_EQ(uses[1].outcome, rules::Outcome::fail);
  EXPECT_EQ(uses[1].met, 0);
}

// As colour rendering that no maker states.
TEST(RowUses, WhatCannotBeJudgedIsNotJudgedWholly) {
  std::vector<SpacePart> spaces = {room("a", kDesk, {{"a.1", "Em"}}),
                                   room("b", kDesk, {{"b.1", "Em"}})};
  spaces[1].coverage[0].roles.push_back({"lamp", rules::RoleState::not_possible, {}});
  const std::vector<RowUse> uses = row_uses(project_of(std::move(spaces)));
  EXPECT_EQ(uses.at(0).whole, 2);
  EXPECT_EQ(uses[0].open, 1);
  EXPECT_TRUE(uses[0].is_met()) << "it does not count";
  EXPECT_FALSE(uses[0].is_wholly_judged());
}

// What cannot be judged is graver than what fails, and has no margin; advice does not count; a
// limit of 0 has no share.
TEST(RowUses, TakeWhatCounts) {
  const std::vector<RowUse> uses = row_uses(project_of(
      {room("a", kDesk,
            {{"a.1", "Em", rules::Verdict::fail, -0.1},
             {"a.2", "x", rules::Verdict::not_judged, -0.9},
             {"a.3", "wish", rules::Verdict::fail, -0.8, rules::Severity::advice},
             {"a.4", "none", rules::Verdict::pass, -0.7, rules::Severity::shall, 0.0}})}));
  ASSERT_THAT(uses, SizeIs(1));
  EXPECT_EQ(uses[0].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(uses[0].requirements, 3);
  EXPECT_EQ(uses[0].met, 1);
  EXPECT_EQ(uses[0].margin, -0.1);
}

// Walls that two workplaces share are one requirement each; the room is one room.
TEST(RowUses, CountWhatIsSharedOnce) {
  SpacePart shared = room("a", kDesk, {{"wall", "Em", rules::Verdict::pass, 0.3}});
  shared.coverage.push_back(shared.coverage[0]);
  const std::vector<RowUse> uses = row_uses(project_of({shared}));
  ASSERT_THAT(uses, SizeIs(1));
  EXPECT_THAT(uses[0].rooms, ElementsAre("a"));
  EXPECT_EQ(uses[0].times, 2);
  EXPECT_EQ(uses[0].requirements, 1);
}

TEST(RowUses, AreNotMetWhereLeavingOutHasEnded) {
  SpacePart ended = room("a", kDesk, {{"a.1", "Em"}});
  ended.coverage[0].roles.push_back(
      {"wall", rules::RoleState::left_out_ended, calc::Message::words("ended")});
  EXPECT_EQ(row_uses(project_of({ended}))[0].outcome, rules::Outcome::not_judged);
}

// What counts only in an aggregate of its pack is what the aggregate comes to; a row of which a
// part was never asked is not met.
TEST(RowUses, AreWhatTheirAggregatesAre) {
  ProjectPart project = project_of({room("a", kDesk, {{"a.1", "Em"}})});
  EXPECT_TRUE(row_uses(project)[0].is_met());
  rules::AggregateFinding aggregate;
  aggregate.verdict = rules::Verdict::fail;
  aggregate.members.resize(1);
  aggregate.members[0].of = {{"other", "Em"}};
  project.aggregates = {aggregate};
  EXPECT_EQ(row_uses(project)[0].outcome, rules::Outcome::pass);
  project.aggregates[0].members[0].of = {{"a.1", "Em"}};
  EXPECT_EQ(row_uses(project)[0].outcome, rules::Outcome::fail);
  const ProjectPart in_part = project_of({room("a", kDesk, {{"a.1", "Em"}}, false)});
  EXPECT_EQ(row_uses(in_part)[0].outcome, rules::Outcome::pass);
  EXPECT_FALSE(row_uses(in_part)[0].is_met());
}

TEST(RowUses, AreNotMetWhereSomethingIsWaivedOrLeftOut) {
  SpacePart waived = room("a", kDesk, {{"a.1", "Em"}});
  waived.coverage[0].roles[0].state = rules::RoleState::waived;
  SpacePart left_out = room("b", kDesk, {{"b.1", "Em"}});
  left_out.coverage[0].roles.push_back(
      {"wall", rules::RoleState::left_out, {}, {}, {{"wall", {}, false}}});
  for (const SpacePart& space : {waived, left_out}) {
    const RowUse use = row_uses(project_of({space}))[0];
    EXPECT_EQ(use.outcome, rules::Outcome::pass);
    EXPECT_EQ(use.whole, use.times);
    EXPECT_EQ(use.excepted, 1);
    EXPECT_FALSE(use.is_met());
  }
}

TEST(RowUses, AreNoneWithoutRows) { EXPECT_THAT(row_uses(project_of({SpacePart{}})), IsEmpty()); }

}  // namespace
}  // namespace report::row_uses_test
