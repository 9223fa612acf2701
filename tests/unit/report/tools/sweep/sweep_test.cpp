#include "report/tools/sweep/sweep_shards.h"
#include "report/tools/sweep/sweep_table.h"
#include "report/tools/sweep/vary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sweep_test {
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
  EXPECT_EQ(problem_of("a.b=1:x:1"), "in '1:x:1', which is from:to:step, 'x' is not a number");
  EXPECT_EQ(problem_of("a.b=0:1:1e-9"), "'0:1:1e-9' has more than 100000 values");
  EXPECT_EQ(problem_of("a.b=3,1:3:1"), "'a.b': the value '3' is given twice");
}

TEST(Variants, AreAllCombinationsTheLastPathFastest) {
  const std::vector<cli::Vary> vary{{"a.b", {"1", "2"}}, {"c.d", {"x", "y", "z"}}};
  EXPECT_EQ(cli::count_variants(vary), 6u);
  EXPECT_THAT(cli::values_of_variant(vary, 0), ElementsAre("1", "x"));
  EXPECT_THAT(cli::values_of_variant(vary, 2), ElementsAre("1", "z"));
  EXPECT_THAT(cli::values_of_variant(vary, 5), ElementsAre("2", "z"));
}

const std::vector<cli::Vary> kLightAmidLimits{
    {"r.limit", {"1", "2"}}, {"t.flux", {"5", "6", "7"}}, {"t.price", {"8", "9"}}};

