// Floor plans and site plans, against their own metres.
#include "report/html/chapters/html_storeys.h"

#include "calc/base/utf8.h"
#include "report/document/luminaire_labels.h"
#include "report/document/storeys.h"
#include "report/html/drawings/storey_plan.h"
#include "report/html/page/html.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/glm.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace report::html_storeys_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

SpacePart room(const std::string& name, double x, double z = 0.0, double width = 6.0) {
  SpacePart space = small_document().projects[0].spaces[0];
  space.id = "id-" + name;
  space.name = name;
  space.footprint_m = {{x, 0}, {x + width, 0}, {x + width, 5}, {x, 5}};
  space.floor_z_m = z;
  LuminaireMark panel{{x + 1.5, 1, z + 2.7}, "panel"};
  panel.outline_m = {{x + 1.2, 0.7}, {x + 1.8, 0.7}, {x + 1.8, 1.3}, {x + 1.2, 1.3}};
  space.luminaires = {{{x + 3, 4, z + 2.7}, "spot"}, panel};
  return space;
}

ProjectPart house() {
  ProjectPart project = small_document().projects[0];
  project.luminaires.resize(2);
  project.luminaires[0].type_id = "panel";
  project.luminaires[0].name = "Panel <600>";
  project.luminaires[1].type_id = "spot";
  project.spaces = {room("1.01 Office", 0), room("1.02 Store", 6.2), room("2.01 Attic", 0, 3.113)};
  return project;
}

std::string shown(ProjectPart project, Paper paper = Paper::a4) {
  label_luminaires(project);
  return html_storeys({}, project, 0, paper);
}

struct Page {
  explicit Page(const std::string& html) {
    EXPECT_TRUE(tree.load_string(("<main>" + html + "</main>").c_str(), pugi::parse_full)) << html;
  }
  std::vector<std::string> texts(std::size_t svg) const {
    std::vector<std::string> found;
    const pugi::xpath_node_set all = tree.select_nodes("//svg");
    if (svg >= all.size()) return found;
    for (const pugi::xpath_node& node : all[svg].node().select_nodes(".//text"))
      found.emplace_back(node.node().child_value());
    return found;
  }
  std::vector<std::string> of(const char* path) const {
    std::vector<std::string> found;
    for (const pugi::xpath_node& node : tree.select_nodes(path))
      found.emplace_back(node.attribute() ? node.attribute().value() : node.node().child_value());
    return found;
  }
  pugi::xml_document tree;
};

std::vector<double> numbers(const std::string& data) {
  std::vector<double> found;
  const std::regex number("-?[0-9.]+");
  for (auto i = std::sregex_iterator(data.begin(), data.end(), number); i != std::sregex_iterator();
       ++i) {
    found.push_back(std::stod(i->str()));
  }
  return found;
}

TEST(FitPlan, IsTheLargestScaleThatFits) {
  const auto scale = [](double x, double y, Paper paper = Paper::a4, double least = 50.0) {
    const std::optional<PlanFit> fit = fit_plan({x, y}, paper, least);
    return fit ? fmt::format("1:{}{}", fit->scale, fit->is_turned ? " turned" : "") : "none";
  };
  EXPECT_EQ(scale(8, 9), "1:50");
  EXPECT_EQ(scale(17.6, 14), "1:100");
  EXPECT_EQ(scale(18.2, 14), "1:100 turned");
  EXPECT_EQ(scale(18.2, 18.2), "1:200");
  EXPECT_EQ(scale(18.1, 14, Paper::letter), "1:100");
  EXPECT_EQ(scale(14, 18.1, Paper::letter), "1:100 turned");
  EXPECT_EQ(scale(1700, 10), "1:10000");
  EXPECT_EQ(scale(2000, 10), "none");
  EXPECT_EQ(scale(8, 9, Paper::a4, 200.0), "1:200");
  EXPECT_EQ(scale(std::numeric_limits<double>::infinity(), 1), "none");
  EXPECT_EQ(scale(std::numeric_limits<double>::quiet_NaN(), 1), "none");
}

TEST(HtmlStoreys, HaveTwoPlansEachToScale) {
  const std::string html = shown(house());
  const Page page(html);
  EXPECT_THAT(page.of("//h3"), testing::ElementsAre("Storey at ±0.00 m", "Storey at +3.10 m"));
  EXPECT_THAT(page.of("//svg/@aria-label"),
              testing::ElementsAre("Floor plan, Storey at ±0.00 m, scale 1:100",
                                   "Floor plan with results, Storey at ±0.00 m, scale 1:100",
                                   "Floor plan, Storey at +3.10 m, scale 1:50",
                                   "Floor plan with results, Storey at +3.10 m, scale 1:50"));
  // Units of the drawing are millimetres of paper, and 6 m are 60 of them.
  const std::string width = page.of("//svg/@width")[0];
  EXPECT_THAT(page.of("//svg/@viewBox")[0],
              StartsWith("0 0 " + width.substr(0, width.size() - 2) + " "));
  EXPECT_THAT(width, testing::EndsWith("mm"));
  const std::vector<double> wall = numbers(page.of("//path[@class='wall']/@d")[0]);
  ASSERT_EQ(wall.size(), 8U);
  EXPECT_NEAR(wall[2] - wall[0], 60.0, 0.02);
  EXPECT_NEAR(wall[3] - wall[5], 50.0, 0.02);  // y points down
}

