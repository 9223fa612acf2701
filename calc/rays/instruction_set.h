#pragma once
// Selects the processor's vectors for the searches: the widest, or those that LUXGATE_ISA names. No
// answer depends on it; tests use it to show that.

#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Returns the names that LUXGATE_ISA may have on this processor, narrowest first: "sse2", "ssse3",
// "sse4.2", "avx", "avx2", "avx512".
std::vector<std::string_view> instruction_sets();

// Returns the value of LUXGATE_ISA; "" = not set.
std::string_view wanted_instruction_set();

// Returns the set in use, decided once, at the first call. Throws std::runtime_error if the wanted
// set is not among instruction_sets().
std::string_view instruction_set();

// The versions in which the searches are compiled; sse2: without vectors, because Highway has none
// for it.
enum class SearchKernels { sse2, ssse3, sse4, avx2, avx512 };
SearchKernels search_kernels();

// Returns the same for Embree, which has no "ssse3": "isa=avx2".
std::string embree_instruction_set();

}  // namespace calc
