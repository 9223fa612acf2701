// Chapters of a project's report: deviations, energy, maintenance, emergency, method, annex.
#include "report/html/chapters/html_deviations.h"
#include "report/html/chapters/html_emergency.h"
#include "report/html/chapters/html_energy.h"
#include "report/html/chapters/html_findings.h"
#include "report/html/chapters/html_maintenance.h"
#include "report/html/chapters/html_method.h"
#include "report/html/chapters/html_project.h"
#include "report/html/room/html_values.h"
#include "report/text/room_power.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <regex>
#include <string>
#include <vector>

namespace report::html_chapters_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const calc::Waiver kOldHall{"old <hall>", "A. Meier", "2099-12-31"};

// The words of a table's rows, without markup.
std::vector<std::string> rows_of_table(const std::string& html) {
  pugi::xml_document tree;
  EXPECT_TRUE(tree.load_string(("<r>" + html + "</r>").c_str(), pugi::parse_full)) << html;
  std::vector<std::string> rows;
  for (const pugi::xpath_node& row : tree.select_nodes("//tbody/tr")) {
    std::string words;
    for (const pugi::xml_node& cell : row.node().children()) {
      std::string text;
      for (const pugi::xpath_node& part : cell.select_nodes(".//text()"))
        text += (text.empty() ? "" : " ") + std::string(part.node().value());
      words += (words.empty() ? "" : " | ") + text;
    }
    rows.push_back(words);
  }
  return rows;
}

std::string deviations(const Document& document) {
  return html_deviations({}, document.projects[0], 0, "");
}

TEST(HtmlDeviations, SayThatThereAreNone) {
  EXPECT_THAT(deviations(small_document()), HasSubstr("None: no requirement is waived"));
  Document nothing = small_document();
  nothing.projects[0].spaces[0].planes[0].findings.clear();
  EXPECT_EQ(deviations(nothing), "");
}

// Where all is left out, nothing is asked; that is when it must be said.
TEST(HtmlDeviations, ListWhatIsLeftOutThoughNothingElseIsAsked) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes[0].findings.clear();
  rules::RowCoverage row;
  row.roles = {{"task", rules::RoleState::left_out, {}, {}, {{"task", kOldHall, false}}}};
  space.coverage = {row};
  EXPECT_EQ(rows_of_table(deviations(document)).size(), 1U);
}

TEST(HtmlDeviations, ListWaiversWhateverTheirEffect) {
  Document document = small_document();
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings[1].requirement.waiver = kOldHall;
  findings[1].is_waived = true;
  EXPECT_THAT(rows_of_table(deviations(document)),
              ElementsAre("waived | Work plane Office | minimum ≥ 450 lx, found 424 ± 5 lx: "
                          "fail | old <hall> | A. Meier, until 2099-12-31"));
  findings[1].is_waived = false;  // its day is over
  EXPECT_THAT(deviations(document), HasSubstr("waiver without effect"));
  findings[0].requirement.waiver = kOldHall;
  EXPECT_THAT(deviations(document), HasSubstr("waiver that is not needed"));
}

// A verdict that does not count says so where it stands.
TEST(HtmlFindings, WaivedOnesSayItBesideTheirVerdict) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  const SpacePart& space = document.projects[0].spaces[0];
  const Footnotes none{Texts()};
  EXPECT_THAT(html_plane_findings({}, space, plane, none), Not(HasSubstr("waived")));
  plane.findings[1].requirement.waiver = kOldHall;
  plane.findings[1].is_waived = true;
  EXPECT_THAT(
      html_plane_findings({}, space, plane, none),
      HasSubstr(badge({}, rules::Verdict::fail, false) + "<span class=\"note\">waived</span>"));
}

