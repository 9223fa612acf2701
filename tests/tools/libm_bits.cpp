// Bits of some sines of the C library, which depend on the code that it chooses for the processor.
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

int main() {
  std::uint64_t sum = 0;
  for (int k = 1; k <= 1000; ++k) {
    volatile double x = 0.0137 * k;  // not to be worked out by the compiler
    const double sine = std::sin(x);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &sine, sizeof bits);
    sum = sum * 31 + bits;
  }
  std::printf("%016" PRIx64 "\n", sum);
}