TEST(HtmlStoreys, NameRoomsAndLuminaires) {
  const Page page(shown(house()));
  EXPECT_THAT(page.texts(0),
              IsSupersetOf({"1.01", "Office", "1.02", "Store", "A1", "A2", "B1", "B2"}));
  EXPECT_THAT(page.texts(2), IsSupersetOf({"A3", "B3"})) << "the upper storey counts on";
  EXPECT_THAT(page.of("//ul[@class='layout-key']/li/b"), Contains("A"));
  EXPECT_THAT(shown(house()), HasSubstr("2 × Panel &lt;600&gt;"));
}

TEST(HtmlStoreys, CaptionsExplainWhatIsDrawnAlone) {
  ProjectPart project = house();
  EXPECT_THAT(shown(project), HasSubstr("Marks of luminaires: the letter"));
  for (SpacePart& space : project.spaces) {
    space.luminaires.clear();
    for (PlanePart& plane : space.planes) plane.outline_m.clear();
  }
  EXPECT_THAT(shown(project), Not(HasSubstr("Marks of luminaires: the letter")));
  EXPECT_THAT(shown(project), Not(HasSubstr("Dashed: ")));
}

TEST(HtmlStoreys, ResultsHaveSignsAndValues) {
  const std::string html = shown(house());
  // 512.5 of 500 lx passes, a minimum fails.
  EXPECT_THAT(Page(html).texts(1), Contains(StartsWith("✗ 1.01")));
  EXPECT_THAT(Page(html).texts(1), Contains(AllOf(StartsWith("Em 512"), HasSubstr("≥ 500"))));
  EXPECT_THAT(
      html, AllOf(HasSubstr("class=\"wall tint fail\""), HasSubstr("url(#storey1-1-results-fail)"),
                  HasSubstr("id=\"storey1-1-results-fail\"")));
}

TEST(HtmlStoreys, ASingleRoomHasNone) {
  ProjectPart project = house();
  project.spaces.resize(1);
  EXPECT_EQ(shown(project), "");
  project.spaces = {room("a", 0), room("b", 0)};  // around origins of their own
  EXPECT_EQ(shown(project), "");
}

TEST(HtmlStoreys, LeaveOutWhatIsNotThere) {
  ProjectPart project = house();
  project.spaces[2].luminaires.clear();
  project.spaces[2].planes.clear();
  SpacePart inner = room("1.03 Box", 1, 0, 2);
  project.spaces.push_back(inner);
  const std::string html = shown(project);
  EXPECT_THAT(html, HasSubstr("not drawn: Storey at +3.10 m."));
  EXPECT_THAT(html, HasSubstr("overlap other rooms at their height: 1.03 Box."));
}

TEST(HtmlStoreys, SmallRoomsHaveNumbersWithAList) {
  ProjectPart project = house();
  project.spaces = {room("1.01 Hall", 0, 0, 60), room("1.02 Cupboard for keys", 60.5, 0, 1.5)};
  project.spaces[1].luminaires.clear();
  const std::string html = shown(project);
  EXPECT_THAT(html, HasSubstr("<li><b>1.02</b> Cupboard for keys</li>"));
  EXPECT_THAT(html, Not(HasSubstr("<li><b>1.01</b>")));
}

// Boxes of words, of letters that are narrower than any font's.
TEST(HtmlStoreys, WordsDoNotOverlapInTwoHundredRooms) {
  ProjectPart project = house();
  project.spaces.clear();
  for (int i = 0; i < 200; ++i) {
    SpacePart space = room(fmt::format("2.{:03} Office of {}", i, i), 4.5 * (i % 10), 0, 4.2);
    for (glm::dvec2& corner : space.footprint_m) corner.y = 0.8 * corner.y + 4.4 * (i / 10);
    for (LuminaireMark& mark : space.luminaires) {
      mark.position_m.y += 4.4 * (i / 10) - 0.5;
      mark.outline_m.clear();
    }
    project.spaces.push_back(space);
  }
  const std::string html = shown(project);
  EXPECT_LT(html.size(), 250'000U);
  const Page page(html);
  for (const pugi::xpath_node& svg : page.tree.select_nodes("//svg")) {
    std::vector<glm::dvec4> boxes;
    for (const pugi::xpath_node& text : svg.node().select_nodes("./g//text")) {
      const pugi::xml_node node = text.node();
      if (node.parent().attribute("transform")) continue;
      const double size = node.attribute("font-size").as_double();
      EXPECT_GE(size, 2.117) << "6 points";
      const std::string words = node.child_value();
      const auto letters = std::count_if(words.begin(), words.end(),
                                         [](char c) { return !calc::is_utf8_continuation(c); });
      const double half = 0.25 * size * static_cast<double>(letters);
      const glm::dvec2 p(node.attribute("x").as_double(), node.attribute("y").as_double());
      boxes.emplace_back(p.x - half, p.y - 0.7 * size, p.x + half, p.y);
    }
    EXPECT_GT(boxes.size(), 150U);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const glm::dvec4 &a = boxes[i], &b = boxes[j];
        EXPECT_FALSE(a.x < b.z && b.x < a.z && a.y < b.w && b.y < a.w) << i << " and " << j;
      }
    }
  }
}

