#include "rules/verdict/waiver.h"

#include <gtest/gtest.h>

#include <string>

namespace rules::waiver_test {
namespace {

Finding finding_of(Verdict verdict, const std::string& reason = "") {
  Finding finding;
  finding.verdict = verdict;
  finding.reason = calc::Message::words(reason);
  finding.requirement.waiver = Waiver{"wall moves in May", "J. Doe", "2027-06-30"};
  return finding;
}

Finding applied(Finding finding, const std::string& today) {
  apply_waiver(finding, today);
  return finding;
}

TEST(Waiver, HoldsUpToItsLastDay) {
  const Finding last_day = applied(finding_of(Verdict::fail), "2027-06-30");
  EXPECT_TRUE(last_day.is_waived);
  EXPECT_EQ(last_day.verdict, Verdict::fail);
  EXPECT_EQ(last_day.reason,
            "waived by J. Doe until 2027-06-30, as of 2027-06-30: wall moves in May");
  const Finding day_after = applied(finding_of(Verdict::fail), "2027-07-01");
  EXPECT_FALSE(day_after.is_waived);
  EXPECT_EQ(day_after.reason, "the waiver by J. Doe ended on 2027-06-30: wall moves in May");
}

TEST(Waiver, IsForWhatFailsOrIsOpen) {
  EXPECT_FALSE(applied(finding_of(Verdict::pass), "2027-01-01").is_waived);
  EXPECT_EQ(applied(finding_of(Verdict::pass), "2027-01-01").reason, "");
  EXPECT_FALSE(applied(finding_of(Verdict::not_judged), "2027-01-01").is_waived);
  const Finding open = applied(finding_of(Verdict::undecided, "too wide"), "2027-01-01");
  EXPECT_TRUE(open.is_waived);
  EXPECT_EQ(open.reason,
            "too wide; waived by J. Doe until 2027-06-30, as of 2027-01-01: wall moves in May");
}

TEST(Waiver, WithoutOneNothingChanges) {
  Finding finding = finding_of(Verdict::fail);
  finding.requirement.waiver.reset();
  EXPECT_FALSE(applied(finding, "2027-01-01").is_waived);
  EXPECT_EQ(applied(finding, "2027-01-01").reason, "");
}

}  // namespace
}  // namespace rules::waiver_test
