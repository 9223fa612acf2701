// A warning is in every format that a check or a report writes, and one that counts (--strict)
// looks green in none.

#include "calc/base/diagnostic_ids.h"
#include "report/formats/format.h"
#include "report/result_file/read_json.h"
#include "tests/support/legible.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <optional>
#include <string>

namespace report::warnings_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr calc::DiagnosticId kId = calc::DiagnosticId::light_leaves_room;

// Everything passes; two warnings of one id, one of another.
Document warned() {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.spaces[0].planes[0].findings.resize(1);
  project.diagnostics = {
      {kId, {"office.xml", 7, 3}, "16 % of the light is lost"},
      {kId, {"office.xml", 9, 3}, "12 % of the light is lost"},
      {calc::DiagnosticId::luminaires_coincide, {"office.xml", 8, 3}, "pasted twice?"}};
  return document;
}

Document strict() {
  Document document = warned();
  document.projects[0].strict_warnings = {kId};
  return document;
}

TEST(Warnings, AreInEveryFormatButPoints) {
  for (const Format& format : formats()) {
    if (is_table(format)) continue;
    const std::string text = legible(format, warned());
    for (const char* part : {"light-leaves-room", "luminaires-coincide", "16 % of the light",
                             "12 % of the light", "pasted twice?"}) {
      std::string found = text;
      if (format.name == "github") {
        for (std::size_t at = 0; (at = found.find("%25", at)) != std::string::npos;)
          found.replace(at, 3, "%");
      }
      EXPECT_THAT(found, HasSubstr(part)) << format.name;
    }
  }
}

TEST(Warnings, AreCountedInTheLastLineOfText) {
  const std::string text = rendered("text", warned());
  EXPECT_TRUE(text.ends_with("\n1 requirement: 1 pass, 3 warnings\n")) << text;
  Document one = warned();
  one.projects[0].diagnostics.resize(1);
  EXPECT_THAT(rendered("text", one), HasSubstr("1 requirement: 1 pass, 1 warning\n"));
  EXPECT_TRUE(rendered("text", strict())
                  .ends_with("\n1 requirement: 1 pass, 3 warnings (that count: 2)\n"));
}

TEST(Warnings, AreNotSaidTwiceOnATerminal) {
  TextOptions terminal;
  terminal.has_messages = false;
  const std::string text = rendered("text", warned(), {terminal});
  EXPECT_THAT(text, Not(HasSubstr("pasted twice?")));
  EXPECT_THAT(text, HasSubstr("3 warnings"));
}

TEST(Warnings, AreRowsOfTheTable) {
  EXPECT_THAT(rendered("csv", warned()),
              HasSubstr("\r\noffice.xml,,,light-leaves-room,,,,,,,,,,,,,warning,office.xml:7:3: "
                        "warning[light-leaves-room]: 16 % of the light is lost,,,,,,,,,,\r\n"));
  EXPECT_THAT(rendered("csv", strict()),
              HasSubstr("office.xml,,,light-leaves-room,,,,,,,,,,,,,strict warning,"));
  EXPECT_THAT(rendered("csv", strict()),
              HasSubstr("office.xml,,,luminaires-coincide,,,,,,,,,,,,,warning,"));
}

TEST(Warnings, AreCasesOfJunitWithNamesOfTheirOwn) {
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(rendered("junit", warned()).c_str()));
  const auto has_case = [&xml](const char* name, const char* result) {
    return !xml.select_nodes((std::string("//testcase[@name='") + name + "']/" + result).c_str())
                .empty();
  };
  EXPECT_TRUE(has_case("warning / light-leaves-room", "skipped"));
  EXPECT_TRUE(has_case("warning / light-leaves-room-2", "skipped"));
  EXPECT_TRUE(has_case("warning / luminaires-coincide", "skipped"));
  EXPECT_EQ(xml.child("testsuites").attribute("tests").as_int(), 4);
  EXPECT_EQ(xml.child("testsuites").attribute("failures").as_int(), 0);
  ASSERT_TRUE(xml.load_string(rendered("junit", strict()).c_str()));
  EXPECT_TRUE(has_case("warning / light-leaves-room", "failure"));
  EXPECT_TRUE(has_case("warning / luminaires-coincide", "skipped"));
  EXPECT_EQ(xml.child("testsuites").attribute("failures").as_int(), 2);
  EXPECT_EQ(xml.child("testsuites").child("testsuite").attribute("skipped").as_int(), 1);
}

