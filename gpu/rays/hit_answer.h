#pragma once
// The answer for the short rays of a point, see hit_pass.h.

#include <cstddef>
#include <cstdint>

namespace gpu {

// An answer; a double for each channel follows: lx.
struct HitAnswer {
  float largest_lx;  // of a ray
  std::uint32_t rays;
  std::uint32_t hits;  // that are in it, and that are left; more than these means not done
  std::uint32_t left;  // to the CPU
};
static_assert(sizeof(HitAnswer) == 16);

constexpr std::size_t hit_answer_bytes(std::size_t channels) {
  return sizeof(HitAnswer) + channels * sizeof(double);
}

}  // namespace gpu
