#include "report/formats/console.h"

#include "report/text/plain_text.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace report::console_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Console, SmallDocument) {
  EXPECT_EQ(rendered("text", small_document()),
            R"(office.xml: Small office
  verdict  room / plane         quantity  required  calculated  margin  at (m)
  ✓ pass   Office / Work plane  average   ≥ 500 lx  512 ± 5 lx  +2.5 %
           └ EN 12464-1:2021 34.2 (project's own)
  ✗ FAIL   Office / Work plane  minimum   ≥ 450 lx  424 ± 5 lx  -5.7 %  (2.75, 1.00, 0.80)

2 requirements: 1 pass, 1 fail
)");
}

TEST(Console, ProjectDataStandBelowTheTitle) {
  Document document = small_document();
  document.projects[0].about.client = "Meier\n& Sons";
  document.projects[0].about.revision = "b";
  EXPECT_THAT(rendered("text", document), HasSubstr("\n  Client: Meier & Sons · Revision: b\n"));
  EXPECT_THAT(rendered("markdown", document),
              HasSubstr("\n\nClient: Meier &#38; Sons · Revision: b\n"));
  document.projects.push_back(document.projects[0]);
  EXPECT_THAT(rendered("markdown", document),
              HasSubstr("; Client: Meier &#38; Sons · Revision: b\n"));
}

// Whatever does not decide is there with all of its numbers, also where nothing else is.
TEST(Console, WhatIsWaivedOrAdviceStandsWithItsNumbers) {
  for (const bool is_waived : {true, false}) {
    Document document = small_document();
    for (rules::Finding& finding : document.projects[0].spaces[0].planes[0].findings) {
      finding.is_waived = is_waived;
      if (is_waived) finding.requirement.waiver = rules::Waiver{"glass", "A. Meier", "2099-06-30"};
      if (!is_waived) finding.requirement.severity = rules::Severity::advice;
    }
    const std::string text = rendered("text", document);
    EXPECT_THAT(text, HasSubstr("Office / Work plane  average   ≥ 500 lx  512 ± 5 lx  +2.5 %"));
    EXPECT_THAT(text, HasSubstr("Office / Work plane  minimum   ≥ 450 lx  424 ± 5 lx  -5.7 %"));
  }
}

TEST(Console, PlaneWithoutRequirementIsListed) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].findings.clear();
  EXPECT_EQ(rendered("text", document),
            R"(office.xml: Small office
  verdict     room / plane
    no limit  Office / Work plane
              └ average 512 ± 5 lx, minimum 424 ± 5 lx, Uo 0.83 ± 0.01

0 requirements: nothing is required
)");
}

TEST(Console, WhatAProjectChangesAboutAZoneAndLeavesOutIsTold) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes[0].made_by = calc::Message::words("workplace desk, task: the whole room");
  EXPECT_THAT(rendered("text", document), testing::Not(HasSubstr("workplace desk")));
  space.planes[0].changed = calc::Message::words("height 1.1 m instead of 0.75 m");
  space.notes = {calc::Message::words("workplace desk: left out: ceiling (open)")};
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ workplace desk, task: the whole room; changed: height 1.1 m instead of "
                        "0.75 m\n"));
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ workplace desk: left out: ceiling (open)\n"));
}

// Two planes of a workplace that pass, and one that does not.
Document workplace_document() {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes[0].findings.resize(1);  // that passes
  planes[0].made_by = calc::Message::words("workplace desk, task: the whole room");
  planes[0].findings[0].requirement.origin.workplaces = {"desk"};
  planes[0].findings[0].requirement.origin.pack = "en12464-1:2021";
  const auto add = [&](const std::string& role) {
    planes.push_back(planes[0]);
    planes.back().name = "Desk: " + role;
  };
  add("surround");
  add("observer 1");
  planes[0].name = "Desk: task";
  planes[2].findings[0].verdict = rules::Verdict::fail;
  planes[1].findings[0].margin = 0.01;
  return document;
}

TEST(Console, PassesOfAWorkplaceShareALine) {
  Document document = workplace_document();
  EXPECT_EQ(rendered("text", document),
            R"(office.xml: Small office
  verdict  room / plane               quantity        required  calculated  margin
  ✓ pass   Office / Desk              2 requirements                        +1.0 %
           └ task, surround; nearest to its limit: surround, average 512 ± 5 lx, required ≥ 500 lx
  ✗ FAIL   Office / Desk: observer 1  average         ≥ 500 lx  512 ± 5 lx  +2.5 %

3 requirements: 2 pass, 1 fail
)");
  TextOptions options;
  options.lists_passes = true;
  EXPECT_THAT(rendered("text", document, {options}), HasSubstr("Office / Desk: task"));
}

