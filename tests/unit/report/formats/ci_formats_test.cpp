// The formats of CI systems: one document with every verdict against files, and what must hold for
// any document.
#include "calc/base/diagnostic_ids.h"
#include "report/formats/ci_finding.h"
#include "report/formats/sarif.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace report::ci_formats_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

calc::SourceLocation at(int line) { return {"office.xml", line, 7}; }

// A pass, a fail, an undecided, a not judged, a waived requirement and advice, a plane and a
// project without result, a warning.
Document every_verdict() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.inputs = {{"office.xml", std::string(64, 'a')}, {"my lamp.ies", std::string(64, 'b')}};
  project.diagnostics = {{calc::DiagnosticId::nothing_required, at(3), "a warning, 100% true"}};
  PlanePart& plane = project.spaces[0].planes[0];
  plane.where = at(20);
  plane.findings[0].requirement.where = at(21);
  plane.findings[1].requirement.where = at(22);
  rules::Finding undecided =
      sample_finding(rules::Metric::uniformity_min_avg, 0.83, plane.uniformity_min_avg);
  undecided.requirement.where = at(23);
  undecided.is_close = true;
  rules::Finding unjudged = sample_finding(rules::Metric::maximum, 900, {});
  unjudged.requirement.comparison = rules::Comparison::at_most;
  unjudged.requirement.where = at(24);
  unjudged.requirement.scene = "night";
  unjudged.verdict = rules::Verdict::not_judged;
  unjudged.reason = calc::Message::words("no such light");
  rules::Finding waived =
      sample_finding(rules::Metric::uniformity_min_max, 0.8, plane.uniformity_min_max);
  waived.requirement.where = at(25);
  waived.requirement.waiver = rules::Waiver{"old hall", "A. Client", "2030-12-31"};
  waived.is_waived = true;
  waived.reason = calc::Message::words("waived by A. Client until 2030-12-31: old hall");
  rules::Finding advice = sample_finding(rules::Metric::percentile, 500, plane.minimum);
  advice.requirement.arguments = rules::Percentile{5};
  advice.requirement.severity = rules::Severity::advice;
  advice.requirement.where = at(26);
  plane.findings.push_back(undecided);
  plane.findings.push_back(unjudged);
  plane.findings.push_back(waived);
  plane.findings.push_back(advice);
  PlanePart dark;
  dark.id = "stairs";
  dark.where = at(30);
  dark.reason = calc::Message::words("every point lies inside a solid");
  project.spaces[0].planes.push_back(dark);

  ProjectPart broken;
  broken.path = "/srv/a b/yard.xml";
  broken.diagnostics = {
      {calc::DiagnosticId::internal_error, {"/srv/a b/yard.xml", 4, 0}, "broken"}};
  document.projects.push_back(broken);
  return document;
}

// Names that try to be markup, commands, or lines of their own.
Document hostile() {
  Document document = every_verdict();
  ProjectPart& project = document.projects[0];
  const std::string name =
      "a|b</td><script>x</script>\n::error::no %0A @all #1 `c` [l](u) https://x.y www.x.y \x1b[31m "
      "\xff";
  project.name = name;
  project.path = name;
  project.spaces[0].name = name;
  project.spaces[0].planes[0].id = name;
  project.spaces[0].planes[0].name = name;
  project.spaces[0].planes[0].findings[1].requirement.clause = calc::Message::words(name);
  project.spaces[0].planes[0].findings[1].requirement.id = name;
  project.diagnostics[0].message = name;
  return document;
}

// What was rendered is left beside the test where it differs from the file.
void expect_file(const std::string& name, const std::string& text) {
  std::ifstream file(std::string(LUXGATE_FORMAT_SAMPLES) + "/expected." + name, std::ios::binary);
  std::ostringstream expected;
  expected << file.rdbuf();
  if (text == expected.str()) return;
  std::ofstream(testing::TempDir() + "actual." + name, std::ios::binary) << text;
  EXPECT_EQ(text, expected.str()) << "see " << testing::TempDir() << "actual." << name;
}

TEST(CiFormats, EveryVerdictLooksLikeTheFiles) {
  const Document document = every_verdict();
  expect_file("junit.xml", rendered("junit", document));
  expect_file("sarif", rendered("sarif", document));
  expect_file("all.sarif", rendered("sarif-all", document));
  expect_file("github.txt", rendered("github", document));
  expect_file("gitlab.json", rendered("gitlab", document));
  expect_file("md", rendered("markdown", document));
}

