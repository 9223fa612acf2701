#include "report/html/client/client_positions.h"

#include "report/document/luminaire_labels.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <cstddef>
#include <string>

namespace report::client_positions_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr glm::dvec3 kDown{0, 0, -1};

// So many rooms beside each other, with so many luminaires each, 2.5 m above the floor.
ProjectPart project(int rooms, int luminaires) {
  ProjectPart part = small_document().projects[0];
  part.luminaires.resize(1);
  part.luminaires[0].type_id = "panel";
  part.luminaires[0].count = rooms * luminaires;
  const SpacePart sample = part.spaces[0];
  part.spaces.clear();
  for (int r = 0; r < rooms; ++r) {
    SpacePart& space = part.spaces.emplace_back(sample);
    const double x = 5.0 * r;
    space.id = space.name = fmt::format("Room <{}>", r + 1);
    space.footprint_m = {{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}};
    space.floor_z_m = 0.5;
    for (int k = 0; k < luminaires; ++k) {
      LuminaireMark mark{{x + 1.0 + 0.25 * k, 1.5, 3.0}, "panel"};
      mark.axis = kDown;
      space.luminaires.push_back(mark);
    }
  }
  label_luminaires(part);
  return part;
}

std::size_t count(const std::string& html, const std::string& words) {
  std::size_t found = 0;
  for (std::size_t at = html.find(words); at != std::string::npos; at = html.find(words, at + 1))
    ++found;
  return found;
}

TEST(ClientPositions, HaveMarkPlaceAndHeight) {
  const ClientPositions positions = client_positions({}, project(2, 3), false);
  EXPECT_TRUE(pugi::xml_document().load_string(positions.html.c_str())) << positions.html;
  EXPECT_EQ(positions.listed, 6u);
  EXPECT_THAT(positions.html,
              HasSubstr("<th scope=\"row\">A5</th><td class=\"num\">6.25</td><td class=\"num\">"
                        "1.50</td><td class=\"num\">2.50</td>"));
  EXPECT_THAT(positions.html, HasSubstr("Room &lt;2&gt;"));
  EXPECT_THAT(positions.html, HasSubstr("x m"));
  EXPECT_THAT(positions.html, Not(HasSubstr("Tilt"))) << "all shine straight down";
  EXPECT_THAT(positions.html, Not(HasSubstr("this part of the project")));
  EXPECT_THAT(client_positions({}, project(2, 3), true).html,
              HasSubstr("this part of the project"));
}

TEST(ClientPositions, SayWhereOthersAim) {
  ProjectPart part = project(1, 3);
  part.spaces[0].luminaires[1].axis = {0.6, 0, -0.8};
  part.spaces[0].luminaires[2].axis = {};
  const std::string html = client_positions({}, part, false).html;
  EXPECT_THAT(html, HasSubstr("36.9° → 0.0°"));
  EXPECT_THAT(html, HasSubstr("<td class=\"num\">–</td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"num\"></td>"));
  EXPECT_THAT(html, HasSubstr("Tilt"));
}

TEST(ClientPositions, SixtyLuminairesFitOnAPage) {
  constexpr std::size_t kMostLines = 66;
  for (const auto& [rooms, luminaires] : {std::pair{1, 60}, std::pair{10, 6}, std::pair{60, 1}}) {
    ProjectPart part = project(rooms, luminaires);
    part.spaces[0].luminaires[0].axis = {0.6, 0, -0.8};
    const std::string html = client_positions({}, part, false).html;
    EXPECT_LE(count(html, "<tr"), kMostLines) << rooms;
    EXPECT_EQ(count(html, "<th scope=\"row\">"), 60u);
  }
  const std::string by_storey = client_positions({}, project(60, 1), false).html;
  EXPECT_THAT(by_storey, HasSubstr("Storey at +0.50 m"));
  EXPECT_LT(by_storey.find(">A9<"), by_storey.find(">A10<"));
}

TEST(ClientPositions, OfHundredsTheRestIsCounted) {
  const ClientPositions positions = client_positions({}, project(1, 450), false);
  EXPECT_EQ(positions.listed, kMostClientPositions);
  EXPECT_EQ(count(positions.html, "<th scope=\"row\">"), kMostClientPositions);
  EXPECT_THAT(positions.html, HasSubstr("250 of 450 luminaires are not listed here"));
  EXPECT_THAT(positions.html, HasSubstr("luminaires-csv"));
  const ClientPositions none = client_positions({}, project(1, 5), false, 0);
  EXPECT_THAT(none.html, HasSubstr("5 of 5 luminaires are not listed"));
  EXPECT_THAT(none.html, Not(HasSubstr("<table")));
}

// A road in the open, a name of a book's length, places that no building has.
TEST(ClientPositions, StrangeProjectsDoNotMakeThePageWide) {
  ProjectPart part = project(2, 2);
  part.spaces[0].footprint_m.clear();
  part.spaces[0].name = std::string(20'000, 'x');
  part.spaces[0].luminaires[0].position_m = {1e300, -1e300, 8.0};
  part.spaces[1].luminaires[0].type_id = "unknown";
  label_luminaires(part);
  const std::string html = client_positions({}, part, false).html;
  EXPECT_LT(html.size(), 5000u);
  EXPECT_THAT(html, HasSubstr(">8.00<")) << "above z = 0";
  EXPECT_EQ(client_positions({}, project(2, 0), false).html, "");
}

TEST(ClientPositions, FollowTheScheduleAndAllProjectsShareTheLines) {
  Document document = small_document();
  document.projects = {project(1, 150), project(1, 100)};
  FormatStyle style;
  style.page.detail = Detail::client;
  const std::string html = rendered("html", document, style);
  EXPECT_LT(html.find("class=\"schedule\""), html.find("class=\"client-positions\""));
  EXPECT_EQ(count(html, "class=\"client-positions\""), 2u);
  EXPECT_THAT(html, HasSubstr("50 of 100 luminaires are not listed here"));
}

}  // namespace
}  // namespace report::client_positions_test
