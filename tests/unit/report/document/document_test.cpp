#include "report/document/document.h"

#include "calc/base/diagnostic_ids.h"
#include "report/html/page/html.h"
#include "report/result_file/read_json.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace report::document_test {
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
  EXPECT_EQ(summary_words(totals_of(sample_document())),
            "6 requirements: 2 pass, 2 fail, 1 undecided, 1 not judged; 1 project not judged");
  EXPECT_EQ(summary_words({}), "0 requirements: nothing is required");
}

Document with_verdicts(const std::vector<rules::Verdict>& verdicts) {
  Document document = small_document();
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings.clear();
  for (const rules::Verdict verdict : verdicts) findings.emplace_back().verdict = verdict;
  return document;
}

// The order of the exit codes: 2 before 1 before 3 before 0.
TEST(Document, OutcomeIsTheGravest) {
  using enum rules::Verdict;
  using rules::Outcome;
  EXPECT_EQ(outcome_of(with_verdicts({pass, fail, not_judged, undecided})), Outcome::not_judged);
  EXPECT_EQ(outcome_of(with_verdicts({pass, undecided, fail})), Outcome::fail);
  EXPECT_EQ(outcome_of(with_verdicts({pass, undecided})), Outcome::undecided);
  EXPECT_EQ(outcome_of(with_verdicts({pass})), Outcome::pass);
  EXPECT_EQ(outcome_of(with_verdicts({})), Outcome::nothing_asked);
}

TEST(Document, OutcomeCountsAPlaneWithoutResult) {
  Document document = with_verdicts({rules::Verdict::pass});
  document.projects[0].spaces[0].planes.emplace_back().is_computed = false;
  EXPECT_EQ(outcome_of(document), rules::Outcome::not_judged);
  document = with_verdicts({});
  document.projects[0].spaces[0].planes[0].is_computed = false;
  EXPECT_EQ(outcome_of(document), rules::Outcome::not_judged);
  EXPECT_EQ(summary_words(totals_of(document)), "0 requirements");
}

TEST(Document, AProjectOfWhichNothingIsAskedChangesNothingInABatch) {
  const Document nothing = with_verdicts({});
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    Document document = with_verdicts({verdict});
    document.projects.push_back(nothing.projects[0]);
    EXPECT_EQ(outcome_of(document), rules::outcome_of(verdict));
    EXPECT_EQ(outcome_of(document.projects[1]), rules::Outcome::nothing_asked);
  }
}

TEST(Document, AdviceDoesNotCount) {
  Document document = with_verdicts({rules::Verdict::pass, rules::Verdict::fail});
  rules::Finding& advice = document.projects[0].spaces[0].planes[0].findings[1];
  advice.requirement.severity = rules::Severity::advice;
  EXPECT_EQ(outcome_of(document), rules::Outcome::pass);
  EXPECT_EQ(summary_words(totals_of(document)), "1 requirement: 1 pass");
  EXPECT_EQ(note_words(advice), "recommendation: does not count");
}

TEST(Document, WaivedFindingsAreCountedApart) {
  Document document = with_verdicts({rules::Verdict::fail, rules::Verdict::undecided});
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings[0].is_waived = true;
  EXPECT_EQ(outcome_of(document), rules::Outcome::undecided);
  EXPECT_EQ(summary_words(totals_of(document)), "2 requirements: 1 undecided, 1 waived");
  findings[1].is_waived = true;
  EXPECT_EQ(outcome_of(document), rules::Outcome::waived);
  EXPECT_STREQ(outcome_words(outcome_of(document)), "waived");
  findings.emplace_back().verdict = rules::Verdict::pass;
  EXPECT_STREQ(outcome_words(outcome_of(document)), "pass");
}

TEST(CloseWords, GoByThePolicy) {
  rules::Finding finding;
  EXPECT_EQ(close_words(finding), "");
  finding.is_close = true;
  EXPECT_EQ(close_words(finding), "close: usual rounding would change the verdict");
  finding.requirement.policy.compares_rounded = true;
  EXPECT_EQ(close_words(finding), "close: the verdict would differ without rounding");
}

