// Numbers of one public source are said once in every format, and beside no requirement; that
// nobody has verified a number is said beside each.
#include "report/text/one_source_note.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "report/document/one_source.h"
#include "report/formats/format.h"
#include "report/result_file/read_json.h"
#include "tests/support/legible.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report::one_source_note_test {
namespace {

using calc::Message;
using calc::Sentence;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view kNote =
    "Numbers of 2 rows rest on one public source: EN 1:2021 7.1, 7.2.";

Message row(const std::string& name) { return Message::words("EN 1:2021 " + name); }

std::vector<Message> rows_of(const ProjectPart& project) {
  std::vector<Message> rows;
  add_one_source_rows(project, rows);
  return rows;
}

void mark(rules::Finding& finding, const std::string& name) {
  finding.requirement.clause = calc::say<Sentence::one_source_of>(row(name));
  finding.requirement.note =
      calc::say<Sentence::one_source>() + "; " + Message::words("a remark of the pack");
}

// Two requirements by two rows, each of one source; two projects ask the same.
Document marked() {
  Document document = small_document();
  document.projects.push_back(document.projects[0]);
  document.projects[1].path = "other.xml";
  for (ProjectPart& project : document.projects) {
    std::vector<rules::Finding>& findings = project.spaces[0].planes[0].findings;
    mark(findings.at(0), "7.1");
    mark(findings.at(1), "7.2");
  }
  return document;
}

std::size_t times(std::string_view text, std::string_view words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
  return count;
}

TEST(OneSourceNote, IsOncePerReportAndBesideNoRequirement) {
  std::vector<FormatStyle> styles(2);
  styles[1].page.detail = Detail::client;
  for (const Format& format : formats()) {
    if (is_table(format) || format.name == "json" || format.name == "pdf") continue;
    for (const FormatStyle& style : styles) {
      const bool is_page = format.name == "html";
      const std::string text = is_page ? format.render(marked(), style) : legible(format, marked());
      EXPECT_EQ(times(text, kNote), 1U) << format.name << "\n" << text;
      EXPECT_EQ(times(text, "one public source"), 1U) << format.name;
      EXPECT_THAT(text, HasSubstr("EN 1:2021 7.1")) << format.name;
      EXPECT_THAT(text, HasSubstr("with your copy of the standard.")) << format.name;
    }
  }
}

TEST(OneSourceNote, IsNotThereWithoutSuchNumbers) {
  for (const Format& format : formats()) {
    if (format.name == "pdf") continue;
    EXPECT_THAT(legible(format, small_document()), Not(HasSubstr("public source"))) << format.name;
  }
}

TEST(OneSourceNote, LeavesWhatNobodyHasVerifiedBesideEachRequirement) {
  Document document = small_document();
  for (rules::Finding& finding : document.projects[0].spaces[0].planes[0].findings) {
    finding.requirement.clause = calc::say<Sentence::unverified_of>(row("7.1"));
    finding.requirement.note = calc::say<Sentence::unverified>();
  }
  EXPECT_THAT(rows_of(document.projects[0]), IsEmpty());
  for (const std::string_view name : {"text", "csv", "junit", "markdown", "sarif-all"})
    EXPECT_GE(times(rendered(name, document), "unverified requirement"), 2U) << name;
  EXPECT_THAT(rendered("html", document), HasSubstr("nverified requirement"));
}

// Of aggregates, too. What is of both is one row.
TEST(OneSourceNote, NamesRowsOfAggregates) {
  Document document = marked();
  ProjectPart& project = document.projects[0];
  rules::AggregateFinding any;
  any.id = "glare";
  any.clause = calc::say<Sentence::one_source_of>(row("9"));
  any.note = calc::say<Sentence::one_source>();
  any.verdict = rules::Verdict::pass;
  project.aggregates = {any};
  any.clause = calc::say<Sentence::one_source_of>(row("7.2"));
  project.aggregates.push_back(any);
  EXPECT_THAT(rows_of(project), ElementsAre(row("7.1"), row("7.2"), row("9")));
  const std::string text = rendered("text", document);
  EXPECT_THAT(text, HasSubstr("Numbers of 3 rows rest on one public source: EN 1:2021 7.1, 7.2, "
                              "9."));
  EXPECT_EQ(times(text, "one public source"), 1U);
}

TEST(OneSourceNote, NamesSomeRowsAndCountsTheRest) {
  std::vector<Message> rows;
  EXPECT_EQ(one_source_note({}, rows), "");
  rows.push_back(row("7.1"));
  EXPECT_EQ(one_source_note({}, rows),
            "Numbers of one row rest on one public source: EN 1:2021 7.1. Compare the row with "
            "your copy of the standard.");
  rows.push_back(Message::words("EN 2:2024 escape route"));
  rows.push_back(row("7.2"));
  EXPECT_THAT(one_source_note({}, rows), HasSubstr("EN 1:2021 7.1, 7.2; EN 2:2024 escape route."));
  for (int i = 0; i < 12; ++i) rows.push_back(row(fmt::format("8.{}", i)));
  EXPECT_THAT(one_source_note({}, rows), HasSubstr("Numbers of 15 rows"));
  EXPECT_THAT(one_source_note({}, rows), HasSubstr(" and 3 more."));
  EXPECT_THAT(one_source_note({}, rows), Not(HasSubstr("8.9")));
}

TEST(OneSourceNote, RecommendationsDoNotCount) {
  Document document = marked();
  for (ProjectPart& project : document.projects)
    project.spaces[0].planes[0].findings.at(0).requirement.severity = rules::Severity::advice;
  EXPECT_THAT(rows_of(document.projects[0]), ElementsAre(row("7.2")));
}

TEST(OneSourceNote, IsInTheReadersLanguage) {
  const std::vector<Message> rows{row("7.1"), row("7.2")};
  EXPECT_EQ(one_source_note(Texts(Language::german, true), rows),
            "Werte von 2 Zeilen stammen aus einer einzigen öffentlichen Quelle: EN 1:2021 7.1, "
            "7.2. Vergleichen Sie die Zeilen mit Ihrem Exemplar der Norm.");
  EXPECT_EQ(one_source_note(Texts(Language::french, true), rows),
            "Des valeurs de 2 lignes proviennent d’une seule source publique\u202f: EN 1:2021 7.1, "
            "7.2. Comparez-les à votre exemplaire de la norme.");
}

// A result has the mark at each requirement, as earlier versions wrote it, and all rows in a list.
TEST(OneSourceNote, StaysInResultsWhereItWas) {
  const std::string text = rendered("json", marked());
  const json result = json::parse(text);
  EXPECT_EQ(result["one_source"], json({"EN 1:2021 7.1", "EN 1:2021 7.2"}));
  const json& finding = result["projects"][0]["spaces"][0]["planes"][0]["findings"][0];
  EXPECT_EQ(finding["clause"], "EN 1:2021 7.1 [one public source]");
  EXPECT_EQ(finding["requirement_note"], "one public source; a remark of the pack");
  EXPECT_EQ(finding["note"], "one public source; a remark of the pack");
  std::string problem;
  const std::optional<Document> again = read_json(text, problem);
  ASSERT_TRUE(again) << problem;
  EXPECT_EQ(rendered("json", *again), text);
  EXPECT_EQ(times(rendered("text", *again), kNote), 1U);
  json older = result;
  older.erase("one_source");
  const std::optional<Document> of_older = read_json(older.dump(), problem);
  ASSERT_TRUE(of_older) << problem;
  EXPECT_EQ(times(rendered("text", *of_older), kNote), 1U);
  EXPECT_FALSE(json::parse(rendered("json", small_document())).contains("one_source"));
}

TEST(OneSourceNote, WithoutTheMarkTheOtherRemarksStay) {
  const Message one = calc::say<Sentence::one_source>();
  const Message a = Message::words("a"), b = Message::words("b");
  EXPECT_EQ(without_one_source(one).english(), "");
  EXPECT_EQ(without_one_source(one + "; " + a).english(), "a");
  EXPECT_EQ(without_one_source(a + "; " + one).english(), "a");
  EXPECT_EQ(without_one_source(a + "; " + one + "; " + b).english(), "a; b");
  const Message within = calc::say<Sentence::not_made>(calc::say<Sentence::one_source_of>(a));
  EXPECT_EQ(without_one_source(within).english(), calc::say<Sentence::not_made>(a).english());
  EXPECT_EQ(without_one_source(calc::say<Sentence::unverified>()),
            calc::say<Sentence::unverified>());
}

// For those alone who want it to count.
TEST(OneSourceNote, IsAWarningOncePerProject) {
  ProjectPart project = marked().projects[0];
  const std::size_t before = project.diagnostics.size();
  warn_of_one_source(project);
  ASSERT_EQ(project.diagnostics.size(), before + 1);
  const calc::Diagnostic& warning = project.diagnostics.back();
  EXPECT_EQ(warning.id, calc::DiagnosticId::one_source);
  EXPECT_TRUE(is_warning(warning));
  EXPECT_EQ(warning.message,
            "the numbers of 2 rows rest on one public source: EN 1:2021 7.1, 7.2; compare them "
            "with your copy of the standard");
  project.strict_warnings = {warning.id};
  EXPECT_EQ(count_warnings(project).strict, 1);
  ProjectPart other = small_document().projects[0];
  warn_of_one_source(other);
  EXPECT_THAT(other.diagnostics, IsEmpty());
}

}  // namespace
}  // namespace report::one_source_note_test
