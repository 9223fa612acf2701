#pragma once
// Numbers that tell objects apart beyond their lives, where addresses are used again.

#include <cstdint>

namespace calc {

// Never the same twice in a process, never 0. Not a result's business: it orders nothing.
std::uint64_t new_identity();

}  // namespace calc
