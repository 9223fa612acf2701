#include "report/document/room_summary.h"

#include "report/html/page/html.h"
#include "report/text/plain_text.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

namespace report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

rules::Finding& finding(SpacePart& space, std::size_t k) { return space.planes[0].findings.at(k); }

void set_average(rules::Finding& of, double value, double half_width = 0.5) {
  of.measured = estimate(value, half_width);
  judge_again(of);
}

// A room of two average requirements that pass, 600 of 500 lx and 460 of 450.
SpacePart room(const std::string& id, const std::string& name) {
  SpacePart space = small_document().projects[0].spaces[0];
  space.id = id;
  space.name = name;
  space.planes[0].id = id + "-work";
  for (rules::Finding& one : space.planes[0].findings) {
    one.requirement.metric = rules::Metric::average;
  }
  set_average(finding(space, 0), 600.0);
  set_average(finding(space, 1), 460.0);
  return space;
}

Document rooms() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.spaces = {room("r1", "Hall"), room("r2", "Office"), room("r3", "Store")};
  set_average(finding(project.spaces[1], 0), 412.0);
  finding(project.spaces[2], 1).verdict = rules::Verdict::not_judged;
  return document;
}

TEST(RoomSummary, IsOfWhatCountsAndNamesTheWorst) {
  const Document document = rooms();
  const auto list = room_summaries(document.projects[0]);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].outcome, rules::Outcome::pass);
  EXPECT_EQ(list[0].met, 2);
  EXPECT_EQ(list[0].required, 2);
  ASSERT_NE(list[0].average, nullptr);
  EXPECT_EQ(list[0].average->requirement.limit, 450.0) << "2 % above is nearer than 20 %";
  EXPECT_EQ(list[1].outcome, rules::Outcome::fail);
  EXPECT_EQ(list[1].met, 1);
  EXPECT_EQ(list[1].average->measured.value, 412.0);
  EXPECT_EQ(list[2].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(list[2].average->verdict, rules::Verdict::not_judged);
  EXPECT_EQ(list[2].uniformity, nullptr);
}

TEST(RoomSummary, AdviceWaiversAndOtherRolesTakeNoPart) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  finding(office, 0).requirement.severity = rules::Severity::advice;
  auto list = room_summaries(document.projects[0]);
  EXPECT_EQ(list[1].outcome, rules::Outcome::pass);
  EXPECT_EQ(list[1].required, 1);
  finding(office, 0).requirement.severity = rules::Severity::shall;
  finding(office, 0).is_waived = true;
  list = room_summaries(document.projects[0]);
  EXPECT_EQ(list[1].outcome, rules::Outcome::pass);
  EXPECT_EQ(list[1].required, 1);
  finding(office, 0).is_waived = false;
  finding(office, 0).requirement.origin.is_of_own_role = false;  // of a wall
  list = room_summaries(document.projects[0]);
  EXPECT_EQ(list[1].outcome, rules::Outcome::fail);
  EXPECT_EQ(list[1].average->measured.value, 460.0);
  document.projects[0].spaces[0].planes[0].findings.clear();
  EXPECT_EQ(room_summaries(document.projects[0]).size(), 2u) << "nothing is asked of one";
}

TEST(RoomSummary, AggregatesAboutARoomCount) {
  Document document = rooms();
  rules::AggregateFinding aggregate;
  aggregate.space_id = "r1";
  aggregate.verdict = rules::Verdict::fail;
  document.projects[0].aggregates = {aggregate};
  const auto list = room_summaries(document.projects[0]);
  EXPECT_EQ(list[0].outcome, rules::Outcome::fail);
  EXPECT_EQ(list[0].required, 3);
}

