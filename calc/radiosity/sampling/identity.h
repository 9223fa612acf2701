#pragma once
// Numbers that identify objects beyond their lives, because addresses are used again.

#include <cstdint>

namespace calc {

// Returns a number that is unique in the process and never 0. Results do not depend on it.
std::uint64_t new_identity();

}  // namespace calc
