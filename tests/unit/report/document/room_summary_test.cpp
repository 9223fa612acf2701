#include "report/document/room_summary.h"

#include "calc/base/sentences.h"
#include "report/html/page/html.h"
#include "report/text/plain_text.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

// What several planes of a room miss alike is one cause; what cannot be judged is one by its
// reason.
TEST(RoomSummary, CausesAreWhatIsMissingAndNotEachPlane) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  office.planes.push_back(office.planes[0]);
  office.planes[1].id = "wall";
  set_average(office.planes[1].findings[0], 300.0);
  for (const PlanePart& plane : {office.planes[0], office.planes[1]}) {
    PlanePart& unlit = office.planes.emplace_back(plane);
    for (rules::Finding& one : unlit.findings) {
      one.verdict = rules::Verdict::not_judged;
      one.reason = calc::Message::words("no light");
    }
  }
  office.planes.back().findings.back().reason = calc::Message::words("no point");
  const auto list = room_summaries(document.projects[0]);
  EXPECT_TRUE(list[0].causes.empty());
  const std::vector<RoomCause>& causes = list[1].causes;
  ASSERT_EQ(causes.size(), 3U);
  EXPECT_EQ(causes[0].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(causes[0].parts.size(), 3U) << "one reason";
  EXPECT_EQ(causes[1].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(causes[1].parts.size(), 1U) << "another";
  EXPECT_EQ(causes[2].outcome, rules::Outcome::fail);
  ASSERT_EQ(causes[2].parts.size(), 2U);
  EXPECT_EQ(causes[2].worst().plane->id, "wall");
}

// The worst value may be a wall's.
TEST(RoomSummary, TheTaskHasItsOwnCauseBeforeAllOthers) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  office.planes.push_back(office.planes[0]);
  office.planes[1].id = "wall";
  set_average(office.planes[1].findings[0], 53.0);
  office.planes[1].findings[0].requirement.origin.is_of_own_role = false;
  std::swap(office.planes[0], office.planes[1]);
  const auto list = room_summaries(document.projects[0]);
  ASSERT_EQ(list[1].causes.size(), 2U);
  EXPECT_EQ(list[1].causes[0].worst().finding->measured.value, 412.0);
  EXPECT_EQ(list[1].causes[1].worst().plane->id, "wall");
}

// A dimmer does not mend a ratio.
TEST(RoomSummary, NoFactorWhereUniformityFailsToo) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  rules::Finding& uniformity = finding(office, 1);
  uniformity.requirement.metric = rules::Metric::uniformity_min_avg;
  uniformity.requirement.limit = 0.6;
  set_average(uniformity, 0.7, 0.01);
  EXPECT_THAT(rendered("text", document), HasSubstr("flux of all luminaires ×"));
  set_average(uniformity, 0.3, 0.01);
  EXPECT_THAT(rendered("text", document), Not(HasSubstr("flux of all luminaires ×")));
  EXPECT_THAT(rendered("text", document), HasSubstr("uniformity fails, too."));
  uniformity.requirement.scene = "night";  // another light
  EXPECT_THAT(rendered("text", document), HasSubstr("flux of all luminaires ×"));
}

// Each with its value: two percentiles are not one failure, and neither are two of one plane.
TEST(RoomSummary, CausesHideNoValue) {
  Document document = rooms();
  SpacePart& office = document.projects[0].spaces[1];
  set_average(finding(office, 1), 300.0);
  EXPECT_EQ(room_summaries(document.projects[0])[1].causes.size(), 2U);
  office.planes.push_back(office.planes[0]);
  office.planes[1].id = "other";
  for (PlanePart& plane : office.planes) {
    for (rules::Finding& one : plane.findings) {
      one.requirement.metric = rules::Metric::percentile;
      one.requirement.arguments = rules::Percentile{10.0};
    }
  }
  EXPECT_EQ(room_summaries(document.projects[0])[1].causes.size(), 4U);
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("412 ± 1 lx, required ≥ 500 lx"));
  EXPECT_THAT(text, HasSubstr("300 ± 1 lx, required ≥ 450 lx"));
}

// Points that a project's own mask leaves out are no matter of course.
TEST(RoomSummary, NotesHaveMasksThatNoStandardMakes) {
  Document document = rooms();
  rules::Requirement& requirement = finding(document.projects[0].spaces[0], 0).requirement;
  requirement.mask.id = "inner";
  requirement.clause = {};
  EXPECT_THAT(rendered("text", document), HasSubstr("· Hall / Work plane: mask inner"));
  requirement.origin.pack = "en12464-1:2021";
  EXPECT_THAT(rendered("text", document), Not(HasSubstr("mask inner")));
}

