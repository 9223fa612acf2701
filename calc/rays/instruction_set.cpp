#include "calc/rays/instruction_set.h"

#include <cpuid.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace calc {
namespace {

struct Row {
  std::string_view name, embree;
  SearchKernels kernels;
  bool (*is_here)();  // with all that Highway takes for granted beside it
};

bool has_sse4() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("aes") &&
         __builtin_cpu_supports("pclmul");
}
bool has_avx() { return has_sse4() && __builtin_cpu_supports("avx"); }
// Clang 14 does not know the name for __builtin_cpu_supports.
bool has_f16c() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}
bool has_avx2() {
  return has_avx() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && has_f16c();
}
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd");
}

constexpr std::array<Row, 6> kRows{{
    {"sse2", "sse2", SearchKernels::sse2, [] { return true; }},
    {"ssse3", "sse2", SearchKernels::ssse3, [] { return __builtin_cpu_supports("ssse3") != 0; }},
    {"sse4.2", "sse4.2", SearchKernels::sse4, has_sse4},
    {"avx", "avx", SearchKernels::sse4, has_avx},  // Highway has none of its own
    {"avx2", "avx2", SearchKernels::avx2, has_avx2},
    {"avx512", "avx512", SearchKernels::avx512, has_avx512},
}};

const Row& choose() {
  const std::string_view wanted = wanted_instruction_set();
  const auto found = std::find_if(kRows.rbegin(), kRows.rend(), [&](const Row& row) {
    return (wanted.empty() || row.name == wanted) && row.is_here();
  });
  if (found == kRows.rend()) {
    throw std::runtime_error(fmt::format("no instruction set '{}'", wanted));
  }
  return *found;
}

const Row& chosen() {
  static const Row& row = choose();
  return row;
}

}  // namespace

std::vector<std::string_view> instruction_sets() {
  std::vector<std::string_view> names;
  for (const Row& row : kRows) {
    if (row.is_here()) names.push_back(row.name);
  }
  return names;
}

std::string_view wanted_instruction_set() {
  const char* value = std::getenv("LUXGATE_ISA");
  return value == nullptr ? "" : value;
}

std::string_view instruction_set() { return chosen().name; }

SearchKernels search_kernels() { return chosen().kernels; }

std::string embree_instruction_set() { return fmt::format("isa={}", chosen().embree); }

}  // namespace calc
