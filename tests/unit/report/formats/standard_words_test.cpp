// What keeps a tick from being the standard's own (a stated deviation, a row that was asked in
// part) is beside the verdict in every format.

#include "report/formats/format.h"
#include "report/result_file/read_json.h"
#include "report/text/clause_words.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"
#include "tests/support/legible.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>

namespace report::standard_words_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// The first finding fails on a plane that deviates: formats of problems show it, too.
Document deviating() {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  rules::Finding& finding = space.planes[0].findings.at(1);
  finding.requirement.origin = {"en12464-1:2021", "task.Em", "34.2", {}, {}};
  finding.requirement.deviations = {{rules::FitAspect::grid,
                                     calc::Message::words("4 points where 54 are asked for"),
                                     rules::Waiver{"as measured", "A. Meier", "2027-01-31"}, true}};
  space.coverage = {{"",
                     calc::Message::words("EN 12464-1:2021 34.2"),
                     {{"task", rules::RoleState::failed, {}, {{"work", "minimum"}}},
                      {"observer", rules::RoleState::never_asked, {}}}}};
  document.provenance.judged_on = "2027-01-31";
  return document;
}

TEST(StandardWords, ADeviationIsInEveryFormatButPoints) {
  for (const Format& format : formats()) {
    if (is_table(format)) continue;
    const std::string text = legible(format, deviating());
    EXPECT_THAT(text, HasSubstr("4 points where 54 are asked for")) << format.name;
    EXPECT_THAT(text, HasSubstr("A. Meier")) << format.name;
    EXPECT_THAT(text, HasSubstr("2027-01-31")) << format.name;
  }
}

TEST(StandardWords, ARowInPartIsInEveryFormatThatHasMoreThanProblems) {
  const std::set<std::string_view> without{"points-csv", "luminaires-csv", "github",
                                           "gitlab",     "sarif",          "sarif-all"};
  for (const Format& format : formats()) {
    if (without.contains(format.name)) continue;
    const std::string text = legible(format, deviating());
    EXPECT_THAT(text, HasSubstr("observer")) << format.name;
    Document whole = deviating();
    whole.projects[0].spaces[0].coverage[0].roles.pop_back();
    EXPECT_THAT(legible(format, whole), Not(HasSubstr("observer"))) << format.name;
  }
  EXPECT_THAT(rendered("github", deviating()), HasSubstr("judged in part only"));
}

TEST(StandardWords, WhatIsLeftOutIsInEveryFormatButPoints) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  const rules::Waiver by{"window wall", "B. Roe", "2027-03-31"};
  space.notes = {calc::Message::words(
      "workplace desk, EN 12464-1:2021 34.2: left out: wall.1 (window wall, by B. Roe "
      "until 2027-03-31)")};
  space.coverage = {{"desk",
                     calc::Message::words("EN 12464-1:2021 34.2"),
                     {{"wall", rules::RoleState::met, {}, {}, {{"wall.1", by, false}}}}}};
  for (const Format& format : formats()) {
    if (is_table(format)) continue;
    const std::string text = legible(format, document);
    for (const char* words : {"wall.1", "window wall", "B. Roe", "2027-03-31"}) {
      EXPECT_THAT(text, HasSubstr(words)) << format.name;
    }
  }
}

// "EN 12464-1:2021 34.2" may be free text of the project, or the title of a table of one's own.
TEST(StandardWords, WhoSaysTheLimitIsInEveryFormatButPoints) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings.at(1);
  finding.requirement.clause = calc::Message::words("EN 12464-1:2021 34.2");
  const auto says = [&](const char* words, const char* name) {
    for (const Format& format : formats()) {
      if (is_table(format)) continue;
      EXPECT_THAT(legible(format, document), testing::AnyOf(HasSubstr(words), HasSubstr(name)))
          << format.name;
    }
  };
  says("EN 12464-1:2021 34.2 (project's own)", "project");
  finding.requirement.origin = {"own:1", "task.Em", "34.2", {}, {}};
  finding.requirement.origin.is_user_supplied = true;
  says("EN 12464-1:2021 34.2 (user-supplied)", "user-pack");
  finding.requirement.origin.is_user_supplied = false;
  EXPECT_EQ(clause_words({}, finding.requirement), "EN 12464-1:2021 34.2");
  EXPECT_THAT(rendered("text", document), Not(HasSubstr("user-supplied")));
  // Rows and aggregates of such a pack, too.
  rules::RowCoverage row{
      "desk", calc::Message::words("EN 12464-1:2021 34.2"), {{"task", rules::RoleState::met, {}}}};
  row.is_user_supplied = true;
  EXPECT_EQ(coverage_words({}, row),
            "desk, EN 12464-1:2021 34.2 (user-supplied): the whole row is met");
  rules::AggregateFinding aggregate;
  aggregate.clause = calc::Message::words("Own:1 3.1");
  aggregate.is_user_supplied = true;
  EXPECT_EQ(clause_words({}, aggregate), "Own:1 3.1 (user-supplied)");
}