// A doubt of one plane names it, however many requirements it has.
TEST(RoomSummary, NotesNameTheirPlaces) {
  Document document = rooms();
  for (const std::size_t r : {0U, 2U}) {
    for (rules::Finding& one : document.projects[0].spaces[r].planes[0].findings)
      one.is_close = true;
  }
  EXPECT_THAT(rendered("text", document),
              HasSubstr("· Hall / Work plane, Store / Work plane: close: "));
}

TEST(RoomSummary, CausesTakeNoAdviceAndTellWhatIsWaived) {
  Document document = rooms();
  rules::Finding& failed = finding(document.projects[0].spaces[1], 0);
  failed.requirement.severity = rules::Severity::advice;
  EXPECT_TRUE(room_summaries(document.projects[0])[1].causes.empty());
  EXPECT_THAT(rendered("text", document), HasSubstr("is outside the recommended range"));
  failed.requirement.severity = rules::Severity::shall;
  failed.is_waived = true;
  const auto list = room_summaries(document.projects[0]);
  ASSERT_EQ(list[1].causes.size(), 1U);
  EXPECT_EQ(list[1].causes[0].outcome, rules::Outcome::waived);
  EXPECT_THAT(rendered("text", document), HasSubstr("Waived\n  Office\n"));
}

// Of several rooms the terminal says why and not each requirement; --passes has them all.
TEST(RoomSummary, CausesStandBelowTheRoomsOnTheTerminal) {
  Document document = rooms();
  document.projects[0].spaces.push_back(room("r4", "Annex"));
  document.projects[0].spaces[3].planes[0] = document.projects[0].spaces[1].planes[0];
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("Not met\n  Office, Annex\n    "));
  EXPECT_THAT(text, HasSubstr("required ≥ 500 lx\n    └ The flux of all luminaires ×"));
  EXPECT_THAT(text, Not(HasSubstr("room / plane")));
  FormatStyle style;
  style.terminal.lists_passes = true;
  EXPECT_THAT(rendered("text", document, style), HasSubstr("room / plane"));
}

TEST(RoomSummary, StandsFirstOnTheTerminalAndNamesRoomsAtTheEnd) {
  const std::string text = rendered("text", rooms());
  EXPECT_THAT(text, HasSubstr("  verdict       room       met  average lx\n"
                              "  – not judged  Store   1 of 2     – ≥ 450\n"
                              "  ✗ FAIL        Office  1 of 2   412 ≥ 500\n"
                              "  ✓ pass        Hall    2 of 2   460 ≥ 450\n"));
  EXPECT_THAT(text, HasSubstr("1 room fails: Office · 1 room not judged: Store\n"));
  EXPECT_THAT(rendered("text", small_document()), Not(HasSubstr("room fails")));
  Document passing = rooms();
  passing.projects[0].spaces = {room("r1", "Hall"), room("r2", "Office")};
  EXPECT_TRUE(rendered("text", passing).ends_with("4 requirements: 4 pass\n"));
}

TEST(RoomSummary, WhatFailsInARoomThatIsNotJudgedIsNamedAsWell) {
  Document document = rooms();
  set_average(finding(document.projects[0].spaces[2], 0), 412.0);
  EXPECT_EQ(room_summaries(document.projects[0])[2].outcome, rules::Outcome::not_judged);
  EXPECT_THAT(rendered("text", document),
              HasSubstr("2 rooms fail: Office, Store · 1 room not judged: Store\n"));
}

// What is least required says more than what is most allowed, unless that is what fails.
TEST(RoomSummary, OfTwoLimitsThatAreMetTheLeastIsShown) {
  Document document = rooms();
  SpacePart& hall = document.projects[0].spaces[0];
  finding(hall, 1).requirement.comparison = rules::Comparison::at_most;
  finding(hall, 1).requirement.limit = 601.0;
  set_average(finding(hall, 1), 600.0);
  EXPECT_EQ(room_summaries(document.projects[0])[0].average, &finding(hall, 0));
  set_average(finding(hall, 1), 640.0);
  EXPECT_EQ(room_summaries(document.projects[0])[0].average, &finding(hall, 1));
}

// Nobody mends it by more light of the others.
TEST(RoomSummary, WhatFailsForMissingLightHasNoFactor) {
  Document document = rooms();
  EXPECT_THAT(rendered("text", document), HasSubstr("flux of all luminaires"));
  finding(document.projects[0].spaces[1], 0).reason =
      calc::say<calc::Sentence::light_is_lost>("L7");
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("'L7' is wholly or partly outside the room"));
  EXPECT_THAT(text, Not(HasSubstr("flux of all luminaires")));
}

