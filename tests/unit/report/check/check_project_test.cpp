#include "report/check/check_project.h"

#include "calc/radiosity/gatherer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace check::check_project_test {
namespace {

const std::string kOffice = std::string(LUXGATE_SOURCE_DIR) + "/examples/04-office/project.xml";

report::ProjectPart watched(Observer& observer) {
  const Settings settings;
  const calc::DiskFileReader files;
  const auto packs = rules::builtin_rule_packs();
  const std::unique_ptr<calc::Gatherer> gatherer = calc::make_cpu_gatherer();
  const calc::Stages stages(*gatherer);
  return check_project(kOffice, Context{settings, files, packs, stages, observer});
}

TEST(CheckProject, NeedsAPathAlone) {
  const report::ProjectPart part = check_project(kOffice);
  EXPECT_TRUE(part.is_judged);
  EXPECT_EQ(outcome_of(part), rules::Outcome::pass);
}

TEST(CheckProject, AFileThatIsNotThereIsNotJudged) {
  const report::ProjectPart part = check_project("nowhere.xml");
  EXPECT_EQ(outcome_of(part), rules::Outcome::not_judged);
  EXPECT_FALSE(part.diagnostics.empty());
}

TEST(CheckProject, RefusesSettingsThatCannotBeMeant) {
  Settings settings;
  settings.confidence = 1.0;
  EXPECT_THROW(check_project(kOffice, settings), std::invalid_argument);
  settings = {};
  settings.tolerance = 0.0;
  EXPECT_THROW(check_project(kOffice, settings), std::invalid_argument);
  settings = {};
  settings.radiosity.replicates = 1;
  EXPECT_THROW(check_project(kOffice, settings), std::invalid_argument);
}

// What was done until then passes; the rest was not looked at.
TEST(CheckProject, OneThatIsStoppedHasJudgedNothing) {
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

}  // namespace
}  // namespace check::check_project_test