// Advice decides nothing, and so it never fails: grey, with what is recommended.
TEST(HtmlFindings, AdviceThatIsNotKeptToIsNoFailure) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  rules::Finding low = plane.findings[1], high = low;
  low.verdict = rules::Verdict::fail;
  low.requirement.severity = rules::Severity::advice;
  low.requirement.metric = rules::Metric::minimum;
  low.requirement.derived = calc::DerivedQuantity::modelling;
  low.requirement.limit = 0.3;
  low.measured = calc::Estimate{0.21, 0.2, 0.22};
  high = low;
  high.verdict = rules::Verdict::pass;
  high.requirement.metric = rules::Metric::maximum;
  high.requirement.comparison = rules::Comparison::at_most;
  high.requirement.limit = 0.6;
  plane.findings = {low, high};
  const SpacePart& space = document.projects[0].spaces[0];
  const Footnotes none{Texts()};
  std::string html = html_plane_findings({}, space, plane, none);
  EXPECT_THAT(html, Not(HasSubstr("badge fail")));
  EXPECT_THAT(html, Not(HasSubstr("<tr class=\"fail\">")));
  EXPECT_THAT(html, HasSubstr("○</span>outside the recommended range</span><span "
                              "class=\"note\">recommended: 0.30 to 0.60</span>"));
  plane.findings[0].requirement.severity = rules::Severity::shall;
  html = html_plane_findings({}, space, plane, none);
  EXPECT_THAT(html, HasSubstr("badge fail"));
  EXPECT_THAT(html, Not(HasSubstr("recommended")));
}

TEST(HtmlDeviations, ListWhatIsNotAsTheStandardMeans) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  rules::Finding& finding = space.planes[0].findings[0];
  finding.requirement.deviations = {
      {rules::FitAspect::grid, calc::Message::words("2 x 1 points"), kOldHall, true},
      {rules::FitAspect::height, calc::Message::words("0.1 m too high"), {}, false}};
  finding.requirement.origin.is_weakened = true;
  finding.by_tolerance = true;
  rules::RowCoverage row;
  row.clause = calc::Message::words("EN 12464-1:2021 34.2");
  using enum rules::RoleState;
  row.roles = {{"task", met, {}},
               {"surround", never_asked, {}},  // the room says these two
               {"wall", asked_in_part, calc::Message::words("without wall.2")},
               {"ceiling", left_out, {}, {}, {{"ceiling", kOldHall, false}}},
               {"floor", left_out_ended, {}, {}, {{"floor", kOldHall, true}}}};
  space.coverage = {row};
  std::vector<std::string> kinds;
  for (const std::string& words : rows_of_table(deviations(document)))
    kinds.push_back(words.substr(0, words.find(" |")));
  EXPECT_THAT(kinds, ElementsAre("stated deviation", "deviation that is not accepted",
                                 "limit weaker than its row", "met by its tolerance alone",
                                 "omitted from its row", "omitted, but the last day is over"));
}

TEST(HtmlEnergy, HasARowForEachRoomAndSumsOfWhatIsKnown) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.spaces.push_back(project.spaces[0]);
  project.spaces[0].power = {60.0, 20.0, 2, 0};
  LuminaireRow ceiling, wall;
  ceiling.type_id = "ceiling";
  ceiling.count = 2;
  ceiling.power_w = 30.0;
  wall.type_id = "wall";
  wall.count = 1;
  wall.power_w = 40.0;
  project.luminaires = {ceiling, wall};
  project.spaces[0].luminaires = {{{1, 1, 2}, "ceiling"}, {{2, 1, 2}, "ceiling"}};
  project.spaces[1].luminaires = {{{1, 1, 2}, "wall"}};
  project.spaces[0].energy = calc::LightingEnergy{150.0, 8.0, {}, calc::Message::words("2500 h")};
  project.spaces[1].name = "Store";
  project.spaces[1].power = {40.0, 30.0, 1, 0};
  std::string html = html_energy({}, project, 0);
  EXPECT_THAT(rows_of_table(html)[0],
              HasSubstr("Office | 20.00 m² | 2 | 60.0 W | 3.00 W/m² | 0.585"));
  EXPECT_THAT(html, HasSubstr("<li>Office: 2500 h</li>"));
  EXPECT_THAT(rows_of_table(html)[0], HasSubstr("| 160 kWh | 8.0 kWh/m²"));
  EXPECT_THAT(rows_of_table(html)[1], HasSubstr("Store | 30.00 m²"));
  EXPECT_THAT(html, HasSubstr("50.00 m²"));
  EXPECT_THAT(html, HasSubstr("100.0 W"));
  EXPECT_THAT(html, HasSubstr("2.00 W/m²"));  // of both
  EXPECT_THAT(html,
              Not(HasSubstr("<td class=\"num\">160 kWh</td><td class=\"num\"></td></tr></tfoot>")));
  EXPECT_THAT(html, Not(HasSubstr("Rooms with floor area and luminaires")));  // these are all
  project.spaces.push_back(project.spaces[1]);
  project.spaces.back().luminaires.clear();  // a roof
  project.spaces.back().power = {0.0, 135.0, 0, 0};
  project.spaces[1].energy = calc::LightingEnergy{180.0, 8.0, {}, calc::Message::words("2500 h")};
  html = html_energy({}, project, 0);
  EXPECT_THAT(html, HasSubstr("Rooms with floor area and luminaires: 2</th>"
                              "<td class=\"num\">50.00 m²</td><td class=\"num\">3</td>"
                              "<td class=\"num\">100.0 W</td><td class=\"num\">2.00 W/m²</td>"
                              "<td class=\"num\"></td><td class=\"num\">400 kWh</td>"
                              "<td class=\"num\">8.0 kWh/m²</td>"));
  EXPECT_THAT(html, HasSubstr("rooms without luminaires, not in any total: 1, 135.00 m²"));
  project.spaces.pop_back();
  project.spaces[1].energy.reset();
  project.spaces[1].power.without_power = 1;
  project.luminaires[1].power_w = 0.0;
  html = html_energy({}, project, 0);
  EXPECT_THAT(html, Not(HasSubstr("100.0 W")));
  EXPECT_THAT(rows_of_table(html)[1], HasSubstr("not stated"));
  project.spaces[1].energy =
      calc::LightingEnergy{0, 0, calc::Message::words("power is not known"), {}};
  EXPECT_THAT(rows_of_table(html_energy({}, project, 0))[1], HasSubstr("not known"));
  EXPECT_THAT(html, Not(HasSubstr("<td class=\"num\">0 kWh")));
}

