#include "rules/verdict/judge_aggregates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

namespace rules::judge_aggregates_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Verdict kPass = Verdict::pass, kFail = Verdict::fail, kOpen = Verdict::undecided,
                  kNone = Verdict::not_judged;

const std::string kHead =
    "<rule-pack id='own' edition='1' title='Own' version='1' kind='company' status='published' "
    "licence='internal' role='desk'><parameter id='E' unit='lx' meaning='m'/>"
    "<parameter id='W' unit='lx' meaning='m'/>"
    "<row ref='A' name='a' trust='confirmed'><value of='E' required='300'/>"
    "<value of='W' required='50'/></row>"
    "<row ref='B' name='b' trust='single-source'><value of='E' required='200'/></row>"
    "<row ref='C' name='c' trust='confirmed'><value of='E' required='100'/></row>";

std::string check(const std::string& id, const std::string& role, const std::string& more,
                  const std::string& severity = "in-aggregate") {
  return "<check id='" + id + "' role='" + role + "' quantity='planar' severity='" + severity +
         "' " + more + "/>";
}

const std::string kMean = check("mean", "desk", "statistic='average' at-least='row(E)'"),
                  kMin = check("min", "desk", "statistic='minimum' at-least='0.5 * row(E)'"),
                  kWall = check("wall", "wall", "statistic='average' at-least='row(W)'");

