#include "report/result_file/redact.h"

#include "calc/base/diagnostic_ids.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

namespace report::redact_test {
namespace {

using testing::HasSubstr;
using testing::Not;

Document one_project(std::string path) {
  Document document = small_document();
  document.projects.resize(1);
  document.projects[0].path = std::move(path);
  return document;
}

// What becomes of a text of a plane.
std::string redacted(const std::string& project_path, const std::string& text) {
  Document document = one_project(project_path);
  document.projects[0].spaces[0].planes[0].reason = calc::Message::words(text);
  redact(document);
  return document.projects[0].spaces[0].planes[0].reason.english();
}

std::string redacted_file(const std::string& project_path, const std::string& file) {
  Document document = one_project(project_path);
  document.projects[0].spaces[0].planes[0].where.file = file;
  redact(document);
  return document.projects[0].spaces[0].planes[0].where.file;
}

std::string redacted_backend(const std::string& backend) {
  Document document = small_document();
  document.provenance.backend = backend;
  redact(document);
  return document.provenance.backend;
}

TEST(Redact, NamesFilesRelativeToTheirProject) {
  EXPECT_EQ(redacted_file("/home/anna/p/a.xml", "/home/anna/p/a.xml"), "a.xml");
  EXPECT_EQ(redacted_file("/home/anna/p/a.xml", "/home/anna/p/lamps/b.ies"), "lamps/b.ies");
  EXPECT_EQ(redacted_file("/home/anna/p/a.xml", "/home/anna/packs/c.xml"), "c.xml");
  EXPECT_EQ(redacted_file("/home/anna/p/a.xml", "/home/anna/p2/c.xml"), "c.xml");
  EXPECT_EQ(redacted_file("p/a.xml", "p/lamps/b.ies"), "lamps/b.ies");
  EXPECT_EQ(redacted_file("p/a.xml", "/packs/c.xml"), "c.xml");
  EXPECT_EQ(redacted_file("a.xml", "lamps/b.ies"), "lamps/b.ies");
  EXPECT_EQ(redacted_file("a.xml", "../anna/c.xml"), "c.xml");
  EXPECT_EQ(redacted_file("./x/../p/a.xml", "p/lamps/b.ies"), "lamps/b.ies");
  EXPECT_EQ(redacted_file("/a.xml", ""), "");
}

TEST(Redact, FindsPathsInTexts) {
  const char* project = "/home/anna/p/a.xml";
  EXPECT_EQ(redacted(project, "cannot read '/home/anna/p/lamps/b.ies': no"),
            "cannot read 'lamps/b.ies': no");
  EXPECT_EQ(redacted(project, "/home/anna/p/a.xml:12:5: bad"), "a.xml:12:5: bad");
  EXPECT_EQ(redacted(project, "loaded from '/opt/my packs/c.xml', twice"),
            "loaded from 'c.xml', twice");
  EXPECT_EQ(redacted(project, "see /opt/packs/c.xml; again"), "see c.xml; again");
  EXPECT_EQ(redacted(project, "see file:///opt/packs/c.xml"), "see file:c.xml");
  EXPECT_EQ(redacted(project, "'/secret'"), "'secret'");
  EXPECT_EQ(redacted(project, "'../anna/c.xml'"), "'c.xml'");
  EXPECT_EQ(redacted("p/a.xml", "cannot read 'p/b.ies'"), "cannot read 'b.ies'");
}

TEST(Redact, LeavesWhatIsNoPath) {
  for (const char* text : {"300 cd /m2 and lm/W", "'a'/'b'", "https://example.org/a/b", "1/2/3",
                           "/", "..", "cylinder / plane", "'/'", ""}) {
    EXPECT_EQ(redacted("m2/a.xml", text), text);
    EXPECT_EQ(redacted("/home/a.xml", text), text);
  }
}

TEST(Redact, CommandHasTheSameNames) {
  Document document = one_project("/home/anna's/my p/a.xml");
  document.provenance.command_line =
      "luxgate check '/home/anna'\\''s/my p/a.xml' --rules /opt/packs/ --rules ../c.xml --seed 3";
  redact(document);
  EXPECT_EQ(document.provenance.command_line,
            "luxgate check a.xml --rules packs --rules c.xml --seed 3");
}

TEST(Redact, ProjectsOfOneNameStayApart) {
  Document document = one_project("/x/anna/a.xml");
  document.projects.push_back(document.projects[0]);
  document.projects[1].path = "/x/benno/a.xml";
  document.projects[1].inputs = {{"/x/benno/a.xml", "12"}, {"lamps/b.ies", "34"}};
  document.provenance.command_line = "luxgate check /x/anna/a.xml /x/benno/a.xml";
  redact(document);
  EXPECT_EQ(document.projects[0].path, "project1/a.xml");
  EXPECT_EQ(document.projects[1].path, "project2/a.xml");
  EXPECT_EQ(document.projects[1].inputs[0].path, "project2/a.xml");
  EXPECT_EQ(document.projects[1].inputs[1].path, "project2/lamps/b.ies");
  EXPECT_EQ(document.projects[1].inputs[1].sha256, "34");
  EXPECT_EQ(document.provenance.command_line, "luxgate check project1/a.xml project2/a.xml");
  const std::string once = rendered("json", document);
  redact(document);
  EXPECT_EQ(rendered("json", document), once);
}

TEST(Redact, RevisionHasTheSameNames) {
  Document document = one_project("/home/anna/p/a.xml");
  Revision revision;
  revision.baseline = "/home/anna/main.json";
  RevisionPlace place;
  place.project = "/home/anna/p/a.xml";
  place.where.file = "/home/anna/p/a.xml";
  revision.results.resize(2);
  revision.results[0].place = place;
  revision.results[1].place.project = "/home/benno/gone.xml";
  revision.questions.resize(1);
  revision.questions[0].place = place;
  revision.inputs.resize(1);
  revision.inputs[0].place = place;
  revision.planes.resize(1);
  revision.planes[0].place = place;
  revision.notes = {calc::Message::words("/home/anna/p/a.xml could not be judged now")};
  revision.gate.weaker_accepted_by = "see /home/anna/letter.txt";
  revision.known_warnings = {{"/home/anna/p/a.xml", {}}};
  document.revision = revision;
  redact(document);
  EXPECT_EQ(document.revision->baseline, "main.json");
  EXPECT_EQ(document.revision->planes[0].place.project, document.projects[0].path);
  EXPECT_EQ(document.revision->results[1].place.project, "gone.xml");
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("/home")));

