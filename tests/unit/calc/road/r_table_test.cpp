// Road surfaces: look-ups by hand, the classes' own measures by integration, and the edge.
#include "calc/road/r_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace calc::r_table_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double r_of(std::string_view name, double tan_epsilon, double beta_deg) {
  const RTable* table = r_table(name);
  if (table == nullptr) {
    ADD_FAILURE() << name;
    return 0.0;
  }
  return r_1e4(*table, tan_epsilon, beta_deg);
}

TEST(RTable, NamesAreThoseOfTheTables) {
  EXPECT_EQ(r_table_names(),
            (std::vector<std::string_view>{"R1", "R2", "R3", "R4", "C1", "C2", "W3", "W4"}));
  for (const std::string_view name : r_table_names()) {
    ASSERT_NE(r_table(name), nullptr);
    EXPECT_EQ(r_table(name)->name, name);
    EXPECT_EQ(r_table(name)->is_wet, name.front() == 'W');
  }
  EXPECT_EQ(r_table("R5"), nullptr);
  EXPECT_EQ(r_table("r3"), nullptr);
  EXPECT_EQ(r_table(""), nullptr);
}

// Worked out by hand from the printed table.
TEST(RTable, LookUpsAgreeWithHandWork) {
  EXPECT_NEAR(r_of("R3", 2, 0), 326, 1e-9);
  EXPECT_NEAR(r_of("R3", 2, 180), 38, 1e-9);
  EXPECT_NEAR(r_of("R3", 0, 90), 294, 1e-9);
  EXPECT_NEAR(r_of("R3", 10, 20), 2, 1e-9);
  EXPECT_NEAR(r_of("R3", 2.25, 12.5), 134.75, 1e-9);
  EXPECT_NEAR(r_of("R3", 0.1, 1), 306.8, 1e-9);
  EXPECT_NEAR(r_of("R3", 5.25, 100), 1.78333333, 1e-8);
  EXPECT_NEAR(r_of("R3", 11.8, 3.5), 14.34, 1e-9);
  EXPECT_NEAR(r_of("C2", 2.5, 2), 262, 1e-9);
  EXPECT_NEAR(r_of("C2", 0.6, 7.5), 373, 1e-9);
  EXPECT_NEAR(r_of("R1", 0.75, 60), 386, 1e-9);
  EXPECT_NEAR(r_of("R4", 4.5, 90), 6.4, 1e-9);
  EXPECT_NEAR(r_of("C1", 1.6, 35), 118.4, 1e-9);
  EXPECT_EQ(r_of("R3", 12.5, 0), 0.0);
}

TEST(RTable, NodesGiveThePrintedFigures) {
  for (const std::string_view name : r_table_names()) {
    const RTable& table = *r_table(name);
    for (std::size_t i = 0; i < kRTableTans; ++i) {
      for (std::size_t k = 0; k < kRTableBetas; ++k) {
        EXPECT_NEAR(r_1e4(table, kRTableTan[i], kRTableBeta_deg[k]), table.r_1e4[i][k], 1e-9)
            << name << " " << kRTableTan[i] << " " << kRTableBeta_deg[k];
        EXPECT_GE(table.r_1e4[i][k], 0.0);
        // Under a luminaire beta has no meaning.
        EXPECT_EQ(table.r_1e4[0][k], table.r_1e4[0][0]) << name;
      }
    }
  }
}

TEST(RTable, EndsAtTan12) {
  EXPECT_EQ(r_of("R3", 12.0, 0.0), r_table("R3")->r_1e4[28][0]);
  EXPECT_GT(r_of("R3", 12.0, 0.0), 10.0);
  EXPECT_GT(r_of("R3", 12.0 + 1e-12, 0.0), 10.0);  // rounding
  EXPECT_EQ(r_of("R3", 12.0001, 0.0), 0.0);
  EXPECT_EQ(r_of("R3", 1e9, 0.0), 0.0);
}

