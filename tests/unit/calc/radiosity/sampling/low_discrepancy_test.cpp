#include "calc/radiosity/sampling/low_discrepancy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace low_discrepancy_test {
namespace {

using calc::RandomKey;
using calc::ScrambledSobol;

// Every interval of length 1/n holds exactly one of the first n points, for every power of two.
TEST(ScrambledSobol, EveryDimensionIsStratified) {
  const ScrambledSobol sobol(RandomKey(5));
  for (int d = 0; d < calc::kSobolDimensions; ++d) {
    for (const std::uint32_t n : {8u, 256u, 4096u}) {
      std::vector<int> hits(n, 0);
      for (std::uint32_t i = 0; i < n; ++i) {
        const double u = sobol.sample(i, d);
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        ++hits[static_cast<std::size_t>(u * n)];
      }
      for (const int h : hits) ASSERT_EQ(h, 1) << "dimension " << d << ", n " << n;
    }
  }
}

// The first two dimensions form a (0, 2)-sequence: every elementary rectangle of area 1/n holds one
// point.
TEST(ScrambledSobol, FirstTwoDimensionsAreAZeroTwoSequence) {
  const ScrambledSobol sobol(RandomKey(77));
  constexpr std::uint32_t kPoints = 256;
  for (std::uint32_t columns = 1; columns <= kPoints; columns *= 2) {
    const std::uint32_t rows = kPoints / columns;
    std::vector<int> hits(kPoints, 0);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const auto x = static_cast<std::size_t>(sobol.sample(i, 0) * columns);
      const auto y = static_cast<std::size_t>(sobol.sample(i, 1) * rows);
      ++hits[y * columns + x];
    }
    for (const int h : hits) ASSERT_EQ(h, 1) << columns << " x " << rows;
  }
}

// Direction numbers of any two tabulated dimensions are different sequences: no two are correlated.
TEST(ScrambledSobol, DimensionsAreUncorrelated) {
  const ScrambledSobol sobol(RandomKey(3));
  constexpr std::uint32_t kPoints = 4096;
  for (int a = 0; a < calc::kSobolDimensions + 2; ++a) {
    for (int b = a + 1; b < calc::kSobolDimensions + 2; ++b) {
      double sum = 0.0;
      for (std::uint32_t i = 0; i < kPoints; ++i) {
        sum += (sobol.sample(i, a) - 0.5) * (sobol.sample(i, b) - 0.5);
      }
      // Standard deviation for independent numbers is 1 / 64; five of them.
      EXPECT_LT(std::abs(12.0 * sum / kPoints), 5.0 / 64.0) << a << ", " << b;
    }
  }
}

// Replicates must be independent, or error bars lie: means over different keys of one point are
// uniform, and neighbouring keys are uncorrelated.
TEST(ScrambledSobol, KeysGiveIndependentSequences) {
  constexpr int kKeys = 4096;
  for (const std::uint32_t index : {0u, 1u, 100u}) {
    for (const int d : {0, 1, 7}) {
      double mean = 0.0, variance = 0.0, neighbour = 0.0, previous = 0.0;
      for (int k = 0; k < kKeys; ++k) {
        const double u =
            ScrambledSobol(RandomKey(1).with(static_cast<std::uint64_t>(k))).sample(index, d) - 0.5;
        mean += u / kKeys;
        variance += u * u / kKeys;
        neighbour += u * previous / kKeys;
        previous = u;
      }
      EXPECT_LT(std::abs(mean), 5.0 * std::sqrt(1.0 / 12.0 / kKeys));
      EXPECT_NEAR(variance, 1.0 / 12.0, 0.005);
      EXPECT_LT(std::abs(neighbour), 5.0 / 12.0 / std::sqrt(kKeys));
    }
  }
}

// A smooth integrand: the error of a scrambled net falls much faster than n^-1/2.
TEST(ScrambledSobol, SmoothIntegrandsConvergeFasterThanRandom) {
  const auto error = [](std::uint32_t n) {
    double square = 0.0;
    for (std::uint64_t key = 0; key < 32; ++key) {
      const ScrambledSobol sobol(RandomKey(4).with(key));
      double sum = 0.0;
      for (std::uint32_t i = 0; i < n; ++i) sum += sobol.sample(i, 0) * sobol.sample(i, 1);
      square += std::pow(sum / n - 0.25, 2) / 32;
    }
    return std::sqrt(square);
  };
  EXPECT_LT(error(1024), 0.003 * error(4));  // random points: 0.06
}

TEST(RandomKey, TextAndNumberPartsDoNotCollide) {
  const RandomKey key(1);
  EXPECT_NE(key.with("ab").bits(), key.with("ba").bits());
  EXPECT_NE(key.with("a").with("b").bits(), key.with("ab").bits());
  EXPECT_NE(key.with(1).with(2).bits(), key.with(2).with(1).bits());
  EXPECT_EQ(key.with("task").bits(), RandomKey(1).with("task").bits());
}

}  // namespace
}  // namespace low_discrepancy_test
