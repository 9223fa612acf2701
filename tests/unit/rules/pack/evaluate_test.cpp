#include "rules/pack/evaluate.h"

#include "tests/support/evaluated.h"
#include "tests/support/message_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <string>

namespace rules::evaluate_test {
namespace {

calc::Estimate between(double low, double high) { return {0.5 * (low + high), low, high}; }
calc::Estimate exactly(double value) { return {value, value, value}; }

const std::string kHead =
    "<rule-pack id='own' edition='1' title='Own' version='1' kind='company' status='published' "
    "licence='internal' role='desk'>"
    "<parameter id='E' unit='lx' meaning='m'/><fact id='need' unit='lx' meaning='m'/>"
    "<table id='next' key-unit='lx' value-unit='lx' match='next-lower' trust='unverified'>"
    "<entry key='0' value='key'/><entry key='200' value='150'/><entry key='500' value='300'/>"
    "</table>"
    "<table id='line' key-unit='lx' value-unit='none' match='linear'>"
    "<entry key='100' value='1'/><entry key='300' value='2'/></table>"
    "<scale id='steps' unit='lx' values='100 150 200 300 500'/>"
    "<row ref='1' name='a' trust='confirmed'><value of='E' required='200' modified='500'/></row>"
    "<row ref='2' name='b' trust='single-source'><value of='E' none='unknown'/></row>"
    "<row ref='3' name='c' trust='confirmed'/>";

std::string check(const std::string& id, const std::string& limit,
                  const std::string& statistic = "average") {
  return "<check id='" + id + "' role='desk' quantity='planar' statistic='" + statistic +
         "' at-least='" + limit + "'/>";
}

RulePack pack_of(const std::string& parts) {
  calc::Diagnostics diagnostics;
  std::optional<RulePack> pack =
      parse_rule_pack(kHead + parts + "</rule-pack>", "own.xml", diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  return pack.value_or(RulePack{});
}

// The limit of a check with this formula for row 1, in words if there is none.
std::string limit_of(const std::string& formula, RowLevel level = RowLevel::required,
                     const std::map<std::string, double>& facts = {},
                     const std::string& ref = "1") {
  const RulePack pack = pack_of(check("x", formula));
  const Limit limit = evaluate_limit(pack.checks.at(0), {pack, pack.find_row(ref), level, facts});
  if (limit.status != LimitStatus::known) return limit.reason.english();
  return std::to_string(limit.value.value).substr(0, 7);
}

TEST(EvaluateLimit, ComputesFormulas) {
  EXPECT_EQ(limit_of("max(15 lx, 0.1 * row(E))"), "20.0000");
  EXPECT_EQ(limit_of("min(15 lx, 0.1 * row(E))"), "15.0000");
  EXPECT_EQ(limit_of("row(E) / 4 + 1 lx"), "51.0000");
  EXPECT_EQ(limit_of("100 lx * (row(E) / 400 lx)"), "50.0000");
  EXPECT_EQ(limit_of("row(E)", RowLevel::modified), "500.000");
  EXPECT_EQ(limit_of("2 * fact(need)", RowLevel::required, {{"need", 70.0}}), "140.000");
}

TEST(EvaluateLimit, LooksUpTables) {
  EXPECT_EQ(limit_of("table(next, row(E))"), "150.000");
  EXPECT_EQ(limit_of("table(next, 499 lx)"), "150.000");
  EXPECT_EQ(limit_of("table(next, 120 lx)"), "120.000");  // the key itself
  EXPECT_EQ(limit_of("10 lx * table(line, 150 lx)"), "12.5000");
  EXPECT_EQ(limit_of("10 lx * table(line, 300 lx)"), "20.0000");
  EXPECT_EQ(limit_of("10 lx * table(line, 301 lx)"), "table 'line' has no entry for 301 lx");
}

TEST(EvaluateLimit, StepsUpAndDownTheScale) {
  EXPECT_EQ(limit_of("step(row(E), +1, steps)"), "300.000");
  EXPECT_EQ(limit_of("step(row(E), -2, steps)"), "100.000");
  EXPECT_EQ(limit_of("step(row(E), +0, steps)"), "200.000");
  EXPECT_EQ(limit_of("step(row(E), +3, steps)"), "scale 'steps' has no value +3 steps from 200 lx");
  EXPECT_EQ(limit_of("step(210 lx, +1, steps)"), "210 lx is not on scale 'steps'");
}

// Of the required value, also where the row has a modified one; limits that follow go with it.
TEST(EvaluateLimit, TakesAParameterAlongItsScale) {
  const std::string scale =
      "<scale id='of-E' unit='fc' values='10 20 30' of='E' down='1' up='1' trust='unverified'/>";
  const std::string row = "<row ref='9' name='a' trust='confirmed'><value of='E' required='";
  const auto limit_at = [&](int steps, const std::string& required, const std::string& formula) {
    const RulePack pack = pack_of(scale + row + required + "'/></row>" + check("x", formula));
    const Limit limit =
        evaluate_limit(pack.checks.at(0), {pack, pack.find_row("9"), RowLevel{.steps = steps}});
    if (limit.status != LimitStatus::known) return limit.reason.english();
    EXPECT_EQ(limit.trust, Trust::unverified);
    EXPECT_EQ(limit.level.steps, steps);
    return std::to_string(limit.value.value).substr(0, 7);
  };
  const std::string ten_fc = "107.639104167097", twenty_fc = "215.278208334194";
  EXPECT_EQ(limit_at(1, ten_fc, "row(E)"), "215.278");
  EXPECT_EQ(limit_at(-1, twenty_fc, "2 * row(E)"), "215.278");
  EXPECT_EQ(limit_at(-1, ten_fc, "row(E)"),
            "scale 'of-E' has no value -1 steps from 107.639104 "
            "lx");
  EXPECT_EQ(limit_at(1, "120", "row(E)"), "120 lx is not on scale 'of-E'");
}

TEST(EvaluateLimit, SaysWhatIsMissing) {
  EXPECT_EQ(limit_of("fact(need)"), "fact 'need' is not stated");
  EXPECT_EQ(limit_of("row(E) + fact(need)", RowLevel::required, {}, "2"), "row 2: E is not known");
  EXPECT_EQ(limit_of("row(E)", RowLevel::required, {}, "9"), "no row is chosen");
  std::string huge = "1 lx";
  for (int i = 0; i < 40; ++i) huge += " * 1000000000";
  EXPECT_EQ(limit_of(huge), "the limit is not a finite number");
  EXPECT_EQ(limit_of("min(5 lx, 0 * (" + huge + "))"), "the limit is not a finite number");
  EXPECT_EQ(limit_of("max(5 lx, 1 lx * (1 lx / (" + huge + ")))"),
            "the limit is not a finite number");
  EXPECT_EQ(limit_of("row(E) / 0"), "the limit is divided by a value that may be 0");
}

TEST(EvaluateLimit, IsTrustedAsItsWorstPart) {
  const RulePack pack = pack_of(check("plain", "row(E)") + check("tabled", "table(next, row(E))") +
                                check("linked", "limit(tabled) / 2"));
  const auto trust = [&](std::size_t i) {
    return evaluate_limit(pack.checks.at(i), {pack, pack.find_row("1")}).trust;
  };
  EXPECT_EQ(trust(0), Trust::confirmed);
  EXPECT_EQ(trust(1), Trust::unverified);
  EXPECT_EQ(trust(2), Trust::unverified);
}

TEST(EvaluateCheck, AgainstTheResultOfAnother) {
  const RulePack pack = pack_of(check("pa", "row(E)") + check("ta", "0.75 * result(pa)"));
  const auto status = [&](const calc::Estimate& pa, const calc::Estimate& ta) {
    const Evidence evidence{
        pack, pack.find_row("1"), RowLevel::required, {}, {{"pa", pa}, {"ta", ta}}};
    return evaluate_check(pack.checks.at(1), evidence);
  };
  EXPECT_EQ(status(exactly(400), exactly(300)), CheckStatus::pass);
  EXPECT_EQ(status(exactly(400), exactly(299)), CheckStatus::fail);
  EXPECT_EQ(status(between(390, 410), exactly(300)), CheckStatus::undecided);
  EXPECT_EQ(status(between(390, 410), between(308, 320)), CheckStatus::pass);
  const Evidence alone{pack, pack.find_row("1"), RowLevel::required, {}, {{"ta", exactly(300)}}};
  EXPECT_EQ(evaluate_check(pack.checks[1], alone), CheckStatus::not_evaluated);
  EXPECT_EQ(limit_of(pack.checks[1], alone).reason, "the result of check 'pa' is not known");
}

TEST(EvaluateCheck, WithoutValueOrResultNeitherPassesNorFails) {
  const RulePack pack = pack_of(check("x", "row(E)"));
  const auto result = [&](const std::string& ref, bool is_measured) {
    Evidence evidence{pack, pack.find_row(ref)};
    if (is_measured) evidence.measured["x"] = exactly(1000);
    return evaluate_check(pack.checks.at(0), evidence);
  };
  EXPECT_EQ(result("1", true), CheckStatus::pass);
  EXPECT_EQ(result("1", false), CheckStatus::not_evaluated);
  EXPECT_EQ(result("2", true), CheckStatus::not_evaluated);
  EXPECT_EQ(result("3", true), CheckStatus::not_applicable);
  EXPECT_EQ(limit_of(pack.checks.at(0), {pack, pack.find_row("3")}).reason,
            "row 3: E is not-specified");
}

RuleAggregate aggregate_of(AggregateRule rule, int count = 0, double share = 0) {
  RuleAggregate aggregate;
  aggregate.rule = rule;
  aggregate.count = count;
  aggregate.share = share;
  return aggregate;
}

constexpr CheckStatus kPass = CheckStatus::pass, kFail = CheckStatus::fail,
                      kOpen = CheckStatus::undecided, kNone = CheckStatus::not_applicable,
                      kMissing = CheckStatus::not_evaluated;

CheckStatus combined(const RuleAggregate& aggregate, const std::vector<CheckStatus>& statuses) {
  std::vector<WeightedStatus> members;
  for (const CheckStatus status : statuses) members.push_back({status, 1.0});
  return combine_statuses(aggregate, members);
}

TEST(CombineStatuses, AllAndAny) {
  const RuleAggregate all = aggregate_of(AggregateRule::all);
  EXPECT_EQ(combined(all, {kPass, kPass}), kPass);
  EXPECT_EQ(combined(all, {kPass, kOpen, kFail}), kFail);
  EXPECT_EQ(combined(all, {kPass, kOpen}), kOpen);
  EXPECT_EQ(combined(all, {kPass, kMissing}), kOpen);
  EXPECT_EQ(combined(all, {kPass, kNone}), kPass);
  EXPECT_EQ(combined(all, {kNone}), kNone);
  const RuleAggregate any = aggregate_of(AggregateRule::any);
  EXPECT_EQ(combined(any, {kFail, kOpen, kPass}), kPass);
  EXPECT_EQ(combined(any, {kFail, kOpen}), kOpen);
  EXPECT_EQ(combined(any, {kFail, kNone}), kFail);
}

TEST(CombineStatuses, AtLeast) {
  const RuleAggregate two = aggregate_of(AggregateRule::at_least, 2);
  EXPECT_EQ(combined(two, {kPass, kPass, kFail}), kPass);
  EXPECT_EQ(combined(two, {kPass, kOpen, kFail}), kOpen);
  EXPECT_EQ(combined(two, {kPass, kFail, kFail}), kFail);
  EXPECT_EQ(combined(two, {kPass}), kFail);
}

TEST(CombineStatuses, ShareOfWeights) {
  const RuleAggregate share = aggregate_of(AggregateRule::share, 0, 0.9);
  EXPECT_EQ(combine_statuses(share, {{kPass, 90.0}, {kFail, 10.0}}), kPass);
  EXPECT_EQ(combine_statuses(share, {{kPass, 89.0}, {kFail, 11.0}}), kFail);
  EXPECT_EQ(combine_statuses(share, {{kPass, 80.0}, {kOpen, 10.0}, {kFail, 10.0}}), kOpen);
  EXPECT_EQ(combine_statuses(share, {{kPass, 80.0}, {kOpen, 9.0}, {kFail, 11.0}}), kFail);
  EXPECT_EQ(combine_statuses(share, {{kPass, 90.0}, {kNone, 1000.0}, {kFail, 10.0}}), kPass);
}

TEST(EvaluateClass, FindsTheBestThatIsReached) {
  const std::vector<RulePack> packs = builtin_rule_packs();
  for (const RulePack& pack : packs) {
    if (pack.id != "en13201-2") continue;
    const RuleClass& p = *std::find_if(pack.classes.begin(), pack.classes.end(),
                                       [](const RuleClass& one) { return one.id == "P"; });
    const auto classes = [&](const calc::Estimate& mean, const calc::Estimate& minimum) {
      const Evidence evidence{
          pack,
          nullptr,
          RowLevel::required,
          {},
          {{"P.average", mean}, {"P.minimum", minimum}, {"P.not-too-much", mean}}};
      const ClassResult result = evaluate_class(p, evidence);
      return (result.reached ? result.reached->ref : "none") + "/" +
             (result.possible ? result.possible->ref : "none");
    };
    EXPECT_EQ(classes(exactly(16), exactly(3)), "P1/P1");
    EXPECT_EQ(classes(exactly(6), exactly(1.2)), "P4/P4");
    EXPECT_EQ(classes(between(9.9, 10.1), exactly(2)), "P3/P2");
    EXPECT_EQ(classes(exactly(1), exactly(1)), "none/none");
    EXPECT_EQ(classes(exactly(40), exactly(9)), "none/none");  // too much for every class
    return;
  }
  FAIL() << "there is no pack en13201-2";
}

}  // namespace
}  // namespace rules::evaluate_test
