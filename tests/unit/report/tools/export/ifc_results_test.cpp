#include "report/tools/export/ifc_results.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "report/tools/import/step_text.h"
#include "tests/support/sample_document.h"
#include "tests/unit/report/tools/import/ifc_text.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

namespace ifc_results_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kSpace = "0BTBFw6f90Nfh9rP1dl$3P";

// A space of 4 m x 2 m x 3 m, as small_document() has it, and another one.
std::string model(const std::string& schema = "IFC4", const std::string& owner = "#700") {
  std::string space = test_support::ifc_space(
      test_support::ifc_extrusion("#11=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,2000.);"));
  space.replace(space.find("'room-a',$"), 10, "'" + std::string(kSpace) + "'," + owner);
  return test_support::ifc_file(
      space + "#20=IFCSPACE('1F',$,'102',$,$,#800,$,'Hall',.ELEMENT.,.SPACE.,$);" +
          "#700=IFCOWNERHISTORY($,$,$,.ADDED.,$,$,$,0);\n",
      schema);
}

report::Document result() {
  report::Document document = report::small_document();
  document.projects[0].spaces[0].id = "room-0BTBFw6f90Nfh9rP1dl:3P";
  return document;
}

struct Written {
  std::string problem;
  std::optional<cli::IfcWithResults> with;
  std::optional<cli::StepText> text;
  // Set and property, with the arguments of the property.
  std::map<std::string, std::map<std::string, std::vector<cli::StepValue>>> sets;
  std::map<std::string, std::uint32_t> set_at;

  explicit Written(const std::string& bytes, const report::Document& document) {
    with = cli::ifc_with_results(bytes, document, problem);
    if (!with) return;
    cli::StepProblem unread;
    text = cli::StepText::open(with->text, unread);
    EXPECT_TRUE(text) << unread.line << ": " << unread.what;
    if (!text) return;
    for (const std::uint32_t set : text->of_name("IFCPROPERTYSET")) {
      const auto a = text->arguments(set);
      const std::string name = *a.at(2).text();
      EXPECT_TRUE(set_at.emplace(name, set).second) << name;
      for (const cli::StepValue& one : a.at(4).items()) {
        const auto property = text->find(one);
        EXPECT_TRUE(property);
        const auto b = text->arguments(*property);
        EXPECT_TRUE(sets[name].emplace(*b.at(0).text(), b).second) << *b[0].text();
      }
    }
  }

  std::string words(const std::string& set, const std::string& property) const {
    const auto found = sets.find(set);
    if (found == sets.end() || !found->second.contains(property)) return "(none)";
    return found->second.at(property).at(2).untyped().text().value_or("(no text)");
  }
  double number(const std::string& set, const std::string& property, std::size_t argument) const {
    return sets.at(set).at(property).at(argument).untyped().number().value();
  }
};

constexpr const char* kRoom = "Luxgate_Results";
constexpr const char* kPlane = "Luxgate_Plane_work";

TEST(IfcResults, VerdictsAndValuesWithIntervals) {
  const Written w(model(), result());
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_TRUE(w.with->is_all);
  EXPECT_EQ(w.with->rooms, 1u);
  EXPECT_EQ(w.words(kRoom, "Verdict"), "fail");
  EXPECT_EQ(w.words(kRoom, "Requirements"), "2 requirements: 1 pass, 1 fail");
  EXPECT_EQ(w.words(kPlane, "average: verdict"), "pass");
  EXPECT_EQ(w.words(kPlane, "minimum: verdict"), "fail");
  EXPECT_THAT(w.words(kPlane, "minimum: result"), HasSubstr("required ≥ 450 lx"));
  EXPECT_EQ(w.number(kPlane, "average: value", 2), 516.5);  // the upper end
  EXPECT_EQ(w.number(kPlane, "average: value", 3), 508.5);
  EXPECT_EQ(w.number(kPlane, "average: value", 5), 512.5);
  EXPECT_EQ(w.number(kPlane, "average: limit ≥", 2), 500.0);
  const auto& value = w.sets.at(kPlane).at("average: value");
  EXPECT_EQ(value[2].type_name(), "IFCILLUMINANCEMEASURE");
  const auto unit = w.text->find(value[4]);
  ASSERT_TRUE(unit);
  EXPECT_EQ(w.text->arguments(*unit).at(3).enumeration(), "LUX");
  EXPECT_EQ(w.words("Luxgate_Run", "Verdict"), "fail, of a part only");
  EXPECT_THAT(w.with->notes, Contains(HasSubstr("without results: 1 of 2 spaces of the model: "
                                                "'102 Hall'")));
}

