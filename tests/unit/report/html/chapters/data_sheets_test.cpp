// Data sheets of luminaires behind a report: which there are, and what they say.
#include "report/html/chapters/data_sheets.h"

#include "report/html/page/html.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <memory>
#include <string>

namespace report::data_sheets_test {
namespace {

using testing::HasSubstr;
using testing::Not;

SheetLight batwing(double step_deg, std::size_t emitters = 1) {
  calc::PhotometricWeb web =
      test_support::make_web(test_support::angle_steps(0, 360, step_deg),
                             test_support::angle_steps(0, 180, step_deg), test_support::batwing);
  const double flux_lm = web.flux_lm();
  return {std::move(web), flux_lm, 0.0, emitters, "a & b.ies", "abc"};
}

class OneLight : public SheetSource {
 public:
  explicit OneLight(std::variant<SheetLight, Text> light) : light_(std::move(light)) {}
  void see(const ProjectPart&, const std::string&) override {}
  std::variant<SheetLight, Text> light_of(const LuminaireRow&) const override { return light_; }

 private:
  std::variant<SheetLight, Text> light_;
};

LuminaireRow row(const std::string& id, const std::string& sha256) {
  LuminaireRow one;
  one.type_id = id;
  one.photometry_file = "a & b.ies";
  one.count = 3;
  one.flux_lm = 1234;
  one.sha256 = sha256;
  return one;
}

bool is_xml(const std::string& html) {
  return pugi::xml_document().load_string(("<r>" + html + "</r>").c_str());
}

TEST(DataSheets, TypesOfOneLightShareASheet) {
  ProjectPart project;
  project.luminaires = {row("<a>", "abc"), row("b", "def"), row("c", "abc"), row("d", ""),
                        row("e", "")};
  const DataSheets sheets = data_sheets({}, project, 1, OneLight(batwing(15)), 0);
  ASSERT_EQ(sheets.entries.size(), 4U);  // what has no file shares nothing
  EXPECT_EQ(sheets.entries[0].anchor, "sheet2-1");
  EXPECT_THAT(sheets.html, HasSubstr("id=\"datasheets2\""));
  EXPECT_THAT(sheets.html, HasSubstr("&lt;a&gt;: 3 × 1234 lm"));
  EXPECT_THAT(sheets.html, HasSubstr("<br/>c: 3 ×"));
  EXPECT_TRUE(is_xml(sheets.html));
}

// The same file, and what is drawn of the types is different light.
TEST(DataSheets, LightsOfOneFileMayDiffer) {
  ProjectPart project;
  project.luminaires = {row("a", "abc"), row("b", "abc"), row("c", "abc"), row("d", "abc")};
  for (LuminaireRow& one : project.luminaires) {
    one.max_intensity_cd = 500;
    one.c0_cd = {100, 500, 100};
    one.c90_cd = {80, 500, 80};
  }
  LuminaireRow& twice = project.luminaires[1];  // as much light, and the same curves
  twice.flux_lm *= 2;
  twice.max_intensity_cd *= 2;
  for (std::vector<double>* curve : {&twice.c0_cd, &twice.c90_cd}) {
    for (double& cd : *curve) cd *= 2;
  }
  project.luminaires[2].c90_cd = {90, 500, 90};
  project.luminaires[3].max_intensity_cd = 600;
  EXPECT_EQ(data_sheets({}, project, 1, OneLight(batwing(15)), 0).entries.size(), 3U);
}

TEST(DataSheets, SayWhyThereIsNone) {
  ProjectPart project;
  EXPECT_EQ(data_sheets({}, project, 0, OneLight(Text::sheet_not_found), 0).html, "");
  project.luminaires = {row("a", "abc")};
  const DataSheets sheets =
      data_sheets({Language::german, true}, project, 0, OneLight(Text::sheet_other_file), 0);
  EXPECT_THAT(sheets.html, HasSubstr("Kein Datenblatt: die photometrische Datei ist nicht die"));
  EXPECT_THAT(sheets.html, HasSubstr("a &amp; b.ies abc"));
  EXPECT_THAT(sheets.html, Not(HasSubstr("<table")));
}

TEST(DataSheets, NameWhatIsLeftOut) {
  ProjectPart project;
  for (const char* id : {"a", "b", "<c>"}) project.luminaires.push_back(row(id, id));
  const DataSheets sheets =
      data_sheets({}, project, 0, OneLight(Text::sheet_not_found), kMostSheets - 1);
  EXPECT_EQ(sheets.entries.size(), 1U);
  EXPECT_THAT(sheets.html,
              HasSubstr("without a data sheet here: b, &lt;c&gt;. A report has at most "
                        "200 sheets."));
}

TEST(DataSheets, ABodyHasAllValuesOrSaysThatItIsAbridged) {
  const SheetParts parts{"h5", "", true};
  const std::string whole = sheet_body({}, batwing(15), parts);
  EXPECT_THAT(whole, Not(HasSubstr("Abridged")));
  EXPECT_THAT(whole, HasSubstr("γ 15°"));
  const std::string part = sheet_body({}, batwing(1), parts);
  EXPECT_THAT(part, HasSubstr("Abridged: C every 15°, γ every 5°"));
  EXPECT_THAT(part, HasSubstr("has 360 × 181 angles."));
  EXPECT_THAT(part, Not(HasSubstr("γ 1°")));
  EXPECT_THAT(sheet_body({}, batwing(15)), Not(HasSubstr("Luminous intensity, cd")));
}

TEST(DataSheets, WhatIsNotStatedIsSaid) {
  const std::string one = sheet_body({}, batwing(15));
  EXPECT_THAT(one, HasSubstr("Efficacy</th><td>not stated"));
  EXPECT_THAT(one, HasSubstr("a &amp; b.ies"));
  const std::string several = sheet_body({}, batwing(15, 2));
  EXPECT_THAT(several, HasSubstr("2, lit together"));
  EXPECT_THAT(several, HasSubstr("several emitters are lit together, and their total size"));
  EXPECT_THAT(several, Not(HasSubstr("4 H × 8 H")));
}

TEST(DataSheets, StandInThePageOnlyWhenAskedFor) {
  Document document = small_document();
  document.projects[0].luminaires = {row("a", "abc")};
  const auto page = [&](std::shared_ptr<SheetSource> source) {
    PageStyle style;
    style.sheets = std::move(source);
    return render_whole(document, [&](const DocumentFrame& frame, const SpillPlace& place) {
      return html_writer(frame, place, {}, "", style);
    });
  };
  EXPECT_THAT(page(nullptr), Not(HasSubstr("data-sheet")));
  const std::string html = page(std::make_shared<OneLight>(batwing(15)));
  EXPECT_THAT(html, HasSubstr("<a href=\"#datasheets1\">Photometric data sheets</a>"));
  EXPECT_THAT(html, HasSubstr("<li class=\"on-paper\"><a href=\"#sheet1-1\">a</a>"));
  EXPECT_THAT(html, HasSubstr(".data-sheet + .data-sheet { break-before: page; }"));
  EXPECT_TRUE(pugi::xml_document().load_string(html.c_str()));
}

}  // namespace
}  // namespace report::data_sheets_test
