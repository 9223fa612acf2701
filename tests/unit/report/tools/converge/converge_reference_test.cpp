#include "report/tools/converge/converge_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cli::converge_reference_test {
namespace {

using testing::HasSubstr;

class ConvergeReference : public testing::Test {
 protected:
  ConvergeReference() {
    desk.position_m = {{1, 1, 0.75}, {2, 1, 0.75}};
    desk.column = {0, 1};
    desk.row = {0, 0};
    wall.position_m = {{0, 1, 1.5}};
    wall.column = {0};
    wall.row = {0};
    tasks = {{"desk", &desk}, {"wall", &wall}};
  }

  std::optional<std::vector<report::ConvergeTruth>> read(const std::string& text) {
    diagnostics = {};
    return read_reference(text, "r.csv", tasks, diagnostics);
  }
  std::string message() {
    return diagnostics.all().empty() ? "" : calc::format_diagnostic(diagnostics.all()[0]);
  }

  calc::SensorGrid desk, wall;
  std::vector<calc::PlaneTask> tasks;
  calc::Diagnostics diagnostics;
};

TEST_F(ConvergeReference, ReadsCellsInAnyOrderOfColumns) {
  const auto truths = read(
      "# by hand\nrow,lx,plane,column,note,error_lx\r\n0,120,desk,1,x,0.5\r\n0,100,desk,0,y,0.4\n"
      "0,30,wall,0,,0\n0,1,elsewhere,0,,0\n");
  ASSERT_TRUE(truths) << message();
  EXPECT_EQ((*truths)[0].lx, (std::vector<double>{100, 120}));
  EXPECT_EQ((*truths)[0].error_lx, (std::vector<double>{0.4, 0.5}));
  EXPECT_EQ((*truths)[1].lx, (std::vector<double>{30}));
  EXPECT_EQ((*truths)[0].average_lx, 110.0);
}

TEST_F(ConvergeReference, ReadsPlaces) {
  const auto truths = read("x_m,y_m,z_m,lx\n2.0004,1,0.75,120\n1,1,0.75,100\n0,1,1.5,30\n");
  ASSERT_TRUE(truths) << message();
  EXPECT_EQ((*truths)[0].lx, (std::vector<double>{100, 120}));
  EXPECT_EQ((*truths)[0].error_lx, (std::vector<double>{0, 0}));
}

TEST_F(ConvergeReference, SaysWhatIsWrong) {
  const auto problem = [&](const std::string& text) {
    EXPECT_FALSE(read(text));
    return message();
  };
  EXPECT_THAT(problem(""), HasSubstr("no line of column names"));
  EXPECT_THAT(problem("plane,lx\n"), HasSubstr("r.csv:1: error[reference-unreadable]"));
  EXPECT_THAT(problem("x,y,z,error_lx\n"), HasSubstr("columns 'lx' and either"));
  EXPECT_THAT(problem("x,y,z,lx,x_m\n"), HasSubstr("'x_m' is given twice"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.75\n"), HasSubstr("3 values in this line, 4 names"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.75,bright\n"), HasSubstr("'bright' in column 'lx'"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.75,-1\n"), HasSubstr("0 or more"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.752,1\n"), HasSubstr("r.csv:2: "));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.752,1\n"), HasSubstr("no such point"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.75,1\n1,1,0.75,2\n"), HasSubstr("given before"));
  EXPECT_THAT(problem("x,y,z,lx\n1,1,0.75,1\n0,1,1.5,2\n"),
              HasSubstr("1 of the 2 points of plane 'desk' are missing"));
  EXPECT_THAT(problem("plane,column,row,lx\ndesk,2,0,1\n"), HasSubstr("no such point"));
}

}  // namespace
}  // namespace cli::converge_reference_test