// Once, with the run; beside no requirement.
TEST(IfcResults, SayOnceThatNumbersRestOnOnePublicSource) {
  report::Document document = result();
  rules::Requirement& requirement =
      document.projects[0].spaces[0].planes[0].findings[0].requirement;
  requirement.clause =
      calc::say<calc::Sentence::one_source_of>(calc::Message::words("EN 1:2021 7.1"));
  requirement.note = calc::say<calc::Sentence::one_source>();
  const Written w(model(), document);
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_THAT(w.words("Luxgate_Run", "One public source"),
              HasSubstr("rest on one public source: EN 1:2021 7.1."));
  EXPECT_THAT(w.words(kPlane, "average: result"), HasSubstr("[EN 1:2021 7.1 (project's own)]"));
  EXPECT_THAT(w.words(kPlane, "average: result"), Not(HasSubstr("public source")));
}

// The space and its sets are tied together, with the space's own owner history.
TEST(IfcResults, SetsBelongToTheirSpace) {
  const Written w(model(), result());
  ASSERT_TRUE(w.with) << w.problem;
  std::size_t of_space = 0, of_project = 0;
  for (const std::uint32_t relation : w.text->of_name("IFCRELDEFINESBYPROPERTIES")) {
    const auto a = w.text->arguments(relation);
    EXPECT_THAT(*a.at(0).text(), MatchesRegex("[0-3][0-9A-Za-z_$]{21}"));
    ASSERT_EQ(a.at(4).items().size(), 1u);
    const auto thing = a[4].items()[0].reference();
    of_space += thing == 1 ? 1 : 0;
    of_project += thing == 900 ? 1 : 0;
    if (thing == 1) {
      EXPECT_EQ(a.at(1).reference(), 700u);
    }
    if (thing == 900) {
      EXPECT_EQ(a.at(1).kind(), cli::StepValue::Kind::null);
    }
  }
  EXPECT_EQ(of_space, 2u);
  EXPECT_EQ(of_project, 1u);
}

TEST(IfcResults, AllElseStaysByteForByte) {
  const std::string before = "\xEF\xBB\xBF" + model();
  const Written w(before, result());
  ASSERT_TRUE(w.with) << w.problem;
  const std::string& after = w.with->text;
  const std::size_t end = before.rfind("ENDSEC;");
  EXPECT_EQ(after.substr(0, end), before.substr(0, end));
  EXPECT_THAT(after.substr(end), StartsWith("/* luxgate results: begin */\n#906="));
  EXPECT_EQ(after.substr(after.rfind("ENDSEC;")), before.substr(end));
  EXPECT_EQ(Written(before, result()).with->text, after);  // the same bytes again
}

TEST(IfcResults, AnEarlierExportIsReplacedAndNotDoubled) {
  const Written first(model(), result());
  ASSERT_TRUE(first.with);
  const Written again(first.with->text, result());
  ASSERT_TRUE(again.with) << again.problem;
  EXPECT_EQ(again.with->text, first.with->text);
  EXPECT_THAT(again.with->notes, Contains("the results of an earlier export were replaced"));
  // Another result takes its place, and the sets keep their GlobalIds.
  report::Document better = result();
  better.projects[0].spaces[0].planes[0].findings.pop_back();
  const Written other(first.with->text, better);
  ASSERT_TRUE(other.with);
  EXPECT_EQ(other.words(kRoom, "Verdict"), "pass");
  EXPECT_EQ(other.text->arguments(other.set_at.at(kRoom)).at(0).text(),
            first.text->arguments(first.set_at.at(kRoom)).at(0).text());
}

