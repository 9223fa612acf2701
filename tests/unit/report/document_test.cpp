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

TEST(Document, NothingJudgedDoesNotPass) {
  EXPECT_EQ(overall_verdict({}), rules::Verdict::not_judged);
}

}  // namespace
}  // namespace report
