// Bits of many sines and angles of the C library, which depend on the code that it chooses for the
// processor.
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

int main() {
  std::uint64_t sum = 0;
  for (int k = 1; k <= 200000; ++k) {
    volatile double x = 0.0137 * k;  // not to be worked out by the compiler
    for (const double value : {std::sin(x), std::atan2(x, 7.3), std::pow(x, 0.37)}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      sum = sum * 31 + bits;
    }
  }
  std::printf("%016" PRIx64 "\n", sum);
}
