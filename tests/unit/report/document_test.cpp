#include "report/document.h"

#include "report/words.h"
#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

namespace report {
namespace {

TEST(Document, CountsEveryFinding) {
  const VerdictCounts counts = count_verdicts(sample_document().projects[0]);
  EXPECT_EQ(counts.pass, 2);
  EXPECT_EQ(counts.fail, 2);
  EXPECT_EQ(counts.undecided, 1);
  EXPECT_EQ(counts.not_judged, 1);
}

TEST(Document, ProjectThatWasNotJudgedCountsOnce) {
  EXPECT_EQ(count_verdicts(sample_document()).not_judged, 2);
}

TEST(Document, SummaryTellsProjectsFromRequirements) {
  EXPECT_EQ(summary_words(sample_document()),
            "6 requirements: 2 pass, 2 fail, 1 undecided, 1 not judged; 1 project not judged");
  EXPECT_EQ(summary_words({}), "0 requirements");
}

Document with_verdicts(const std::vector<rules::Verdict>& verdicts) {
  Document document = small_document();
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings.clear();
  for (const rules::Verdict verdict : verdicts) findings.emplace_back().verdict = verdict;
  return document;
}

// The order of the exit codes: 2 before 1 before 3 before 0.
TEST(Document, OverallVerdictIsTheGravest) {
  using enum rules::Verdict;
  EXPECT_EQ(overall_verdict(with_verdicts({pass, fail, not_judged, undecided})), not_judged);
  EXPECT_EQ(overall_verdict(with_verdicts({pass, undecided, fail})), fail);
  EXPECT_EQ(overall_verdict(with_verdicts({pass, undecided})), undecided);
  EXPECT_EQ(overall_verdict(with_verdicts({pass})), pass);
}

TEST(Document, OverallVerdictCountsAPlaneWithoutResult) {
  Document document = with_verdicts({rules::Verdict::pass});
  document.projects[0].spaces[0].planes.emplace_back().is_computed = false;
  EXPECT_EQ(overall_verdict(document), rules::Verdict::not_judged);
}

TEST(Document, AdviceDoesNotCount) {
  Document document = with_verdicts({rules::Verdict::pass, rules::Verdict::fail});
  rules::Finding& advice = document.projects[0].spaces[0].planes[0].findings[1];
  advice.requirement.severity = rules::Severity::advice;
  EXPECT_EQ(overall_verdict(document), rules::Verdict::pass);
  EXPECT_EQ(summary_words(document), "1 requirement: 1 pass");
  EXPECT_EQ(note_words(advice), "advice: does not count");
}

TEST(Document, WaivedFindingsAreCountedApart) {
  Document document = with_verdicts({rules::Verdict::fail, rules::Verdict::undecided});
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings[0].is_waived = true;
  EXPECT_EQ(overall_verdict(document), rules::Verdict::undecided);
  EXPECT_EQ(summary_words(document), "2 requirements: 1 undecided, 1 waived");
  findings[1].is_waived = true;
  EXPECT_EQ(overall_verdict(document), rules::Verdict::pass);
  EXPECT_STREQ(outcome_words(document), "waived");
  findings.emplace_back().verdict = rules::Verdict::pass;
  EXPECT_STREQ(outcome_words(document), "pass");
}

TEST(CloseWords, GoByThePolicy) {
  rules::Finding finding;
  EXPECT_EQ(close_words(finding), "");
  finding.is_close = true;
  EXPECT_EQ(close_words(finding), "close: usual rounding would change the verdict");
  finding.requirement.policy.compares_rounded = true;
  EXPECT_EQ(close_words(finding), "close: without rounding the verdict would be another");
}

TEST(NoteWords, SayWhatMustBeReadWithAFinding) {
  rules::Finding finding;
  EXPECT_EQ(note_words(finding), "");
  finding.requirement.note = "unverified requirement";
  finding.requirement.direct_only = true;
  finding.requirement.mask.id = "width";
  finding.requirement.policy.tolerance = 0.01;
  finding.requirement.policy.tolerance_reason = "contract";
  finding.points_used = 12;
  finding.by_tolerance = true;
  EXPECT_EQ(note_words(finding),
            "unverified requirement; direct light only; mask width: 12 points count; unrounded "
            "values, tolerance 1 % of the limit (contract); passes only with the tolerance");
}

TEST(Document, NothingJudgedDoesNotPass) {
  EXPECT_EQ(overall_verdict({}), rules::Verdict::not_judged);
}

}  // namespace
}  // namespace report
