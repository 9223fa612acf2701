#pragma once
// The sources of shaders, put together from shaders/ and the formulas of calc/.

#include <cstdint>
#include <string>

namespace gpu {

inline constexpr std::uint32_t kGroupSize = 64;

// Results of one connection, bit patterns that are no positive number; see gather_pass.h.
inline constexpr std::uint32_t kNoRay = 0;
inline constexpr std::uint32_t kAddsNothing = 0x8000'0000;
inline constexpr std::uint32_t kNotDone = 0xffff'ffff;

// Declares connection_geometry() and connection_lx() of calc/radiosity/connection_terms.glsl.
std::string connection_terms_text();

// has_shadows: false leaves the rays out.
std::string gather_shader(bool has_shadows);

}  // namespace gpu