TEST(Shards, KeepVariantsOfOneLightTogether) {
  const auto shard = [](std::uint64_t number, std::uint64_t count) {
    return cli::variants_of_shard(kLightAmidLimits, {false, true, false}, {number, count});
  };
  EXPECT_THAT(shard(1, 3), ElementsAre(0, 1, 6, 7));
  EXPECT_THAT(shard(2, 3), ElementsAre(2, 3, 8, 9));
  EXPECT_THAT(shard(3, 3), ElementsAre(4, 5, 10, 11));
  EXPECT_THAT(shard(2, 2), ElementsAre(4, 5, 10, 11));  // three lights: two and one
  EXPECT_THAT(shard(1, 4), ElementsAre(0, 1, 6, 7));
  EXPECT_EQ(shard(1, 4).size() + shard(2, 4).size() + shard(3, 4).size() + shard(4, 4).size(), 12u);
  // Of two paths the first one's values stay together: 6 lights in thirds.
  EXPECT_THAT(cli::variants_of_shard(kLightAmidLimits, {true, true, false}, {1, 3}),
              ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(cli::variants_of_shard(kLightAmidLimits, {false, false, false}, {1, 2}).size(), 12u);
}

TEST(Shards, KnowLightByWhatIsAskedOfAStore) {
  std::size_t asked = 0;
  const auto keys_of = [&](std::size_t variant) {
    ++asked;
    return std::set<std::string>{"plane", cli::values_of_variant(kLightAmidLimits, variant)[1]};
  };
  EXPECT_THAT(cli::paths_of_light(kLightAmidLimits, keys_of), ElementsAre(false, true, false));
  EXPECT_EQ(asked, 4u);
  // One value alone, in between; and of many values a few are asked for.
  const auto middle = [&](std::size_t variant) {
    ++asked;
    return std::set<std::string>{variant == 1 ? "a" : "b"};
  };
  EXPECT_THAT(cli::paths_of_light({{"a.b", {"1", "2", "3"}}}, middle), ElementsAre(true));
  asked = 0;
  const std::vector<cli::Vary> many{{"a.b", std::vector<std::string>(1000, "x")}};
  EXPECT_THAT(cli::paths_of_light(many,
                                  [&](std::size_t) {
                                    ++asked;
                                    return std::set<std::string>{};
                                  }),
              ElementsAre(false));
  EXPECT_EQ(asked, 9u);
}

cli::SweepRow row(double power_w, const calc::Estimate& margin,
                  rules::Outcome outcome = rules::Outcome::pass) {
  cli::SweepRow row;
  row.power_w = power_w;
  row.margin = margin;
  row.outcome = outcome;
  return row;
}

std::vector<ParetoPlace> front_of(std::vector<cli::SweepRow> rows,
                                  cli::FrontOf front_of = cli::FrontOf::power) {
  cli::find_front(rows, front_of);
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

// Only the watts are others.
TEST(Front, KnowsTheSameLight) {
  using enum ParetoPlace;
  const calc::Estimate light{0.1, 0.05, 0.15};
  EXPECT_THAT(front_of({row(100, light), row(120, light), row(100, light)}),
              ElementsAre(on, off, on));
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

cli::SweepRow priced(double power_w, std::optional<double> price, double margin,
                     int without_price = 0) {
  cli::SweepRow one = row(power_w, exactly(margin));
  one.price = price;
  one.without_price = without_price;
  return one;
}

TEST(Front, IsOfThePriceWhereThatIsAsked) {
  using enum ParetoPlace;
  const std::vector<cli::SweepRow> rows{priced(100, 50, 0.1), priced(200, 40, 0.1),
                                        priced(300, 60, 0.3), priced(50, 10, 0.5, 1),
                                        priced(50, std::nullopt, 0.5, 2)};
  EXPECT_THAT(front_of(rows, cli::FrontOf::price), ElementsAre(off, on, on, off, off));
  EXPECT_THAT(front_of(rows, cli::FrontOf::power), ElementsAre(off, off, off, on, on));
  // Luminaires that cost nothing have a price.
  EXPECT_THAT(front_of({priced(1, 0, 0.1), priced(1, 1, 0.1)}, cli::FrontOf::price),
              ElementsAre(on, off));
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

TEST(RowOf, SumsPricesOfThoseThatStateOne) {
  report::ProjectPart part = part_with({});
  const auto row_with = [&](double price, int luminaires, int without_price) {
    part.spaces[0].price = {price, luminaires, without_price};
    return cli::row_of(0, {}, part);
  };
  const cli::SweepRow some = row_with(30.5, 4, 1);
  EXPECT_EQ(some.price, 30.5);
  EXPECT_EQ(some.without_price, 1);
  EXPECT_EQ(cli::price_words(some), "30.5 and 1 not known");
  EXPECT_FALSE(cli::cost_of(some, cli::FrontOf::price));
  const cli::SweepRow all = row_with(0.1 + 0.1 + 0.1, 3, 0);  // not 0.30000000000000004
  EXPECT_EQ(all.price, 0.3);
  EXPECT_EQ(cli::price_words(all), "0.3");
  EXPECT_EQ(cli::cost_of(all, cli::FrontOf::price), 0.3);
  const cli::SweepRow none = row_with(0, 3, 3);
  EXPECT_FALSE(none.price);
  EXPECT_EQ(none.without_price, 3);
  EXPECT_EQ(cli::price_words(none), "not known");
  part.spaces.push_back(part.spaces[0]);
  part.spaces[1].price = {2, 2, 1};
  const cli::SweepRow both = row_with(1, 1, 0);
  EXPECT_EQ(both.price, 3);
  EXPECT_EQ(both.without_price, 1);
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

// What looks like a pass and is none of the light alone.
TEST(RowOf, CountsWhatIsWaivedAndWhatPassesBeyondItsLimit) {
  using enum rules::Verdict;
  rules::Finding waived = finding("w", rules::Comparison::at_least, 100, {50, 50, 50}, fail);
  waived.is_waived = true;
  const cli::SweepRow row = cli::row_of(
      0, {},
      part_with({waived, finding("t", rules::Comparison::at_least, 100, {95, 95, 95}, pass),
                 finding("p", rules::Comparison::at_least, 100, {150, 150, 150}, pass)}));
  EXPECT_EQ(row.waived, 1);
  EXPECT_EQ(row.passed_beyond_limit, 1);
  EXPECT_DOUBLE_EQ(row.margin->value, -0.05);
  cli::Sweep sweep;
  sweep.rows = {row};
  EXPECT_THAT(cli::sweep_notes(sweep),
              ElementsAre(testing::HasSubstr("waived"), testing::HasSubstr("beyond its limit")));
}

// Equal light that was summed up in another order: the last bits are no margin.
TEST(RowOf, HasMarginsWithoutNoise) {
  const auto with = [](double lx) {
    return cli::row_of(0, {},
                       part_with({finding("a", rules::Comparison::at_least, 300, {lx, lx, lx},
                                          rules::Verdict::pass)}));
  };
  EXPECT_EQ(with(317.66707738515656).margin->value, with(317.66707738515650).margin->value);
  EXPECT_NE(317.66707738515656, 317.66707738515650);
}

TEST(RowOf, HasNoMarginWhereSomethingIsNotJudged) {
  using enum rules::Verdict;
  rules::Finding open = finding("b", rules::Comparison::at_least, 1, {}, not_judged);
  open.reason = calc::Message::words("because");
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
  EXPECT_THAT(cli::sweep_notes(sweep), ElementsAre(testing::HasSubstr("warnings: 1"),
                                                   testing::HasSubstr("only in part: 1")));
}

cli::Sweep sweep_of(const std::vector<cli::SweepRow>& rows,
                    cli::FrontOf front_of = cli::FrontOf::power) {
  cli::Sweep sweep;
  sweep.vary = {{"a.b", {}}};
  sweep.front_of = front_of;
  sweep.rows = rows;
  for (std::size_t v = 0; v < rows.size(); ++v) {
    sweep.vary[0].values.push_back(std::to_string(v));
    sweep.rows[v].variant = v;
    sweep.rows[v].values = {std::to_string(v)};
  }
  cli::find_front(sweep.rows, sweep.front_of);
  return sweep;
}

TEST(SweepNotes, SayWhatCannotBeOnTheFront) {
  const std::vector<cli::SweepRow> rows{priced(10, 5, 0.1), priced(20, 5, 0.2, 1)};
  EXPECT_THAT(cli::sweep_notes(sweep_of(rows)), ElementsAre());
  EXPECT_THAT(cli::sweep_notes(sweep_of(rows, cli::FrontOf::price)),
              ElementsAre("variants that pass and cannot be on the front, because the price of "
                          "luminaires is not known: 1"));
}

// Only a price parts these.
TEST(SweepNotes, KnowThatAPriceIsAnEffect) {
  EXPECT_THAT(cli::sweep_notes(sweep_of({priced(10, 5, 0.1), priced(10, 6, 0.1)})), ElementsAre());
  EXPECT_THAT(cli::sweep_notes(sweep_of({priced(10, 5, 0.1), priced(10, 5, 0.1)})),
              ElementsAre(testing::HasSubstr("'a.b' changes no verdict, margin, power or price")));
}

TEST(SweepFormats, HaveAColumnOfPricesWhereThereAreAny) {
  using testing::HasSubstr, testing::Not;
  const cli::Sweep without = sweep_of({priced(10, std::nullopt, 0.1, 2)});
  EXPECT_THAT(cli::render_sweep_text(without), Not(HasSubstr("price")));
  EXPECT_THAT(cli::render_sweep_html(without), Not(HasSubstr(">price</th>")));
  EXPECT_THAT(cli::render_sweep_csv(without), HasSubstr(",10,0,,2,0,0,0,0,on,power,"));
  EXPECT_THAT(cli::render_sweep_json(without), HasSubstr("\"price\": null"));
  const cli::Sweep with =
      sweep_of({priced(10, 12.5, 0.1), priced(10, 7, 0.2, 2)}, cli::FrontOf::price);
  EXPECT_THAT(cli::render_sweep_text(with), HasSubstr("  price              front of price\n"));
  EXPECT_THAT(cli::render_sweep_text(with), HasSubstr("7 and 2 not known"));
  EXPECT_THAT(cli::render_sweep_html(with), HasSubstr("<td class=\"num\">7 and 2 not known</td>"));
  EXPECT_THAT(cli::render_sweep_html(with), HasSubstr(">12.5</text>"));
  EXPECT_THAT(cli::render_sweep_html(with),
              HasSubstr("1 variants have no margin or no known price"));
  EXPECT_THAT(cli::render_sweep_csv(with), HasSubstr(",10,0,12.5,0,0,0,0,0,on,price,"));
  EXPECT_THAT(cli::render_sweep_json(with), HasSubstr("\"price\": 12.5"));
  EXPECT_THAT(cli::render_sweep_json(with), HasSubstr("\"luminaires_without_price\": 2"));
}

TEST(SweepFormats, SayWhatTheFrontIsOf) {
  using testing::HasSubstr;
  for (const auto& [front_of, name] :
       {std::pair(cli::FrontOf::power, std::string("power")), {cli::FrontOf::price, "price"}}) {
    const cli::Sweep sweep = sweep_of({priced(10, 12.5, 0.1)}, front_of);
    EXPECT_THAT(cli::render_sweep_text(sweep), HasSubstr("front of " + name));
    EXPECT_THAT(cli::render_sweep_csv(sweep), HasSubstr(",on," + name + ","));
    EXPECT_THAT(cli::render_sweep_json(sweep), HasSubstr("\"front_of\": \"" + name + "\""));
    const std::string html = cli::render_sweep_html(sweep);
    for (const char* words : {"On the front of margin and ", "Margin over ", "<th>front of "}) {
      EXPECT_THAT(html, HasSubstr(words + name));
    }
  }
}

// The published file is written by the program: 'luxgate schema --sweep > sweep.schema.json'.
TEST(SweepSchema, IsThePublishedFile) {
  std::ifstream file(LUXGATE_SWEEP_SCHEMA, std::ios::binary);
  const std::string published((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(cli::sweep_schema(), published);
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
  cli::find_front(sweep.rows, sweep.front_of);
  const std::string html = cli::render_sweep_html(sweep);
  for (const char* raw : {"<script", "<p>&", "a<b", "<x>"}) {
    EXPECT_EQ(html.find(raw), std::string::npos) << raw;
  }
}

}  // namespace
}  // namespace sweep_test
