#include "report/formats/xlsx.h"

#include "report/text/shown_decimals.h"
#include "tests/support/hostile_document.h"
#include "tests/support/legible.h"
#include "tests/support/rendered.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace report::xlsx_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Every file of it, parsed.
class Book {
 public:
  explicit Book(const std::string& bytes) {
    calc::Diagnostics diagnostics;
    auto archive =
        calc::ZipArchive::open(bytes, "x.xlsx", diagnostics, {10'000, 1u << 30, 1u << 30});
    EXPECT_TRUE(archive.has_value());
    if (!archive) return;
    for (const std::string& name : archive->names()) {
      const std::string xml = archive->read(name).value_or("");
      EXPECT_TRUE(files_[name].load_string(xml.c_str())) << name;
      texts_[name] = xml;
    }
    for (const pugi::xml_node sheet : files_["xl/workbook.xml"].child("workbook").child("sheets"))
      names_.emplace_back(sheet.attribute("name").value());
  }

  const std::vector<std::string>& sheets() const { return names_; }
  const std::string& text(const std::string& file) const { return texts_.at(file); }
  const std::map<std::string, std::string>& texts() const { return texts_; }
  pugi::xml_node sheet(const std::string& name) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) {
        return files_.at("xl/worksheets/sheet" + std::to_string(i + 1) + ".xml").child("worksheet");
      }
    }
    ADD_FAILURE() << "no sheet " << name;
    return {};
  }
  // By a reference, "B2".
  pugi::xml_node cell(const std::string& sheet_name, const std::string& place) const {
    return sheet(sheet_name).find_node([&](const pugi::xml_node& node) {
      return place == node.attribute("r").value();
    });
  }
  std::string words(const std::string& sheet_name, const std::string& place) const {
    return cell(sheet_name, place).child("is").child("t").text().get();
  }
  // How a number is shown.
  std::string format_of(const pugi::xml_node& cell) const {
    const pugi::xml_node styles = files_.at("xl/styles.xml").child("styleSheet");
    pugi::xml_node style = styles.child("cellXfs").first_child();
    for (int i = cell.attribute("s").as_int(); i > 0; --i) style = style.next_sibling();
    const std::string id = style.attribute("numFmtId").value();
    const pugi::xml_node format =
        styles.child("numFmts").find_child_by_attribute("numFmtId", id.c_str());
    return format ? format.attribute("formatCode").value() : "General";
  }
  std::size_t rows(const std::string& name) const {
    std::size_t count = 0;
    for (const pugi::xml_node row : sheet(name).child("sheetData"))
      count += row.name() == std::string("row") ? 1 : 0;
    return count;
  }

 private:
  std::map<std::string, pugi::xml_document> files_;
  std::map<std::string, std::string> texts_;
  std::vector<std::string> names_;
};

// Columns of a sheet, by their heads.
std::string column_with(const Book& book, const std::string& head,
                        const std::string& sheet = "Requirements") {
  for (const pugi::xml_node cell : book.sheet(sheet).child("sheetData").first_child()) {
    if (head == cell.child("is").child("t").text().get()) {
      const std::string place = cell.attribute("r").value();
      return place.substr(0, place.size() - 1);
    }
  }
  ADD_FAILURE() << "no column " << head;
  return "";
}

TEST(Xlsx, HasItsSheetsAndTheVerdictFirst) {
  const Book book(rendered("xlsx", small_document()));
  EXPECT_THAT(book.sheets(), ElementsAre("Overview", "Requirements", "Luminaires", "Positions",
                                         "Points", "Notes", "About"));
  EXPECT_EQ(book.words("Requirements", "A1"), "Verdict");
  EXPECT_EQ(book.words("Requirements", "A2"), "pass");
  EXPECT_EQ(book.words("Requirements", "A3"), "fail");
  EXPECT_EQ(book.words("Requirements", column_with(book, "Required") + "2"), "≥ 500 lx");
  EXPECT_EQ(book.rows("Points"), 3U);
}

// Whether a cell of the sheet has these words.
bool says(const Book& book, const std::string& sheet, const std::string& words) {
  return !book.sheet(sheet)
              .find_node([&](const pugi::xml_node& node) {
                return std::string(node.text().get()).find(words) != std::string::npos;
              })
              .empty();
}

