#include "calc/radiosity/sampling/radix_sort.h"

#include <array>
#include <cstddef>

namespace calc {

void radix_sort(std::vector<KeyedIndex>& items, int bits) {
  constexpr int kDigitBits = 11;
  constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
  std::vector<KeyedIndex> other(items.size());
  for (int shift = 0; shift < bits; shift += kDigitBits) {
    const auto digit = [shift](const KeyedIndex& item) {
      return static_cast<std::size_t>(item.key >> shift) & (kDigits - 1);
    };
    std::array<std::uint32_t, kDigits> next{};
    for (const KeyedIndex& item : items) ++next[digit(item)];
    if (!items.empty() && next[digit(items.front())] == items.size()) continue;
    std::uint32_t begin = 0;
    for (std::uint32_t& n : next) {
      const std::uint32_t count = n;
      n = begin;
      begin += count;
    }
    for (const KeyedIndex& item : items) other[next[digit(item)]++] = item;
    items.swap(other);
  }
}

}  // namespace calc
