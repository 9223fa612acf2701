#include "report/document/room_areas.h"

#include "report/document/room_summary.h"
#include "report/text/plain_text.h"
#include "report/text/room_overview.h"
#include "tests/support/rendered.h"
#include "tests/support/room_documents.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace report::room_areas_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// A plane that the project describes itself, of one average.
PlanePart own_plane(const std::string& id, const std::string& name, double lx, double limit_lx) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  plane.id = id;
  plane.name = name;
  plane.findings = {sample_finding(rules::Metric::average, limit_lx, estimate(lx, 0.5))};
  return plane;
}

// The task of a workplace, of an average and a Uo that passes.
PlanePart made_plane(const std::string& workplace, const std::string& name, double lx,
                     double limit_lx) {
  PlanePart plane = own_plane(workplace + ".task", name + ": task", lx, limit_lx);
  plane.made_by = calc::Message::words("workplace " + workplace);
  plane.findings.push_back(
      sample_finding(rules::Metric::uniformity_min_avg, 0.6, estimate(0.75, 0.01)));
  for (rules::Finding& finding : plane.findings)
    finding.requirement.origin.workplaces = {workplace};
  return plane;
}

SpacePart room(const std::string& id, const std::string& name, std::vector<PlanePart> planes) {
  SpacePart space = small_document().projects[0].spaces[0];
  space.id = id;
  space.name = name;
  space.planes = std::move(planes);
  return space;
}

// A classroom of tables that pass and a board that fails, and a store.
Document school() {
  Document document = small_document();
  document.projects[0].spaces = {room("r1", "Classroom",
                                      {made_plane("desks", "Pupils' tables", 520.0, 300.0),
                                       made_plane("board", "Board", 412.0, 500.0)}),
                                 room("r2", "Store", {own_plane("shelf", "Shelf", 460.0, 300.0)})};
  return document;
}

// The first room has that many planes of its own; all pass but the last one.
Document hall(std::size_t planes, const std::string& name = "Court ") {
  Document document = school();
  std::vector<PlanePart>& list = document.projects[0].spaces[0].planes;
  list.clear();
  for (std::size_t k = 0; k < planes; ++k) {
    const double lx = k + 1 == planes ? 200.0 : 520.0;
    list.push_back(own_plane("p" + std::to_string(k), name + std::to_string(k), lx, 300.0));
  }
  return document;
}

RoomSummary first_room(const Document& document) {
  return room_summaries(document.projects[0]).at(0);
}

rules::Finding& finding(Document& document, std::size_t plane, std::size_t k) {
  return document.projects[0].spaces[0].planes.at(plane).findings.at(k);
}

std::size_t times(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    ++count;
  return count;
}

TEST(RoomAreas, EachTaskHasItsVerdictAndItsValues) {
  Document document = school();
  const RoomSummary room = first_room(document);
  EXPECT_EQ(room.outcome, rules::Outcome::fail);
  ASSERT_EQ(room.areas.size(), 2u);
  const RoomArea &board = room.areas[0], &desks = room.areas[1];
  EXPECT_EQ(board.workplace, "board");
  EXPECT_EQ(board.outcome, rules::Outcome::fail);
  EXPECT_EQ(board.average, &finding(document, 1, 0));
  EXPECT_EQ(board.uniformity, &finding(document, 1, 1));
  EXPECT_EQ(board.met, 1);
  EXPECT_EQ(board.required, 2);
  EXPECT_EQ(desks.outcome, rules::Outcome::pass);
  EXPECT_EQ(desks.average, &finding(document, 0, 0));
  EXPECT_THAT(area_titles({}, room), ElementsAre("Board", "Pupils' tables"));
  EXPECT_TRUE(room_summaries(document.projects[0])[1].areas.empty()) << "one task";
}

// A wall or an eye that two workplaces share is of both.
TEST(RoomAreas, WhatTasksShareIsOfEach) {
  Document document = school();
  PlanePart eyes = own_plane("observer.1", "observer 1", 0.0, 0.0);
  eyes.derived = calc::DerivedQuantity::ugr;
  eyes.findings = {sample_finding(rules::Metric::maximum, 19, estimate(21.0, 0.1))};
  eyes.findings[0].requirement.comparison = rules::Comparison::at_most;
  eyes.findings[0].requirement.origin.is_of_own_role = false;
  eyes.findings[0].requirement.origin.workplaces = {"desks", "board"};
  eyes.findings[0].requirement.origin.pack = "own:1";
  eyes.findings[0].requirement.origin.row = "1";
  judge_again(eyes.findings[0]);
  document.projects[0].spaces[0].planes.push_back(eyes);
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u) << "eyes are no task";
  for (const RoomArea& area : room.areas) {
    EXPECT_EQ(area.outcome, rules::Outcome::fail);
    EXPECT_EQ(area.glare, &finding(document, 2, 0));
    EXPECT_TRUE(area.rows.empty()) << "its use is what asks of the task";
  }
}