// Who takes the mark away is found out.
TEST(StandardWords, WhoSaysTheLimitIsReadAgain) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  rules::Finding& finding = space.planes[0].findings.at(1);
  finding.requirement.origin = {"own:1", "task.Em", "34.2", {}, {}};
  finding.requirement.origin.is_user_supplied = true;
  rules::RowCoverage row{"", calc::Message::words("EN 12464-1:2021 34.2"), {}};
  row.roles = {{"task", rules::RoleState::failed, {}, {{"work", "minimum"}}}};
  row.is_user_supplied = true;
  space.coverage = {row};
  std::string problem;
  const std::optional<Document> read = read_json(rendered("json", document), problem);
  ASSERT_TRUE(read) << problem;
  EXPECT_EQ(rendered("json", *read), rendered("json", document));
  space.coverage[0].is_user_supplied = false;
  EXPECT_FALSE(read_json(rendered("json", document), problem));
  EXPECT_THAT(problem, HasSubstr("user_supplied"));
}

// The exit code is 0, and still nobody may read that the row is met.
TEST(StandardWords, ARowIsNotMetByWaivingIt) {
  Document document = small_document();
  const rules::Waiver by{"later", "B. Roe", "2027-03-31"};
  document.projects[0].spaces[0].coverage = {
      {"desk",
       calc::Message::words("EN 12464-1:2021 14.1"),
       {{"task", rules::RoleState::waived, {}},
        {"surround", rules::RoleState::left_out, {}, {}, {{"surround", by, false}}},
        {"wall", rules::RoleState::met, {}, {}, {{"wall.2", by, false}}}}}};
  for (const Format& format : formats()) {
    EXPECT_THAT(legible(format, document), Not(HasSubstr("whole row is met"))) << format.name;
  }
  const rules::RowCoverage row = document.projects[0].spaces[0].coverage[0];
  EXPECT_EQ(coverage_words({}, row),
            "desk, EN 12464-1:2021 14.1: met, except for waived or omitted parts; waived: task; "
            "omitted: surround, wall.2");
  rules::RowCoverage failed = row;
  failed.roles[0].state = rules::RoleState::failed;
  EXPECT_EQ(coverage_words({}, failed),
            "desk, EN 12464-1:2021 14.1: the required part of the row is not fully met; omitted: "
            "surround, wall.2");
}

// Who waits for a colour rendering that nobody states must not read that the row is met.
TEST(StandardWords, ARowIsNotWholeWithWhatIsImpossible) {
  Document document = small_document();
  document.projects[0].spaces[0].coverage = {
      {"desk",
       calc::Message::words("EN 12464-1:2021 34.2"),
       {{"task", rules::RoleState::met, {}},
        {"lamp", rules::RoleState::not_possible, calc::Message::words("made-up reason")}}}};
  for (const Format& format : formats()) {
    const std::string text = legible(format, document);
    EXPECT_THAT(text, Not(HasSubstr("whole row is"))) << format.name;
    const bool lists_problems = format.name == "github" || format.name == "gitlab";
    if (is_table(format) || lists_problems || format.name == "dxf") continue;
    EXPECT_THAT(text, HasSubstr("made-up reason")) << format.name;
  }
  rules::RowCoverage& row = document.projects[0].spaces[0].coverage[0];
  EXPECT_EQ(coverage_words({}, row),
            "desk, EN 12464-1:2021 34.2: every part of the row that can be judged here is met; "
            "not possible here: lamp (made-up reason)");
  row.roles[0].state = rules::RoleState::failed;
  EXPECT_EQ(coverage_words({}, row),
            "desk, EN 12464-1:2021 34.2: the required part of the row is not fully met; "
            "not possible here: lamp (made-up reason)");
}