TEST(RoomSummary, StandsFirstOnTheTerminalAndNamesRoomsAtTheEnd) {
  const std::string text = rendered("text", rooms());
  EXPECT_THAT(text, HasSubstr("  verdict       room       met  average lx\n"
                              "  – not judged  Store   1 of 2     – ≥ 450\n"
                              "  ✗ fail        Office  1 of 2   412 ≥ 500\n"
                              "  ✓ pass        Hall    2 of 2   460 ≥ 450\n"));
  EXPECT_THAT(text, HasSubstr("rooms that are not judged: Store\nrooms that fail: Office\n"));
  EXPECT_THAT(rendered("text", small_document()), Not(HasSubstr("rooms that")));
  Document passing = rooms();
  passing.projects[0].spaces = {room("r1", "Hall"), room("r2", "Office")};
  EXPECT_THAT(rendered("text", passing), Not(HasSubstr("rooms that")));
}

TEST(RoomSummary, NoGlareIsNotAMissingValue) {
  Document document = rooms();
  for (SpacePart& space : document.projects[0].spaces) {
    rules::Finding glare = sample_finding(rules::Metric::ugr_table, 19, estimate(17.2, 0.0));
    glare.requirement.comparison = rules::Comparison::at_most;
    if (space.id == "r1") glare.measured = {-kInfinity, -kInfinity, -kInfinity};
    judge_again(glare);
    space.planes[0].findings.push_back(glare);
  }
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("Hall    3 of 3   460 ≥ 450  none ≤ 19\n"));
  EXPECT_THAT(text, HasSubstr("Office  2 of 3   412 ≥ 500  17.2 ≤ 19\n"));
}

TEST(RoomSummary, NearALimitTheIntervalIsSeenAndNothingIsRoundedOverIt) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  finding(office, 0).requirement.limit = 0.6;
  finding(office, 0).requirement.metric = rules::Metric::uniformity_min_avg;
  set_average(finding(office, 0), 0.5996, 0.0);
  set_average(finding(office, 1), 460.0, 9.0);
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("0.5996 ≥ 0.60"));
  EXPECT_THAT(text, HasSubstr("460.0 ± 9.0 ≥ 450"));
}

TEST(RoomSummary, OfSeveralProjectsRoomsAreNamedWithTheirs) {
  Document document = rooms();
  document.projects[0].path = "a.xml";
  ProjectPart broken;
  broken.path = "b.xml";
  document.projects.push_back(broken);
  EXPECT_THAT(rendered("text", document),
              HasSubstr("rooms that are not judged: a.xml: Store, b.xml\n"
                        "rooms that fail: a.xml: Office\n"));
}

TEST(RoomSummary, NamesGiveWayToANarrowTerminalAtTheirEnd) {
  Document document = rooms();
  document.projects[0].spaces[1].name = "2.03 Bedroom of the caretaker, facing the yard";
  const std::string text = rendered("text", document, {{.width = 60}});
  EXPECT_THAT(text, HasSubstr("✗ fail        2.03 Bedroom of the car…  1 of 2   412 ≥ 500\n"));
}

TEST(RoomSummary, StandsFirstInHtmlWithLinks) {
  const Document document = rooms();
  const std::string page = render_html(document);
  const std::size_t brief = page.find("<h2 id=\"rooms\">Rooms in brief</h2>");
  ASSERT_NE(brief, std::string::npos);
  EXPECT_LT(brief, page.find("id=\"attention\""));
  EXPECT_LT(brief, page.find("id=\"summary\""));
  EXPECT_THAT(page, HasSubstr("<a href=\"#p1s2\">Office</a>"));
  EXPECT_THAT(page, HasSubstr("<h3 id=\"p1s2\">"));
  EXPECT_THAT(rendered_index(document, "pages"),
              HasSubstr("<a href=\"pages/p1s2.html\">Office</a>"));
  EXPECT_THAT(render_html(small_document()), Not(HasSubstr("Rooms in brief")));
}

TEST(RoomSummary, StandsFirstInMarkdown) {
  EXPECT_THAT(rendered("markdown", rooms()),
              HasSubstr("| verdict | room | met | average lx |\n"
                        "| --- | --- | ---: | ---: |\n"
                        "| – not judged | Store | 1 of 2 | – ≥ 450 |\n"
                        "| ✗ fail | Office | 1 of 2 | 412 ≥ 500 |\n"));
}

}  // namespace
}  // namespace report