TEST(RoomAreas, AdviceTakesNoPart) {
  Document document = school();
  finding(document, 1, 0).requirement.severity = rules::Severity::advice;
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  for (const RoomArea& area : room.areas) EXPECT_EQ(area.outcome, rules::Outcome::pass);
  finding(document, 1, 1).requirement.severity = rules::Severity::advice;
  EXPECT_TRUE(first_room(document).areas.empty()) << "nothing is asked of the board";
}

TEST(RoomAreas, WhatIsNotJudgedIsNoPassAndComesFirst) {
  Document document = school();
  PlanePart& desks = document.projects[0].spaces[0].planes[0];
  desks.is_computed = false;
  desks.points.clear();
  for (rules::Finding& one : desks.findings) one.verdict = rules::Verdict::not_judged;
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  EXPECT_EQ(room.areas[0].workplace, "desks");
  EXPECT_EQ(room.areas[0].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(room.areas[0].met, 0);
  for (const char* format : {"text", "markdown", "html", "xlsx"})
    EXPECT_FALSE(rendered(format, document).empty()) << format;
}

// What the project asks besides of a workplace's plane makes no second task of it.
TEST(RoomAreas, ARequirementOfTheProjectIsOfTheWorkplace) {
  Document document = school();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes[1].findings.push_back(sample_finding(rules::Metric::minimum, 300, estimate(250, 1)));
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  EXPECT_EQ(room.areas[0].minimum, &finding(document, 1, 2));
  planes.erase(planes.begin());
  EXPECT_TRUE(first_room(document).areas.empty());
}

// Nothing of it is lost where two rows ask of one plane.
TEST(RoomAreas, OfTwoRowsATaskHasTwoUses) {
  Document document = school();
  const RoomKind office{"", "34.2", 0, 0, 0}, hall{"", "9.1", 0, 0, 0};
  PlanePart plane = own_plane("work", "Desk", 0.0, 0.0);
  plane.findings = {room_finding(office, "a", rules::Metric::average, 500, estimate(412, 0.5)),
                    room_finding(hall, "b", rules::Metric::average, 100, estimate(412, 0.5)),
                    sample_finding(rules::Metric::ugr_table, 19, estimate(17, 0))};
  plane.findings[2].requirement.comparison = rules::Comparison::at_most;
  judge_again(plane.findings[2]);
  document.projects[0].spaces[0].planes = {plane};
  RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  EXPECT_THAT(area_titles({}, room), ElementsAre("Desk (34.2)", "Desk (9.1)"));
  EXPECT_EQ(room.areas[0].outcome, rules::Outcome::fail);
  EXPECT_EQ(room.areas[1].outcome, rules::Outcome::pass);
  for (const RoomArea& area : room.areas) EXPECT_EQ(area.glare, &finding(document, 0, 2));
  finding(document, 0, 1).requirement.origin.row = "34.2";
  EXPECT_TRUE(first_room(document).areas.empty());
  finding(document, 0, 1).requirement.origin.pack = "own:1";
  room = first_room(document);
  EXPECT_THAT(area_titles({}, room),
              ElementsAre("Desk (en12464-1:2021 34.2)", "Desk (own:1 34.2)"));
}

TEST(RoomAreas, OfOneNameTheyHaveTheirIds) {
  Document document = school();
  document.projects[0].spaces[0].planes = {made_plane("b1", "Board", 412.0, 500.0),
                                           made_plane("b2", "Board", 520.0, 500.0)};
  EXPECT_THAT(area_titles({}, first_room(document)), ElementsAre("Board (b1)", "Board (b2)"));
}

// EN 13201-2 is about footways; its carriageway is a part of the street all the same.
TEST(RoomAreas, TheCarriagewayOfAStreetIsOne) {
  Document document = school();
  SpacePart& street = document.projects[0].spaces[0];
  street.planes = {own_plane("street", "Carriageway", 12.0, 15.0),
                   own_plane("footway", "Footway", 12.0, 10.0)};
  finding(document, 0, 0).requirement.origin.is_of_own_role = false;
  EXPECT_TRUE(first_room(document).areas.empty()) << "as a wall of a room";
  street.road.emplace();
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  EXPECT_THAT(area_titles({}, room), ElementsAre("Carriageway", "Footway"));
  EXPECT_EQ(room.areas[0].average, &finding(document, 0, 0));
}

TEST(RoomAreas, AggregatesOfATaskCount) {
  Document document = school();
  rules::AggregateFinding both;
  both.space_id = "r1";
  both.verdict = rules::Verdict::not_judged;
  both.members.emplace_back().of = {{"desks.task", finding(document, 0, 0).requirement.id}};
  document.projects[0].aggregates = {both};
  const RoomSummary room = first_room(document);
  ASSERT_EQ(room.areas.size(), 2u);
  EXPECT_EQ(room.areas[0].workplace, "desks");
  EXPECT_EQ(room.areas[0].outcome, rules::Outcome::not_judged);
  EXPECT_EQ(room.areas[1].outcome, rules::Outcome::fail);
}

TEST(RoomAreas, StandBelowTheirRoomOnTheTerminal) {
  EXPECT_THAT(rendered("text", school()),
              HasSubstr("  verdict  room                 met  average lx           Uo\n"
                        "  ✗ FAIL   Classroom         3 of 4\n"
                        "  ✗ FAIL     Board           1 of 2   412 ≥ 500  0.75 ≥ 0.60\n"
                        "  ✓ pass     Pupils' tables  2 of 2   520 ≥ 300  0.75 ≥ 0.60\n"
                        "  ✓ pass   Store             1 of 1   460 ≥ 300\n"));
}

// A value that is of no task, such as of eyes that the project places, stays the room's.
TEST(RoomAreas, TheRoomKeepsWhatIsOfNoTask) {
  Document document = school();
  PlanePart eyes = own_plane("eyes", "Eyes", 0.0, 0.0);
  eyes.derived = calc::DerivedQuantity::ugr;
  eyes.findings = {sample_finding(rules::Metric::maximum, 19, estimate(16.0, 0.1))};
  eyes.findings[0].requirement.comparison = rules::Comparison::at_most;
  judge_again(eyes.findings[0]);
  document.projects[0].spaces[0].planes.push_back(eyes);
  const RoomOverview table = room_overview({}, document.projects[0]);
  const auto glare = static_cast<std::size_t>(
      std::find(table.columns.begin(), table.columns.end(), RoomOverview::Column::glare) -
      table.columns.begin());
  ASSERT_LT(glare, table.columns.size());
  EXPECT_THAT(table.rows[0].cells[glare], HasSubstr("≤ 19"));
  EXPECT_EQ(table.rows[1].cells[glare], "");
  EXPECT_TRUE(table.rows[1].is_area);
}

TEST(RoomAreas, AreNotAllOfARoomAndTheWorstIsFirst) {
  const Document document = hall(1000);
  const RoomOverview table = room_overview({}, document.projects[0]);
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[1].cells[1], "Court 999") << "what fails is in sight";
  EXPECT_EQ(table.rows[1].outcome, rules::Outcome::fail);
  EXPECT_EQ(table.rows[2].cells[1], "Court 0");
  EXPECT_EQ(table.rows[4].cells[1], "and 997 more");
  EXPECT_EQ(table.rows[4].outcome, rules::Outcome::pass);
  EXPECT_EQ(table.rows[5].cells[1], "Store");
  EXPECT_FALSE(table.rows[5].is_area);
}