// Only in clauses of packs it is a level; the project's words stay its own.
TEST(StandardWords, LevelsOfClausesOfTheProjectStayAsTheyAre) {
  const Texts german(Language::german, true);
  const calc::Message clause = calc::Message::words("brief 7 (+1 step)");
  EXPECT_THAT(clause_words(german, clause, rules::LimitSource::project), HasSubstr("(+1 step)"));
  EXPECT_THAT(clause_words(german, clause, rules::LimitSource::pack), Not(HasSubstr("step")));
}

// Below 10 a UGR has no number, unless the number is what the limit is about.
TEST(StandardWords, AGlareRatingBelowItsScaleNeverFailsByAPositiveMargin) {
  PlanePart plane;
  plane.derived = calc::DerivedQuantity::ugr;
  const Threshold limit{19, rules::Comparison::at_most};
  EXPECT_EQ(cell_words({}, plane, estimate(9.0, 0.5), limit), "< 10");
  EXPECT_EQ(cell_words({}, plane, estimate(9.8, 0.8), limit), "9.80");
  rules::Finding finding = sample_finding(rules::Metric::maximum, 19, estimate(9.0, 0.5));
  finding.requirement.derived = plane.derived;
  ASSERT_EQ(finding.verdict, rules::Verdict::fail);  // at least 19
  EXPECT_EQ(margin_words({}, finding), "-10.0 UGR");
  finding.requirement.comparison = rules::Comparison::at_most;
  judge_again(finding);
  EXPECT_EQ(margin_words({}, finding), "> +9.0 UGR");
}

TEST(StandardWords, RecommendedRangesAreOfOneQuantity) {
  PlanePart plane;
  plane.findings = {sample_finding(rules::Metric::average, 300, estimate(400, 4)),
                    sample_finding(rules::Metric::uniformity_min_avg, 0.6, estimate(0.7, 0.01))};
  for (rules::Finding& finding : plane.findings)
    finding.requirement.severity = rules::Severity::advice;
  plane.findings[0].requirement.comparison = rules::Comparison::at_most;
  EXPECT_EQ(advice_range_words({}, plane, plane.findings[0]).find("0.6"), std::string::npos);
  plane.findings[1].requirement.metric = rules::Metric::minimum;
  EXPECT_NE(advice_range_words({}, plane, plane.findings[0]).find("0.6"), std::string::npos);
}

TEST(StandardWords, AWaiverIsInEveryFormatButPoints) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings.at(1);
  finding.verdict = rules::Verdict::fail;
  finding.requirement.waiver = rules::Waiver{"spring", "C. Poe", "2027-04-30"};
  rules::apply_waiver(finding, "2027-01-01");
  for (const Format& format : formats()) {
    if (is_table(format)) continue;
    const std::string text = legible(format, document);
    EXPECT_THAT(text, HasSubstr("C. Poe")) << format.name;
    EXPECT_THAT(text, HasSubstr("2027-04-30")) << format.name;
  }
}

TEST(StandardWords, TheSummaryCountsBoth) {
  const std::string text = rendered("text", deviating());
  EXPECT_THAT(text, HasSubstr("1 with a deviation from the standard"));
  EXPECT_THAT(text, HasSubstr("1 row of a standard is judged in part only"));
  EXPECT_THAT(rendered("text", small_document()), Not(HasSubstr("standard")));
}

// A plane that deviates, and is not judged for it, is not counted as judged with a deviation.
TEST(StandardWords, WhatIsNotJudgedIsNotCountedAsDeviating) {
  Document document = deviating();
  document.projects[0].spaces[0].planes[0].findings[1].verdict = rules::Verdict::not_judged;
  EXPECT_EQ(count_verdicts(document).deviating, 0);
  EXPECT_EQ(count_verdicts(deviating()).deviating, 1);
}

TEST(StandardWords, SurviveTheResultFile) {
  const std::string bytes = rendered("json", deviating());
  std::string problem;
  const std::optional<Document> read = read_json(bytes, problem);
  ASSERT_TRUE(read.has_value()) << problem;
  EXPECT_EQ(rendered("json", *read), bytes);
  for (const Format& format : formats()) {
    EXPECT_EQ(format.render(*read, {}), format.render(deviating(), {})) << format.name;
  }
}

}  // namespace
}  // namespace report::standard_words_test