TEST(Warnings, ThatCountAreErrorsToCiSystems) {
  EXPECT_THAT(rendered("github", warned()), Not(HasSubstr("::error")));
  EXPECT_THAT(rendered("github", strict()),
              HasSubstr("::error file=office.xml,line=7,col=3,title=luxgate%3A light-leaves-room"));
  EXPECT_THAT(rendered("github", strict()), HasSubstr("::warning file=office.xml,line=8"));
  EXPECT_THAT(rendered("gitlab", warned()), Not(HasSubstr("blocker")));
  EXPECT_THAT(rendered("gitlab", strict()), HasSubstr("blocker"));
  const auto level = [](const Document& document, int k) {
    return json::parse(rendered(
        "sarif", document))["runs"][0]["invocations"][0]["toolExecutionNotifications"][k]["level"];
  };
  EXPECT_EQ(level(warned(), 0), "warning");
  EXPECT_EQ(level(strict(), 0), "error");
  EXPECT_EQ(level(strict(), 2), "warning");
}

TEST(Warnings, ThatCountLeaveNoHeadlineGreen) {
  EXPECT_THAT(rendered("markdown", warned()), HasSubstr("### luxgate: ✓ pass: "));
  EXPECT_THAT(rendered("markdown", strict()), HasSubstr("### luxgate: ! warnings count: "));
  EXPECT_THAT(rendered("markdown", strict()),
              HasSubstr("- **warning that counts** office.xml:7:3: "));
  EXPECT_THAT(rendered("html", warned()), HasSubstr("class=\"banner pass\""));
  const std::string html = rendered("html", strict());
  EXPECT_THAT(html, Not(HasSubstr("class=\"banner pass\"")));
  EXPECT_THAT(html, HasSubstr("Warnings count in this run, and there are some"));
  EXPECT_THAT(html, HasSubstr("<b>warning that counts</b>"));
}

TEST(Warnings, MarkdownLeavesOutWhatIsTooMuch) {
  Document document = warned();
  document.projects[0].diagnostics.assign(23, document.projects[0].diagnostics[0]);
  EXPECT_THAT(rendered("markdown", document), HasSubstr("\n3 more are not listed here.\n"));
}

TEST(Warnings, ThatCountDoSoAgainWhenTheResultIsRead) {
  std::string problem;
  const std::optional<Document> again = read_json(rendered("json", strict()), problem);
  ASSERT_TRUE(again) << problem;
  EXPECT_EQ(outcome_of(*again), rules::Outcome::warned);
  EXPECT_EQ(count_warnings(*again).all, 3);
  EXPECT_EQ(count_warnings(*again).strict, 2);
  const json result = json::parse(rendered("json", strict()));
  EXPECT_EQ(result["warnings"], json({{"all", 3}, {"strict", 2}}));
  EXPECT_EQ(result["projects"][0]["strict_warnings"], json({"light-leaves-room"}));
  EXPECT_FALSE(json::parse(rendered("json", warned()))["projects"][0].contains("strict_warnings"));
}

TEST(Warnings, AnIdThatThisProgramDoesNotKnowIsRefused) {
  std::string text = rendered("json", strict());
  const std::string list = "\"strict_warnings\": [\"light-leaves-room\"]";
  const std::size_t at = text.find(list);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, list.size(), "\"strict_warnings\": [\"light-leaves-the-house\"]");
  std::string problem;
  EXPECT_FALSE(read_json(text, problem));
  EXPECT_THAT(problem, HasSubstr("unknown message id"));
}

}  // namespace
}  // namespace report::warnings_test
