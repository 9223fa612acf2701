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

TEST(Document, OverallVerdictIsTheGravest) {
  EXPECT_EQ(overall_verdict({5, 1, 1, 1}), rules::Verdict::fail);
  EXPECT_EQ(overall_verdict({5, 0, 1, 1}), rules::Verdict::not_judged);
  EXPECT_EQ(overall_verdict({5, 0, 1, 0}), rules::Verdict::undecided);
  EXPECT_EQ(overall_verdict({5, 0, 0, 0}), rules::Verdict::pass);
}

TEST(Document, NothingJudgedDoesNotPass) {
  EXPECT_EQ(overall_verdict({}), rules::Verdict::not_judged);
}

}  // namespace
}  // namespace report
