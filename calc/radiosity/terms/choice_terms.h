#pragma once
// Includes choice_terms.glsl as C++. A processor rounds division and square root as it requires.

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#define TERM inline
#define UINT std::uint32_t
#define FVEC3 glm::vec3
#define IN_FVEC3 const glm::vec3&
#define IN_SOURCE const ChoiceSource&
#define EXACT const
#define QUOTIENT(a, b) ((a) / (b))
#define ROOT(a) std::sqrt(a)
#define CHOICE_BANDS kChoiceBands
#define LOBE const ChoiceLobe&
#define MOST_CD(lobe, band) (lobe).most_cd[band]
#define LARGEST_CD(lobe) (lobe).largest_cd

namespace calc::choice_terms {

inline constexpr std::size_t kChoiceBands = 32;  // of equal solid angle

// Intensities of a web about its axis; numbers of a device's table, one after the other.
struct ChoiceLobe {
  float largest_cd;
  std::array<float, kChoiceBands> most_cd;  // over the band and its neighbours
};

#include "calc/radiosity/terms/choice_terms.glsl"

}  // namespace calc::choice_terms

#undef TERM
#undef UINT
#undef FVEC3
#undef IN_FVEC3
#undef IN_SOURCE
#undef EXACT
#undef QUOTIENT
#undef ROOT
#undef CHOICE_BANDS
#undef LOBE
#undef MOST_CD
#undef LARGEST_CD
