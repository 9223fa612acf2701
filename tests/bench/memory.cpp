#include "tests/bench/memory.h"

#include <fstream>
#include <limits>
#include <string>

// __GLIBC__ is known after any standard header.
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace bench {
namespace {

double memory_mib(const std::string& field) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    double kib = 0.0;
    if (word == field + ":" && file >> kib) return kib / 1024.0;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double used_memory_mib() { return memory_mib("VmRSS"); }
double peak_memory_mib() { return memory_mib("VmHWM"); }

void reset_peak_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace bench