// A road's power is that of one spacing; what counts is what is drawn, as in the schedule.
TEST(HtmlEnergy, ARoadHasAllThatIsDrawnAndSaysWhatASpacingHas) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  LuminaireRow pole;
  pole.type_id = "pole";
  pole.count = 5;
  pole.power_w = 57.0;
  project.luminaires = {pole};
  SpacePart& road = project.spaces[0];
  road.luminaires.assign(4, {{0, 0, 8}, "pole"});
  road.power = {57.0, 0.0, 1, 0};
  road.power.is_of_spacing = true;
  const std::vector<std::string> rows = rows_of_table(html_energy({}, project, 0));
  EXPECT_THAT(html_energy({}, project, 0),
              HasSubstr("for each spacing of the road: 1 × luminaire, 57.0 W"));
  EXPECT_THAT(rows[0], HasSubstr("| 4 | 228.0 W |"));
  EXPECT_THAT(rows[1], HasSubstr("not in this report |  | 1 | 57.0 W |"));  // cut short
  EXPECT_THAT(html_energy({}, project, 0), HasSubstr("<td class=\"num\">285.0 W</td>"));
  EXPECT_THAT(html_energy({}, project, 0),
              HasSubstr("luminaires of roads: 4, as many as the calculation uses"));
}

TEST(HtmlLuminaires, OneRowForEachTypeThatIsUsedAndTheOthersByName) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  LuminaireRow spare, panel;
  spare.type_id = "spare";
  panel.type_id = "p600";
  panel.maker = "Maker & Co";
  panel.name = "Panel 600";
  panel.article_number = "4711";
  panel.count = 2;
  panel.flux_lm = 3600;
  panel.power_w = 30;
  panel.colour_temperature = "4000 K";
  panel.colour_rendering = "1B";
  project.luminaires = {spare, panel};
  SpacePart& room = project.spaces[0];
  room.name = "1.01 <Office>";
  room.floor_z_m = 4.0;
  room.footprint_m = {{0, 0}, {5, 0}, {5, 4}};
  room.luminaires = {{{1, 1, 6.8}, "p600"}, {{3, 1, 7.2}, "p600"}};
  LuminaireMark& mark = room.luminaires[0];
  mark.axis = {0, 0, -1};
  mark.c0 = {0, 1, 0};
  mark.outline_m = {{0.85, 0.4}, {1.15, 0.4}, {1.15, 1.6}, {0.85, 1.6}};
  const std::string html = html_luminaires({}, project, 0);
  const std::vector<std::string> rows = rows_of_table(html);
  ASSERT_EQ(rows.size(), 1u) << testing::PrintToString(rows);
  EXPECT_THAT(rows[0], testing::StartsWith("B | Maker & Co · Panel 600 Article 4711, luminous "
                                           "opening 1.20 m × 0.30 m"));
  EXPECT_THAT(rows[0], HasSubstr("| 3600 | 30.0 | 120 | 4000 | 80–89 | 2.80 m, 3.20 m | 2 |"));
  EXPECT_THAT(rows[0], HasSubstr("| 1.01 <Office>"));
  EXPECT_THAT(html, HasSubstr("All luminaires</th><td class=\"num\">7200</td>"
                              "<td class=\"num\">60.0</td>"));
  EXPECT_THAT(html, HasSubstr("not used, therefore not counted: A (spare)."));
}