// What a request did not bring is not pinned to it.
TEST(CiFormats, GithubPinsNewWarningsAlone) {
  Document document = every_verdict();
  auto& diagnostics = document.projects[0].diagnostics;
  const calc::SourceLocation where = diagnostics.at(0).where;
  diagnostics = {{calc::DiagnosticId::mesh_bent_faces, where, "old"},
                 {calc::DiagnosticId::mesh_bent_faces, where, "new"},
                 {calc::DiagnosticId::mesh_bent_faces, where, "old"}};
  document.revision.emplace();
  document.revision->known_warnings = {{document.projects[0].path, {0}}};
  const std::string text = rendered("github", document);
  const std::size_t first = text.find("::old");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(text.find("::old", first + 1), std::string::npos) << "one of the two is new";
  EXPECT_THAT(text, HasSubstr("::new"));
  EXPECT_THAT(text,
              HasSubstr("luxgate: warnings that are not new, listed in the other reports: 1\n"));
}

std::vector<CiFinding> findings_of(const Document& document) {
  const CiFindings of_all({}, nullptr);
  std::vector<CiFinding> list;
  for (const ProjectPart& project : document.projects) {
    const std::vector<CiFinding> more = of_all.of(project);
    list.insert(list.end(), more.begin(), more.end());
  }
  return list;
}

TEST(CiFindings, FingerprintsFollowIdsAlone) {
  const Document document = every_verdict();
  const auto before = findings_of(document);
  std::set<std::string> different;
  for (const CiFinding& entry : before) different.insert(entry.fingerprint);
  EXPECT_EQ(different.size(), before.size());
  Document changed = document;
  PlanePart& plane = changed.projects[0].spaces[0].planes[0];
  plane.name = "New name";
  plane.findings[0].requirement.where.line = 99;
  plane.findings[0].measured.value = 480.0;
  plane.findings[0].verdict = rules::Verdict::fail;
  EXPECT_EQ(findings_of(changed)[0].fingerprint, before[0].fingerprint);
  plane.findings[0].requirement.id = "other";
  EXPECT_NE(findings_of(changed)[0].fingerprint, before[0].fingerprint);
}

// Its exit code is 2: no format may look green.
TEST(CiFindings, APlaneWithoutResultIsToldBesideAdvice) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.is_computed = false;
  plane.findings.resize(1);
  plane.findings[0].verdict = rules::Verdict::not_judged;
  EXPECT_EQ(findings_of(document).size(), 1u);
  plane.findings[0].requirement.severity = rules::Severity::advice;
  const auto list = findings_of(document);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].rule, "plane");
  EXPECT_TRUE(list[1].counts);
  EXPECT_THAT(rendered("junit", document), HasSubstr("errors=\"1\""));
}

TEST(Junit, CountsWhatItLists) {
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(rendered("junit", every_verdict()).c_str()));
  const pugi::xml_node all = xml.child("testsuites");
  EXPECT_EQ(all.attribute("tests").as_int(), 9);
  EXPECT_EQ(all.attribute("failures").as_int(), 2);
  EXPECT_EQ(all.attribute("errors").as_int(), 3);
  EXPECT_EQ(all.select_nodes("testsuite/testcase").size(), 9u);
  EXPECT_EQ(all.select_nodes("testsuite/testcase/failure").size(), 2u);
  EXPECT_EQ(all.select_nodes("testsuite/testcase/error").size(), 3u);
  EXPECT_EQ(all.select_nodes("testsuite").size(), 2u);
  EXPECT_EQ(all.child("testsuite").attribute("skipped").as_int(), 3);
  EXPECT_EQ(all.select_nodes("testsuite/testcase/skipped").size(), 3u);
}

TEST(Sarif, PointsToRulesAndKeepsKindsApart) {
  const json run = json::parse(rendered("sarif-all", every_verdict()))["runs"][0];
  std::set<std::string> kinds;
  for (const json& result : run["results"]) {
    const std::size_t index = result["ruleIndex"];
    EXPECT_EQ(run["tool"]["driver"]["rules"][index]["id"], result["ruleId"]);
    kinds.insert(result["kind"]);
    const bool is_advice = result["ruleId"] == "percentile";
    EXPECT_EQ(result["level"], result["kind"] != "fail" ? "none" : is_advice ? "note" : "error");
    EXPECT_EQ(result.contains("suppressions"), result["ruleId"] == "Ud");
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"pass", "fail", "review", "open"}));
  for (const json& result : json::parse(rendered("sarif", every_verdict()))["runs"][0]["results"]) {
    EXPECT_NE(result["kind"], "pass");
  }
  EXPECT_EQ(run["artifacts"][1]["location"]["uri"], "my%20lamp.ies");
  EXPECT_FALSE(run["invocations"][0]["executionSuccessful"]);
}