// Nothing that somebody has to decide about disappears in a line with others.
TEST(Console, WhatHasToBeReadIsNotFolded) {
  const auto folds = [](auto&& change) {
    Document document = workplace_document();
    change(document.projects[0].spaces[0].planes[1]);
    return rendered("text", document).find("2 requirements:") == std::string::npos &&
           rendered("text", document).find("nearest to its limit") != std::string::npos;
  };
  EXPECT_TRUE(folds([](PlanePart&) {}));
  EXPECT_FALSE(folds([](PlanePart& plane) {
    plane.changed = calc::Message::words("height 1 m instead of 0.75 m");
  }));
  EXPECT_FALSE(folds([](PlanePart& plane) { plane.single_sample_points = 2; }));
  EXPECT_FALSE(folds([](PlanePart& plane) { plane.findings[0].is_close = true; }));
  EXPECT_FALSE(folds([](PlanePart& plane) { plane.findings[0].by_tolerance = true; }));
  EXPECT_FALSE(
      folds([](PlanePart& plane) { plane.findings[0].reason = calc::Message::words("because"); }));
  EXPECT_FALSE(
      folds([](PlanePart& plane) { plane.findings[0].requirement.deviations.emplace_back(); }));
  EXPECT_FALSE(folds([](PlanePart& plane) { plane.findings[0].requirement.waiver.emplace(); }));
  EXPECT_FALSE(folds([](PlanePart& plane) { plane.made_by = {}; }));
}

TEST(Console, AdviceAmongFoldedPassesIsNamed) {
  Document document = workplace_document();
  document.projects[0].spaces[0].planes[1].findings[0].requirement.severity =
      rules::Severity::advice;
  EXPECT_THAT(
      rendered("text", document),
      HasSubstr("└ task, surround (recommendation: does not count); nearest to its limit: task, "));
}

TEST(Console, NotesOfFoldedPassesAreSaid) {
  Document document = workplace_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes[1].findings[0].requirement.note = calc::Message::words("one public source");
  planes[1].remarks = {calc::Message::words("a remark")};
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ one public source\n           └ a remark\n"));
}

TEST(Console, LongNotesThatComeAgainAreNumbered) {
  Document document = workplace_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  const std::string lengthy(80, 'x');
  for (PlanePart& plane : planes)
    plane.findings[0].requirement.note = calc::Message::words(lengthy);
  TextOptions options;
  options.lists_passes = true;
  const std::string text = rendered("text", document, {options});
  EXPECT_THAT(text, HasSubstr("└ [1] " + lengthy + "\n"));
  EXPECT_EQ(text.find(lengthy), text.rfind(lengthy));
  EXPECT_THAT(text, HasSubstr("surround    average"));
  EXPECT_THAT(text, HasSubstr("└ [1]\n"));
}

TEST(Console, RowsOfWhichTheSameIsToBeSaidShareALine) {
  Document document = small_document();
  rules::RowCoverage row{"g[0,0]",
                         calc::Message::words("EN 12464-1:2021 34.2"),
                         {{"task", rules::RoleState::met, {}}}};
  std::vector<rules::RowCoverage>& rows = document.projects[0].spaces[0].coverage;
  for (const char* id : {"a", "b", "c", "d", "e"}) {
    row.workplace = id;
    rows.push_back(row);
  }
  rows[1].roles[0].state = rules::RoleState::never_asked;
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("└ a, c, d and 1 more, EN 12464-1:2021 34.2: the whole row is met"));
  EXPECT_THAT(text,
              HasSubstr("└ b, EN 12464-1:2021 34.2: no part of the row that counts is required; "
                        "not requested: task"));
}

TEST(Console, QuantitiesThatAreNotPlanarAreNamed) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.kernel = calc::ReceiverKernel::cylindrical;
  EXPECT_THAT(rendered("text", document),
              HasSubstr("  average of cylindrical illuminance Ez  ≥ 500 lx  "));
  EXPECT_THAT(rendered("text", document), HasSubstr("  minimum of cylindrical illuminance Ez  "));
  plane.findings.clear();
  plane.kernel = calc::ReceiverKernel::semicylindrical;
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ semicylindrical illuminance Esz: average 512 ± 5 lx, minimum"));
}

TEST(Console, RatingsHaveNoUnit) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.derived = calc::DerivedQuantity::ugr;
  plane.minimum = {15.5, 15.25, 15.75};
  plane.maximum = {18.5, 18.25, 18.75};
  plane.remarks = {calc::Message::words("how it was rated")};
  rules::Finding finding = plane.findings[0];
  finding.requirement.metric = rules::Metric::maximum;
  finding.requirement.derived = plane.derived;
  finding.measured = plane.maximum;
  plane.findings = {finding};
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("  maximum of glare rating UGR  "));
  EXPECT_THAT(text, HasSubstr("18.5 ± 0.3  "));
  EXPECT_THAT(text, HasSubstr("└ how it was rated\n"));
  plane.findings.clear();
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ glare rating UGR: minimum 15.5 ± 0.3, maximum 18.5 ± 0.3\n"));
}