  revision.baseline = "origin/main";
  revision.commits = {std::string(40, 'a')};
  document.revision = revision;
  redact(document);
  EXPECT_EQ(document.revision->baseline, "origin/main");
  EXPECT_EQ(document.revision->commits, revision.commits);
}

TEST(Redact, DevicesLoseTheirNames) {
  EXPECT_EQ(redacted_backend("cpu"), "cpu");
  EXPECT_EQ(redacted_backend("gpu (X 1 (rev 2), software)"), "gpu");
  EXPECT_EQ(redacted_backend("gpu (X 1): light-paths; cpu: near-field"),
            "gpu: light-paths; cpu: near-field");
  EXPECT_EQ(redacted_backend("gpu (X"), "gpu");
  Document document = small_document();
  document.projects[0].spaces[0].pictures.device = "X 1";
  redact(document);
  EXPECT_EQ(document.projects[0].spaces[0].pictures.device, "OpenGL");
}

TEST(Redact, NoFieldKeepsAFolder) {
  Document document = one_project("/home/anna/p/a.xml");
  const std::string file = "/home/anna/q/b.xml", text = "as in '/home/anna/q/b.xml'";
  ProjectPart& project = document.projects[0];
  project.diagnostics = {{calc::DiagnosticId::file_not_readable, {file, 1, 2}, text}};
  project.inputs = {{project.path, "1"}, {file, "2"}};
  LuminaireRow row;
  row.photometry_file = file;
  project.luminaires.push_back(row);
  project.spaces[0].notes = {calc::Message::words(text)};
  project.spaces[0].pictures.problem = text;
  PlanePart& plane = project.spaces[0].planes[0];
  plane.where.file = file;
  plane.reason = plane.made_by = plane.changed = calc::Message::words(text);
  plane.remarks = {calc::Message::words(text)};
  plane.findings = {sample_finding(rules::Metric::average, 300, estimate(310, 5))};
  plane.findings[0].requirement.where.file = file;
  plane.findings[0].reason = calc::Message::words(text);
  plane.findings[0].requirement.note = calc::Message::words(text);
  plane.findings[0].requirement.policy.tolerance_reason = text;
  rules::AggregateFinding aggregate;
  aggregate.where.file = file;
  aggregate.reason = aggregate.note = calc::Message::words(text);
  aggregate.members = {{"a", rules::Verdict::fail, false, {}, calc::Message::words(text)}};
  project.aggregates = {aggregate};
  document.provenance.command_line = "luxgate check /home/anna/p/a.xml --rules " + file;
  ASSERT_THAT(rendered("json", document), HasSubstr("anna"));
  redact(document);
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("anna")));
  EXPECT_THAT(project.spaces[0].pictures.problem, Not(HasSubstr("anna")));
}