// Of the row whose second cell is that.
std::string row_with(const Book& book, const std::string& sheet, const std::string& words) {
  for (const pugi::xml_node row : book.sheet(sheet).child("sheetData")) {
    const std::string number = row.attribute("r").value();
    if (book.words(sheet, "B" + number) == words) return number;
  }
  ADD_FAILURE() << "no row " << words;
  return "1";
}

// In the overview, whose table does not begin in the first row; "" without such a column.
std::string overview_column(const Book& book, const std::string& head) {
  const std::string row = row_with(book, "Overview", "Room");
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (book.words("Overview", letter + row) == head) return std::string(1, letter);
  }
  return "";
}

TEST(Xlsx, ARoomHasARowThatSaysWhy) {
  const Book book(rendered("xlsx", small_document()));
  const std::string row = row_with(book, "Overview", "Office");
  EXPECT_EQ(book.words("Overview", "A" + row), "fail");
  EXPECT_THAT(book.words("Overview", overview_column(book, "Why not passed") + row),
              testing::AllOf(HasSubstr("Work plane: "), HasSubstr("required ")));
}

// Below the room's row, which says whose its values are.
TEST(Xlsx, EachTaskOfARoomHasARow) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes.push_back(space.planes[0]);
  space.planes[1].id = "board";
  space.planes[1].name = "=Board";
  rules::Finding& average = space.planes[1].findings[0];
  average.requirement.limit = 600.0;
  judge_again(average);
  space.planes[1].findings.resize(1);
  const Book book(rendered("xlsx", document));
  const std::size_t row = std::stoul(row_with(book, "Overview", "Office"));
  const auto words = [&](char column, std::size_t below) {
    return book.words("Overview", column + std::to_string(row + below));
  };
  EXPECT_EQ(words('A', 0), "fail");
  EXPECT_EQ(words(overview_column(book, "Values of").front(), 0),
            "average =Board, minimum Work plane");
  EXPECT_EQ(words('B', 1), "    =Board");
  EXPECT_EQ(words('A', 1), "fail");
  EXPECT_EQ(words('H', 1), "≥ 600");
  EXPECT_EQ(words('B', 2), "    Work plane");
  EXPECT_EQ(words('H', 2), "≥ 500");
  EXPECT_EQ(words(overview_column(book, "space").front(), 2), space.id);
  for (int k = 0; k < 7; ++k) {
    space.planes.push_back(space.planes[0]);
    space.planes.back().id = "more" + std::to_string(k);
  }
  const Book more(rendered("xlsx", document));
  const std::string of_room = row_with(more, "Overview", "Office");
  EXPECT_EQ(row_with(more, "Overview", "    and 3 more"), std::to_string(std::stoul(of_room) + 7));
}

// A cell has one line: what is joined must be told apart there.
TEST(Xlsx, UsesAndCausesAreJoinedBySigns) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.coverage = {{"desk", calc::Message::words("EN 1:2021 2"), {}},
                    {"desk", calc::Message::words("EN 1:2021 3"), {}}};
  space.planes[0].findings[0].requirement.limit = 600.0;
  space.planes[0].findings[1].requirement.limit = 424.0;
  for (rules::Finding& finding : space.planes[0].findings) judge_again(finding);
  const Book book(rendered("xlsx", document));
  const std::string row = row_with(book, "Overview", "Office");
  EXPECT_EQ(book.words("Overview", "C" + row), "EN 1:2021 2; EN 1:2021 3");
  EXPECT_THAT(book.words("Overview", overview_column(book, "Why not passed") + row),
              HasSubstr(" | "));
}

