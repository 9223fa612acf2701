#include "calc/rays/instruction_set.h"

#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace calc {
namespace {

struct Row {
  std::string_view name;
  bool (*is_here)();
  std::int64_t target;  // Highway's; smaller numbers are better ones. 0 = the baseline
};

const std::array<Row, 6> kRows{{
    {"sse2", [] { return true; }, 0},  // without vectors: Highway has none for it
    {"ssse3", [] { return __builtin_cpu_supports("ssse3") != 0; }, HWY_SSSE3},
    {"sse4.2", [] { return __builtin_cpu_supports("sse4.2") != 0; }, HWY_SSE4},
    {"avx", [] { return __builtin_cpu_supports("avx") != 0; }, HWY_SSE4},  // Highway has none of it
    {"avx2", [] { return __builtin_cpu_supports("avx2") != 0; }, HWY_AVX2},
    {"avx512",
     [] {
       return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
              __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0;
     },
     HWY_AVX3},
}};

const Row& choose() {
  const std::vector<std::string_view> here = instruction_sets();
  const std::string_view wanted = wanted_instruction_set();
  const std::string_view name = wanted.empty() ? here.back() : wanted;
  if (std::find(here.begin(), here.end(), name) == here.end()) {
    throw std::runtime_error(fmt::format("no instruction set '{}'", name));
  }
  const Row& row =
      *std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.name == name; });
  if (!wanted.empty()) {
    const std::int64_t all = hwy::SupportedTargets();
    hwy::DisableTargets(row.target == 0 ? all : all & (row.target - 1));
  }
  return row;
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

std::string embree_instruction_set() {
  return fmt::format("isa={}", chosen().name == "ssse3" ? "sse2" : chosen().name);
}

}  // namespace calc
