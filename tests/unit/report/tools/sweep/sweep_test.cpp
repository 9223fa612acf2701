#include "report/tools/sweep/sweep_table.h"
#include "report/tools/sweep/vary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using cli::ParetoPlace;
using testing::ElementsAre;

std::vector<std::string> values_of(const std::string& list) {
  std::string problem;
  const auto vary = cli::parse_vary("a.b=" + list, problem);
  EXPECT_TRUE(vary) << problem;
  return vary ? vary->values : std::vector<std::string>();
}

std::string problem_of(const std::string& text) {
  std::string problem;
  EXPECT_FALSE(cli::parse_vary(text, problem)) << text;
  return problem;
}

TEST(ParseVary, TakesValuesAndRanges) {
  EXPECT_THAT(values_of("3,4,5"), ElementsAre("3", "4", "5"));
  EXPECT_THAT(values_of("3000:5000:1000"), ElementsAre("3000", "4000", "5000"));
  EXPECT_THAT(values_of("0.8:0.96:0.05"), ElementsAre("0.80", "0.85", "0.90", "0.95"));
  EXPECT_THAT(values_of("3:1:-1"), ElementsAre("3", "2", "1"));
  EXPECT_THAT(values_of("1,4:8:2, 20"), ElementsAre("1", "4", "6", "8", "20"));
  EXPECT_THAT(values_of("1:1:5"), ElementsAre("1"));
  EXPECT_THAT(values_of("0 0 1,0 1 0"), ElementsAre("0 0 1", "0 1 0"));
  EXPECT_THAT(values_of("a:b:c"), ElementsAre("a:b:c"));  // ids may be like that
  EXPECT_EQ(values_of("0:0.3:0.1").size(), 4u);           // although 3 * 0.1 > 0.3
  EXPECT_THAT(values_of("1e3:3e3:1e3"), ElementsAre("1000", "2000", "3000"));
}

TEST(ParseVary, SaysWhatIsWrong) {
  EXPECT_EQ(problem_of("a.b"),
            "'a.b' is not PATH=LIST, as linear.flux-lm=3000:5000:500 or L.columns=3,4,5");
  EXPECT_EQ(problem_of("a.b=1,,2"),
            "'a.b=1,,2' has an empty value; values are separated by single commas");
  EXPECT_EQ(problem_of("a.b=1:2:0"), "in '1:2:0', which is from:to:step, the step is 0");
  EXPECT_EQ(problem_of("a.b=1:2:-1"),
            "in '1:2:-1', which is from:to:step, the step -1 leads away from 2");
  EXPECT_EQ(problem_of("a.b=1:x:1"), "in '1:x:1', which is from:to:step, 'x' is no number");
  EXPECT_EQ(problem_of("a.b=0:1:1e-9"), "'0:1:1e-9' are more than 100000 values");
  EXPECT_EQ(problem_of("a.b=3,1:3:1"), "'a.b' has the value '3' twice");
}

TEST(Variants, AreAllCombinationsTheLastPathFastest) {
  const std::vector<cli::Vary> vary{{"a.b", {"1", "2"}}, {"c.d", {"x", "y", "z"}}};
  EXPECT_EQ(cli::count_variants(vary), 6u);
  EXPECT_THAT(cli::values_of_variant(vary, 0), ElementsAre("1", "x"));
  EXPECT_THAT(cli::values_of_variant(vary, 2), ElementsAre("1", "z"));
  EXPECT_THAT(cli::values_of_variant(vary, 5), ElementsAre("2", "z"));
}

cli::SweepRow row(double power_w, const calc::Estimate& margin,
                  rules::Outcome outcome = rules::Outcome::pass) {
  cli::SweepRow row;
  row.power_w = power_w;
  row.margin = margin;
  row.outcome = outcome;
  return row;
}

std::vector<ParetoPlace> front_of(std::vector<cli::SweepRow> rows) {
  cli::find_front(rows);
  std::vector<ParetoPlace> places;
  for (const cli::SweepRow& one : rows) places.push_back(one.pareto);
  return places;
}

calc::Estimate exactly(double margin) { return {margin, margin, margin}; }

TEST(Front, HoldsWhatNoOtherVariantBeats) {
  using enum ParetoPlace;
  EXPECT_THAT(front_of({row(100, exactly(0.1)), row(200, exactly(0.3)), row(300, exactly(0.2)),
                        row(200, exactly(0.25)), row(400, exactly(0.3))}),
              ElementsAre(on, on, off, off, off));
  // Ties are on it together.
  EXPECT_THAT(front_of({row(100, exactly(0.1)), row(100, exactly(0.1))}), ElementsAre(on, on));
}

TEST(Front, KnowsIntervals) {
  using enum ParetoPlace;
  EXPECT_THAT(front_of({row(100, {0.1, 0.05, 0.15}), row(100, {0.08, 0.04, 0.12}),
                        row(100, {0.01, 0.0, 0.04}), row(200, {0.09, 0.08, 0.11})}),
              ElementsAre(on, perhaps, off, perhaps));
}

