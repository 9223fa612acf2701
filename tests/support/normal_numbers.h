#pragma once
// Normal random numbers that are the same with every standard library.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

// std::normal_distribution differs between libraries; Box and Muller's transform does not.
class NormalNumbers {
 public:
  explicit NormalNumbers(std::uint64_t seed) : generator_(seed) {}

  double next() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  double uniform() {  // in (0, 1]
    return (static_cast<double>(generator_() >> 11) + 1.0) * 0x1p-53;
  }

  std::mt19937_64 generator_;
};