TEST(CiFormats, NamesStayText) {
  const Document document = hostile();
  pugi::xml_document xml;
  EXPECT_TRUE(xml.load_string(rendered("junit", document).c_str()));
  EXPECT_EQ(xml.select_nodes("//script").size(), 0u);
  EXPECT_TRUE(json::accept(rendered("sarif-all", document)));
  EXPECT_TRUE(json::accept(rendered("gitlab", document)));
  const std::string github = rendered("github", document);
  std::istringstream lines(github);
  int commands = 0;
  for (std::string line; std::getline(lines, line);) commands += line.starts_with("::") ? 1 : 0;
  EXPECT_EQ(commands, 9);  // two diagnostics, seven findings that did not pass
  EXPECT_THAT(github, HasSubstr("no %250A"));
  const std::string markdown = rendered("markdown", document);
  EXPECT_THAT(markdown, Not(HasSubstr("<script>")));
  EXPECT_THAT(markdown, Not(HasSubstr("@all")));
  EXPECT_THAT(markdown, Not(HasSubstr("[l](u)")));
  EXPECT_THAT(markdown, Not(HasSubstr("://")));
  EXPECT_THAT(markdown, Not(HasSubstr("www.")));
  for (const std::string& text : {github, markdown, rendered("junit", document)}) {
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_THAT(text, Not(HasSubstr("\xff")));
  }
}

// Two variants of a design have the same rooms and planes.
TEST(Markdown, NamesTheProjectWhereThereAreSeveral) {
  Document two = small_document();
  two.projects.push_back(two.projects[0]);
  two.projects[1].path = "variants/b|c.xml";
  two.projects[1].name.clear();
  two.projects[1].spaces[0].planes[0].findings.pop_back();
  const std::string text = rendered("markdown", two);
  EXPECT_THAT(text, HasSubstr("\n- ✗ fail: office.xml, Small office\n"
                              "- ✓ pass: variants/b&#124;c.xml\n"));
  EXPECT_THAT(text, HasSubstr("\n| project | verdict | where | quantity | required | calculated | "
                              "margin |\n| --- | --- | --- | --- | ---: | ---: | ---: |\n"
                              "| office.xml | ✗ fail | Office / Work plane | minimum |"));
  EXPECT_THAT(text,
              HasSubstr("\n| variants/b&#124;c.xml | ✓ pass | Office / Work plane | average"));
  const std::string one = rendered("markdown", small_document());
  EXPECT_THAT(one, testing::StartsWith("### luxgate: ✗ fail: Small office (office.xml)\n"));
  EXPECT_THAT(one, Not(HasSubstr("\n- ")));
  EXPECT_THAT(one, Not(HasSubstr("| project |")));
}

TEST(Markdown, SaysWhatALongTableLeavesOut) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.findings.assign(130, plane.findings[1]);
  const std::string text = rendered("markdown", document);
  EXPECT_THAT(text, HasSubstr("30 more are not listed here."));
  EXPECT_LT(text.size(), 65536u);  // GitHub's limit of a comment
}

TEST(Gitlab, FingerprintsAreUniqueEvenForEqualMessages) {
  Document document = small_document();
  document.projects[0].diagnostics.assign(
      3, {calc::DiagnosticId::nothing_required, at(3), "the same"});
  std::set<std::string> different;
  const json issues = json::parse(rendered("gitlab", document));
  for (const json& issue : issues) different.insert(issue["fingerprint"]);
  EXPECT_EQ(issues.size(), 4u);
  EXPECT_EQ(different.size(), 4u);
}

// CI output must not hide that a zone was left out or changed.
TEST(CiFormats, NotesOfRoomsAreTold) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  EXPECT_THAT(rendered("markdown", document), Not(HasSubstr("Notes on")));
  EXPECT_THAT(rendered("junit", document), Not(HasSubstr("Office: ")));
  space.notes = {calc::Message::words("workplace desk: left out: ceiling | <open>")};
  space.planes[0].changed = calc::Message::words("height 1.1 m instead of 0.75 m");
  EXPECT_THAT(rendered("markdown", document),
              HasSubstr("- Office: workplace desk: left out: ceiling &#124; &#60;open&#62;\n"
                        "- Office / Work plane: changed: height 1.1 m instead of 0.75 m\n"));
  pugi::xml_document tree;
  ASSERT_TRUE(tree.load_string(rendered("junit", document).c_str()));
  const std::string told = tree.select_node("//testsuite/system-out").node().text().as_string();
  EXPECT_EQ(told,
            "Office: workplace desk: left out: ceiling | <open>\n"
            "Office / Work plane: changed: height 1.1 m instead of 0.75 m\n");
}

// What must be read with the numbers of a plane is in every format, whatever its verdicts are.
TEST(CiFormats, RemarksAndDoubtsOfPlanesAreInAll) {
  Document document = every_verdict();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.remarks = {calc::Message::words("how it was rated")};
  plane.single_sample_points = 2;
  const std::string doubt = doubt_words({}, plane);
  ASSERT_NE(doubt, "");
  for (const std::string& text :
       {rendered("sarif", document), rendered("github", document), rendered("gitlab", document),
        rendered("junit", document), rendered("markdown", document), rendered("csv", document)}) {
    EXPECT_THAT(text, HasSubstr("how it was rated"));
    EXPECT_THAT(text, HasSubstr(doubt));
  }
}

}  // namespace
}  // namespace report::ci_formats_test