std::vector<RulePack> packs_of(const std::string& parts) {
  calc::Diagnostics diagnostics;
  std::optional<RulePack> pack =
      parse_rule_pack(kHead + parts + "</rule-pack>", "own.xml", diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  std::vector<RulePack> packs;
  if (pack) packs.push_back(std::move(*pack));
  return packs;
}

// Rooms and planes with findings made by hand.
class Site {
 public:
  explicit Site(const std::string& parts) : packs_(packs_of(parts)) {}

  calc::Space& room(const std::string& id, double side_m = 0.0) {
    calc::Space& space = rooms_.emplace_back();
    space.id = id;
    if (side_m > 0.0) space.outline_m = square(side_m);
    return space;
  }
  // side_m 0: a list of points; < 0: a route.
  void plane(const std::string& id, double side_m = 1.0, const glm::dvec3& at_m = {0, 0, 0}) {
    calc::CalcPlane& plane = planes_.emplace_back();
    plane.id = id;
    calc::PlanarArea area;
    area.outline_m = square(side_m);
    area.origin_m = at_m;
    plane.area = area;
    if (side_m == 0.0) plane.area = calc::PointList{};
    if (side_m < 0.0) {
      calc::EscapeRoute route;
      route.line = {{at_m, at_m + glm::dvec3(-side_m, 0, 0)}, -side_m};
      plane.area = route;
    }
    findings_.emplace_back();
    judged_.push_back({&rooms_.back(), &plane, &findings_.back()});
  }
  Finding& add(const std::string& check, Verdict verdict, const std::string& row = "A",
               int line = 1) {
    Finding& finding = findings_.back().emplace_back();
    finding.verdict = verdict;
    finding.requirement.origin = {"own:1", check, row, {}, {}};
    finding.requirement.where = {"p.xml", line, 1};
    return finding;
  }
  // A plane of eyes, which look that way, and what of them is found.
  Finding& eyes(const std::string& id, const glm::dvec3& way, Verdict verdict, double at_m = 0.0) {
    plane(id);
    planes_.back().direction = way;
    std::get<calc::PlanarArea>(planes_.back().area).origin_m.x = at_m;
    return add("eyes", verdict);
  }
  void waive(Finding& finding) {
    finding.is_waived = true;
    finding.requirement.waiver = Waiver{"moves in May", "J. Doe", "2027-06-30"};
  }

  std::vector<AggregateFinding> judged() const { return judge_aggregates(judged_, packs_); }
  AggregateFinding only() const {
    std::vector<AggregateFinding> all = judged();
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? AggregateFinding{} : all.front();
  }

 private:
  static std::vector<glm::dvec2> square(double side_m) {
    return {{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}};
  }
  std::vector<RulePack> packs_;
  std::deque<calc::Space> rooms_;
  std::deque<calc::CalcPlane> planes_;
  std::deque<std::vector<Finding>> findings_;
  std::vector<JudgedPlane> judged_;
};

Verdict any_of(Verdict mean, Verdict min) {
  Site site(kMean + kMin + "<aggregate id='a' rule='any' of='mean min'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", mean);
  site.add("min", min);
  return site.only().verdict;
}

TEST(JudgeAggregates, AnyIsAsDecidedAsItsParts) {
  EXPECT_EQ(any_of(kFail, kPass), kPass);
  EXPECT_EQ(any_of(kNone, kPass), kPass);
  EXPECT_EQ(any_of(kFail, kFail), kFail);
  EXPECT_EQ(any_of(kFail, kOpen), kOpen);
  EXPECT_EQ(any_of(kFail, kNone), kNone);
  EXPECT_EQ(any_of(kOpen, kNone), kNone);
}

// A room whose glare is rated at eyes is no better where somebody looks at a wall.
TEST(JudgeAggregates, EyesThatLookOneWayAreNotTheRoom) {
  const std::string parts =
      check("mean", "desk", "statistic='average' at-least='row(E)'", "shall") + kWall +
      "<check id='eyes' role='eye' quantity='UGR' statistic='maximum' severity='in-aggregate' "
      "state='initial' at-most='19'/><aggregate id='a' rule='any' of='eyes wall'/>";
  Site site(parts);
  site.room("r");
  site.eyes("e", {1, 0, 0}, kPass);
  site.eyes("f", {0.9, 0.4, 0}, kPass);
  EXPECT_EQ(site.only().verdict, kNone);
  EXPECT_THAT(site.only().reason.english(), HasSubstr("in one direction only"));
  site.eyes("g", {0, 1, 0}, kPass);
  EXPECT_EQ(site.only().verdict, kPass);
  // Two seats that each look one way, apart from each other, are no two ways.
  Site apart(parts);
  apart.room("r");
  apart.eyes("e", {1, 0, 0}, kPass, 8.0);
  apart.eyes("f", {-1, 0, 0}, kPass);
  EXPECT_EQ(apart.only().verdict, kNone);
  Site dark(parts);  // nothing that any of them sees is rated
  dark.room("r");
  for (const glm::dvec3& way : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
    dark.eyes("e" + std::to_string(way.y), way, kPass).reason =
        calc::Message::words("nothing is seen");
  }
  EXPECT_EQ(dark.only().verdict, kNone);
  Site failing(parts);
  failing.room("r");
  failing.eyes("e", {1, 0, 0}, kFail);
  EXPECT_EQ(failing.only().verdict, kNone);  // the wall may do, and nobody has asked
}

// Of a row that requires nothing else: less than is needed is no failure.
TEST(JudgeAggregates, AtLeastOfTooFewIsNotJudged) {
  Site site(kMean + kWall + "<aggregate id='a' rule='at-least' count='2' of='mean wall'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", kPass, "B");
  const AggregateFinding finding = site.only();
  EXPECT_EQ(finding.verdict, kNone);
  EXPECT_THAT(finding.reason.english(), HasSubstr("at least 2 must be met"));
}

TEST(JudgeAggregates, OfOneRoleAreMadeForEveryPlaneAndEveryRequire) {
  Site site(kMean + kMin + "<aggregate id='a' rule='any' of='mean min'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", kPass);
  site.add("min", kFail);
  site.add("mean", kFail, "A", 2);
  site.add("min", kFail, "A", 2);
  site.plane("q");
  site.add("mean", kFail, "A", 3);
  site.add("min", kPass, "A", 3);
  const std::vector<AggregateFinding> all = site.judged();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].verdict, kPass);
  EXPECT_EQ(all[0].plane_id, "p");
  EXPECT_EQ(all[1].verdict, kFail);
  EXPECT_EQ(all[1].where.line, 2);
  EXPECT_EQ(all[1].reason, "fail: mean (p), min (p)");
  EXPECT_EQ(all[2].verdict, kPass);
  EXPECT_EQ(all[2].plane_id, "q");
  EXPECT_EQ(all[2].clause, "Own:1 A");
}

