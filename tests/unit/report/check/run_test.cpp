#include "report/check/run.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/store/memory_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace check::run_test {
namespace {

const std::string kOffice = std::string(LUXGATE_SOURCE_DIR) + "/examples/04-office/project.xml";

report::ProjectPart watched(Observer& observer) { return check::Run().check(kOffice, observer); }

TEST(CheckRun, NeedsAPathAlone) {
  const report::ProjectPart part = check::Run().check(kOffice);
  EXPECT_TRUE(part.is_judged);
  EXPECT_EQ(outcome_of(part), rules::Outcome::pass);
}

TEST(CheckRun, AFileThatIsNotThereIsNotJudged) {
  const report::ProjectPart part = check::Run().check("nowhere.xml");
  EXPECT_EQ(outcome_of(part), rules::Outcome::not_judged);
  EXPECT_FALSE(part.diagnostics.empty());
}

TEST(CheckRun, RefusesSettingsThatCannotBeMeant) {
  Settings settings;
  settings.confidence = 1.0;
  EXPECT_THROW(check::Run run(settings), std::invalid_argument);
  settings = {};
  settings.tolerance = 0.0;
  EXPECT_THROW(check::Run run(settings), std::invalid_argument);
  settings = {};
  settings.radiosity.replicates = 1;
  EXPECT_THROW(check::Run run(settings), std::invalid_argument);
}

// What was done until then passes; the rest was not looked at.
TEST(CheckRun, OneThatIsStoppedHasJudgedNothing) {
  struct StoppedInside : Observer {
    bool go_on(const calc::SolveProgress&) override { return false; }
  } inside;
  EXPECT_EQ(outcome_of(watched(inside)), rules::Outcome::not_judged);
  struct StoppedBetween : Observer {
    bool is_stopped() const override { return true; }
  } between;
  EXPECT_EQ(outcome_of(watched(between)), rules::Outcome::not_judged);
  Observer nobody;
  EXPECT_EQ(outcome_of(watched(nobody)), rules::Outcome::pass);
}

// One bad project stops no batch.
TEST(CheckRun, AFailureInsideLeavesTheProjectNotJudged) {
  struct Failing : Observer {
    void start_project(std::size_t) override { throw std::runtime_error("no more"); }
  } failing;
  const report::ProjectPart part = watched(failing);
  EXPECT_EQ(outcome_of(part), rules::Outcome::not_judged);
  EXPECT_EQ(part.path, kOffice);
  ASSERT_EQ(part.diagnostics.size(), 1U);
  EXPECT_EQ(part.diagnostics[0].id, calc::DiagnosticId::internal_error);
  EXPECT_THAT(part.diagnostics[0].message, testing::HasSubstr("no more"));
}

TEST(CheckRun, CopiesDifferInOneThingAndShareTheRest) {
  struct Counting : Observer {
    void solved(const std::string&, const std::string&, const calc::PreparedScene&,
                const std::vector<calc::PlaneTask>&, const calc::SpaceSolution& one) override {
      looks = one.looks;
    }
    calc::LookCounts looks;
  } first, second;
  constexpr std::size_t kMostBytes = 1 << 20;
  const check::Run run =
      check::Run().with_light_in(std::make_shared<calc::MemoryStore>(kMostBytes));
  EXPECT_EQ(outcome_of(run.check(kOffice, first)), rules::Outcome::pass);
  EXPECT_GT(first.looks.computed, 0U);
  EXPECT_EQ(outcome_of(run.with_packs({}).check(kOffice)), rules::Outcome::not_judged);
  Settings of_a_day;
  of_a_day.today = "2026-05-31";
  const check::Run later = run.with_settings(of_a_day);
  EXPECT_EQ(later.settings().today, "2026-05-31");
  EXPECT_NE(run.settings().today, "");
  EXPECT_EQ(outcome_of(later.check(kOffice, second)), rules::Outcome::pass);
  EXPECT_EQ(second.looks.computed, 0U);
  EXPECT_GT(second.looks.read, 0U);
  std::string text = run.files().read(kOffice).bytes;
  text.replace(text.find("name=\""), 6, "name=\"Other ");
  const report::ProjectPart other = run.with_text(kOffice, text).check(kOffice);
  EXPECT_EQ(outcome_of(other), rules::Outcome::pass);
  EXPECT_THAT(other.name, testing::StartsWith("Other "));
}

}  // namespace
}  // namespace check::run_test