TEST(HtmlStoreys, StrangeLuminairesDoNotBreakIt) {
  ProjectPart project = house();
  project.spaces[0].luminaires.push_back({{500, 0, 2}, "panel"});
  project.spaces[0].luminaires.push_back(
      {{std::numeric_limits<double>::quiet_NaN(), 0, 2}, "panel"});
  LuminaireMark wide{{1, 1, 2}, "unknown"};
  wide.outline_m = {{-1e300, 0}, {1e300, 0}, {0, 1e300}};
  project.spaces[0].luminaires.push_back(wide);
  const std::string html = shown(project);
  EXPECT_THAT(html, HasSubstr("Luminaires outside the plan, not drawn: 3."));
  EXPECT_THAT(html, Not(HasSubstr("–L")));
  for (int i = 0; i < 3000; ++i) project.spaces[0].luminaires.push_back({{1, 1, 2}, "panel"});
  EXPECT_THAT(shown(project), HasSubstr("Too many luminaires for outlines and marks"));
}

// The letter alone is not the mark that tables have.
TEST(HtmlStoreys, CountsLuminairesWithoutTheirWholeMark) {
  ProjectPart project = house();
  for (int i = 0; i < 60; ++i)
    project.spaces[0].luminaires.push_back(
        {{0.5 + 0.25 * (i % 20), 2.0 + 0.25 * (i / 20), 2.7}, "spot"});
  label_luminaires(project);
  const std::string html = html_storeys({}, project, 0, Paper::a4);
  const std::vector<std::string> words = Page(html).texts(0);
  std::size_t missing = 0;
  for (const SpacePart* space : {&project.spaces[0], &project.spaces[1]}) {
    for (const LuminaireMark& mark : space->luminaires)
      missing += std::count(words.begin(), words.end(), mark.label) == 0 ? 1 : 0;
  }
  EXPECT_GT(missing, 0U);
  EXPECT_THAT(html, HasSubstr(fmt::format("without their whole mark, because it would cover "
                                          "something: {}.",
                                          missing)));
}

TEST(HtmlStoreys, HaveASitePlanOfARoad) {
  ProjectPart project = house();
  project.north_deg = 90.0;
  SpacePart road = small_document().projects[0].spaces[0];
  road.name = "Road <1>";
  road.footprint_m.clear();
  road.planes[0].outline_m = {{0, 0}, {30, 0}, {30, 7}, {0, 7}};
  road.luminaires = {{{0, -1, 8}, "spot"}, {{30, -1, 8}, "spot"}, {{5000, 0, 8}, "spot"}};
  project.spaces.resize(1);
  project.spaces.push_back(road);
  const std::string html = shown(project);
  const Page page(html);
  EXPECT_THAT(page.of("//h3"), testing::ElementsAre("Site plan: Road <1>"));
  EXPECT_THAT(page.of("//svg/@aria-label"),
              testing::ElementsAre("Site plan: Road <1>, scale 1:200"));
  EXPECT_THAT(page.texts(0), IsSupersetOf({"✗ Work plane", "B2", "B3", "N"}));
  EXPECT_THAT(html, HasSubstr("outside the plan, not drawn: 1."));
  EXPECT_EQ(storeys_title({}, project), "Site plan: Small office");
  EXPECT_THAT(html, Not(HasSubstr("too many corners")));
  PlanePart& endless = project.spaces[1].planes.emplace_back(road.planes[0]);
  endless.name = "Endless";
  endless.outline_m.resize(kMostPlanCorners + 1);
  EXPECT_THAT(shown(project), HasSubstr("are not known or have too many corners: Endless."));
}

TEST(HtmlStoreys, AreASectionBehindTheRooms) {
  Document document = small_document();
  document.projects = {house()};
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("<a href=\"#storeys\">Floor plans</a>"));
  const std::size_t rooms = html.find("id=\"rooms\""), storeys = html.find("id=\"storeys\""),
                    summary = html.find("id=\"summary\"");
  EXPECT_LT(rooms, storeys);
  EXPECT_LT(storeys, summary);
  EXPECT_NE(summary, std::string::npos);
  EXPECT_THAT(render_html(small_document()), Not(HasSubstr("id=\"storeys\"")));
}

}  // namespace
}  // namespace report::html_storeys_test
