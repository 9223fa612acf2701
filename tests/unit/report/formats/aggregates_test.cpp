// Aggregates and classes in every format, and what they count.
#include "report/formats/ci_finding.h"
#include "report/html/page/html.h"
#include "report/result_file/read_json.h"
#include "report/text/aggregate_words.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"
#include "tests/support/sample_road.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace report::aggregates_test {
namespace {

using testing::HasSubstr;
using testing::Not;

rules::AggregateFinding any_of_two(rules::Verdict verdict) {
  rules::AggregateFinding finding;
  finding.id = "glare";
  finding.space_id = "r1";
  finding.clause = calc::Message::words("Own:1 <7.3>");
  finding.note = calc::Message::words("one public source");
  finding.rule = rules::AggregateRule::any;
  finding.verdict = verdict;
  finding.reason = calc::Message::words("fail: ugr (eyes)");
  finding.members = {{"ugr", rules::Verdict::fail, false, {}, calc::Message::words("eyes")},
                     {"luminance", rules::Verdict::pass, false, 12.25, {}}};
  finding.where = {"office.xml", 9, 5};
  return finding;
}

rules::AggregateFinding class_p() {
  rules::AggregateFinding finding;
  finding.kind = rules::AggregateKind::row_class;
  finding.id = "P";
  finding.space_id = "r1";
  finding.plane_id = "work";
  finding.severity = rules::Severity::advice;
  finding.verdict = rules::Verdict::undecided;
  finding.asked = "P2";
  finding.reached = "P3";
  finding.possible = "P2";
  finding.members = {
      {"P.average", rules::Verdict::undecided, false, {}, calc::Message::words("work")}};
  return finding;
}

// Whose plane has one pass; its failing requirement counts only in the aggregate.
Document document_with(const rules::AggregateFinding& finding) {
  Document document = small_document();
  rules::Requirement& failing = document.projects[0].spaces[0].planes[0].findings[1].requirement;
  failing.severity = rules::Severity::in_aggregate;
  document.projects[0].aggregates = {finding, class_p()};
  return document;
}

TEST(Aggregates, CountAsRequirementsAndTheirMembersDoNot) {
  const auto counts = [](rules::AggregateFinding finding) {
    return count_verdicts(document_with(finding));
  };
  EXPECT_EQ(counts(any_of_two(rules::Verdict::pass)).pass, 2);
  EXPECT_EQ(counts(any_of_two(rules::Verdict::pass)).fail, 0);
  EXPECT_EQ(counts(any_of_two(rules::Verdict::pass)).undecided, 0);  // classes do not count
  EXPECT_EQ(counts(any_of_two(rules::Verdict::fail)).fail, 1);
  EXPECT_EQ(counts(any_of_two(rules::Verdict::undecided)).undecided, 1);
  EXPECT_EQ(counts(any_of_two(rules::Verdict::not_judged)).not_judged, 1);
  rules::AggregateFinding advice = any_of_two(rules::Verdict::fail);
  advice.severity = rules::Severity::advice;
  EXPECT_EQ(counts(advice).fail, 0);
  rules::AggregateFinding waived = any_of_two(rules::Verdict::fail);
  waived.is_waived = true;
  EXPECT_EQ(counts(waived).fail, 0);
  EXPECT_EQ(counts(waived).waived, 1);
  EXPECT_EQ(outcome_of(document_with(any_of_two(rules::Verdict::fail))), rules::Outcome::fail);
}

TEST(Aggregates, HaveWords) {
  rules::AggregateFinding finding = any_of_two(rules::Verdict::pass);
  EXPECT_EQ(aggregate_title({}, finding), "aggregate glare");
  EXPECT_EQ(aggregate_required({}, finding), "any of 2 checks");
  EXPECT_EQ(aggregate_measured({}, finding), "1 of 2 met");
  finding.rule = rules::AggregateRule::share;
  finding.share = 0.9;
  finding.over = rules::AggregateOver::rooms;
  finding.by_area = true;
  EXPECT_THAT(aggregate_required({}, finding),
              testing::MatchesRegex("at least 90.* of the area of 2 rooms"));
  finding.members[0].area_m2 = 3.0;
  finding.members[1].area_m2 = 1.0;
  const bool is_first_met = finding.members[0].verdict == rules::Verdict::pass;
  EXPECT_EQ(aggregate_measured({}, finding),
            (is_first_met ? "75.0" : "25.0") + std::string(" % of the area, 1 of 2 met"));
  finding.rule = rules::AggregateRule::at_least;
  finding.count = 2;
  EXPECT_EQ(aggregate_required({}, finding), "at least 2 of 2 rooms");
  EXPECT_EQ(aggregate_required({}, class_p()), "P2");
  EXPECT_EQ(aggregate_measured({}, class_p()), "P3 reached, P2 possible");
  EXPECT_EQ(aggregate_place(small_document().projects[0], class_p()).find("Work plane") ==
                std::string::npos,
            false);
}

// Ids of checks tell clients nothing, and a class of a street stands in its chapter.
TEST(Aggregates, ClientsReadWhatIsNotSaidElsewhereWithoutIds) {
  Document document = document_with(any_of_two(rules::Verdict::pass));
  FormatStyle style;
  style.page.detail = Detail::client;
  const std::string html = rendered("html", document, style);
  EXPECT_THAT(html, HasSubstr(">class P<"));
  EXPECT_THAT(html, HasSubstr("<td>0 of 1 met</td>"));
  EXPECT_THAT(html, Not(HasSubstr("P.average")));
  document.projects[0].spaces.push_back(sample_road());
  rules::AggregateFinding of_street = class_p();
  of_street.space_id = of_street.plane_id = "street";
  document.projects[0].aggregates = {of_street};
  EXPECT_THAT(rendered("html", document, style), Not(HasSubstr(">class P<")));
}

// With one requirement that is undecided and waived, as the only member of both.
Document waived_document() {
  Document document = document_with(any_of_two(rules::Verdict::undecided));
  rules::Finding& open = document.projects[0].spaces[0].planes[0].findings[1];
  open.requirement.limit = open.measured.value;
  judge_again(open);
  open.requirement.origin = {"own:1", "ugr", "", {}, {}};
  open.requirement.waiver = rules::Waiver{"moves", "J. Doe", "2027-06-30"};
  open.is_waived = true;
  document.provenance.judged_on = "2027-06-30";
  for (rules::AggregateFinding& finding : document.projects[0].aggregates) {
    finding.is_waived = true;
    finding.share = 0.1;
    finding.members = {{"ugr",
                        rules::Verdict::undecided,
                        true,
                        12.25,
                        calc::Message::words("eyes"),
                        {{"work", "minimum"}}}};
  }
  return document;
}

TEST(Aggregates, SurviveTheJsonByteByByte) {
  const std::string json = rendered("json", waived_document());
  std::string problem;
  const std::optional<Document> read = read_json(json, problem);
  ASSERT_TRUE(read.has_value()) << problem;
  EXPECT_EQ(rendered("json", *read), json);
  EXPECT_EQ(render_html(*read), render_html(waived_document()));
  EXPECT_EQ(rendered("text", *read), rendered("text", waived_document()));
}

TEST(Aggregates, OfJsonMustMakeSense) {
  rules::AggregateFinding finding = any_of_two(rules::Verdict::pass);
  finding.is_waived = true;
  std::string problem;
  EXPECT_FALSE(read_json(rendered("json", document_with(finding)), problem));
  EXPECT_THAT(problem, HasSubstr("what passes cannot be waived"));
}

TEST(Aggregates, AreRowsOfTextAndCsv) {
  const Document document = document_with(any_of_two(rules::Verdict::fail));
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("aggregate glare"));
  EXPECT_THAT(text, HasSubstr("any of 2 checks"));
  EXPECT_THAT(text, HasSubstr("P3 reached, P2 possible"));
  EXPECT_THAT(text, HasSubstr("counts only in its aggregates"));
  const std::string csv = rendered("csv", document);
  EXPECT_THAT(csv, HasSubstr(",r1,,glare,aggregate,"));
  EXPECT_THAT(csv,
              HasSubstr(",fail,any of 2 checks: 1 of 2 met; fail: ugr (eyes),,,,,,,,,,pack\r\n"));
  EXPECT_THAT(csv, HasSubstr(",r1,work,P,class,"));
  // As many fields as the head has.
  const auto commas = [&](std::size_t from) {
    return std::count(csv.begin() + static_cast<std::ptrdiff_t>(from),
                      csv.begin() + static_cast<std::ptrdiff_t>(csv.find("\r\n", from)), ',');
  };
  const std::size_t row = csv.rfind("\r\n", csv.find(",work,P,class,")) + 2;
  EXPECT_EQ(commas(row), commas(0) + 1);  // one comma is in the words, between quotes
}