TEST(IfcResults, WhatSomebodyChangedIsNotTakenOut) {
  std::string touched = Written(model(), result()).with->text;
  touched.replace(touched.find("IFCLABEL('fail')"), 16, "IFCLABEL('pass')");
  const Written w(touched, result());
  EXPECT_FALSE(w.with);
  EXPECT_THAT(w.problem, HasSubstr("'Luxgate_"));
  EXPECT_THAT(w.problem, HasSubstr("of an earlier export"));
  // Something of the model refers to a result.
  std::string tied = Written(model(), result()).with->text;
  tied.insert(tied.find("#700="), "#699=IFCRELASSOCIATES('a',$,$,$,(#910));");
  const Written hanging(tied, result());
  EXPECT_FALSE(hanging.with);
  EXPECT_THAT(hanging.problem, HasSubstr("#699 refers to results"));
}

TEST(IfcResults, Ifc2x3HasNoSetPointAndWantsAnOwner) {
  const Written w(model("IFC2X3"), result());
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_EQ(w.sets.at(kPlane).at("average: value interval").size(), 5u);
  EXPECT_EQ(w.number(kPlane, "average: value", 2), 512.5);
  EXPECT_EQ(w.sets.at(kPlane).at("average: value").size(), 4u);
  // None of its own: another one of the model.
  const Written other(model("IFC2X3", "$"), result());
  ASSERT_TRUE(other.with) << other.problem;
  EXPECT_EQ(other.text->arguments(other.set_at.at(kRoom)).at(1).reference(), 700u);
  std::string none = model("IFC2X3", "$");
  none.replace(none.find("IFCOWNERHISTORY"), 15, "IFCSOMETHING");
  const Written without(none, result());
  EXPECT_FALSE(without.with);
  EXPECT_THAT(without.problem, HasSubstr("owner history"));
}

TEST(IfcResults, NothingThatIsNoPassLooksLikeOne) {
  report::Document document = result();
  report::PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.findings.pop_back();
  EXPECT_EQ(Written(model(), document).words(kRoom, "Verdict"), "pass");
  // A part.
  report::Document part = document;
  part.provenance.selection = "--plane 'desk-*'";
  EXPECT_EQ(Written(model(), part).words(kRoom, "Verdict"), "pass, of a part only");
  EXPECT_THAT(Written(model(), part).words(kRoom, "Part"), HasSubstr("desk-*"));
  // A plane without result, although nothing is asked of it.
  report::Document missing = document;
  report::PlanePart none;
  none.id = "none";
  none.reason = calc::Message::words("no luminaire");
  missing.projects[0].spaces[0].planes.push_back(none);
  const Written w(model(), missing);
  EXPECT_EQ(w.words(kRoom, "Verdict"), "not judged");
  EXPECT_EQ(w.words("Luxgate_Plane_none", "Verdict"), "not judged");
  EXPECT_EQ(w.words("Luxgate_Plane_none", "Not computed"), "no luminaire");
  // Undecided.
  report::Document open = document;
  open.projects[0].spaces[0].planes[0].findings[0] =
      report::sample_finding(rules::Metric::average, 500, report::estimate(501, 4));
  EXPECT_EQ(Written(model(), open).words(kRoom, "Verdict"), "undecided");
  // A warning that counts.
  report::Document warned = document;
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::rule_import_doubtful, {"a.xml", 1, 1}, "look here");
  warned.projects[0].diagnostics = diagnostics.all();
  warned.projects[0].strict_warnings = {calc::DiagnosticId::rule_import_doubtful};
  const Written strict(model(), warned);
  EXPECT_THAT(strict.words(kRoom, "Verdict"), Not(HasSubstr("pass")));
  EXPECT_THAT(strict.words("Luxgate_Run", "Message 1"), HasSubstr("look here"));
  EXPECT_THAT(strict.words(kRoom, "Warnings"), StartsWith("1 of the project"));
  // Nothing asked, or waived.
  report::Document nothing = document;
  nothing.projects[0].spaces[0].planes[0].findings.clear();
  EXPECT_EQ(Written(model(), nothing).words(kRoom, "Verdict"), "nothing is required");
  report::Document waived = result();
  waived.projects[0].spaces[0].planes[0].findings[1].is_waived = true;
  EXPECT_EQ(Written(model(), waived).words(kPlane, "minimum: verdict"),
            "fail, waived: it does not count");
}

