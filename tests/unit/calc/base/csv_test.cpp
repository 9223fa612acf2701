#include "calc/base/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace calc::csv_test {
namespace {

using testing::ElementsAre;

using Texts = std::vector<std::string>;

Texts texts(const CsvRecord& record) {
  Texts all;
  for (const CsvCell& cell : record.cells) all.push_back(cell.text);
  return all;
}

std::vector<Texts> all_of(std::string_view bytes, CsvComments comments = CsvComments::none) {
  CsvReader table(bytes, comments);
  std::vector<Texts> all;
  while (const std::optional<CsvRecord> record = table.next()) all.push_back(texts(*record));
  EXPECT_FALSE(table.problem());
  return all;
}

std::string problem_of(std::string_view bytes) {
  CsvReader table(bytes);
  while (table.next()) {
  }
  Diagnostics diagnostics;
  EXPECT_TRUE(report_csv_problem(table, "t.csv", diagnostics));
  EXPECT_FALSE(table.next());
  return diagnostics.all().empty() ? "" : format_diagnostic(diagnostics.all()[0]);
}

TEST(Csv, CellsAreTrimmedAndLinesEndInAnyWay) {
  EXPECT_THAT(all_of("a, b ,\tc\r\n1,,3\r4\n,"),
              ElementsAre(Texts{"a", "b", "c"}, Texts{"1", "", "3"}, Texts{"4"}, Texts{"", ""}));
  EXPECT_THAT(all_of("\xEF\xBB\xBF"
                     "a"),
              ElementsAre(Texts{"a"}));
  EXPECT_THAT(all_of(""), ElementsAre());
}

TEST(Csv, QuotesEncloseCommasQuotesAndLineEnds) {
  EXPECT_THAT(all_of("\"a, b\", \"say \"\"x\"\"\" ,\"1\r\n2\n3\",\"\"\n\"#\"\n", CsvComments::hash),
              ElementsAre(Texts{"a, b", "say \"x\"", "1 2 3", ""}, Texts{"#"}));
}

TEST(Csv, BlankLinesAreRecordsThatSaySo) {
  CsvReader table("\n \t\n\"\"\na\n,\n");
  for (const bool is_blank : {true, true, true, false, false}) {
    const std::optional<CsvRecord> record = table.next();
    ASSERT_TRUE(record);
    EXPECT_EQ(record->is_blank(), is_blank) << record->line;
  }
  EXPECT_FALSE(table.next());
}

TEST(Csv, CommentsAreBlankLinesWhateverIsInThem) {
  EXPECT_THAT(all_of("# 5\" tube, a\n  #\na#\n", CsvComments::hash),
              ElementsAre(Texts{""}, Texts{""}, Texts{"a#"}));
  EXPECT_THAT(all_of("#a,b\n"), ElementsAre(Texts{"#a", "b"}));
}

TEST(Csv, EveryCellKnowsItsPlace) {
  CsvReader table("\xC3\xA4, b\n\"1\n2\",c\nd\n");
  const CsvRecord first = table.next().value(), second = table.next().value();
  EXPECT_EQ(first.text, "\xC3\xA4, b");
  EXPECT_EQ(first.cells[1].place.line, 1);
  EXPECT_EQ(first.cells[1].place.column, 4);
  EXPECT_EQ(second.line, 2);
  EXPECT_EQ(second.text, "\"1\n2\",c");
  EXPECT_EQ(second.cells[1].place.line, 3);
  EXPECT_EQ(second.cells[1].place.column, 4);
  EXPECT_EQ(table.next().value().line, 4);
}

TEST(Csv, MistakesWithQuotesAreFoundWhereTheyBegin) {
  EXPECT_EQ(problem_of("a\n1,\"2\n3,4\n"), "t.csv:2:3: error[csv-quotes]: a quote is not closed");
  EXPECT_EQ(problem_of("\""), "t.csv:1:1: error[csv-quotes]: a quote is not closed");
  EXPECT_EQ(problem_of("\"a\"\""), "t.csv:1:1: error[csv-quotes]: a quote is not closed");
  const std::string stray =
      " error[csv-quotes]: misplaced quote; enclose the whole cell in quotes and write a quote in "
      "it twice";
  EXPECT_EQ(problem_of("a,5\" tube\n"), "t.csv:1:4:" + stray);
  EXPECT_EQ(problem_of("a, \"b\" c\n"), "t.csv:1:4:" + stray);
}

TEST(Csv, SemicolonsAndTabsAreNamed) {
  const std::string needed = "; commas are needed between cells, and decimal points in numbers";
  EXPECT_EQ(problem_of("\n x;y;z\n1,5;2;3\n"),
            "t.csv:2:3: error[csv-separator]: cells are separated by semicolons" + needed);
  EXPECT_EQ(problem_of("\"\xC3\xA4,b\";\"y\"\n"),
            "t.csv:1:6: error[csv-separator]: cells are separated by semicolons" + needed);
  EXPECT_EQ(problem_of("x\ty\n1\t2\n"),
            "t.csv:1:2: error[csv-separator]: cells are separated by tabs" + needed);
  EXPECT_EQ(problem_of("sep=;\nx;y\n"),
            "t.csv:1:5: error[csv-separator]: cells are separated by semicolons" + needed);
  // The semicolon is in a remark: the next line has commas.
  EXPECT_THAT(all_of("survey; by me\na,b\n"), ElementsAre(Texts{"survey; by me"}, Texts{"a", "b"}));
  EXPECT_EQ(problem_of("x;y\n1,5;2\n"),
            "t.csv:1:2: error[csv-separator]: cells are separated by semicolons" + needed);
  // A comma between cells, one column, and text in later lines.
  EXPECT_THAT(all_of("a;b,c\n\"1;2\",3\n"), ElementsAre(Texts{"a;b", "c"}, Texts{"1;2", "3"}));
  EXPECT_THAT(all_of("a\n1;2\n"), ElementsAre(Texts{"a"}, Texts{"1;2"}));
  EXPECT_THAT(all_of("\"a;b\"\n"), ElementsAre(Texts{"a;b"}));
  EXPECT_THAT(all_of("# a;b\nx,y\n", CsvComments::hash), ElementsAre(Texts{""}, Texts{"x", "y"}));
}

TEST(Csv, DecimalCommasAreTold) {
  EXPECT_EQ(decimal_comma_hint("-1,5"), "; write it with a decimal point");
  for (const char* text : {"", "1.5", "a,b", "1,2,3"}) EXPECT_EQ(decimal_comma_hint(text), "");
}

TEST(Csv, ColumnsOfLengthsNameTheirUnit) {
  EXPECT_EQ(length_column("aim_x_mm").name, "aim_x");
  EXPECT_EQ(length_column("aim_x_mm").metres, 0.001);
  for (const std::string_view name : {"x", "axis_x", "_m", "m", "rotation_deg", ""}) {
    EXPECT_EQ(length_column(name).name, name);
    EXPECT_FALSE(length_column(name).metres) << name;
  }
}

TEST(CsvColumns, FindNamesInAnyOrder) {
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  CsvReader table("y,what,x_m\n1,2,3\n");
  const CsvColumns columns(table.next().value(), kNames, [](std::string_view name) {
    return name == "x_m" ? std::string_view("x") : name;
  });
  const CsvRecord record = table.next().value();
  EXPECT_EQ(columns.width(), 3u);
  EXPECT_EQ(columns.cell(record, 0), "3");
  EXPECT_EQ(columns.cell(record, 1), "1");
  EXPECT_FALSE(columns.has(2));
  EXPECT_EQ(columns.cell(record, 2), "");
  EXPECT_THAT(columns.unknown(), ElementsAre("what"));
  EXPECT_EQ(columns.doubled(), "");
  CsvReader again("x,y,x,q,q\n");
  EXPECT_EQ(CsvColumns(again.next().value(), kNames).doubled(), "x");
}

}  // namespace
}  // namespace calc::csv_test