TEST(NoteWords, SayWhatMustBeReadWithAFinding) {
  rules::Finding finding;
  EXPECT_EQ(note_words(finding), "");
  finding.requirement.note = calc::Message::words("unverified requirement");
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

TEST(Document, NothingAskedDoesNotPass) {
  EXPECT_EQ(outcome_of(Document{}), rules::Outcome::nothing_asked);
}

// The exit code said "nothing is required" (0) while Markdown and HTML said "not judged" (2).
TEST(NothingAsked, IsWhatEveryFormatSays) {
  using testing::AllOf, testing::HasSubstr, testing::Not;
  Document advice = with_verdicts({rules::Verdict::fail});
  advice.projects[0].spaces[0].planes[0].findings[0].requirement.severity = rules::Severity::advice;
  for (const Document& document : {with_verdicts({}), advice}) {
    EXPECT_THAT(rendered("text", document), HasSubstr("\n0 requirements: nothing is required\n"));
    EXPECT_THAT(rendered("github", document),
                HasSubstr("luxgate: 0 requirements: nothing is required\n"));
    EXPECT_THAT(rendered("markdown", document),
                AllOf(HasSubstr("### luxgate: ○ nothing is required: "),
                      Not(HasSubstr("not judged")), Not(HasSubstr("pass"))));
    EXPECT_THAT(rendered("junit", document),
                AllOf(HasSubstr("nothing is required"), HasSubstr("errors=\"0\""),
                      HasSubstr("failures=\"0\"")));
    EXPECT_THAT(render_html(document),
                AllOf(HasSubstr("<title>○ Small office – "),
                      HasSubstr("<div class=\"banner nothing-asked\""),
                      HasSubstr("<p class=\"outcome\">Nothing is required</p>")));
    EXPECT_THAT(rendered("json", document),
                HasSubstr("\"counts\": {\n  \"pass\": 0,\n  \"fail\": 0,\n  \"undecided\": 0,\n  "
                          "\"not_judged\": 0,\n  \"waived\": 0,\n  \"with_deviations\": 0\n }"));
  }
  const Texts german(Language::german, true);
  EXPECT_THAT(rendered("text", with_verdicts({}), {{}, german}),
              HasSubstr("0 Anforderungen: nichts ist gefordert\n"));
  EXPECT_THAT(rendered("markdown", with_verdicts({}), {{}, german}),
              HasSubstr("### luxgate: ○ nichts ist gefordert: "));
  EXPECT_THAT(render_html(with_verdicts({}), german),
              HasSubstr("<p class=\"outcome\">Nichts ist gefordert</p>"));
}

// One project of which options choose nothing.
ProjectPart unchosen() {
  ProjectPart project = small_document().projects[0];
  project.spaces.clear();
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::nothing_selected, {project.path, 0, 0}, "--plane dsk",
                     "the planes desk");
  project.diagnostics = diagnostics.all();
  return project;
}

