#pragma once
// node_terms.glsl as C++. A processor's division and square root are rounded as it needs them.

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

namespace calc::node_terms {
#include "calc/radiosity/node_terms.glsl"
}  // namespace calc::node_terms

#undef TERM
#undef REAL
#undef EXACT
#undef QUOTIENT
#undef ROOT
