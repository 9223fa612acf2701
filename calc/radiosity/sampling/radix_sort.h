#pragma once
// Sorts 64-bit keys with their indices.

#include <cstdint>
#include <vector>

namespace calc {

struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

// Sorts ascending by the lowest `bits` bits (1 to 64), which must hold the whole key; equal keys
// keep their order. Least significant digit first; digits that are the same in all keys cost
// nothing.
void radix_sort(std::vector<KeyedIndex>& items, int bits);

}  // namespace calc
