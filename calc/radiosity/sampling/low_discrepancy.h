#pragma once
// Owen-scrambled Sobol' points: point i of a sequence, no state.

#include "calc/radiosity/sampling/random.h"

#include <array>
#include <cstdint>

namespace calc {

// Dimensions with tabulated direction numbers [JoeKuo08]; later ones are hashed random numbers,
// which is harmless for the late bounces of a light path.
inline constexpr int kSobolDimensions = 21;

// An independent scramble of the Sobol' sequence. Any first 2^m points are a digital net; two keys
// give independent sequences, and every single point is uniform on [0, 1)^d.  [Owen95, Burley20]
class ScrambledSobol {
 public:
  // dimensions: as many have a prepared scramble; later ones compute it at every sample.
  explicit ScrambledSobol(RandomKey key, int dimensions = 2);

  // Returns coordinate `dimension` (>= 0) of point `index`, in [0, 1).
  double sample(std::uint32_t index, int dimension) const;
  // Returns coordinates `dimension` and `dimension` + 1.
  std::array<double, 2> sample_pair(std::uint32_t index, int dimension) const {
    return {sample(index, dimension), sample(index, dimension + 1)};
  }

  // Return the parts of samples, to make them elsewhere: the bits of `index` choose direction
  // numbers (bit 0 to 31, dimension below kSobolDimensions), whose sum modulo 2 is scrambled.
  RandomKey key() const { return key_; }
  std::uint32_t scramble(int dimension) const;
  static std::uint32_t direction_number(int dimension, int bit);

 private:
  RandomKey key_;
  int prepared_;
  std::array<std::uint32_t, kSobolDimensions> scramble_;
};

}  // namespace calc
