// For which scenes a report has advice, and when nothing is calculated for it.

#include "report/advice/advised_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cli::advised_levels_test {
namespace {

rules::Finding finding_of(const std::string& scene, rules::Verdict verdict,
                          rules::Metric metric = rules::Metric::average) {
  rules::Finding finding;
  finding.requirement.scene = scene;
  finding.requirement.metric = metric;
  finding.verdict = verdict;
  return finding;
}

report::ProjectPart part_with(std::vector<rules::Finding> findings) {
  report::ProjectPart part;
  part.is_judged = true;
  part.spaces.resize(1);
  part.spaces[0].planes.resize(1);
  part.spaces[0].planes[0].findings = std::move(findings);
  return part;
}

// With a project whose light cannot be calculated; is_calculated: somebody tried.
std::vector<report::LevelAdvice> advice_on(const report::ProjectPart& part, bool& is_calculated) {
  const std::string file = "p.xml", bytes;
  is_calculated = false;
  return advised_levels(
      {file, bytes, part}, {},
      [&](KeptLight&) -> std::optional<report::ProjectPart> {
        is_calculated = true;
        return std::nullopt;
      },
      [](const std::string&, std::string&) -> std::optional<report::ProjectPart> {
        return std::nullopt;
      });
}

TEST(AdvisedLevels, NothingIsCalculatedWhereNothingIsOpen) {
  rules::Finding waived = finding_of("", rules::Verdict::fail);
  waived.is_waived = true;
  rules::Finding advice = finding_of("", rules::Verdict::fail);
  advice.requirement.severity = rules::Severity::advice;
  bool is_calculated = false;
  EXPECT_TRUE(
      advice_on(part_with({finding_of("", rules::Verdict::pass),
                           finding_of("s", rules::Verdict::not_judged), waived, advice,
                           // No levels of dimming mend it.
                           finding_of("", rules::Verdict::fail, rules::Metric::power_density)}),
                is_calculated)
          .empty());
  EXPECT_FALSE(is_calculated);
}

TEST(AdvisedLevels, EveryOpenSceneHasItsOwnAndSaysWhyThereIsNone) {
  bool is_calculated = false;
  const auto advice = advice_on(
      part_with({finding_of("b", rules::Verdict::undecided), finding_of("a", rules::Verdict::pass),
                 finding_of("", rules::Verdict::fail, rules::Metric::minimum),
                 finding_of("b", rules::Verdict::fail)}),
      is_calculated);
  EXPECT_TRUE(is_calculated);
  ASSERT_EQ(advice.size(), 2U);
  EXPECT_EQ(advice[0].scene, "b");
  EXPECT_EQ(advice[1].scene, "");
  for (const report::LevelAdvice& one : advice) {
    EXPECT_EQ(one.outcome, report::AdviceOutcome::none_found);
    EXPECT_THAT(one.reason.english(), testing::HasSubstr("could not be calculated"));
    EXPECT_FALSE(one.has_levels());
  }
}

}  // namespace
}  // namespace cli::advised_levels_test