// Those that face up; of equal ones the first.
TEST(HtmlEnergy, HundredLuxAreThoseOfAPlaneThatPeopleUse) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.power = {60.0, 20.0, 2, 0};
  space.planes.resize(4, space.planes[0]);
  for (std::size_t k = 0; k < 4; ++k) space.planes[k].name = fmt::format("plane {}", k);
  space.planes[0].findings.clear();
  for (glm::dvec2& corner : space.planes[0].outline_m) corner *= 3.0;
  std::swap(space.planes[1].grid.u, space.planes[1].grid.v);  // the ceiling
  space.planes[1].grid.origin_m.z = 3.0;
  ASSERT_TRUE(power_by_light(space));
  EXPECT_EQ(power_by_light(space)->plane->name, "plane 2");
  space.planes[2].findings.clear();
  space.planes[3].findings[0].requirement.scene = "night";
  EXPECT_EQ(power_by_light(space)->plane->name, "plane 3");  // something is asked of it
  space.planes[3].findings.clear();
  EXPECT_EQ(power_by_light(space)->plane->name, "plane 0");
}

TEST(HtmlEnergy, IsNotThereWithoutLuminaires) {
  EXPECT_EQ(html_energy({}, small_document().projects[0], 0), "");
}

TEST(HtmlMaintenance, SaysWhatIsStatedAndWhatIsNot) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  EXPECT_EQ(html_maintenance({}, project, 0), "");
  LuminaireRow row;
  row.type_id = "panel";
  row.count = 3;
  row.maintenance_factor = 0.93 * 0.95 * 0.97;
  row.maintenance.is_stated = true;
  row.maintenance.llmf = 0.93;
  row.maintenance.lmf = 0.95;
  row.maintenance.rsmf = 0.97;
  project.luminaires = {row};
  EXPECT_THAT(html_maintenance({}, project, 0),
              HasSubstr("The project does not state when luminaires"));
  EXPECT_THAT(html_maintenance({}, project, 0), HasSubstr(">RSMF</th>"));
  EXPECT_THAT(html_maintenance({}, project, 0), Not(HasSubstr(">LSF</th>"))) << "of no type";
  project.maintenance_plan.clean_luminaires_months = 1.0;
  EXPECT_THAT(html_maintenance({}, project, 0),
              HasSubstr("Luminaires are cleaned</th><td>every month<"));
  project.maintenance_plan = {"clean office", "", 12.0, {}, 50000.0, {}};
  const std::string html = html_maintenance({}, project, 0);
  EXPECT_THAT(html, HasSubstr("0.857"));
  EXPECT_THAT(html, HasSubstr("Surroundings</th><td>clean office"));
  EXPECT_THAT(html, HasSubstr("Luminaires are cleaned</th><td>every 12 months"));
  EXPECT_THAT(html, HasSubstr("Room surfaces are cleaned</th><td>not stated"));
  EXPECT_THAT(html, HasSubstr("replaced after</th><td>50000 h"));
}

TEST(HtmlEmergency, HasWhatHoldsAtTheEndOfTheBatteries) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  EXPECT_EQ(html_emergency({}, project, 0, "", Footnotes{Texts()}), "");
  SpacePart& space = project.spaces[0];
  LuminaireMark day{{0, 0, 2}, "panel"}, night = day;
  day.group = "general";
  night.group = "battery";
  space.luminaires = {day, day, night, {{1, 1, 2}, "sign"}};  // the last: no group, always on
  project.scenes = {{"battery", {{"general", 0.0}}}};
  rules::Requirement& asked = space.planes[0].findings[1].requirement;
  asked.state = rules::LightState::end_of_duration;
  asked.scene = "battery";
  space.planes[0].findings[1].reason = calc::Message::words("");
  EXPECT_THAT(rows_of_table(html_emergency({}, project, 0, "", Footnotes{Texts()})),
              ElementsAre("Work plane Office | minimum end-of-duration · scene battery | battery | "
                          "2 | ≥ 450 lx | 424 ± 5 lx "
                          "| ✗ fail"));
}

