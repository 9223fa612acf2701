#pragma once
// Counter-based random numbers: a value is a function of its purpose (seed, stage, replicate,
// index), never of earlier draws. So results do not depend on threads or on the order of work.

#include <cstdint>
#include <string_view>

namespace calc {

// Finaliser of splitmix64: a bijection of 64-bit words with full avalanche [Steele14].
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A chain of keys: RandomKey(seed).with(stage).with(replicate) ...
class RandomKey {
 public:
  constexpr explicit RandomKey(std::uint64_t seed) : bits_(mix_bits(seed)) {}

  constexpr RandomKey with(std::uint64_t part) const {
    RandomKey key(0);
    key.bits_ = mix_bits(bits_ ^ mix_bits(part));
    return key;
  }
  constexpr RandomKey with(std::string_view text) const {
    RandomKey key = with(text.size());
    for (const char c : text) key = key.with(static_cast<unsigned char>(c));
    return key;
  }

  constexpr std::uint64_t bits() const { return bits_; }
  // Returns a number in [0, 1), 53 bits.
  constexpr double uniform() const { return static_cast<double>(bits_ >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t bits_;
};

// First part of every key below the seed, so that no two uses share a stream.
enum class RandomStage : std::uint64_t {
  light_paths = 1,
  opening,
  near_field,
  connections,
  paths_from_points,
  between_points
};

constexpr RandomKey stage_key(std::uint64_t seed, RandomStage stage) {
  return RandomKey(seed).with(static_cast<std::uint64_t>(stage));
}

}  // namespace calc
