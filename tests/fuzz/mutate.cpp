#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace fuzz {
namespace {

constexpr std::size_t kLongest = 64 * 1024;  // bytes of an input

constexpr std::array<std::string_view, 18> kNumbers{
    "nan", "inf", "-inf", "1e308",       "-1e308",     "1e-308",
    "-1",  "0",   "-0",   "2147483647",  "4294967296", "1000000",
    "0.5", "1e9", "",     "-2147483649", "1,5",        "360"};

constexpr std::array<std::uint32_t, 9> kIntegers{
    0u, 1u, 2u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu, 0x7F800000u, 0x7FC00000u, 0x00100000u};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

}  // namespace

Mutator::Mutator(const std::vector<std::string>& seeds, std::uint64_t random_seed)
    : seeds_(seeds), random_(random_seed) {}

// Not a distribution of the standard library, whose numbers differ between libraries.
std::size_t Mutator::below(std::size_t count) {
  return count == 0 ? 0 : static_cast<std::size_t>(random_() % count);
}

std::string Mutator::next() {
  std::string text = any_seed();
  const std::size_t changes = below(2) == 0 ? 1 : 1 + below(4);
  for (std::size_t i = 0; i < changes; ++i) change(text);
  if (text.size() > kLongest) text.resize(kLongest);
  return text;
}

void Mutator::change(std::string& text) {
  switch (below(16)) {
    case 0:
      return cut(text);
    case 1:
      return splice(text);
    case 2:
    case 3:
      return remove_part(text);
    case 4:
    case 5:
      return double_part(text);
    case 6:
    case 7:
      return replace_integer(text);
    case 8:
    case 9:
    case 10:
      return flip_bytes(text);
    default:
      return replace_number(text);
  }
}

void Mutator::flip_bytes(std::string& text) {
  if (text.empty()) return;
  const std::size_t bytes = 1 + below(2);
  for (std::size_t i = 0; i < bytes; ++i) text[below(text.size())] = static_cast<char>(random_());
}

// The number that stands at or after a random place.
void Mutator::replace_number(std::string& text) {
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(below(text.size()));
  const auto begin = std::find_if(from, text.end(), is_of_number);
  const auto end = std::find_if_not(begin, text.end(), is_of_number);
  text.replace(begin, end, kNumbers[below(kNumbers.size())]);
}

void Mutator::replace_integer(std::string& text) {
  std::uint32_t value = kIntegers[below(kIntegers.size())];
  if (text.size() < sizeof value) return;
  const std::size_t at = below(text.size() - sizeof value + 1);
  std::memcpy(text.data() + at, &value, sizeof value);
}

void Mutator::cut(std::string& text) { text.resize(below(text.size())); }

void Mutator::remove_part(std::string& text) { text.erase(below(text.size()), 1 + below(40)); }

void Mutator::double_part(std::string& text) {
  const std::size_t at = below(text.size());
  const std::string part = text.substr(at, 1 + below(200));
  text.insert(at, part);
}

void Mutator::splice(std::string& text) {
  const std::string& other = any_seed();
  text = text.substr(0, below(text.size())) + other.substr(below(other.size()));
}

}  // namespace fuzz
