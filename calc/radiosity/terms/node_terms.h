#pragma once
// Includes node_terms.glsl and cut_terms.glsl as C++. A processor rounds division and square root
// as they require.

#include <bit>
#include <cstdint>

#if defined(__GNUC__)
// Loops over nodes only become vectors if all of it is inlined.
#define TERM [[gnu::always_inline]] inline
#else
#define TERM inline
#endif
#define REAL float
#define EXACT const
#define QUOTIENT(a, b) ((a) / (b))
#define ROOT(a) __builtin_sqrtf(a)
#define BITS_OF(a) std::bit_cast<std::uint32_t>(a)

namespace calc::node_terms {
#include "calc/radiosity/terms/node_terms.glsl"
// This text uses the one above.
#include "calc/radiosity/terms/cut_terms.glsl"
}  // namespace calc::node_terms

#undef TERM
#undef REAL
#undef EXACT
#undef QUOTIENT
#undef ROOT
#undef BITS_OF
