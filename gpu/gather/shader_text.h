#pragma once
// Builds the sources of shaders from shaders/ and the formulas of calc/.

#include "gpu/gather/draw_piece.h"
#include "gpu/gather/tile_words.h"

#include <cstdint>
#include <string>

namespace gpu {

inline constexpr std::uint32_t kGroupSize = 64;

// Results of one connection or receiver, bit patterns that are not positive numbers; see
// gather_pass.h.
inline constexpr std::uint32_t kNoRay = 0;
inline constexpr std::uint32_t kAddsNothing = 0x8000'0000;
inline constexpr std::uint32_t kNotDone = 0xffff'ffff;

// Declares connection_geometry() and connection_lx() of calc/radiosity/terms/connection_terms.glsl.
std::string connection_terms_text();
// Returns the same in double, with numbers as in calc/base/shader_words.h: DBL(0.25).
std::string connection_terms_in_double();

// Returns the shader for given connections. has_shadows: false omits the rays.
std::string gather_shader(bool has_shadows);

// The shader that chooses the nodes of a tile's cut before its receivers draw; see tile_words.glsl.
inline constexpr std::uint32_t kMostChosen = 1024;  // nodes of a cut, by shared memory
std::string choose_shader();

// Stages of drawn connections in their order: the weights of nodes, their sums and the channels'
// shares, one ray for each draw, the sums of receivers.
enum class DrawStage { weigh, share, trace, add };
std::string draw_shader(DrawStage stage, const DrawShape& shape);

// Returns exact_quotient(a, b) and exact_root(a) after a shader's first lines, for their test.
std::string exact_arithmetic();
// Returns the same without these lines.
std::string exact_text();
// Declares key_with() and fraction_of().
std::string random_keys_text();
// Declares find_draw(), the data it reads, and the size of groups.
std::string drawn_vertex_text();

}  // namespace gpu