// As the overview of other formats has them.
TEST(Xlsx, TheOverviewHasTheColumnsThatRoomsUse) {
  const char* const optional[]{"Minimum (lx)", "Minimum required", "UGR",
                               "UGR required", "Walls met",        "Walls required",
                               "Ez (lx)",      "Ez required",      "LENI (kWh/m²)"};
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  for (rules::Finding& finding : space.planes[0].findings)
    finding.requirement.origin.is_of_own_role =
        finding.requirement.metric != rules::Metric::minimum;
  const Book plain(rendered("xlsx", document));
  for (const char* head : optional) EXPECT_EQ(overview_column(plain, head), "") << head;

  for (rules::Finding& finding : space.planes[0].findings)
    finding.requirement.origin.is_of_own_role = true;
  const PlanePart task = space.planes[0];
  const auto add = [&](const char* id) -> PlanePart& {
    space.planes.push_back(task);
    space.planes.back().id = id;
    space.planes.back().findings.resize(1);
    space.planes.back().findings[0].requirement.origin.is_of_own_role = false;
    return space.planes.back();
  };
  PlanePart& faces = add("faces");
  faces.kernel = calc::ReceiverKernel::cylindrical;
  faces.findings[0].requirement.limit = 150.0;
  faces.findings[0].measured = {163.25, 162.0, 164.5};
  add("wall.1").findings[0].verdict = rules::Verdict::pass;
  add("wall.2").findings[0].verdict = rules::Verdict::not_judged;
  space.coverage = {{"desk",
                     calc::Message::words("EN 1:2021 2"),
                     {{"wall",
                       rules::RoleState::not_judged,
                       {},
                       {{"wall.1", "average"}, {"wall.2", "average"}}}}}};
  space.energy.emplace();
  space.energy->leni_kwh_m2 = 12.345;
  const Book book(rendered("xlsx", document));
  const std::string row = row_with(book, "Overview", "Office");
  const auto cell = [&](const char* head) {
    return book.cell("Overview", overview_column(book, head) + row);
  };
  EXPECT_EQ(cell("Minimum (lx)").child("v").text().as_double(), 424.5);
  EXPECT_EQ(book.words("Overview", overview_column(book, "Minimum required") + row), "≥ 450");
  EXPECT_EQ(cell("Ez (lx)").child("v").text().as_double(), 163.25);
  EXPECT_EQ(book.words("Overview", overview_column(book, "Ez required") + row), "≥ 150");
  EXPECT_EQ(cell("Walls met").child("v").text().as_int(), 1);
  EXPECT_EQ(cell("Walls required").child("v").text().as_int(), 2);
  EXPECT_EQ(cell("LENI (kWh/m²)").child("v").text().as_double(), 12.345);
  EXPECT_EQ(book.format_of(cell("LENI (kWh/m²)")), "0.0");
  EXPECT_EQ(overview_column(book, "UGR"), "");

  // No number where nothing is judged or known.
  for (PlanePart& plane : space.planes) {
    for (rules::Finding& finding : plane.findings) finding.verdict = rules::Verdict::not_judged;
  }
  space.energy->problem = calc::Message::words("no hours");
  const Book unjudged(rendered("xlsx", document));
  for (const char* head : {"Average (lx)", "Minimum (lx)", "Ez (lx)", "Walls met"}) {
    const std::string column = overview_column(unjudged, head);
    EXPECT_NE(column, "") << head;
    EXPECT_FALSE(unjudged.cell("Overview", column + row)) << head;
  }
  EXPECT_EQ(overview_column(unjudged, "LENI (kWh/m²)"), "");
  EXPECT_EQ(unjudged.words("Overview", overview_column(unjudged, "Minimum required") + row),
            "≥ 450");
}

TEST(Xlsx, OfSeveralProjectsTheOverviewBeginsWithTheProject) {
  Document document = small_document();
  document.projects.push_back(document.projects[0]);
  document.projects[1].path = "other.xml";
  const Book book(rendered("xlsx", document));
  const std::size_t head = std::stoul(row_with(book, "Overview", "Verdict"));
  EXPECT_EQ(book.words("Overview", "A" + std::to_string(head)), "Project");
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string row = std::to_string(head + 1 + i);
    EXPECT_EQ(book.words("Overview", "A" + row), document.projects[i].path);
    EXPECT_EQ(book.words("Overview", "B" + row), "fail");
    EXPECT_EQ(book.words("Overview", "C" + row), "Office");
  }
}

TEST(Xlsx, NamesStandBesideIdsAndWhatIsForProgramsIsNotPrinted) {
  const Book book(rendered("xlsx", small_document()));
  EXPECT_EQ(book.words("Requirements", "B2"), "Office");
  EXPECT_EQ(book.words("Requirements", "C2"), "Work plane");
  EXPECT_EQ(book.words("Requirements", column_with(book, "plane") + "2"),
            small_document().projects[0].spaces[0].planes[0].id);
  EXPECT_THAT(book.text("xl/workbook.xml"),
              HasSubstr("<definedName name=\"_xlnm.Print_Area\" localSheetId=\"1\">"
                        "'Requirements'!$A$1:$P$"));
}

