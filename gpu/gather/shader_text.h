#pragma once
// The sources of shaders, put together from shaders/ and the formulas of calc/.

#include "gpu/gather/draw_piece.h"
#include "gpu/gather/tile_words.h"

#include <cstdint>
#include <string>

namespace gpu {

inline constexpr std::uint32_t kGroupSize = 64;

// Results of one connection or receiver, bit patterns that are no positive number; see
// gather_pass.h.
inline constexpr std::uint32_t kNoRay = 0;
inline constexpr std::uint32_t kAddsNothing = 0x8000'0000;
inline constexpr std::uint32_t kNotDone = 0xffff'ffff;

// Declares connection_geometry() and connection_lx() of calc/radiosity/terms/connection_terms.glsl.
std::string connection_terms_text();
// The same in double, with numbers as calc/base/shader_words.h has them: DBL(0.25).
std::string connection_terms_in_double();

// Of given connections. has_shadows: false leaves the rays out.
std::string gather_shader(bool has_shadows);

// The nodes of a tile's cut, before its receivers draw; see shaders/gather/tile_words.glsl.
inline constexpr std::uint32_t kMostChosen = 1024;  // nodes of a cut, by shared memory
std::string choose_shader();

// Of drawn connections, in this order: the weights of nodes, their sums and the channels' shares,
// one ray for each draw, the sums of receivers.
enum class DrawStage { weigh, share, trace, add };
std::string draw_shader(DrawStage stage, const DrawShape& shape);

// exact_quotient(a, b) and exact_root(a) with what a shader begins with: for their test.
std::string exact_arithmetic();
// The same without a beginning.
std::string exact_text();
// Declares key_with() and fraction_of().
std::string random_keys_text();
// Declares find_draw(), what it reads, and the size of groups.
std::string drawn_vertex_text();

}  // namespace gpu