TEST(RoomSummary, ARoadHasItsLuminanceThoughItsRoleIsAnother) {
  Document document = rooms();
  SpacePart& street = document.projects[0].spaces[0];
  rules::Finding& luminance = finding(street, 0);
  luminance.requirement.metric = rules::Metric::road_luminance;
  luminance.requirement.origin.is_of_own_role = false;
  luminance.requirement.limit = 0.75;
  set_average(luminance, 0.76, 0.001);
  EXPECT_EQ(room_summaries(document.projects[0])[0].average, &luminance);
  EXPECT_THAT(rendered("text", document), HasSubstr(" L 0.760 ≥ 0.75\n"));
}

// Names give way, then power and counts; values never.
TEST(RoomSummary, FitsTheTerminal) {
  Document document = rooms();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  for (int i = 0; i < 20; ++i) {
    spaces.push_back(room("n" + std::to_string(i), "Meeting room on the upper floor, north"));
    set_average(finding(spaces.back(), 0), 505.0 + i, 9.0);
    spaces.back().power.power_w = 100.0;
    spaces.back().power.area_m2 = 20.0;
  }
  FormatStyle style;
  for (const int width : {60, 80, 120, 200}) {
    style.terminal.width = width;
    std::istringstream lines(rendered("text", document, style));
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(display_width(line), static_cast<std::size_t>(width)) << line;
    }
  }
  style.terminal.width = 60;
  EXPECT_THAT(rendered("text", document, style), HasSubstr("±9 ≥ 500"));
}

// One side of an interval must not seem to reach over the limit.
TEST(RoomSummary, AWideUpperEndMakesNoDoubt) {
  Document document = rooms();
  rules::Finding& one = finding(document.projects[0].spaces[1], 0);
  one.measured = {505.0, 501.0, 530.0};
  judge_again(one);
  EXPECT_EQ(one.verdict, rules::Verdict::pass);
  EXPECT_THAT(rendered("text", document), HasSubstr("505 (501 to 530) ≥ 500"));
  one.measured = {505.0, 490.0, 506.0};
  judge_again(one);
  EXPECT_THAT(rendered("text", document), HasSubstr("505 ±15 ≥ 500"));
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
  EXPECT_THAT(text, HasSubstr("460 ±9 ≥ 450"));
}

TEST(RoomSummary, ARoomWhoseRowRequiresNothingIsThere) {
  Document document = rooms();
  SpacePart& hall = document.projects[0].spaces[0];
  for (PlanePart& plane : hall.planes) plane.findings.clear();
  EXPECT_EQ(room_summaries(document.projects[0]).size(), 2u);
  hall.coverage = {{"desk", calc::Message::words("EN 1:2021 2"), {}}};
  const std::vector<RoomSummary> summaries = room_summaries(document.projects[0]);
  ASSERT_EQ(summaries.size(), 3u);
  EXPECT_EQ(summaries[0].outcome, rules::Outcome::nothing_asked);
  EXPECT_EQ(summaries[0].required, 0);
  EXPECT_THAT(rendered("text", document), HasSubstr("nothing is required"));
}

// An escape route has no other value.
TEST(RoomSummary, NarrowTerminalsKeepAMinimumThatIsAllARoomHas) {
  Document document = rooms();
  SpacePart& route = document.projects[0].spaces[0];
  rules::Finding& minimum = finding(route, 1);
  minimum.requirement.metric = rules::Metric::minimum;
  rules::Finding& uniformity = finding(document.projects[0].spaces[1], 1);
  uniformity.requirement.metric = rules::Metric::uniformity_min_avg;
  FormatStyle style;
  style.terminal.width = 50;
  EXPECT_THAT(rendered("text", document, style), Not(HasSubstr("  minimum lx")));
  route.planes[0].findings.erase(route.planes[0].findings.begin());
  EXPECT_THAT(rendered("text", document, style), HasSubstr("  minimum lx"));
}

TEST(RoomSummary, OfSeveralProjectsRoomsAreNamedWithTheirs) {
  Document document = rooms();
  document.projects[0].path = "a.xml";
  ProjectPart broken;
  broken.path = "b.xml";
  document.projects.push_back(broken);
  EXPECT_THAT(rendered("text", document),
              HasSubstr("1 room fails: a.xml: Office · 1 room not judged: a.xml: Store · 1 project "
                        "not judged: b.xml\n"));
}

TEST(RoomSummary, NamesGiveWayToANarrowTerminalInTheirMiddle) {
  Document document = rooms();
  document.projects[0].spaces[1].name = "2.03 Bedroom of the caretaker, facing the yard";
  const std::string text = rendered("text", document, {{.width = 60}});
  EXPECT_THAT(text, HasSubstr("✗ FAIL        2.03 Bedroom of …he yard  1 of 2   412 ≥ 500\n"));
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