TEST(JudgeAggregates, OfSeveralRolesAreMadeForARoom) {
  const std::string parts = kMean + kWall + "<aggregate id='a' rule='any' of='mean wall'/>";
  Site site(parts);
  site.room("r");
  site.plane("desk");
  site.add("mean", kFail);
  site.plane("wall.1");
  site.add("wall", kPass);
  EXPECT_EQ(site.only().verdict, kPass);
  EXPECT_EQ(site.only().plane_id, "");
  EXPECT_EQ(site.only().space_id, "r");
  site.plane("wall.2");
  site.add("wall", kFail);  // on each of its planes, or it is not met
  EXPECT_EQ(site.only().verdict, kFail);
  site.room("next");
  site.plane("other");
  site.add("wall", kPass);
  EXPECT_EQ(site.judged().size(), 2u);
  EXPECT_EQ(site.judged()[0].verdict, kFail);
}

TEST(JudgeAggregates, WhatNobodyAsksForIsNotJudged) {
  for (const std::string rule : {"any", "all"}) {
    Site site(kMean + kWall + "<aggregate id='a' rule='" + rule + "' of='mean wall'/>");
    site.room("r");
    site.plane("desk");
    site.add("mean", kFail);
    EXPECT_EQ(site.only().verdict, rule == "any" ? kNone : kFail);
    EXPECT_THAT(site.only().reason.english(),
                HasSubstr("wall (role 'wall' is not required of any plane"));
  }
  // Of row B nothing is required of the walls.
  Site site(kMean + kWall + "<aggregate id='a' rule='all' of='mean wall'/>");
  site.room("r");
  site.plane("desk");
  site.add("mean", kPass, "B");
  EXPECT_EQ(site.only().verdict, kPass);
  EXPECT_EQ(site.only().members.size(), 1u);
  EXPECT_EQ(site.only().clause, "Own:1 B [one public source]");
}

TEST(JudgeAggregates, WithoutRequirementsThereIsNone) {
  Site site(kMean + kMin + "<aggregate id='a' rule='any' of='mean min'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", kPass).requirement.origin.pack = "other:1";
  EXPECT_THAT(site.judged(), IsEmpty());
}

TEST(JudgeAggregates, AtLeastSoMany) {
  Site site(kMean + kMin + kWall +
            "<aggregate id='a' rule='at-least' count='2' of='mean min wall'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", kPass);
  site.add("min", kFail);
  site.plane("w");
  Finding& wall = site.add("wall", kOpen);
  EXPECT_EQ(site.only().verdict, kOpen);
  wall.verdict = kPass;
  EXPECT_EQ(site.only().verdict, kPass);
  wall.verdict = kFail;
  EXPECT_EQ(site.only().verdict, kFail);
}

TEST(JudgeAggregates, SharesOfPlanesByCountAndByArea) {
  const auto verdict = [](const std::string& by, double failing_side_m) {
    Site site(kMean + "<aggregate id='a' rule='share' share='0.6' over='planes' by='" + by +
              "' of='mean'/>");
    site.room("r");
    site.plane("large", 3.0);
    site.add("mean", kPass);
    site.plane("small", failing_side_m, {10, 10, 0});
    site.add("mean", kFail);
    const AggregateFinding finding = site.only();
    EXPECT_EQ(finding.plane_id + finding.space_id, "");
    EXPECT_EQ(finding.members.size(), 2u);
    return finding.verdict;
  };
  EXPECT_EQ(verdict("count", 1.0), kFail);
  EXPECT_EQ(verdict("area", 1.0), kPass);  // 9 of 10 m2
  EXPECT_EQ(verdict("area", 3.0), kFail);
  EXPECT_EQ(verdict("area", 0.0), kNone);  // of points, which have no area
  EXPECT_EQ(verdict("area", -1.0), kPass);
  EXPECT_EQ(verdict("area", -3.0), kFail);
}