TEST(IfcResults, ARoomThatHasChangedIsDoubted) {
  report::Document document = result();
  document.projects[0].spaces[0].height_m = 2.5;
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  const Written w(model(), document);
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_FALSE(w.with->is_all);
  EXPECT_EQ(w.words(kRoom, "Verdict"), "pass, but see Doubt");
  EXPECT_EQ(w.words(kPlane, "Verdict"), "pass, but see Doubt");
  EXPECT_THAT(w.words(kRoom, "Doubt"),
              HasSubstr("3.00 m high, that of the result 8.00 m² and 2.50"));
}

TEST(IfcResults, WhatHasNoPlaceIsSaid) {
  report::Document document = result();
  report::SpacePart absent = document.projects[0].spaces[0], foreign = absent;
  absent.id = "room-0BTBFw6f90Nfh9rP1dl000";
  foreign.id = "hall";
  document.projects[0].spaces.push_back(absent);
  document.projects[0].spaces.push_back(foreign);
  report::ProjectPart broken;
  broken.path = "broken.xml";
  document.projects.push_back(broken);
  const Written w(model(), document);
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_FALSE(w.with->is_all);
  EXPECT_THAT(w.with->notes,
              Contains(HasSubstr("not in this model: 'room-0BTBFw6f90Nfh9rP1dl000'")));
  EXPECT_THAT(w.with->notes, Contains(HasSubstr("'hall'")));
  EXPECT_THAT(w.words("Luxgate_Run", "Without a place in the model 1"), HasSubstr("broken.xml"));
  EXPECT_EQ(w.words("Luxgate_Run", "Verdict"), "not judged, of a part only, but see Doubt");
  EXPECT_THAT(w.words("Luxgate_Run", "Doubt"), HasSubstr("not all results have a place"));
}

// A verdict of all is no more than those of the rooms.
TEST(IfcResults, TheRunSaysWhatItsRoomsDoubt) {
  report::Document document = result();
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  const Written good(model(), document);
  EXPECT_EQ(good.words(kRoom, "Verdict"), "pass");
  // The other space of the model has no result.
  EXPECT_EQ(good.words("Luxgate_Run", "Verdict"), "pass, of a part only");
  EXPECT_THAT(good.words("Luxgate_Run", "Spaces without results"), HasSubstr("1 of 2 spaces"));
  document.projects[0].spaces[0].height_m = 2.5;
  const Written w(model(), document);
  EXPECT_EQ(w.words("Luxgate_Run", "Verdict"), "pass, of a part only, but see Doubt");
  EXPECT_THAT(w.words("Luxgate_Run", "Doubt"), HasSubstr("may not be those"));
}

TEST(IfcResults, ARoomOfAnotherShapeIsDoubted) {
  report::Document document = result();
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  // Where it lies does not count: the import takes its own origin.
  auto& outline_m = document.projects[0].spaces[0].footprint_m;
  for (glm::dvec2& corner : outline_m) corner += glm::dvec2(100.0, -7.0);
  EXPECT_EQ(Written(model(), document).words(kRoom, "Verdict"), "pass");
  outline_m = {{0, 0}, {8, 0}, {8, 1}, {0, 1}};  // 8 m2 as before
  const Written other(model(), document);
  EXPECT_FALSE(other.with->is_all);
  EXPECT_EQ(other.words(kRoom, "Verdict"), "pass, but see Doubt");
  EXPECT_THAT(other.words(kRoom, "Doubt"), HasSubstr("different outlines"));
}

