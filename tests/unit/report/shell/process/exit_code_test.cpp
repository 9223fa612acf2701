#include "report/shell/process/exit_code.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/document.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace exit_code_test {
namespace {

using rules::Verdict;

report::ProjectPart project(std::initializer_list<Verdict> verdicts) {
  report::PlanePart plane;
  plane.is_computed = true;
  for (const Verdict verdict : verdicts) {
    rules::Finding finding;
    finding.verdict = verdict;
    plane.findings.push_back(finding);
  }
  report::SpacePart space;
  space.planes.push_back(plane);
  report::ProjectPart part;
  part.is_judged = true;
  part.spaces.push_back(space);
  return part;
}

int code(std::initializer_list<Verdict> verdicts) {
  report::Document document;
  document.projects.push_back(project(verdicts));
  return cli::exit_code_of(outcome_of(document));
}

TEST(ExitCode, WorstVerdictCountsInTheDocumentedOrder) {
  EXPECT_EQ(code({Verdict::pass, Verdict::pass}), 0);
  EXPECT_EQ(code({Verdict::pass, Verdict::undecided}), 3);
  EXPECT_EQ(code({Verdict::undecided, Verdict::fail, Verdict::pass}), 1);
  EXPECT_EQ(code({Verdict::fail, Verdict::not_judged}), 2);
}

TEST(ExitCode, EveryOutcomeHasTheDocumentedCode) {
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::not_judged), 2);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::warned), 2);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::fail), 1);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::undecided), 3);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::pass), 0);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::waived), 0);
  EXPECT_EQ(cli::exit_code_of(rules::Outcome::nothing_asked), 0);
}

TEST(ExitCode, OnlyWarningsThatWereAskedToCountDo) {
  report::Document document;
  document.projects.push_back(project({Verdict::fail}));
  report::ProjectPart& part = document.projects[0];
  part.diagnostics = {{calc::DiagnosticId::light_leaves_room, {}, "light leaves"}};
  EXPECT_EQ(cli::exit_code_of(outcome_of(document)), 1);
  part.strict_warnings = {calc::DiagnosticId::luminaires_coincide};
  EXPECT_EQ(cli::exit_code_of(outcome_of(document)), 1);
  part.strict_warnings = {calc::DiagnosticId::light_leaves_room};
  EXPECT_EQ(cli::exit_code_of(outcome_of(document)), 2);
}

TEST(ExitCode, NothingRequiredIsNoFailure) { EXPECT_EQ(code({}), 0); }

TEST(ExitCode, AnUnreadableProjectSpoilsTheBatch) {
  report::Document document;
  document.projects.push_back(project({Verdict::pass}));
  document.projects.emplace_back();
  EXPECT_EQ(cli::exit_code_of(outcome_of(document)), 2);
}

TEST(ExitCode, APlaneWithoutResultCountsEvenIfNothingWasRequired) {
  report::Document document;
  document.projects.push_back(project({}));
  document.projects[0].spaces[0].planes[0].is_computed = false;
  EXPECT_EQ(cli::exit_code_of(outcome_of(document)), 2);
}

}  // namespace
}  // namespace exit_code_test