// 11 pt, on A4 with its margins; a character is 7 of 96 pixels per inch.
TEST(Xlsx, WhatIsPrintedIsSixPointsHighAtLeast) {
  const Book book(rendered("xlsx", sample_document()));
  for (const std::string& name : book.sheets()) {
    const pugi::xml_node sheet = book.sheet(name);
    double width_in = 0.0;
    int printed = 0;
    const std::string start = "'" + name + "'!$A$1:$";
    const std::string& names = book.text("xl/workbook.xml");
    std::string last;
    const std::size_t area = names.find("Print_Area\" localSheetId=\"" +
                                        std::to_string(&name - book.sheets().data()) + "\"");
    if (area != std::string::npos) {
      const std::size_t at = names.find(start, area) + start.size();
      last = names.substr(at, names.find('$', at) - at);
    }
    for (const pugi::xml_node column : sheet.child("cols")) {
      if (!last.empty() && printed++ > last[0] - 'A') break;
      width_in += (7.0 * column.attribute("width").as_double() + 5.0) / 96.0;
    }
    const bool is_wide =
        sheet.child("pageSetup").attribute("orientation").value() == std::string("landscape");
    const double page_in = (is_wide ? 11.69 : 8.27) - 0.8;
    EXPECT_GE(11.0 * std::min(1.0, page_in / width_in), 6.0) << name << ": " << width_in;
    EXPECT_STREQ(sheet.child("pageSetup").attribute("fitToHeight").value(), "0");
  }
}

TEST(Xlsx, SpeaksTheLanguageAndKeepsNumbers) {
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  const Book book(rendered("xlsx", small_document(), style));
  EXPECT_EQ(book.sheets().front(), "Übersicht");
  EXPECT_EQ(book.words("Anforderungen", "A3"), "nicht erfüllt");
  const std::string column = column_with(book, "Berechnet", "Anforderungen");
  EXPECT_TRUE(book.cell("Anforderungen", column + "2").child("v"));
  const pugi::xml_node rules = book.sheet("Anforderungen").child("conditionalFormatting");
  EXPECT_TRUE(rules.find_node([](const pugi::xml_node& node) {
    return std::string(node.text().get()) == "\"nicht erfüllt\"";
  }));
}

// What people read, in their language; programs read the verdict of CSV in every language.
TEST(Xlsx, AdviceThatIsNotKeptToIsAFailForProgramsAlone) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[1];
  ASSERT_EQ(finding.verdict, rules::Verdict::fail);
  finding.requirement.severity = rules::Severity::advice;
  const Book book(rendered("xlsx", document));
  EXPECT_EQ(book.words("Requirements", "A3"), "outside the recommended range");
  EXPECT_EQ(book.words("Requirements", column_with(book, "verdict") + "3"), "fail");
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  const Book german(rendered("xlsx", document, style));
  EXPECT_EQ(german.words("Anforderungen", "A3"), "außerhalb der Empfehlung");
  EXPECT_EQ(german.words("Anforderungen", column_with(german, "verdict", "Anforderungen") + "3"),
            "fail");
}

TEST(Xlsx, RoomsOfOneNameHaveTheirIds) {
  Document document = small_document();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  spaces.push_back(spaces[0]);
  spaces[1].id = "other";
  const Book book(rendered("xlsx", document));
  EXPECT_EQ(book.words("Requirements", "B2"), "Office (" + spaces[0].id + ")");
  EXPECT_EQ(book.words("Requirements", "B4"), "Office (other)");
}

TEST(Xlsx, PagesHaveTheirHeadsAndThePaper) {
  FormatStyle style;
  style.page.paper = Paper::letter;
  Document document = small_document();
  document.projects[0].name = "A & B";
  const Book book(rendered("xlsx", document, style));
  EXPECT_STREQ(book.sheet("Points").child("pageSetup").attribute("paperSize").value(), "1");
  EXPECT_STREQ(book.sheet("Points").child("headerFooter").child("oddHeader").text().get(),
               "&LA && B&R&A");
  EXPECT_THAT(book.text("xl/workbook.xml"), HasSubstr("'Points'!$1:$1</definedName>"));
}

TEST(Xlsx, SameDocumentSameBytesAndNoDateUnlessAskedFor) {
  Document document = sample_document();
  document.provenance.timestamp = "";
  const std::string bytes = rendered("xlsx", document);
  EXPECT_EQ(bytes, rendered("xlsx", document));
  EXPECT_THAT(Book(bytes).text("docProps/core.xml"), Not(HasSubstr("dcterms:created")));
  document.provenance.timestamp = "2027-01-31T12:00:00Z";
  EXPECT_THAT(Book(rendered("xlsx", document)).text("docProps/core.xml"),
              HasSubstr("2027-01-31T12:00:00Z</dcterms:created>"));
  document.provenance.timestamp = "yesterday";  // is no date for programs
  EXPECT_THAT(Book(rendered("xlsx", document)).text("docProps/core.xml"),
              Not(HasSubstr("dcterms:created")));
}

