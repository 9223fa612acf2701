#include "report/tools/compare/value_table.h"

#include <gtest/gtest.h>

namespace value_table_test {
namespace {

std::string problem_with(const std::string& text) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(cli::read_value_table(text, "t.csv", 0.95, diagnostics));
  return diagnostics.all().empty() ? "" : calc::format_diagnostic(diagnostics.all()[0]);
}

TEST(ValueTable, ReadsPlacesFootcandlesAndErrors) {
  calc::Diagnostics diagnostics;
  const auto table = cli::read_value_table("# site\nx,y,z,fc,error_fc,who\n1,2,0.8,10,0.5,me\n",
                                           "t.csv", 0.95, diagnostics);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 1u);
  EXPECT_EQ(*table->rows[0].position_m, glm::dvec3(1, 2, 0.8));
  EXPECT_FALSE(table->rows[0].plane);
  EXPECT_NEAR(table->rows[0].value.lx, 107.6391, 1e-4);
  EXPECT_NEAR(table->rows[0].value.half_width_lx, 1.959964 * 5.381955, 1e-4);
  EXPECT_EQ(table->unused_columns, (std::vector<std::string>{"who"}));
}

TEST(ValueTable, ReadsThePointsOfCheck) {
  calc::Diagnostics diagnostics;
  const auto table = cli::read_value_table(
      "project,space,plane,column,row,x_m,y_m,z_m,nx,ny,nz,illuminance_lx,low_lx,high_lx,direct_lx,"
      "indirect_lx\r\na.xml,room,\"p, one\",2,3,1,2,0.8,0,0,1,100,96,104,60,40\r\n",
      "points.csv", 0.95, diagnostics);
  ASSERT_TRUE(table);
  EXPECT_EQ(*table->rows[0].plane, "p, one");
  EXPECT_EQ(*table->rows[0].cell, glm::ivec2(2, 3));
  EXPECT_EQ(table->rows[0].value.half_width_lx, 4.0);
}

TEST(ValueTable, LeavesOutRatingsByTheirQuantity) {
  calc::Diagnostics diagnostics;
  const auto table = cli::read_value_table(
      "plane,column,row,illuminance_lx,low_lx,high_lx,quantity,rating\r\np,0,0,100,96,104,planar,"
      "\r\n"
      "u,0,0,,,,ugr,19\r\nm,0,0,,,,modelling,nan\r\nc,0,0,50,49,51,cylindrical,\r\n",
      "points.csv", 0.95, diagnostics);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(table->rows[0].quantity, "planar");
  EXPECT_EQ(table->rows[1].quantity, "cylindrical");
  EXPECT_EQ(table->ratings, 2u);
}

TEST(ValueTable, RefusesWhatItCannotMean) {
  EXPECT_NE(problem_with("plane,column,row,lx,quantity\np,0,0,5,E\n").find("'E' in column"),
            std::string::npos);
  EXPECT_NE(problem_with("plane,column,row,lx,quantity\np,0,0,,planar\n").find("is not a number"),
            std::string::npos);
  EXPECT_NE(problem_with("x,y,z\n1,2,3\n").find("'lx' or a column 'fc'"), std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx,fc\n").find("either"), std::string::npos);
  EXPECT_NE(problem_with("lx\n3\n").find("'x', 'y' and 'z'"), std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx\n1,2,3\n").find("t.csv:2: "), std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx\n1,2,3,much\n").find("'much' in column 'lx'"),
            std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx\n1,2,3,\"4,5\"\n")
                .find("'4,5' in column 'lx' is not a number; write it with a decimal point"),
            std::string::npos);
  EXPECT_NE(problem_with("x;y;z;lx\n1;2;3;4,5\n").find("t.csv:1:2: error[reference-unreadable]: "),
            std::string::npos);
  EXPECT_NE(problem_with("x;y;z;lx\n1;2;3;4,5\n").find("cells are separated by semicolons"),
            std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx\n1,2,3,-1\n").find("0 or more"), std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx,low_lx\n").find("error_lx"), std::string::npos);
  EXPECT_NE(problem_with("plane,column,row,lx\np,1.5,0,3\n").find("whole numbers"),
            std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx,x_m\n").find("the column 'x_m' is given twice"),
            std::string::npos);
  EXPECT_NE(problem_with("# 5\" tubes\nx,y,z,lx\n1,2,3,\"4\n").find("t.csv:3:7: "),
            std::string::npos);
  EXPECT_NE(problem_with("").find("no line of column names"), std::string::npos);
  EXPECT_NE(problem_with("x,y,z,lx\n").find("no values"), std::string::npos);
}

}  // namespace
}  // namespace value_table_test