TEST(Redact, PathsInAnyText) {
  const auto redacted = [](const std::string& text) {
    Document document = one_project("p/a.xml");
    document.projects[0].spaces[0].notes = {calc::Message::words(text)};
    redact(document);
    return document.projects[0].spaces[0].notes[0].english();
  };
  EXPECT_EQ(redacted("cannot open [/home/anna/p/x.ies]"), "cannot open [x.ies]");
  EXPECT_EQ(redacted("read /home/anna/my jobs/acme/x.ies failed"), "read x.ies failed");
  EXPECT_EQ(redacted("read /home/Anna van Doe/x.ies failed"), "read x.ies failed");
  EXPECT_EQ(redacted("of /home/anna/[2024]/x.ies"), "of x.ies");
  EXPECT_EQ(redacted("a|/home/anna/x.ies"), "a|x.ies");
  EXPECT_EQ(redacted("/home/anna/x.ies gives 12 W/m2"), "x.ies gives 12 W/m2");
  EXPECT_EQ(redacted("12.5 kWh/m2/a of 40 W/m2"), "12.5 kWh/m2/a of 40 W/m2");
  EXPECT_EQ(redacted("12.5 kWh/m²/a of 40 W/m²"), "12.5 kWh/m²/a of 40 W/m²");
}

TEST(Redact, IsToldOnlyWhereItWasDone) {
  Document document = small_document();
  EXPECT_EQ(redaction_words(document.provenance), "");
  EXPECT_THAT(rendered("json", document), Not(HasSubstr("redacted")));
  redact(document);
  EXPECT_THAT(redaction_words(document.provenance), HasSubstr("Omitted: folders of files"));
  EXPECT_THAT(rendered("json", document), HasSubstr("\"redacted\": true"));
}

TEST(Redact, ProjectsOneByOneAreThoseOfTheWhole) {
  Document whole = sample_document();
  whole.projects.push_back(whole.projects[0]);
  whole.projects[2].path = "/home/somebody/" + whole.projects[0].path;  // of the same name
  whole.provenance.command_line = "luxgate check " + whole.projects[2].path;
  whole.provenance.backend = "gpu (Some Device (x), software): a";
  DocumentFrame frame = frame_of(whole);
  const Redaction redaction(frame.paths);
  redaction.redact(frame);
  Document one_by_one{frame.provenance, whole.projects, {}};
  for (std::size_t p = 0; p < whole.projects.size(); ++p) {
    redaction.redact(one_by_one.projects[p], p);
  }
  redact(whole);
  EXPECT_EQ(rendered("json", one_by_one), rendered("json", whole));
  EXPECT_EQ(frame.paths, frame_of(whole).paths);
}

}  // namespace
}  // namespace report::redact_test