TEST(Aggregates, AreInTheHtml) {
  const std::string failing = render_html(document_with(any_of_two(rules::Verdict::fail)));
  pugi::xml_document xml;
  const auto parsed = xml.load_string(failing.c_str(), pugi::parse_default | pugi::parse_doctype);
  EXPECT_TRUE(parsed) << parsed.description();
  EXPECT_THAT(failing, HasSubstr("id=\"aggregates1\""));
  EXPECT_THAT(failing, HasSubstr("href=\"#aggregates1\""));  // in what needs attention
  EXPECT_THAT(failing, HasSubstr("Own:1 &lt;7.3&gt;"));
  EXPECT_THAT(failing, Not(HasSubstr("<7.3>")));
  const std::string passing = render_html(document_with(any_of_two(rules::Verdict::pass)));
  EXPECT_THAT(passing, Not(HasSubstr("href=\"#aggregates1\"")));
  EXPECT_THAT(render_html(small_document()), Not(HasSubstr("aggregates1")));
}

TEST(Aggregates, AreFindingsForCiSystems) {
  Document document = document_with(any_of_two(rules::Verdict::fail));
  document.projects[0].aggregates.push_back(any_of_two(rules::Verdict::fail));  // of another row
  std::set<std::string> fingerprints;
  const std::vector<CiFinding> list = CiFindings({}, nullptr).of(document.projects[0]);
  for (const CiFinding& entry : list) fingerprints.insert(entry.fingerprint);
  EXPECT_EQ(fingerprints.size(), list.size());
  EXPECT_THAT(rendered("github", document),
              HasSubstr("::error file=office.xml,line=9,col=5,title=luxgate%3A fail"));
  EXPECT_THAT(rendered("gitlab", document), HasSubstr("luxgate/aggregate"));
  EXPECT_THAT(rendered("markdown", document), HasSubstr("any of 2 checks | 1 of 2 met"));
  const std::string junit = rendered("junit", document);
  EXPECT_THAT(junit, HasSubstr("name=\"aggregate:r1//glare\""));
  EXPECT_THAT(junit, HasSubstr("failures=\"2\""));
  const nlohmann::json sarif = nlohmann::json::parse(rendered("sarif-all", document));
  int failing = 0;
  for (const auto& result : sarif["runs"][0]["results"]) {
    if (result["ruleId"] == "aggregate" && result["level"] == "error") ++failing;
  }
  EXPECT_EQ(failing, 2);
}

TEST(Aggregates, ThatAreWaivedSayWhoLivesWithThem) {
  rules::AggregateFinding finding = any_of_two(rules::Verdict::fail);
  finding.is_waived = true;
  finding.reason = calc::Message::words("fail: ugr; waived by J. Doe until 2027-06-30: moves");
  const Document document = document_with(finding);
  EXPECT_THAT(rendered("sarif-all", document), HasSubstr("waived by J. Doe"));
  EXPECT_THAT(rendered("junit", document), HasSubstr("failures=\"0\""));
  EXPECT_THAT(rendered("markdown", document), HasSubstr("fail, waived"));
  EXPECT_THAT(rendered("markdown", document), HasSubstr("fail, in aggregate"));
  EXPECT_THAT(rendered("github", document), Not(HasSubstr("::error")));
}

}  // namespace
}  // namespace report::aggregates_test