struct SurfaceMeasure {
  const char* name;
  double q0, s1;          // nominal
  double own_q0, own_s1;  // integrated by another program
  double s1_from, s1_to;  // class
};
constexpr SurfaceMeasure kMeasures[] = {
    {"R1", 0.10, 0.25, 0.1027, 0.247, 0.0, 0.42},  {"R2", 0.07, 0.58, 0.0712, 0.582, 0.42, 0.85},
    {"R3", 0.07, 1.11, 0.0712, 1.109, 0.85, 1.35}, {"R4", 0.08, 1.55, 0.0813, 1.549, 1.35, 9.0},
    {"C1", 0.10, 0.24, 0.1014, 0.244, 0.0, 0.40},  {"C2", 0.07, 0.97, 0.0714, 0.967, 0.40, 9.0},
    {"W3", 0.196, 8.65, 0.2038, 8.651, 7.2, 9.8},  {"W4", 0.247, 10.84, 0.2532, 10.838, 9.8, 12.0}};

// Q0 is the mean of q = r / cos^3 over the solid angle, from -4 H to 12 H along and 3 H to each
// side. A transposed or lost row shows.
TEST(RTable, MeasuresAreThoseOfTheClasses) {
  for (const SurfaceMeasure& measure : kMeasures) {
    const RTable& table = *r_table(measure.name);
    EXPECT_DOUBLE_EQ(table.q0, measure.q0);
    constexpr double kCell = 0.05;
    double r_sum = 0.0, cos3_sum = 0.0;
    for (int i = 0; i < 320; ++i) {
      for (int k = 0; k < 60; ++k) {  // one side is as the other
        const double x = -4.0 + kCell * (i + 0.5), y = kCell * (k + 0.5);
        const double tan_epsilon = std::hypot(x, y);
        r_sum += 1e-4 * r_1e4(table, tan_epsilon, std::atan2(y, x) / kDegree);
        cos3_sum += std::pow(1.0 + tan_epsilon * tan_epsilon, -1.5);
      }
    }
    const double q0 = r_sum / cos3_sum;
    EXPECT_NEAR(q0, measure.own_q0, 0.0001) << measure.name;
    EXPECT_NEAR(q0, table.q0, 0.041 * table.q0) << measure.name;
    const double s1 = r_1e4(table, 2.0, 0.0) / r_1e4(table, 0.0, 0.0);
    EXPECT_NEAR(s1, measure.own_s1, 0.0006) << measure.name;
    EXPECT_NEAR(s1, measure.s1, 0.006) << measure.name;
    EXPECT_GE(s1, measure.s1_from);
    EXPECT_LT(s1, measure.s1_to);
  }
}

// Sums over all cells, plain and with the number of the cell (1 to 580, row by row), worked out
// from the collected figures by a script: a cell that changes, moves or is lost shows.
TEST(RTable, FiguresAreThoseCollected) {
  const struct {
    const char* name;
    double sum, numbered;
  } sums[] = {
      {"R1", 67772.3, 5289054},   {"R2", 47446.4, 4247320.4}, {"R3", 42856.4, 4533496.1},
      {"R4", 45343.6, 5721168},   {"C1", 73465, 5364440},     {"C2", 45950, 4478311},
      {"W3", 107132.7, 18230254}, {"W4", 123933, 24673546},
  };
  for (const auto& expected : sums) {
    double sum = 0.0, numbered = 0.0;
    int number = 0;
    for (const auto& row : r_table(expected.name)->r_1e4)
      for (const double r : row) sum += r, numbered += ++number * r;
    EXPECT_NEAR(sum, expected.sum, 1e-6) << expected.name;
    EXPECT_NEAR(numbered, expected.numbered, 1e-4) << expected.name;
  }
}

// Across the nodes.
TEST(RTable, LookUpIsContinuous) {
  for (const std::string_view name : r_table_names()) {
    const RTable& table = *r_table(name);
    for (std::size_t i = 1; i + 1 < kRTableTans; ++i) {
      for (double beta = 0.5; beta < 180.0; beta += 7.3) {
        const double at = r_1e4(table, kRTableTan[i], beta);
        EXPECT_NEAR(r_1e4(table, kRTableTan[i] - 1e-9, beta), at, 1e-4);
        EXPECT_NEAR(r_1e4(table, kRTableTan[i] + 1e-9, beta), at, 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace calc::r_table_test
