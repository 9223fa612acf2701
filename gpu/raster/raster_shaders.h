#pragma once
// Sources of shaders that draw triangles, and of those that read the drawn result.

#include <string>

namespace gpu {

struct RenderShaders {
  std::string vertex, fragment;
};

// The share of a depth by which two depths of one surface may differ: rasterisers interpolate with
// the rounding of large coordinates, Mesa's by 2e-4.
inline constexpr float kDepthBias = 1.0e-3f;

// Return shaders for depths of all surfaces around light vertices, as shares of depth_unit_m.
RenderShaders shadow_map_shaders();
std::string shadow_gather_shader();

// Returns shaders with two outputs: a value, and a colour over it. is_cover: only the colour.
RenderShaders picture_shaders(bool is_cover);

}  // namespace gpu
