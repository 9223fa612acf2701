#include "report/html/client/client_page.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/room_lines.h"
#include "report/text/words.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

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
  EXPECT_GT(html.find("they share space"), html.find("How to read this report</h2>"));
}

TEST(ClientPage, IsInTheReadersLanguage) {
  const std::string html = client_html(walls(), Texts(Language::german, true));
  EXPECT_THAT(html, HasSubstr("Wände (3)"));
  EXPECT_THAT(html, HasSubstr("<html lang=\"de\">"));
}

}  // namespace
}  // namespace report