TEST(Xlsx, ATableThatIsTooLongGoesOnAndAboutSaysSo) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.points.resize(7, plane.points[0]);
  const Book whole(rendered("xlsx", document));
  EXPECT_EQ(whole.rows("Points"), 8U);
  EXPECT_FALSE(says(whole, "About", "Points 2"));
  const Book parts(render_whole(document, [](const DocumentFrame& frame, const SpillPlace& place) {
    return xlsx_writer(frame, place, {}, Paper::a4, 4);
  }));
  EXPECT_THAT(parts.sheets(),
              testing::IsSupersetOf({"Points", "Points 2", "Points 3", "Requirements"}));
  EXPECT_EQ(parts.rows("Points"), 4U);
  EXPECT_EQ(parts.rows("Points 2"), 4U);
  EXPECT_EQ(parts.rows("Points 3"), 2U);  // 3 + 3 + 1 points, each sheet with a head
  EXPECT_EQ(parts.words("Points 3", "A1"), "Room");
  EXPECT_TRUE(says(parts, "About", "7 rows in 3 sheets, 'Points' to 'Points 3'"));
}

TEST(Xlsx, HostileNamesAreTextInEveryCell) {
  const Book book(rendered("xlsx", hostile_document()));
  for (const auto& [name, xml] : book.texts()) {
    for (const char* part : {"<script", "<f>", "hyperlink"})
      EXPECT_EQ(xml.find(part), std::string::npos) << name << ": " << part;
  }
}

TEST(Xlsx, WhatBeginsLikeAFormulaIsMarkedAsText) {
  Document document = small_document();
  document.projects[0].spaces[0].name = "=1+1";
  const Book book(rendered("xlsx", document));
  const pugi::xml_node cell = book.cell("Requirements", "B2");
  EXPECT_STREQ(cell.child("is").child("t").text().get(), "=1+1");
  pugi::xml_document styles;
  ASSERT_TRUE(styles.load_string(book.text("xl/styles.xml").c_str()));
  pugi::xml_node style = styles.child("styleSheet").child("cellXfs").first_child();
  for (int i = cell.attribute("s").as_int(); i > 0; --i) style = style.next_sibling();
  EXPECT_TRUE(style.attribute("quotePrefix").as_bool());
}

// 499.97 lx is not 500 lx, whatever a cell has room for.
TEST(Xlsx, NoNumberLooksAsIfItMetItsLimit) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  const auto shown = [&](double value, double spread) {
    finding.measured = {value, value - spread, value + spread};
    finding.verdict = rules::Verdict::fail;
    const Book book(rendered("xlsx", document));
    return book.format_of(book.cell("Requirements", column_with(book, "Calculated") + "2"));
  };
  EXPECT_EQ(shown(412.5, 8.0), "0");
  EXPECT_EQ(shown(499.97, 0.0), "0.00");
  EXPECT_EQ(shown(499.99996, 0.0), "0.00000");
  // In binary a little less than it says; a spreadsheet rounds what it says.
  EXPECT_EQ(shown(499.95, 0.0), "0.00");
}

TEST(Xlsx, PointsHaveTwoDecimalsAndMoreNextToTheirLimit) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.points[0].measured = estimate(0.46, 0.0);
  plane.points[1].measured = estimate(449.9996, 0.0);  // at least 450 lx are asked for
  const Book book(rendered("xlsx", document));
  const auto format_of = [&](const char* head, const char* row) {
    return book.format_of(book.cell("Points", column_with(book, head, "Points") + row));
  };
  for (const char* head : {"Illuminance (lx)", "Low (lx)", "High (lx)"}) {
    EXPECT_EQ(format_of(head, "2"), "0.00") << head;
    EXPECT_EQ(format_of(head, "3"), "0.0000") << head;
  }
}