// The bright end of the floor asked for again, as a plane of its own, makes no more of it bright.
TEST(JudgeAggregates, AFloorCountsOnceInAShareOfTheArea) {
  const auto finding = [](const glm::dvec3& again_at_m, Verdict dark, double again_side_m = 2.0,
                          const char* by = "area") {
    Site site(kMean + "<aggregate id='a' rule='share' share='0.6' over='planes' by='" + by +
              "' of='mean'/>");
    site.room("r");
    site.plane("dark", 2.0, {-2, 0, 0});
    site.add("mean", dark);
    site.plane("bright", 2.0);
    site.add("mean", kPass);
    site.plane("again", again_side_m, again_at_m);
    site.add("mean", kPass);
    return site.only();
  };
  EXPECT_EQ(finding({0, 0, 0.1}, kFail).verdict, kNone);
  EXPECT_THAT(finding({1, 1, 0}, kFail).reason.english(),
              HasSubstr("planes 'bright' and 'again' share"));
  EXPECT_EQ(finding({0, 0, 0}, kFail, -1.0).verdict, kNone);  // as a route
  EXPECT_EQ(finding({0, 0, 0}, kPass).verdict, kPass);        // whatever their areas are
  EXPECT_EQ(finding({0, 0, 2}, kFail).verdict, kPass);        // on a gallery
  EXPECT_EQ(finding({1.99, 0, 0}, kFail).verdict, kPass);     // a neighbour drawn roughly
  EXPECT_EQ(finding({0, 0, 0}, kFail, 2.0, "count").verdict, kPass);
}

TEST(JudgeAggregates, RoomsPassWithAllThatIsAskedOfThem) {
  Site site(kMean + kWall +
            "<aggregate id='a' rule='at-least' count='2' over='rooms' of='mean wall'/>");
  site.room("whole");
  site.plane("p");
  site.add("mean", kPass);
  site.plane("w");
  site.add("wall", kPass);
  site.room("half");
  site.plane("q");
  Finding& half = site.add("mean", kPass);  // the wall is missing
  EXPECT_EQ(site.only().verdict, kNone);
  half.verdict = kFail;
  EXPECT_EQ(site.only().verdict, kFail);
  site.room("row B asks nothing of walls");
  site.plane("s");
  site.add("mean", kPass, "B");
  EXPECT_EQ(site.only().verdict, kPass);
}

TEST(JudgeAggregates, WaivedMembersKeepTheVerdictAndWaiveIt) {
  Site site(kMean + kMin + "<aggregate id='a' rule='all' of='mean min'/>");
  site.room("r");
  site.plane("p");
  Finding& mean = site.add("mean", kFail);
  site.waive(mean);
  Finding& min = site.add("min", kPass);
  EXPECT_EQ(site.only().verdict, kFail);
  EXPECT_TRUE(site.only().is_waived);
  EXPECT_EQ(site.only().reason, "fail: mean (p); waived by J. Doe until 2027-06-30: moves in May");
  min.verdict = kFail;  // nobody has waived this one
  EXPECT_FALSE(site.only().is_waived);
  min.verdict = kNone;
  EXPECT_FALSE(site.only().is_waived);
}

TEST(JudgeAggregates, WhatIsNotJudgedIsWaivedOnlyWhereItDoesNotMatter) {
  for (const std::string rule : {"any", "all"}) {
    Site site(kMean + kMin + "<aggregate id='a' rule='" + rule + "' of='mean min'/>");
    site.room("r");
    site.plane("p");
    site.waive(site.add("mean", kFail));
    site.add("min", kNone);
    EXPECT_EQ(site.only().verdict, rule == "any" ? kNone : kFail);
    EXPECT_EQ(site.only().is_waived, rule == "any");
  }
}

