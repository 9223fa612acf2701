// The figures of a room, against hand-made ones.
#include "report/html/room/html_room_data.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace report::html_room_data_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// 5 m x 4 m, four walls, two panels of 30 W, a plane of the whole floor with 500 lx +- 10.
Document office() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.materials = {{"white", 0.7}, {"dark", 0.2}, {"oak", 0.35}};
  SpacePart& space = project.spaces[0];
  space.footprint_m = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
  space.floor_z_m = 10.0;
  space.height_m = 2.8;
  space.finishes = {{"floor", "dark"},  {"ceiling", "white"}, {"wall1", "white"},
                    {"wall2", "white"}, {"wall3", "white"},   {"wall4", "white"}};
  space.bodies = {{"desk", 10.0, 10.7, {}, "oak"}, {"chair", 10.0, 10.5, {}, "oak, dark"}};
  LuminaireMark mark{{1.5, 2.0, 12.8}, "panel"};
  mark.id = "L.1";
  mark.group = "window";
  mark.axis = {0, 0, -1};
  mark.c0 = {0, -1, 0};
  space.luminaires = {mark, {{3.5, 2.0, 12.8}, "panel"}};
  space.luminaires[0].label = "A7";
  space.power = {60.0, 20.0, 2, 0};
  PlanePart& plane = space.planes[0];
  plane.average = {500.0, 490.0, 510.0};
  return document;
}

std::string shown(const Document& document, Language language = Language::english) {
  const ProjectPart& project = document.projects[0];
  return html_room_data(Texts(language, language == Language::german), project, project.spaces[0]);
}

TEST(HtmlRoomData, TellsSizeSurfacesAndPower) {
  const std::string html = shown(office());
  for (const char* words :
       {"5.00 × 4.00 m, 2.80 m high", "20.00 m²", "Floor, reflectance</th><td>dark 0.20",
        "Walls, reflectance</th><td>white 0.70", "Objects, reflectance</th><td>oak 0.35, dark 0.20",
        "2 × panel", "60.0 W", "3.00 W/m²", "relative to the average of Work plane"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, HasSubstr("0.600"));  // 3 W/m² by 5 times 100 lx
  EXPECT_THAT(html, Not(HasSubstr("not a rectangle")));
  EXPECT_THAT(shown(office(), Language::german), HasSubstr("5,00 × 4,00 m, 2,80 m hoch"));
}

TEST(HtmlRoomData, WallsOfOtherMaterialsAreTold) {
  Document document = office();
  document.projects[0].spaces[0].finishes[4].materials = "dark";
  const std::string html = shown(document);
  EXPECT_THAT(html, HasSubstr("Wall 3, reflectance</th><td>dark 0.20"));
  EXPECT_THAT(html, HasSubstr("Wall 4, reflectance</th><td>white 0.70"));
}

TEST(HtmlRoomData, TellsWhereLuminairesAreAndHowTheyAreTurned) {
  const std::string html = shown(office());
  EXPECT_THAT(html, HasSubstr("Positions of luminaires: 2"));
  // The height is above the floor, C0 to -y.
  EXPECT_THAT(html,
              HasSubstr("<tr><th scope=\"row\">A7</th><td>L.1</td><td>panel</td><td>"
                        "window</td><td class=\"num\">1.50</td><td class=\"num\">2.00</td><td "
                        "class=\"num\">2.80</td><td class=\"num\">0.0°</td><td "
                        "class=\"num\">270.0°</td></tr>"));
  EXPECT_THAT(html, HasSubstr("2.80</td><td class=\"num\"></td><td class=\"num\"></td></tr>"));
}

TEST(HtmlRoomData, UnknownPowerIsNotZero) {
  Document document = office();
  document.projects[0].spaces[0].power.without_power = 1;
  const std::string html = shown(document);
  EXPECT_THAT(html, HasSubstr("not known: 1 of 2 luminaires state no power"));
  EXPECT_THAT(html, Not(HasSubstr("W/m²")));
}

TEST(HtmlRoomData, AnOutlineThatIsNoRectangleIsToldAndNothingMakesNothing) {
  Document document = office();
  SpacePart& space = document.projects[0].spaces[0];
  space.footprint_m = {{0, 0}, {5, 0}, {5, 4}, {2, 4}, {2, 2}, {0, 2}};
  EXPECT_THAT(shown(document), HasSubstr("of the outline (not a rectangle)"));
  space = {};
  EXPECT_EQ(shown(document), "");
}

TEST(HtmlRoomData, NamesAreEscaped) {
  Document document = office();
  document.projects[0].spaces[0].luminaires[0].id = "<script>";
  document.projects[0].spaces[0].finishes[0].materials = "<b>";
  const std::string html = shown(document);
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
}

}  // namespace
}  // namespace report::html_room_data_test