TEST(Front, HoldsOnlyWhatPassesWithKnownPower) {
  using enum ParetoPlace;
  cli::SweepRow unknown_power = row(1, exactly(1));
  unknown_power.without_power = 1;
  cli::SweepRow no_margin = row(1, exactly(1));
  no_margin.margin.reset();
  EXPECT_THAT(front_of({row(1, exactly(0.1), rules::Outcome::undecided),
                        row(1, exactly(-0.1), rules::Outcome::fail), unknown_power, no_margin,
                        row(500, exactly(0.01))}),
              ElementsAre(off, off, off, off, on));
}

rules::Finding finding(const std::string& id, rules::Comparison comparison, double limit,
                       const calc::Estimate& measured, rules::Verdict verdict) {
  rules::Finding finding;
  finding.requirement.id = id;
  finding.requirement.comparison = comparison;
  finding.requirement.limit = limit;
  finding.measured = measured;
  finding.verdict = verdict;
  return finding;
}

report::ProjectPart part_with(const std::vector<rules::Finding>& findings) {
  report::ProjectPart part;
  part.is_judged = true;
  part.spaces.resize(1);
  part.spaces[0].power.power_w = 70;
  part.spaces[0].planes.resize(1);
  part.spaces[0].planes[0].id = "desk";
  part.spaces[0].planes[0].is_computed = true;
  part.spaces[0].planes[0].findings = findings;
  return part;
}

TEST(RowOf, HasTheSmallestMarginEndByEnd) {
  using enum rules::Verdict;
  const auto least = rules::Comparison::at_least, most = rules::Comparison::at_most;
  const cli::SweepRow row =
      cli::row_of(3, {"1"},
                  part_with({finding("a", least, 100, {110, 105, 120}, pass),
                             finding("b", most, 200, {176, 170, 202}, undecided),
                             finding("none", most, 0, {0, 0, 0}, pass),
                             finding("far", least, 100, {150, 140, 160}, pass)}));
  ASSERT_TRUE(row.margin);
  EXPECT_DOUBLE_EQ(row.margin->value, 0.10);  // of a; b has 0.12, -0.01 to 0.15
  EXPECT_DOUBLE_EQ(row.margin->low, -0.01);
  EXPECT_DOUBLE_EQ(row.margin->high, 0.15);
  EXPECT_EQ(cli::requirement_words(row), "desk: a");
  EXPECT_EQ(row.outcome, rules::Outcome::undecided);
  EXPECT_EQ(row.power_w, 70);
  EXPECT_EQ(row.without_margin, 1);  // a limit of 0
}

// The margin is not about them: they are counted beside it.
TEST(RowOf, CountsAggregatesThatCount) {
  report::ProjectPart part =
      part_with({finding("a", rules::Comparison::at_least, 1, {2, 2, 2}, rules::Verdict::pass)});
  rules::AggregateFinding aggregate;
  aggregate.verdict = rules::Verdict::fail;
  part.aggregates = {aggregate, aggregate};
  part.aggregates[1].severity = rules::Severity::advice;
  const cli::SweepRow row = cli::row_of(0, {}, part);
  EXPECT_EQ(row.outcome, rules::Outcome::fail);
  EXPECT_EQ(row.without_margin, 1);
  EXPECT_EQ(cli::margin_words(row), "+100.0 %, 1 without");
}

TEST(RowOf, HasNoMarginWhereSomethingIsNotJudged) {
  using enum rules::Verdict;
  rules::Finding open = finding("b", rules::Comparison::at_least, 1, {}, not_judged);
  open.reason = "because";
  const cli::SweepRow row = cli::row_of(
      0, {}, part_with({finding("a", rules::Comparison::at_least, 1, {2, 2, 2}, pass), open}));
  EXPECT_FALSE(row.margin);
  EXPECT_EQ(row.outcome, rules::Outcome::not_judged);
  EXPECT_EQ(row.reason, "plane 'desk': because");
}

TEST(SweepNotes, NameAPathWithoutEffect) {
  cli::Sweep sweep;
  sweep.vary = {{"a.b", {"1", "2"}}, {"c.d", {"x", "y"}}};
  for (std::size_t v = 0; v < 4; ++v) {
    sweep.rows.push_back(row(10, exactly(v % 2 == 0 ? 0.1 : 0.2)));
    sweep.rows.back().values = cli::values_of_variant(sweep.vary, v);
  }
  EXPECT_THAT(cli::sweep_notes(sweep), ElementsAre(testing::HasSubstr("'a.b' changes no")));
  sweep.rows[2].margin->high = 0.3;
  sweep.rows[1].rows_in_part = 1;
  sweep.rows[3].warnings = 2;
  EXPECT_THAT(cli::sweep_notes(sweep),
              ElementsAre(testing::HasSubstr("each: 1"), testing::HasSubstr("in part only: 1")));
}

TEST(SweepHtml, EscapesWhatComesFromFiles) {
  cli::Sweep sweep;
  sweep.project = "<p>&.xml";
  sweep.vary = {{"a<b.name", {"<script>", "\"&"}}};
  for (const std::string& value : sweep.vary[0].values) {
    sweep.rows.push_back(row(10, exactly(0.1)));
    sweep.rows.back().values = {value};
    sweep.rows.back().plane = "<x>";
  }
  cli::find_front(sweep.rows);
  const std::string html = cli::render_sweep_html(sweep);
  for (const char* raw : {"<script", "<p>&", "a<b", "<x>"}) {
    EXPECT_EQ(html.find(raw), std::string::npos) << raw;
  }
}

}  // namespace