TEST(HtmlEmergency, HasWhatMustBeReadWithTheVerdict) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[1];
  finding.requirement.state = rules::LightState::end_of_duration;
  finding.requirement.clause = calc::Message::words("EN 1838 risk");
  finding.requirement.note = calc::Message::words("national readings differ");
  finding.requirement.direct_only = true;
  finding.verdict = rules::Verdict::not_judged;
  finding.reason = calc::Message::words("the scene does not say what 1 luminaire does");
  const std::string html = html_emergency({}, document.projects[0], 0, "", Footnotes{Texts()});
  for (const char* words :
       {"EN 1838 risk (project&#39;s own) · end-of-duration · ", "national readings differ",
        "direct light only", "the scene does not say what 1 luminaire does", "not judged"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
}

TEST(HtmlMethod, NamesTheConfidence) {
  DocumentEnd end;
  end.provenance.confidence = 0.99;
  EXPECT_THAT(html_method({}, end, Footnotes{Texts()}), HasSubstr("with a confidence of 99 %"));
}

std::string annex_of(const Document& document, Annex annex) {
  const SpacePart& space = document.projects[0].spaces[0];
  return html_annex({}, {{&space, &space.planes[0]}}, annex, "annex1");
}

// 2 rows of `columns` cells; the value says where it is.
Document wide(int columns) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.grid.columns = columns;
  plane.grid.rows = 2;
  plane.points.clear();
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < columns; ++column) {
      plane.points.push_back(
          sample_point(column, row, {}, estimate(1000.0 * (row + 1) + column, 0), 0));
    }
  }
  return document;
}

TEST(HtmlAnnex, HasEveryValueOnceInTablesThatPaperHolds) {
  const std::string html = annex_of(wide(40), Annex::automatic);
  const std::regex table("<table");
  EXPECT_EQ(std::distance(std::sregex_iterator(html.begin(), html.end(), table), {}), 3);
  for (int value = 1000; value < 1040; ++value) {
    const std::string cell = fmt::format("<td>{}</td>", value);
    EXPECT_THAT(html, HasSubstr(cell));
    EXPECT_EQ(html.find(cell), html.rfind(cell)) << value;
  }
}

// What stands beside others is not cut between pages.
TEST(HtmlAnnex, OnlySmallTablesStandBesideOthers) {
  const std::string beside = "class=\"values beside\"", alone = "class=\"values\"";
  const auto rows = [](int count) {
    Document document = wide(10);
    document.projects[0].spaces[0].planes[0].grid.rows = count;
    return annex_of(document, Annex::automatic);
  };
  EXPECT_THAT(rows(2), HasSubstr(beside));
  EXPECT_THAT(rows(25), HasSubstr(beside));
  EXPECT_THAT(rows(26), AllOf(HasSubstr(alone), Not(HasSubstr(beside))));
  EXPECT_THAT(annex_of(wide(18), Annex::automatic), HasSubstr(beside));
  EXPECT_THAT(annex_of(wide(19), Annex::automatic),
              AllOf(HasSubstr(alone), Not(HasSubstr(beside))));
}

TEST(HtmlAnnex, IsLeftOutWhereItIsLongAndSaysSo) {
  const std::string words = annex_of(wide(1300), Annex::automatic);
  EXPECT_THAT(words, HasSubstr("600 values"));
  EXPECT_THAT(words, HasSubstr("--annex always"));
  EXPECT_THAT(words, Not(HasSubstr("<table")));
  EXPECT_THAT(annex_of(wide(1300), Annex::always), HasSubstr("<table"));
  EXPECT_EQ(annex_of(wide(3), Annex::never), "");
  Document none = wide(3);
  none.projects[0].spaces[0].planes[0].is_computed = false;
  EXPECT_EQ(annex_of(none, Annex::always), "");
}

// A reason that is not ours stays English, marked, and has one full stop.
TEST(HtmlFindings, EndReasonsWithOneFullStop) {
  PlanePart plane;
  rules::Finding finding;
  for (const char* reason : {"own words.", "own words", "<b>"}) {
    finding.reason = calc::Message::words(reason);
    plane.findings.push_back(finding);
  }
  const Texts german(Language::german, true);
  const std::string html = html_plane_findings(german, SpacePart{}, plane, Footnotes{german});
  EXPECT_THAT(html, HasSubstr("<span lang=\"en\">Own words.</span><"));
  EXPECT_THAT(html, HasSubstr("<span lang=\"en\">Own words</span>.<"));
  EXPECT_THAT(html, HasSubstr("<span lang=\"en\">&lt;b&gt;</span>.<"));
}

}  // namespace
}  // namespace report::html_chapters_test
