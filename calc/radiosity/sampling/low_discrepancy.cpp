#include "calc/radiosity/sampling/low_discrepancy.h"

#include "calc/radiosity/terms/path_terms.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace calc {
namespace {

constexpr int kBits = 32;

// Primitive polynomial (degree, inner coefficients) and first direction integers of dimensions 2,
// 3, ... [JoeKuo08, new-joe-kuo-6]
struct SobolSeed {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 7> m;
};

constexpr std::array<SobolSeed, kSobolDimensions - 1> kSeeds{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

using DirectionTable = std::array<std::array<std::uint32_t, kBits>, kSobolDimensions>;

constexpr DirectionTable make_directions() {
  DirectionTable v{};
  for (std::size_t bit = 0; bit < kBits; ++bit) v[0][bit] = std::uint32_t{1} << (31 - bit);
  for (std::size_t d = 1; d < kSobolDimensions; ++d) {
    const SobolSeed& seed = kSeeds[d - 1];
    const auto s = static_cast<std::size_t>(seed.degree);
    for (std::size_t bit = 0; bit < kBits; ++bit) {
      if (bit < s) {
        v[d][bit] = seed.m[bit] << (31 - bit);
        continue;
      }
      std::uint32_t value = v[d][bit - s] ^ (v[d][bit - s] >> s);
      for (std::size_t k = 1; k < s; ++k) {
        if ((seed.coefficients >> (s - 1 - k)) & 1u) value ^= v[d][bit - k];
      }
      v[d][bit] = value;
    }
  }
  return v;
}

constexpr DirectionTable kDirections = make_directions();

// [dimension][byte of the index][value]: the direction numbers of its bits, combined, and reversed
// as the scramble wants them.
using ByteTable =
    std::array<std::array<std::array<std::uint32_t, 256>, kBits / 8>, kSobolDimensions>;

ByteTable make_byte_table() {
  ByteTable table{};
  for (std::size_t d = 0; d < kSobolDimensions; ++d) {
    for (std::size_t byte = 0; byte < kBits / 8; ++byte) {
      for (std::size_t value = 1; value < 256; ++value) {
        const auto low = static_cast<std::size_t>(std::countr_zero(value));
        table[d][byte][value] =
            table[d][byte][value & (value - 1)] ^ reverse_bits(kDirections[d][8 * byte + low]);
      }
    }
  }
  return table;
}

const ByteTable kByteTable = make_byte_table();

std::uint32_t scramble_of(RandomKey key, int dimension) {
  return static_cast<std::uint32_t>(key.with(static_cast<std::uint64_t>(dimension)).bits() >> 32);
}

}  // namespace

ScrambledSobol::ScrambledSobol(RandomKey key, int dimensions)
    : key_(key), prepared_(std::min(dimensions, kSobolDimensions)) {
  for (int d = 0; d < prepared_; ++d) scramble_[static_cast<std::size_t>(d)] = scramble_of(key_, d);
}

std::uint32_t ScrambledSobol::scramble(int dimension) const {
  return dimension < prepared_ ? scramble_[static_cast<std::size_t>(dimension)]
                               : scramble_of(key_, dimension);
}

std::uint32_t ScrambledSobol::direction_number(int dimension, int bit) {
  return kDirections[static_cast<std::size_t>(dimension)][static_cast<std::size_t>(bit)];
}

double ScrambledSobol::sample(std::uint32_t index, int dimension) const {
  const auto d = static_cast<std::size_t>(dimension);
  if (dimension >= kSobolDimensions) return key_.with(d).with(index).uniform();
  const auto& table = kByteTable[d];
  std::uint32_t x = table[0][index & 0xffu];
  std::size_t byte = 1;
  for (std::uint32_t rest = index >> 8; rest != 0; rest >>= 8) x ^= table[byte++][rest & 0xffu];
  return static_cast<double>(nested_scramble_reversed(x, scramble(dimension))) * 0x1.0p-32;
}

}  // namespace calc