TEST(Console, WhatWasNotJudgedSaysWhy) {
  Document document = sample_document();
  document.projects[0].spaces[0].planes[1].findings[0].is_close = true;
  const std::string listed = rendered("text", document, {{false, 0, true}});
  EXPECT_THAT(listed, HasSubstr("– not judged  Sports hall / Stand"));
  EXPECT_THAT(listed, HasSubstr("└ close: usual rounding would change the verdict\n"));
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("Not judged\n  Sports hall\n    Stand: average\n"));
  EXPECT_THAT(text, HasSubstr(": close: usual rounding would change the verdict\n"));
  for (const std::string& one : {listed, text}) {
    EXPECT_THAT(one, HasSubstr("└ the plane was not computed\n"));
    EXPECT_THAT(one, HasSubstr("yard.xml\n  – not judged: the project could not be read"));
    EXPECT_THAT(
        one, HasSubstr("see the errors\n    cannot read 'yard.ies': No such file or directory\n"));
  }
}

TEST(Console, ReasonOfAnUncomputedPlaneWithoutRequirementIsShown) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.findings.clear();
  plane.is_computed = false;
  plane.reason = calc::Message::words("no point is left");
  EXPECT_THAT(rendered("text", document), HasSubstr("– not computed  Office / Work plane\n"));
  EXPECT_THAT(rendered("text", document), HasSubstr("└ no point is left\n"));
}

TEST(Console, PointsThatCannotBeTrustedAreTold) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].unseen_points = 1;
  document.projects[0].spaces[0].planes[0].single_sample_points = 2;
  EXPECT_THAT(rendered("text", document),
              HasSubstr("└ 1 of 2 points got no sample of the light that may reach them; 2 of 2 "
                        "points rest on single samples: their intervals cannot be trusted\n"));
}

TEST(Console, ColoursOnlyOnRequest) {
  EXPECT_THAT(rendered("text", sample_document()), Not(HasSubstr("\033")));
  for (const bool lists_passes : {false, true}) {
    EXPECT_THAT(rendered("text", sample_document(), {{true, 0, lists_passes}}),
                HasSubstr("\033[1;31m✗ FAIL"));
  }
}

// Advice and what is waived decide nothing, and do not look as if they did.
TEST(Console, OnlyWhatCountsStandsOut) {
  Document document = sample_document();
  for (const bool is_waived : {false, true}) {
    for (ProjectPart& project : document.projects) {
      for (SpacePart& space : project.spaces) {
        for (PlanePart& plane : space.planes) {
          for (rules::Finding& finding : plane.findings) {
            finding.is_waived = is_waived;
            finding.requirement.severity =
                is_waived ? rules::Severity::shall : rules::Severity::advice;
          }
        }
      }
    }
    const std::string text = rendered("text", document, {{true, 0, true}});
    EXPECT_THAT(
        text, AllOf(Not(HasSubstr("✗ FAIL")), HasSubstr("✗ fail"), Not(HasSubstr("\033[1;31m✗"))));
  }
}

TEST(Console, EscapesInNamesDoNotReachTheTerminal) {
  Document document = small_document();
  document.projects[0].spaces[0].name = "\033[2J";
  EXPECT_THAT(rendered("text", document), Not(HasSubstr("\033")));
}

TEST(Console, NotesTakeTheLinesThatATerminalNeeds) {
  Document document = small_document();
  const std::string remark =
      "measured from the other side of the board, as what stands before it is wider than the board "
      "itself, a-name-of-more-than-fifty-characters-that-takes-two-lines, and so on";
  document.projects[0].spaces[0].planes[0].remarks = {calc::Message::words(remark)};
  EXPECT_THAT(rendered("text", document), HasSubstr("└ " + remark + "\n"));
  const std::string text = rendered("text", document, {{.width = 60}});
  EXPECT_THAT(text, HasSubstr("           └ measured from the other side of the board, as\n"
                              "             what stands before it is wider than the board\n"
                              "             itself,\n"
                              "             a-name-of-more-than-fifty-characters-that-takes\n"
                              "             -two-lines, and so on\n"));
}

TEST(Console, NarrowTerminalShortensNamesButNeverNumbers) {
  const std::string text = rendered("text", small_document(), {{false, 84}});
  EXPECT_THAT(text, testing::ContainsRegex("  Office .*…lane  "));
  EXPECT_THAT(text, HasSubstr("424 ± 5 lx  -5.7 %  (2.75, 1.00, 0.80)"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 84U) << line;
}

// Where the columns do not fit, all of them are there, with their heads, one behind the other.
TEST(Console, RowsThatAreTooWideAreStacked) {
  const std::string text = rendered("text", small_document(), {{false, 40}});
  EXPECT_THAT(text,
              HasSubstr("  verdict  room / plane  quantity\n    required  calculated  margin"));
  EXPECT_THAT(text, HasSubstr("  ✗ FAIL  Office / Work plane  minimum\n"
                              "    ≥ 450 lx  424 ± 5 lx  -5.7 %  (2.75,\n"
                              "    1.00, 0.80)\n"));
}

TEST(Console, SceneAndStateAreNamed) {
  Document document = small_document();
  rules::Requirement& requirement =
      document.projects[0].spaces[0].planes[0].findings[0].requirement;
  requirement.state = rules::LightState::initial;
  requirement.scene = "evening";
  EXPECT_THAT(rendered("text", document), HasSubstr("average, initial, scene evening"));
}

}  // namespace
}  // namespace report::console_test