TEST(RoomAreas, FurtherOnesHaveTheGravestVerdict) {
  Document document = hall(10);
  for (PlanePart& plane : document.projects[0].spaces[0].planes) {
    plane.findings[0].measured = estimate(100.0, 0.5);
    judge_again(plane.findings[0]);
  }
  const FurtherAreas further = further_areas(first_room(document));
  EXPECT_EQ(further.count, 4u);
  EXPECT_EQ(further.outcome, rules::Outcome::fail);
}

// A single area left would take the line that says so.
TEST(RoomAreas, ThreeOfThemHaveALineIfAllOthersPass) {
  EXPECT_EQ(shown_areas(first_room(hall(10))), 3u);
  EXPECT_EQ(shown_areas(first_room(hall(4))), 4u);
  Document document = hall(10);
  for (std::size_t k = 0; k < 4; ++k) {  // and the last fails, too
    rules::Finding& finding = document.projects[0].spaces[0].planes[k].findings[0];
    finding.measured = estimate(100.0, 0.5);
    judge_again(finding);
  }
  EXPECT_EQ(shown_areas(first_room(document)), 5u);
}

TEST(RoomAreas, FitTheTerminal) {
  FormatStyle style;
  for (const int width : {60, 80, 120, 200}) {
    style.terminal.width = width;
    for (const std::string& name : {std::string("Court "), std::string(20'000, 'x')}) {
      const std::string text = rendered("text", hall(8, name), style);
      EXPECT_THAT(text, HasSubstr("    and 5 more"));
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        EXPECT_LE(display_width(line), static_cast<std::size_t>(width)) << line.substr(0, 300);
    }
  }
}

TEST(RoomAreas, OfOneTaskNothingChanges) {
  const Document document = many_rooms_document(12);
  const ProjectPart& project = document.projects[0];
  const RoomOverview shown = room_overview({}, project, 2, AreaLines::shown),
                     folded = room_overview({}, project, 2, AreaLines::folded);
  ASSERT_EQ(shown.rows.size(), 12u);
  ASSERT_EQ(folded.rows.size(), 12u);
  for (std::size_t k = 0; k < shown.rows.size(); ++k)
    EXPECT_EQ(shown.rows[k].cells, folded.rows[k].cells);
}

TEST(RoomAreas, StandBelowTheirRoomInMarkdown) {
  EXPECT_THAT(rendered("markdown", school()),
              HasSubstr("| ✗ fail | Classroom | 3 of 4 |  |  |\n"
                        "| ✗ fail | &emsp;Board | 1 of 2 | 412 ≥ 500 | 0.75 ≥ 0.60 |\n"
                        "| ✓ pass | &emsp;Pupils' tables | 2 of 2 | 520 ≥ 300 | 0.75 ≥ 0.60 |\n"
                        "| ✓ pass | Store | 1 of 1 | 460 ≥ 300 |  |\n"));
}

// Of very many rooms only whole ones are shown.
TEST(RoomAreas, MarkdownCutsBetweenRooms) {
  Document document = school();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  const SpacePart classroom = spaces[0];
  spaces.clear();
  for (int k = 0; k < 40; ++k) {
    spaces.push_back(classroom);
    spaces.back().id = "c" + std::to_string(k);
  }
  const std::string text = rendered("markdown", document);
  EXPECT_EQ(times(text, "| &emsp;Board |"), 33u);
  EXPECT_EQ(times(text, "| &emsp;Pupils' tables |"), 33u);
  EXPECT_THAT(text, HasSubstr("\n7 more are not listed here.\n"));
}

TEST(RoomAreas, StandBelowTheirRoomInHtml) {
  FormatStyle client;
  client.page.detail = Detail::client;
  for (const std::string& page : {render_html(school()), rendered("html", school(), client)}) {
    const std::size_t classroom = page.find("\">Classroom</a></th>"),
                      board = page.find("font-weight: 400\">Board</th>"),
                      desks = page.find("font-weight: 400\">Pupils&#39; tables</th>"),
                      store = page.find("\">Store</a></th>");
    ASSERT_NE(classroom, std::string::npos);
    EXPECT_LT(classroom, board);
    EXPECT_LT(board, desks);
    EXPECT_LT(desks, store);
    EXPECT_NE(store, std::string::npos);
  }
  EXPECT_THAT(render_html(many_rooms_document(3)), Not(HasSubstr("font-weight: 400\"")));
  EXPECT_THAT(rendered("html", hall(9), client), HasSubstr("and 6 more</th>"));
}

TEST(RoomAreas, DxfHasOneLineForARoom) {
  const RoomOverview table = room_overview({}, school().projects[0], 1, AreaLines::folded);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(table.rows[0].cells, testing::Contains("412 ≥ 500"));
}

TEST(RoomAreas, WhoseTheValuesOfALineAreIsSaid) {
  Document document = school();
  EXPECT_EQ(owners_of_values({}, first_room(document)), "average Board, Uo Pupils' tables");
  finding(document, 1, 1).measured = estimate(0.7, 0.01);
  judge_again(finding(document, 1, 1));
  EXPECT_EQ(owners_of_values({}, first_room(document)), "Board");
  EXPECT_EQ(owners_of_values({}, room_summaries(document.projects[0])[1]), "");
}

TEST(RoomAreas, ResultsAreReadAsBefore) {
  EXPECT_THAT(rendered("json", school()), Not(HasSubstr("\"areas\"")));
}

}  // namespace
}  // namespace report::room_areas_test
