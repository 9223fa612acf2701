#include "report/html/client/client_page.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/message.h"
#include "report/document/room_lines.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string client_html(const Document& document, Texts t = {}) {
  FormatStyle style;
  style.texts = t;
  style.page.detail = Detail::client;
  return rendered("html", document, style);
}

// A room whose three walls are asked the same, as a workplace would have made them.
Document walls() {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  PlanePart wall = space.planes[0];
  wall.findings.resize(1);
  wall.findings[0].requirement.limit = 50.0;
  space.planes.clear();
  rules::RowCoverage row;
  row.workplace = "use";
  row.roles.push_back({"wall", rules::RoleState::met, {}, {}, {}});
  const double values[] = {90.0, 70.0, 80.0};
  for (std::size_t k = 0; k < 3; ++k) {
    wall.id = "wall." + std::to_string(k + 1);
    wall.name = "Wall " + std::to_string(k + 1);
    wall.findings[0].requirement.plane_id = wall.id;
    wall.findings[0].measured = estimate(values[k], 0.5);
    judge_again(wall.findings[0]);
    row.roles[0].of.push_back({wall.id, wall.findings[0].requirement.id});
    space.planes.push_back(wall);
  }
  space.coverage = {row};
  return document;
}

TEST(RoomLines, WallsThatPassAlikeAreOneLineAndTheWorstIsNamed) {
  const Document document = walls();
  const auto lines = room_lines(document.projects[0].spaces[0]);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].role, "wall");
  EXPECT_EQ(lines[0].parts.size(), 3u);
  EXPECT_EQ(lines[0].worst().plane->name, "Wall 2");
}

TEST(RoomLines, WhatFailsIsCloseWaivedOrAskedOtherwiseHasItsOwnLine) {
  Document document = walls();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes[1].findings[0].measured = estimate(40.0, 0.5);
  judge_again(space.planes[1].findings[0]);
  EXPECT_EQ(room_lines(space).size(), 2u) << "a failure is not hidden among passes";
  space.planes[2].findings[0].is_close = true;
  EXPECT_EQ(room_lines(space).size(), 3u);
  space.planes[2].findings[0].is_close = false;
  space.planes[2].findings[0].requirement.limit = 60.0;
  EXPECT_EQ(room_lines(space).size(), 3u);
  space.planes[2].findings[0].requirement.limit = 50.0;
  space.planes[2].findings[0].is_waived = true;
  EXPECT_EQ(room_lines(space).size(), 3u);
  space.coverage.clear();
  EXPECT_EQ(room_lines(space).size(), 3u) << "planes without a role stay apart";
}

TEST(RoomLines, OfOneReasonAreOneLine) {
  Document document = walls();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes[1].findings[0].reason = calc::Message::words("no luminaire in view");
  EXPECT_EQ(room_lines(space).size(), 2u);
  space.planes[2].findings[0].reason = space.planes[1].findings[0].reason;
  EXPECT_EQ(room_lines(space).size(), 2u);
  space.planes[2].findings[0].reason = calc::Message::words("another reason");
  EXPECT_EQ(room_lines(space).size(), 3u);
}

TEST(ClientPage, IsRoomFirstAndWithoutWhatOnlyACheckerNeeds) {
  Document document = walls();
  document.provenance.command_line = "luxgate check secret-path.xml";
  const std::string html = client_html(document);
  for (const char* words : {"<div class=\"cover\">", "Contents", "class=\"client-room\"",
                            "Walls (3)", "Wall 2", "How to read this report", "full report"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, Not(HasSubstr("secret-path")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_LT(html.find("Contents"), html.find("class=\"client-room\""));
}

TEST(ClientPage, SaysWhatIsNotMetBeforeTheTableAndKeepsDoubts) {
  Document document = walls();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes[1].findings[0].measured = estimate(40.0, 0.5);
  judge_again(space.planes[1].findings[0]);
  space.planes[0].single_sample_points = 2;
  const std::string html = client_html(document);
  const std::size_t cause = html.find("class=\"attention\"");
  ASSERT_NE(cause, std::string::npos);
  EXPECT_LT(cause, html.find("class=\"findings\""));
  EXPECT_THAT(html, HasSubstr(doubt_words(space.planes[0])));
}

TEST(ClientPage, HasWarningsBehindAllElse) {
  Document document = walls();
  document.projects[0].diagnostics.clear();
  calc::Diagnostic warning{};
  warning.id = calc::DiagnosticId::rooms_overlap;
  warning.message = "they share space";
  document.projects[0].diagnostics = {warning};
  const std::string html = client_html(document);
  EXPECT_THAT(html, HasSubstr("rooms-overlap"));
  EXPECT_THAT(html, HasSubstr("For the author of the project."));
  EXPECT_GT(html.find("they share space"), html.find("How to read this report</h2>"));
  EXPECT_THAT(html, HasSubstr("(<a href=\"#messages\">see Messages</a>)"));
  EXPECT_THAT(html, HasSubstr("<div id=\"messages\">"));
}

TEST(ClientPage, NamesEveryRowThatARoomIsAskedBy) {
  Document document = walls();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  for (PlanePart& plane : planes) {
    plane.findings[0].requirement.clause = calc::Message::words("EN 1 44.1");
    plane.findings[0].requirement.origin.pack = "en1";
  }
  EXPECT_THAT(client_html(document), HasSubstr("<p class=\"quiet\">EN 1 44.1</p></header>"));
  EXPECT_THAT(client_html(document), Not(HasSubstr("<span class=\"note\">EN 1 44.1</span>")));
  planes[2].findings[0].requirement.clause = calc::Message::words("EN 1 44.4.1");
  const std::string html = client_html(document);
  EXPECT_THAT(html, HasSubstr("<p class=\"quiet\">EN 1 44.1, EN 1 44.4.1</p></header>"));
  for (const char* clause : {"44.1", "44.4.1"})
    EXPECT_THAT(html, HasSubstr("<span class=\"note\">" + std::string(clause) + "</span>"));
}

TEST(ClientPage, RoomsFollowStoreysAndThenNames) {
  Document document = walls();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  spaces.resize(1);
  const char* names[] = {"Room 201", "Room 10", "Room 9"};
  const double floors_m[] = {3.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) spaces.push_back(spaces[0]);
    const double x = 10.0 * static_cast<double>(i);
    spaces[i].id = spaces[i].name = names[i];
    spaces[i].floor_z_m = floors_m[i];
    spaces[i].footprint_m = {{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}};
  }
  const std::string html = client_html(document);
  const auto chapter = [&](const char* name) {
    return html.find(name, html.find("class=\"client-room\""));
  };
  EXPECT_LT(chapter("Room 9"), chapter("Room 10"));
  EXPECT_LT(chapter("Room 10"), chapter("Room 201"));
}

TEST(ClientPage, IsInTheReadersLanguage) {
  const std::string html = client_html(walls(), Texts(Language::german, true));
  EXPECT_THAT(html, HasSubstr("Wände (3)"));
  EXPECT_THAT(html, HasSubstr("<html lang=\"de\">"));
}

}  // namespace
}  // namespace report