// A job that reads one format alone must not be green beside exit code 2.
TEST(NothingChosen, IsAnErrorInEveryFormat) {
  using testing::AllOf, testing::HasSubstr, testing::Not;
  Document document = with_verdicts({});
  document.projects = {unchosen(), unchosen()};
  document.provenance.selection = "--plane dsk";
  const std::string words = "--plane dsk chooses nothing in any of the projects";
  EXPECT_EQ(outcome_of(document), rules::Outcome::not_judged);
  EXPECT_THAT(rendered("text", document),
              AllOf(HasSubstr("0 requirements: nothing was chosen"),
                    HasSubstr("error[selection-empty]: " + words + "\n")));
  EXPECT_THAT(rendered("github", document),
              HasSubstr("::error title=luxgate%3A selection-empty::" + words));
  EXPECT_THAT(rendered("gitlab", document),
              AllOf(HasSubstr("luxgate/selection-empty"), HasSubstr(words), HasSubstr("blocker")));
  EXPECT_THAT(rendered("markdown", document),
              AllOf(HasSubstr("### luxgate: – not judged"), HasSubstr(words)));
  EXPECT_THAT(rendered("junit", document),
              AllOf(HasSubstr("errors=\"1\""), HasSubstr("<error type="),
                    HasSubstr("message=\"" + words + "\"")));
  EXPECT_THAT(rendered("sarif", document),
              AllOf(HasSubstr("\"executionSuccessful\": false"), HasSubstr(words)));
  EXPECT_THAT(rendered("csv", document), HasSubstr("selection-empty"));
  EXPECT_THAT(render_html(document),
              AllOf(HasSubstr("<title>– "), HasSubstr("<div class=\"banner not-judged\""),
                    HasSubstr(words)));
  const std::string json = rendered("json", document);
  EXPECT_THAT(json, AllOf(HasSubstr("\"errors\": ["), HasSubstr(words)));
  std::string problem;
  const auto read = read_json(json, problem);
  ASSERT_TRUE(read) << problem;
  EXPECT_EQ(outcome_of(*read), rules::Outcome::not_judged);
  EXPECT_EQ(rendered("json", *read), json);
}

// "+0.0 %" beside a failure reads as good.
TEST(Margin, IsNotShownWhereThereIsNone) {
  using testing::AllOf, testing::HasSubstr, testing::Not;
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  finding.requirement.comparison = rules::Comparison::at_most;
  finding.requirement.limit = 0.0;
  finding.measured = {0.25, 0.25, 0.25};
  finding.verdict = rules::Verdict::fail;
  finding.is_close = false;
  finding.margin = rules::margin_of(finding.requirement, finding.measured, finding.verdict);
  document.projects[0].spaces[0].planes[0].findings.resize(1);
  for (const std::string& text :
       {rendered("text", document), rendered("markdown", document), render_html(document),
        rendered("junit", document), rendered("sarif", document), rendered("github", document),
        rendered("gitlab", document), rendered("csv", document)}) {
    EXPECT_THAT(text, Not(HasSubstr("+0.0")));
  }
  EXPECT_THAT(rendered("text", document), HasSubstr("–"));
  EXPECT_THAT(rendered("json", document), HasSubstr("\"margin\": null"));
}

// Of one project of several: the options have chosen something.
TEST(NothingChosen, OfOneProjectIsNoError) {
  using testing::HasSubstr, testing::Not;
  Document document = with_verdicts({rules::Verdict::pass});
  document.projects.push_back(unchosen());
  document.provenance.selection = "--plane dsk";
  EXPECT_EQ(outcome_of(document), rules::Outcome::pass);
  EXPECT_THAT(rendered("junit", document), HasSubstr("errors=\"0\""));
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("\"errors\"")));
}

// With something asked nothing of it is to be read.
TEST(NothingAsked, IsNotSaidOfWhatIsWaivedOrNotJudged) {
  Document waived = with_verdicts({rules::Verdict::fail});
  waived.projects[0].spaces[0].planes[0].findings[0].is_waived = true;
  Document uncomputed = with_verdicts({});
  uncomputed.projects[0].spaces[0].planes[0].is_computed = false;
  const auto not_said =
      testing::Not(testing::ContainsRegex("[Nn]othing was asked|nothing-asked|○"));
  for (const Document& document :
       {waived, uncomputed, with_verdicts({rules::Verdict::not_judged}), small_document()}) {
    for (const std::string& text : {rendered("text", document), rendered("markdown", document),
                                    render_html(document), rendered("junit", document)}) {
      EXPECT_THAT(text, not_said);
    }
  }
  EXPECT_THAT(rendered("markdown", waived), testing::HasSubstr("### luxgate: ✓ waived: "));
  EXPECT_THAT(render_html(waived), testing::HasSubstr("<div class=\"banner pass\">"));
  EXPECT_THAT(rendered("markdown", uncomputed), testing::HasSubstr("### luxgate: – not judged: "));
  EXPECT_THAT(render_html(uncomputed), testing::HasSubstr("<div class=\"banner not-judged\">"));
}

}  // namespace
}  // namespace report::document_test
