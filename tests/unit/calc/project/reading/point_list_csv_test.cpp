#include "calc/project/reading/point_list_csv.h"

#include "calc/base/diagnostic_ids.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::point_list_csv_test {
namespace {

TEST(PointListCsv, ReadsByteOrderMarkCarriageReturnsBlanksAndEmptyLines) {
  Diagnostics diagnostics;
  const auto list = parse_point_list(
      "\xEF\xBB\xBFx,y,z,nx,ny,nz\r\n1, -2 ,3e-1,0,3,-4\r\n\r\n5,6,7,0,0,1", "f.csv", diagnostics);
  ASSERT_TRUE(list);
  EXPECT_EQ(list->file, "f.csv");
  ASSERT_EQ(list->position_m.size(), 2u);
  EXPECT_EQ(list->position_m[0], glm::dvec3(1, -2, 0.3));
  EXPECT_DOUBLE_EQ(list->normal[0].y, 0.6);
  EXPECT_DOUBLE_EQ(list->normal[0].z, -0.8);
  EXPECT_EQ(list->position_m[1], glm::dvec3(5, 6, 7));
  EXPECT_EQ(list->line, (std::vector<int>{2, 4}));
}

TEST(PointListCsv, ReadsQuotedCells) {
  Diagnostics diagnostics;
  const auto list =
      parse_point_list("\"x\",y,z,nx,ny,nz\n\"1\",\" 2\",3,0,0,\"1\"\n", "f.csv", diagnostics);
  ASSERT_TRUE(list);
  EXPECT_EQ(list->position_m[0], glm::dvec3(1, 2, 3));
}

TEST(PointListCsv, ColumnsNameTheUnit) {
  const struct {
    const char* head;
    double metres;
    bool names_its_unit;
  } cases[] = {{"x,y,z", 1.0, false},
               {"x_m,y_m,z_m", 1.0, true},
               {"x_cm,y_cm,z_cm", 0.01, true},
               {"x_mm,y_mm,z_mm", 0.001, true},
               {"x_in,y_in,z_in", 0.0254, true},
               {"x_ft,y_ft,z_ft", 0.3048, true}};
  for (const auto& one : cases) {
    Diagnostics diagnostics;
    const auto list =
        parse_point_list(std::string(one.head) + ",nx,ny,nz\n1,2,3,0,0,1\n", "f.csv", diagnostics);
    ASSERT_TRUE(list) << one.head;
    EXPECT_DOUBLE_EQ(list->position_m[0].y, 2 * one.metres);
    EXPECT_EQ(list->names_its_unit, one.names_its_unit);
  }
  for (const char* head : {"x_m,y_mm,z_m,nx,ny,nz", "x_m,y,z,nx,ny,nz", "x,y,z_m,nx,ny,nz",
                           "x_km,y_km,z_km,nx,ny,nz", "x_m,y_m,z_m,nx_m,ny_m,nz_m"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_point_list(std::string(head) + "\n1,2,3,0,0,1\n", "f.csv", diagnostics));
    EXPECT_EQ(diagnostics.all().at(0).id, DiagnosticId::point_list_header) << head;
  }
}

TEST(PointListCsv, ATextWithACommaIsOneCell) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_point_list("x,y,z,nx,ny,nz\n\"1,2\",3,0,0,1\n", "f.csv", diagnostics));
  EXPECT_EQ(format_diagnostic(diagnostics.all().at(0)),
            "f.csv:2: error[point-list-line]: expected 6 numbers separated by commas "
            "(x,y,z,nx,ny,nz), found 5");
}

TEST(PointListCsv, SaysWhereAQuoteBeganThatIsNeverClosed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_point_list("x,y,z,nx,ny,nz\n1,2,3,0,0,1\n1,\"2,3,0,0,1\n1,2,3,0,0,1\n",
                                "f.csv", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(format_diagnostic(diagnostics.all()[0]),
            "f.csv:3:3: error[csv-quotes]: a quote is not closed");
}

TEST(PointListCsv, GivesUpAfterTenBadLines) {
  std::string text = "x,y,z,nx,ny,nz\n";
  for (int i = 0; i < 1000; ++i) text += "1;2;3;0;0;1\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_point_list(text, "f.csv", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 11u);
  EXPECT_EQ(format_diagnostic(diagnostics.all().back()),
            "f.csv:11: error[point-list-gives-up]: more than 9 bad lines; the rest was not read");
}

TEST(PointListCsv, RefusesNumbersThatAreNotFiniteOrTooLarge) {
  for (const char* number : {"nan", "inf", "1e999", "2e9", "", "1 2"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_point_list("x,y,z,nx,ny,nz\n0,0," + std::string(number) + ",0,0,1\n", "f",
                                  diagnostics))
        << number;
    EXPECT_EQ(diagnostics.error_count(), 1u) << number;
  }
}

TEST(PointListCsv, AnEmptyFileHasNoPoints) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_point_list("", "f.csv", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1u);
}

}  // namespace
}  // namespace calc::point_list_csv_test
