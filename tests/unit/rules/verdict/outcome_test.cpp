#include "rules/verdict/outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace rules::outcome_test {
namespace {

constexpr std::array kAll{Outcome::not_judged,   Outcome::warned, Outcome::fail,
                          Outcome::undecided,    Outcome::pass,   Outcome::waived,
                          Outcome::nothing_asked};

TEST(Outcome, TheGraverOfTwoIsTheOneThatComesFirst) {
  for (std::size_t i = 0; i < kAll.size(); ++i) {
    for (std::size_t k = 0; k < kAll.size(); ++k) {
      EXPECT_EQ(graver(kAll[i], kAll[k]), kAll[std::min(i, k)]) << i << " " << k;
    }
  }
}

TEST(Outcome, VerdictsHaveTheSameOrder) {
  for (const Verdict a : kGravestFirst) {
    for (const Verdict b : kGravestFirst) {
      EXPECT_EQ(outcome_of(graver(a, b)), graver(outcome_of(a), outcome_of(b)));
    }
  }
  EXPECT_EQ(graver(Verdict::fail, Verdict::not_judged), Verdict::not_judged);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(gravity_rank(kGravestFirst.at(static_cast<std::size_t>(i))), i);
}

TEST(Outcome, OnlyWhatIsAskedForAndNotWaivedCounts) {
  Finding finding;
  finding.verdict = Verdict::fail;
  EXPECT_EQ(outcome_of(finding), Outcome::fail);
  finding.is_waived = true;
  EXPECT_EQ(outcome_of(finding), Outcome::waived);
  for (const Severity severity : {Severity::advice, Severity::in_aggregate}) {
    finding.requirement.severity = severity;
    EXPECT_EQ(outcome_of(finding), Outcome::nothing_asked);
  }
  AggregateFinding aggregate;
  EXPECT_EQ(outcome_of(aggregate), Outcome::not_judged);
  aggregate.is_waived = true;
  EXPECT_EQ(outcome_of(aggregate), Outcome::waived);
  aggregate.severity = Severity::advice;
  EXPECT_EQ(outcome_of(aggregate), Outcome::nothing_asked);
  for (const Outcome outcome : kAll) {
    EXPECT_EQ(counts(outcome), outcome != Outcome::waived && outcome != Outcome::nothing_asked);
  }
}

}  // namespace
}  // namespace rules::outcome_test