TEST(IfcResults, HolesOfTheModelAreDoubted) {
  report::Document document = result();
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  std::string holed = model();
  const std::string whole = "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,4000.,2000.)";
  const std::size_t at = holed.find(whole);
  ASSERT_NE(at, holed.npos);
  holed.replace(at, whole.size(), "IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#911,(#921))");
  const auto loop = [](int first, const char* corners) {
    return fmt::format("#{0}=IFCPOLYLINE({1});", first, corners);
  };
  std::string points;
  const int corner[8][2] = {{-2000, -1000}, {2000, -1000}, {2000, 1000}, {-2000, 1000},
                            {-500, -500},   {500, -500},   {500, 500},   {-500, 500}};
  for (int i = 0; i < 8; ++i) {
    points += fmt::format("#{}=IFCCARTESIANPOINT(({}.,{}.));", 930 + i, corner[i][0], corner[i][1]);
  }
  const std::string more =
      points + loop(911, "(#930,#931,#932,#933,#930)") + loop(921, "(#934,#935,#936,#937,#934)");
  holed.insert(holed.rfind("ENDSEC;"), more + "\n");
  const Written w(holed, document);
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_EQ(w.words(kRoom, "Verdict"), "pass, but see Doubt");
  EXPECT_THAT(w.words(kRoom, "Doubt"), HasSubstr("holes in its floor (1)"));
}

TEST(IfcResults, ARoomIsFoundByTheIdThatItHad) {
  report::Document document = result();
  document.projects[0].spaces[0].was = document.projects[0].spaces[0].id;
  document.projects[0].spaces[0].id = "office";
  EXPECT_TRUE(Written(model(), document).with);
}

TEST(IfcResults, RefusalsHaveReasons) {
  const auto problem = [](const std::string& bytes, const report::Document& document) {
    const Written w(bytes, document);
    EXPECT_FALSE(w.with);
    return w.problem;
  };
  EXPECT_THAT(problem(model(), report::small_document()),
              HasSubstr("ids are not from an import: 'r1'"));
  EXPECT_THAT(problem(model(), report::Document()), HasSubstr("has no room"));
  EXPECT_THAT(problem("0\nSECTION\n", result()), HasSubstr("ISO-10303-21 is expected"));
  EXPECT_THAT(problem("ISO-10303-21;\nHEADER;\nENDSEC;\nEND-ISO-10303-21;", result()),
              HasSubstr("no instances"));
  EXPECT_THAT(problem(model("AP214"), result()), HasSubstr("'AP214'"));
  EXPECT_THAT(problem(test_support::ifc_file(""), result()), HasSubstr("no IfcSpace"));
  report::Document twice = result();
  twice.projects.push_back(twice.projects[0]);
  EXPECT_THAT(problem(model(), twice), HasSubstr("two results"));
  std::string large = model();
  large.insert(large.find("#700="), "#999999999999999999=IFCLABEL();");
  EXPECT_THAT(problem(large, result()), HasSubstr("no number is left"));
  std::string same = model();
  same.replace(same.find("'1F'"), 4, "'" + std::string(kSpace) + "'");
  EXPECT_THAT(problem(same, result()), HasSubstr("two spaces"));
}

TEST(IfcResults, NamesAndOddValuesAreWrittenSafely) {
  report::Document document = result();
  report::PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.name = "Bü'ro \\ /* 😀";
  plane.findings[0].requirement.id = "a";
  plane.findings[1].requirement.id = "a";
  plane.findings[0].measured.high = std::numeric_limits<double>::infinity();
  plane.findings[1].verdict = rules::Verdict::not_judged;
  plane.findings[1].reason = calc::Message::words("it is not possible");
  const Written w(model(), document);
  ASSERT_TRUE(w.with) << w.problem;
  EXPECT_EQ(w.words(kPlane, "Plane"), plane.name);
  EXPECT_TRUE(w.sets.at(kPlane).at("a: value").at(2).is_null());
  EXPECT_FALSE(w.sets.at(kPlane).contains("a: value (2)"));
  EXPECT_EQ(w.words(kPlane, "a: verdict (2)"), "not judged");
  for (const char c : w.with->text) EXPECT_LT(static_cast<unsigned char>(c), 0x80);
}

}  // namespace
}  // namespace ifc_results_test