TEST(JudgeAggregates, AdviceStaysAdvice) {
  Site site(check("mean", "desk", "statistic='average' at-least='row(E)'", "shall") +
            "<aggregate id='a' rule='any' of='mean' severity='should' trust='unverified' "
            "clause='7.3' note='as agreed'/>");
  site.room("r");
  site.plane("p");
  site.add("mean", kFail);
  EXPECT_EQ(site.only().severity, Severity::advice);
  EXPECT_EQ(site.only().clause, "Own:1 7.3 [unverified requirement]");
  EXPECT_EQ(site.only().note, "unverified requirement; as agreed");
}

AggregateFinding class_of(const calc::Estimate& mean, const std::string& asked,
                          bool is_doubtful = false) {
  Site site(check("mean", "desk", "statistic='average' at-least='row(E)'", "shall") +
            "<class id='k' rows='A B C' of='mean'/>");
  site.room("r");
  site.plane("p");
  const double limit = asked == "A" ? 300 : (asked == "B" ? 200 : 100);
  const bool is_open = is_doubtful || (mean.low < limit && mean.high >= limit);
  Finding& finding = site.add("mean", is_open ? kOpen : (mean.low >= limit ? kPass : kFail), asked);
  finding.measured = mean;
  finding.is_doubtful = is_doubtful;
  return site.only();
}

TEST(JudgeAggregates, ClassesSayWhatIsReached) {
  const AggregateFinding met = class_of({250, 240, 260}, "C");
  EXPECT_EQ(met.kind, AggregateKind::row_class);
  EXPECT_EQ(met.severity, Severity::advice);
  EXPECT_EQ(met.verdict, kPass);
  EXPECT_EQ(met.asked + met.reached + met.possible, "CBB");
  EXPECT_EQ(met.plane_id, "p");
  const AggregateFinding missed = class_of({250, 240, 260}, "A");
  EXPECT_EQ(missed.verdict, kFail);
  EXPECT_EQ(missed.asked + missed.reached + missed.possible, "ABB");
  const AggregateFinding open = class_of({200, 190, 210}, "B");
  EXPECT_EQ(open.verdict, kOpen);
  EXPECT_EQ(open.reached + open.possible, "CB");
  const AggregateFinding none = class_of({50, 40, 60}, "C");
  EXPECT_EQ(none.reached + none.possible, "");
}

TEST(JudgeAggregates, ClassesFromDoubtfulIntervalsAreOpen) {
  const AggregateFinding finding = class_of({250, 240, 260}, "B", true);
  EXPECT_EQ(finding.verdict, kOpen);
  EXPECT_EQ(finding.reached, "");
  EXPECT_EQ(finding.possible, "A");
}

std::vector<std::string> messages_of(const std::string& parts) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(parse_rule_pack(kHead + parts + "</rule-pack>", "own.xml", diagnostics));
  std::vector<std::string> messages;
  for (const calc::Diagnostic& d : diagnostics.all()) messages.push_back(d.message);
  return messages;
}

TEST(ReadAggregates, RefusesWhatCannotBeMeant) {
  EXPECT_THAT(messages_of(kMean), ElementsAre(HasSubstr("needs an <aggregate>")));
  EXPECT_THAT(messages_of(kMean + "<aggregate id='a' rule='any' of='mean' severity='may'/>"),
              ElementsAre(HasSubstr("needs an <aggregate>")));
  EXPECT_THAT(messages_of(kMean + "<aggregate id='a' rule='any' of='mean mean'/>"),
              ElementsAre(HasSubstr("once")));
  EXPECT_THAT(messages_of(kMean + "<aggregate id='a' rule='at-least' count='2' of='mean'/>"),
              ElementsAre(HasSubstr("count")));
  EXPECT_THAT(messages_of(kMean + "<aggregate id='a' rule='share' share='0.5' by='area' "
                                  "of='mean'/>"),
              ElementsAre(HasSubstr("'by' has no meaning")));
}

}  // namespace
}  // namespace rules::judge_aggregates_test
