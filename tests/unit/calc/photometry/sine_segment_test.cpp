#include "calc/photometry/sine_segment.h"

#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace calc::sine_segment_test {
namespace {

// Gauss-Legendre with 8 points on pieces of the segment, in long double: exact to far below 1e-15
// here.
long double quadrature(const SineSegment& segment, double x_rad) {
  constexpr long double kNode[4] = {0.18343464249564980494L, 0.52553240991632898582L,
                                    0.79666647741362673959L, 0.96028985649753623168L};
  constexpr long double kWeight[4] = {0.36268378337836198297L, 0.31370664587788728734L,
                                      0.22238103445337447054L, 0.10122853629037625915L};
  constexpr int kPieces = 32;
  const long double slope =
      (static_cast<long double>(segment.end_cd) - static_cast<long double>(segment.start_cd)) /
      static_cast<long double>(segment.width_rad);
  const auto density = [&](long double t) {
    return (static_cast<long double>(segment.start_cd) + slope * t) *
           std::sin(static_cast<long double>(segment.gamma_rad) + t);
  };
  long double sum = 0.0L;
  const long double half = static_cast<long double>(x_rad) / (2.0L * kPieces);
  for (int piece = 0; piece < kPieces; ++piece) {
    const long double middle = (2.0L * static_cast<long double>(piece) + 1.0L) * half;
    for (int k = 0; k < 4; ++k) {
      sum += kWeight[k] * half *
             (density(middle - kNode[k] * half) + density(middle + kNode[k] * half));
    }
  }
  return sum;
}

std::vector<SineSegment> hard_segments() {
  std::vector<SineSegment> segments;
  for (const double gamma : {0.0, 1e-9, 1e-3, 0.7, 1.5707, 2.9, 3.14159}) {
    for (const double width : {1e-8, 1e-6, 1e-4, 0.01, 0.2, 0.99, 1.01, kPi}) {
      if (gamma + width > kPi) continue;
      for (const auto& [start, end] :
           {std::pair{1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}, {3.0, 3.000001}}) {
        segments.push_back({gamma, width, start, end});
      }
    }
  }
  return segments;
}

TEST(SineSegment, IntegralAgreesWithQuadratureTo1e12) {
  for (const SineSegment& segment : hard_segments()) {
    for (const double share : {1e-3, 0.3, 1.0}) {
      const double x = share * segment.width_rad;
      const auto expected = static_cast<double>(quadrature(segment, x));
      EXPECT_NEAR(integral_to(segment, x) / expected, 1.0, 1e-12)
          << "gamma " << segment.gamma_rad << " width " << segment.width_rad << " from "
          << segment.start_cd << " to " << segment.end_cd << " share " << share;
    }
  }
}

TEST(SineSegment, InverseReturnsToTheSameShare) {
  for (const SineSegment& segment : hard_segments()) {
    const double whole = integral(segment);
    for (const double u : {1e-12, 1e-3, 0.25, 0.5, 0.9, 0.999999}) {
      const double x = invert_integral(segment, u * whole);
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, segment.width_rad);
      EXPECT_NEAR(integral_to(segment, x) / whole, u, 1e-14);
    }
  }
}

TEST(SineSegment, InverseOutsideTheRangeIsTheNearerEnd) {
  const SineSegment segment{0.2, 0.1, 1.0, 2.0};
  EXPECT_EQ(invert_integral(segment, 0.0), 0.0);
  EXPECT_EQ(invert_integral(segment, -1.0), 0.0);
  EXPECT_EQ(invert_integral(segment, 2.0 * integral(segment)), 0.1);
}

TEST(SineSegment, InverseOfADarkSegmentIsItsStart) {
  EXPECT_EQ(invert_integral({0.2, 0.1, 0.0, 0.0}, 0.0), 0.0);
}

TEST(LinearDensity, InversionMatchesClosedForms) {
  EXPECT_DOUBLE_EQ(invert_linear_density(1.0, 1.0, 0.3), 0.3);
  EXPECT_DOUBLE_EQ(invert_linear_density(0.0, 2.0, 0.25), 0.5);   // share s^2
  EXPECT_DOUBLE_EQ(invert_linear_density(2.0, 0.0, 0.75), 0.5);   // share 1 - (1 - s)^2
  EXPECT_DOUBLE_EQ(invert_linear_density(1.0, 3.0, 0.375), 0.5);  // share (s + s^2) / 2
  EXPECT_DOUBLE_EQ(invert_linear_density(0.0, 0.0, 0.4), 0.4);
  EXPECT_EQ(invert_linear_density(5.0, 1.0, 1.0), 1.0);
}

}  // namespace
}  // namespace calc::sine_segment_test
