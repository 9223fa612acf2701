#include "calc/radiosity/sampling/identity.h"

#include <atomic>

namespace calc {

std::uint64_t new_identity() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace calc
