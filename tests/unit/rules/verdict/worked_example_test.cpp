// The worked example of the rule model: one pack for nine families of standards, small planes with
// given point values, and the verdicts they must get.
#include "rules/measure/measure.h"
#include "rules/pack/evaluate.h"
#include "tests/support/evaluated.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

namespace rules::worked_example_test {
namespace {

const RulePack& demo() {
  static const RulePack kPack = [] {
    std::ifstream file(LUXGATE_WORKED_EXAMPLE, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    calc::Diagnostics diagnostics;
    std::optional<RulePack> pack = parse_rule_pack(bytes, "demo.xml", diagnostics);
    for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
    return pack.value_or(RulePack{});
  }();
  return kPack;
}

// Exact values at the centres of cells of 0.5 m; value: of the place along u and v in metres.
struct Plane {
  calc::SensorGrid grid;
  calc::PlaneField field;

  Plane(double u_m, double v_m, const std::function<double(double, double)>& value) {
    grid.spacing_u_m = grid.spacing_v_m = 0.5;
    grid.columns = static_cast<int>(u_m / 0.5);
    grid.rows = static_cast<int>(v_m / 0.5);
    field.channels = {{"", 1.0}};
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const glm::dvec3 place(0.5 * column + 0.25, 0.5 * row + 0.25, 0.0);
        grid.position_m.push_back(place);
        field.direct_exact_lx.push_back(value(place.x, place.y));
      }
    }
    field.points = grid.position_m.size();
  }
  Plane(double u_m, double v_m, double value)
      : Plane(u_m, v_m, [value](double, double) { return value; }) {}
};

struct Outcome {
  CheckStatus status;
  bool is_close;
};
bool operator==(const Outcome& a, const Outcome& b) {
  return a.status == b.status && a.is_close == b.is_close;
}
void PrintTo(const Outcome& outcome, std::ostream* out) {
  *out << name_of_status(outcome.status) << (outcome.is_close ? " (close)" : "");
}

const Outcome kPass{CheckStatus::pass, false}, kFail{CheckStatus::fail, false},
    kFailClose{CheckStatus::fail, true}, kNone{CheckStatus::not_applicable, false},
    kMissing{CheckStatus::not_evaluated, false};

Evidence evidence_for(const std::string& ref, RowLevel level = RowLevel::required) {
  return {demo(), demo().find_row(ref), level, {{"class_Em", 200.0}}};
}

// Measures what the check asks for, with its own mask; nothing if that is not possible.
void measure_into(Evidence& evidence, const RuleCheck& check, const Plane& plane) {
  Requirement requirement;
  requirement.metric = check.metric;
  requirement.mask = check.mask;
  requirement.direct_only = check.direct_only;
  const Measurement measurement = measure(requirement, plane.grid, plane.field, {}, 0.95);
  if (measurement.metric) evidence.measured[check.id] = measurement.metric->estimate;
}

Outcome outcome_of(const RuleCheck& check, const Evidence& evidence) {
  const CheckStatus status = evaluate_check(check, evidence);
  const bool is_decided = status == CheckStatus::pass || status == CheckStatus::fail ||
                          status == CheckStatus::undecided;
  return {status, is_decided && decision_of(check, evidence).is_close};
}

Outcome judged(const std::string& id, const std::string& ref, const Plane& plane,
               RowLevel level = RowLevel::required) {
  Evidence evidence = evidence_for(ref, level);
  const RuleCheck& check = *demo().find_check(id);
  measure_into(evidence, check, plane);
  return outcome_of(check, evidence);
}

Outcome judged_number(const std::string& id, const std::string& ref, double value) {
  Evidence evidence = evidence_for(ref);
  evidence.measured[id] = {value, value, value};
  return outcome_of(*demo().find_check(id), evidence);
}

TEST(WorkedExample, TaskArea) {
  const Plane good(3, 2, [](double x, double) { return x < 0.5 ? 400.0 : 560.0; });
  EXPECT_EQ(judged("task.Em", "34.2", good), kPass);
  EXPECT_EQ(judged("task.Uo", "34.2", good), kPass);
  EXPECT_EQ(judged("task.Em", "34.2", good, RowLevel::modified), kFail);
  EXPECT_EQ(judged("task.Em", "34.2", Plane(3, 2, 499.6)), kFailClose);
  // Uo = 595 / 1000, shown with two digits as 0.60
  const Plane uneven(3, 2, [](double x, double) { return x < 1.5 ? 595.0 : 1405.0; });
  EXPECT_EQ(judged("task.Uo", "34.2", uneven), kFailClose);
}

TEST(WorkedExample, SurroundAndBackgroundFollowTheTask) {
  EXPECT_EQ(judged("sur.Em", "34.2", Plane(3, 2, 300)), kPass);
  EXPECT_EQ(judged("sur.Em", "34.2", Plane(3, 2, 299)), kFail);
  EXPECT_EQ(judged("sur.Em", "9.1", Plane(3, 2, 101)), kPass);
  EXPECT_EQ(judged("sur.Em", "9.1", Plane(3, 2, 99)), kFail);  // as the task below 200 lx
  // dark along the walls, which do not count
  const Plane floor(4, 4, [](double x, double y) {
    return x < 0.5 || x > 3.5 || y < 0.5 || y > 3.5 ? 0.0 : 110.0;
  });
  EXPECT_EQ(judged("bg.Em", "34.2", floor), kPass);
  EXPECT_EQ(judged("bg.Em", "34.2", Plane(4, 4, 99)), kFail);
}

TEST(WorkedExample, RowsWithoutAValueAreNotApplicable) {
  EXPECT_EQ(judged("wall.Em", "34.2", Plane(3, 2, 140)), kFail);
  EXPECT_EQ(judged("wall.Em", "13.6", Plane(3, 2, 140)), kNone);
  EXPECT_EQ(judged("cyl.Em", "34.2", Plane(3, 2, 160)), kPass);
  EXPECT_EQ(judged("cyl.Em", "13.6", Plane(3, 2, 160)), kNone);
  EXPECT_EQ(judged_number("ugr", "34.2", 18.9), kPass);
  EXPECT_EQ(judged_number("ugr", "34.2", 19.3), kFail);
  EXPECT_EQ(judged_number("ugr", "34.2", 19.04), kFailClose);
  EXPECT_EQ(judged_number("ugr", "13.6", 25.0), kNone);
}

TEST(WorkedExample, ModellingAtEveryPoint) {
  const Plane good(3, 2, [](double x, double) { return x < 1.5 ? 0.35 : 0.55; });
  EXPECT_EQ(judged("cyl.mod.low", "34.2", good), kPass);
  EXPECT_EQ(judged("cyl.mod.high", "34.2", good), kPass);
  const Plane flat(3, 2, [](double x, double) { return x < 1.5 ? 0.35 : 0.65; });
  EXPECT_EQ(judged("cyl.mod.low", "34.2", flat), kPass);
  EXPECT_EQ(judged("cyl.mod.high", "34.2", flat), kFail);
}

// 3 m wide: bright in the middle, dark 0.75 m from the edge.
TEST(WorkedExample, RouteThatPasses2013AndFails2024) {
  const Plane route(10, 3, [](double, double y) {
    const double off = y > 1.5 ? y - 1.5 : 1.5 - y;
    return off < 0.5 ? 1.2 : (off < 0.76 ? 0.8 : 0.2);
  });
  EXPECT_EQ(judged("1838.2013.line", "34.2", route), kPass);
  EXPECT_EQ(judged("1838.2013.band", "34.2", route), kPass);
  EXPECT_EQ(judged("1838.2024.min", "34.2", route).status, CheckStatus::fail);
  EXPECT_EQ(judged("1838.2024.div", "34.2", route), kPass);
  const Plane bright(10, 3, [](double x, double) { return x < 1.0 ? 41.0 : 1.0; });
  EXPECT_EQ(judged("1838.2024.min", "34.2", bright), kPass);
  EXPECT_EQ(judged("1838.2024.div", "34.2", bright), kFail);
}

TEST(WorkedExample, HighRisk) {
  EXPECT_EQ(judged("1838.hr", "34.2", Plane(3, 2, 51)), kPass);
  EXPECT_EQ(judged("1838.hr", "34.2", Plane(3, 2, 49)), kFail);
  EXPECT_EQ(judged("1838.hr", "9.1", Plane(3, 2, 16)), kPass);  // 15 lx at least
  EXPECT_EQ(judged("1838.hr", "9.1", Plane(3, 2, 14)), kFail);
}

// 1 fc is 10.7639 lx; 10.8 lx is a rounded reprint.
TEST(WorkedExample, FootcandlesAreNotRounded) {
  EXPECT_EQ(judged("nfpa.mean", "34.2", Plane(3, 2, 10.77)).status, CheckStatus::pass);
  EXPECT_EQ(judged("nfpa.mean", "34.2", Plane(3, 2, 10.76)).status, CheckStatus::fail);
  EXPECT_EQ(judged("nfpa.n1", "34.2", Plane(3, 2, 2.16)).status, CheckStatus::pass);
  EXPECT_EQ(judged("nfpa.n1", "34.2", Plane(3, 2, 2.15)).status, CheckStatus::fail);
}

TEST(WorkedExample, TotalAreaFollowsThePrincipalOne) {
  EXPECT_EQ(judged("pa.Em", "34.2", Plane(3, 2, 210)), kPass);
  EXPECT_EQ(judged("ta.Em", "34.2", Plane(3, 2, 151)), kPass);
  EXPECT_EQ(judged("ta.Em", "34.2", Plane(3, 2, 149)), kFail);
}

// The edge counts for the average but not for the minimum.
TEST(WorkedExample, TwoPopulationsOnOnePlane) {
  const Plane plane(6, 6, [](double x, double y) {
    return x < 0.5 || x > 5.5 || y < 0.5 || y > 5.5 ? 50.0 : 290.0;
  });
  EXPECT_EQ(judged("breeam.min", "34.2", plane), kPass);
  EXPECT_EQ(judged("breeam.mean", "34.2", plane), kPass);
  EXPECT_EQ(judged("breeam.mean", "34.2", Plane(6, 6, 199)), kFail);
  EXPECT_EQ(judged("breeam.min", "34.2", Plane(6, 0.5, 300)), kMissing);  // no point is left
}

TEST(WorkedExample, SpillAndPower) {
  EXPECT_EQ(judged("spill.max", "34.2", Plane(3, 2, 4)), kPass);
  EXPECT_EQ(judged("spill.max", "34.2", Plane(3, 2, 6)), kFail);
  EXPECT_EQ(judged_number("lpd", "open_office", 6.4), kPass);
  EXPECT_EQ(judged_number("lpd", "open_office", 6.7), kFail);
  EXPECT_EQ(judged_number("lpd", "34.2", 6.4), kNone);
}

TEST(WorkedExample, BestClassReached) {
  const auto reached = [](double mean, double minimum) {
    Evidence evidence = evidence_for("");
    evidence.measured = {{"P.mean", {mean, mean, mean}},
                         {"P.most", {mean, mean, mean}},
                         {"P.min", {minimum, minimum, minimum}}};
    const ClassResult result = evaluate_class(demo().classes.at(0), evidence);
    return result.reached == nullptr ? std::string("none") : result.reached->ref;
  };
  EXPECT_EQ(reached(16, 4), "P1");
  EXPECT_EQ(reached(16, 2.9), "none");  // too bright for P2
  EXPECT_EQ(reached(12, 2.5), "P2");
  EXPECT_EQ(reached(6, 1.1), "P4");
  EXPECT_EQ(reached(4, 2), "none");
}

TEST(WorkedExample, Aggregates) {
  Evidence evidence = evidence_for("34.2");
  evidence.measured = {{"task.Em", {480, 480, 480}}, {"ugr", {18, 18, 18}}};
  EXPECT_EQ(evaluate_aggregate(demo().aggregates.at(1), evidence), CheckStatus::pass);
  evidence.measured["ugr"] = {20, 20, 20};
  EXPECT_EQ(evaluate_aggregate(demo().aggregates.at(1), evidence), CheckStatus::fail);
  evidence.measured["ugr"] = {19, 18, 20};
  EXPECT_EQ(evaluate_aggregate(demo().aggregates.at(1), evidence), CheckStatus::undecided);
  EXPECT_EQ(combine_statuses(demo().aggregates.at(0),
                             {{CheckStatus::pass, 91.0}, {CheckStatus::fail, 9.0}}),
            CheckStatus::pass);
  EXPECT_EQ(combine_statuses(demo().aggregates.at(0),
                             {{CheckStatus::pass, 89.0}, {CheckStatus::fail, 11.0}}),
            CheckStatus::fail);
}

}  // namespace
}  // namespace rules::worked_example_test
