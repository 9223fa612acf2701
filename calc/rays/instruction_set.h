#pragma once
// Which of the processor's vectors the searches use: the widest, or those that LUXGATE_ISA names.
// No answer depends on it; tests use it to show that.

#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Names that LUXGATE_ISA may have on this processor, narrowest first: "sse2", "ssse3", "sse4.2",
// "avx", "avx2", "avx512".
std::vector<std::string_view> instruction_sets();

// What LUXGATE_ISA says; "" = not set.
std::string_view wanted_instruction_set();

// The one in use. Decided once, at the first call. Throws std::runtime_error if the one wanted is
// not among instruction_sets().
std::string_view instruction_set();

// The versions in which the searches are compiled; sse2: without vectors, for which Highway has
// none.
enum class SearchKernels { sse2, ssse3, sse4, avx2, avx512 };
SearchKernels search_kernels();

// The same for Embree, which has no "ssse3": "isa=avx2".
std::string embree_instruction_set();

}  // namespace calc