TEST(Xlsx, DecimalsOfAnIntervalKeepAllOfItOnItsSide) {
  const Threshold limit{500.0, rules::Comparison::at_least};
  EXPECT_EQ(interval_decimals({520.0, 499.97, 540.0}, "lx", limit), 2);
  EXPECT_EQ(interval_decimals({520.0, 499.9, 540.0}, "lx", limit), 1);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(interval_decimals({17.2, 17.2, kInfinity}, "", {}), 1);
  EXPECT_EQ(interval_decimals({0.72, 0.72, kInfinity}, "", {}), 2);
  EXPECT_EQ(interval_decimals({kInfinity, kInfinity, kInfinity}, "", {}), 0);
  EXPECT_EQ(margin_decimals(0.025), 1);
  EXPECT_EQ(margin_decimals(-0.000004), 4);
}

// Nothing that is not computed has a number, and no word but "pass" is green.
TEST(Xlsx, WhatIsNotJudgedHasNoNumbersAndOnlyAPassIsGreen) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  finding.verdict = rules::Verdict::not_judged;
  const Book book(rendered("xlsx", document));
  for (const char* head : {"Calculated", "Low", "High", "Margin (% of the limit)"}) {
    EXPECT_FALSE(book.cell("Requirements", column_with(book, head) + "2")) << head;
    EXPECT_TRUE(book.cell("Requirements", column_with(book, head) + "3")) << head;
  }
  std::vector<std::string> green;
  for (const pugi::xml_node rule :
       book.sheet("Requirements").child("conditionalFormatting").children("cfRule")) {
    if (rule.attribute("dxfId").as_int() == 0)
      green.emplace_back(rule.child("formula").text().get());
  }
  EXPECT_THAT(green, ElementsAre("\"pass\""));
}

TEST(Xlsx, TypesAddUpAndUnknownPowerIsNoSum) {
  Document document = small_document();
  LuminaireRow type;
  type.type_id = "a";
  type.count = 3;
  type.flux_lm = 1000;
  type.power_w = 10;
  LuminaireRow other = type;
  other.type_id = "b";
  other.count = 2;
  document.projects[0].luminaires = {type, other};
  const auto total = [&](const char* place) {
    return Book(rendered("xlsx", document)).cell("Luminaires", place);
  };
  EXPECT_EQ(total("L4").child("v").text().as_int(), 5);
  EXPECT_EQ(total("O4").child("v").text().as_double(), 5000.0);
  EXPECT_EQ(total("P4").child("v").text().as_double(), 50.0);
  document.projects[0].luminaires[1].power_w = 0.0;
  EXPECT_FALSE(total("P4"));
  EXPECT_FALSE(total("G3"));
}

TEST(Xlsx, PositionsHaveTheMarksOfThePlans) {
  const Book book(rendered("xlsx", sample_document()));
  EXPECT_EQ(book.words("Positions", column_with(book, "Mark", "Positions") + "3"), "A2");
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  EXPECT_TRUE(
      says(Book(rendered("xlsx", sample_document(), style)), "Leuchtenpositionen", "Kürzel"));
}

TEST(Xlsx, LongTextsAreCutAtTheEndOfACharacter) {
  Document document = small_document();
  std::string name;
  for (int i = 0; i < 20'000; ++i) name += "\U0001F4A1";  // two units of UTF-16 each
  document.projects[0].spaces[0].name = name;
  const std::string shown = Book(rendered("xlsx", document)).words("Requirements", "B2");
  EXPECT_THAT(shown, testing::EndsWith("\U0001F4A1 [cut: too long for a cell]"));
  EXPECT_LE(shown.size() / 2, kMostCellCharacters);
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  EXPECT_THAT(Book(rendered("xlsx", document, style)).words("Anforderungen", "B2"),
              testing::EndsWith("\U0001F4A1 [gekürzt: zu lang für eine Zelle]"));
}

TEST(Xlsx, WhatIsLeftOutIsToldInTheReadersLanguage) {
  Document document = small_document();
  document.projects[0].spaces[0].coverage = {
      {"desk",
       calc::Message::words("EN 1:2021 2"),
       {{"wall",
         rules::RoleState::left_out,
         {},
         {},
         {{"wall.2", {"glass", "A. Meier", "2099-12-31"}, false}}}}}};
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  const Book book(rendered("xlsx", document, style));
  const std::string& notes = book.sheets().at(5);
  EXPECT_TRUE(says(book, notes, "weggelassen: "));
  EXPECT_TRUE(says(book, notes, "A. Meier"));
  EXPECT_FALSE(says(book, notes, "left out"));
}

}  // namespace
}  // namespace report::xlsx_test
