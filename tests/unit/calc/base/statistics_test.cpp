#include "calc/base/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace calc::statistics_test {
namespace {

TEST(StudentTQuantile, HasTheClosedFormOfOneDegreeOfFreedom) {
  for (const double p : {0.501, 0.6, 0.75, 0.9, 0.975, 0.995, 0.99999}) {
    // tan of the distance to the nearer end keeps its digits
    const double expected = p < 0.8 ? std::tan(M_PI * (p - 0.5)) : 1.0 / std::tan(M_PI * (1.0 - p));
    EXPECT_NEAR(student_t_quantile(p, 1) / expected, 1.0, 1e-12) << p;
  }
}

TEST(StudentTQuantile, HasTheClosedFormOfTwoDegreesOfFreedom) {
  for (const double p : {0.501, 0.6, 0.75, 0.9, 0.975, 0.995, 0.99999}) {
    const double q = 1.0 - p;
    const double expected = (p - q) / std::sqrt(2.0 * p * q);
    EXPECT_NEAR(student_t_quantile(p, 2) / expected, 1.0, 1e-12) << p;
  }
}

TEST(StudentTQuantile, HasTheClosedFormOfFourDegreesOfFreedom) {
  for (const double p : {0.6, 0.75, 0.9, 0.975, 0.995}) {
    const double alpha = 4.0 * p * (1.0 - p);
    const double q = std::cos(std::acos(std::sqrt(alpha)) / 3.0) / std::sqrt(alpha);
    EXPECT_NEAR(student_t_quantile(p, 4) / (2.0 * std::sqrt(q - 1.0)), 1.0, 1e-12) << p;
  }
}

struct TableRow {
  int degrees_of_freedom;
  double t_950, t_975, t_995, t_9995;
};

// Three decimals, as printed in statistics text books.
TEST(StudentTQuantile, AgreesWithPublishedTables) {
  constexpr std::array kTable{
      TableRow{1, 6.314, 12.706, 63.657, 636.619}, TableRow{2, 2.920, 4.303, 9.925, 31.599},
      TableRow{3, 2.353, 3.182, 5.841, 12.924},    TableRow{5, 2.015, 2.571, 4.032, 6.869},
      TableRow{7, 1.895, 2.365, 3.499, 5.408},     TableRow{10, 1.812, 2.228, 3.169, 4.587},
      TableRow{15, 1.753, 2.131, 2.947, 4.073},    TableRow{30, 1.697, 2.042, 2.750, 3.646},
      TableRow{60, 1.671, 2.000, 2.660, 3.460},    TableRow{120, 1.658, 1.980, 2.617, 3.373}};
  for (const TableRow& row : kTable) {
    SCOPED_TRACE(row.degrees_of_freedom);
    EXPECT_NEAR(student_t_quantile(0.950, row.degrees_of_freedom), row.t_950, 0.0005001);
    EXPECT_NEAR(student_t_quantile(0.975, row.degrees_of_freedom), row.t_975, 0.0005001);
    EXPECT_NEAR(student_t_quantile(0.995, row.degrees_of_freedom), row.t_995, 0.0005001);
    EXPECT_NEAR(student_t_quantile(0.9995, row.degrees_of_freedom), row.t_9995, 0.0005001);
  }
}

TEST(StudentTQuantile, ApproachesTheNormalDistribution) {
  // Cornish-Fisher: t = z + (z^3 + z) / (4 v) + (5 z^5 + 16 z^3 + 3 z) / (96 v^2) + O(v^-3)
  const double z = 1.959963984540054;
  for (const int v : {999, 1000, 1001, 1002, 5000, 100000}) {
    const double first = (z * z * z + z) / (4.0 * v);
    const double second = (5.0 * std::pow(z, 5) + 16.0 * z * z * z + 3.0 * z) / (96.0 * v * v);
    EXPECT_NEAR(student_t_quantile(0.975, v), z + first + second, 20.0 / (1.0 * v * v * v) + 1e-11)
        << v;
  }
}

TEST(StudentTQuantile, IsAntisymmetricAndIncreases) {
  for (const int v : {1, 2, 3, 15, 63}) {
    EXPECT_EQ(student_t_quantile(0.5, v), 0.0);
    double previous = -HUGE_VAL;
    for (const double p : {1e-12, 1e-4, 0.2, 0.25, 0.3, 0.49, 0.51, 0.7, 0.75, 0.8, 0.999}) {
      const double t = student_t_quantile(p, v);
      EXPECT_GT(t, previous);
      EXPECT_NEAR(student_t_quantile(1.0 - p, v), -t, 1e-3 * std::abs(t)) << "1 - p rounds";
      if (p >= 0.2 && p <= 0.8) {
        EXPECT_NEAR(student_t_quantile(1.0 - p, v), -t, 1e-12);
      }
      previous = t;
    }
  }
}

// Leading term of the tail for v = 3: P(T > t) = 2 sqrt(3) / (pi t^3) * (1 - 18 / (5 t^2) + ...).
TEST(StudentTQuantile, KeepsItsAccuracyFarOutInTheTail) {
  const double t = -student_t_quantile(1e-15, 3);
  const double tail = 2.0 * std::sqrt(3.0) / (M_PI * t * t * t) * (1.0 - 18.0 / (5.0 * t * t));
  EXPECT_NEAR(tail / 1e-15, 1.0, 1e-8);
}

TEST(ReplicateMean, IsMeanAndStandardErrorByHand) {
  const std::vector<double> values{1.0, 2.0, 3.0, 6.0};  // squares about 3: 4 + 1 + 0 + 9 = 14
  const ReplicateMean result = replicate_mean(values);
  EXPECT_DOUBLE_EQ(result.mean, 3.0);
  EXPECT_DOUBLE_EQ(result.standard_error, std::sqrt(14.0 / 3.0 / 4.0));
}

TEST(ReplicateMean, OfEqualValuesIsExact) {
  const std::vector<double> values(7, 0.1);
  EXPECT_EQ(replicate_mean(values).mean, 0.1);
  EXPECT_EQ(replicate_mean(values).standard_error, 0.0);
}

TEST(TInterval, IsMeanAndTTimesStandardError) {
  const std::vector<double> values{1.0, 2.0, 3.0, 6.0};
  const Estimate estimate = t_interval(values, 0.95);
  const double half_width = 3.182446305284263 * std::sqrt(14.0 / 12.0);  // t of 3 degrees, 97.5 %
  EXPECT_DOUBLE_EQ(estimate.value, 3.0);
  EXPECT_NEAR(estimate.low, 3.0 - half_width, 1e-12);
  EXPECT_NEAR(estimate.high, 3.0 + half_width, 1e-12);
}

TEST(TInterval, OfOneReplicateIsExact) {
  const std::vector<double> values{4.25};
  const Estimate estimate = t_interval(values, 0.95);
  EXPECT_EQ(estimate.low, 4.25);
  EXPECT_EQ(estimate.value, 4.25);
  EXPECT_EQ(estimate.high, 4.25);
}

}  // namespace
}  // namespace calc::statistics_test
