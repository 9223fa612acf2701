// What the stages of drawn connections share, see draw_pass.h: weigh, share, trace, add.

layout(local_size_x = LOCAL_SIZE) in;

layout(std430, binding = 4) readonly buffer Receivers { uvec4 receiver_word[]; };
layout(std430, binding = 5) readonly buffer Tiles { uint tile_word[]; };
layout(std430, binding = 6) readonly buffer NodeSpheres { vec4 node_sphere[]; };
layout(std430, binding = 7) readonly buffer NodeRests { uvec4 node_rest[]; };
// Rows of most_nodes values, one row for each receiver.
layout(std430, binding = 8) WEIGHT_ACCESS buffer Weights { float weight[]; };
layout(std430, binding = 9) SHARE_ACCESS buffer Cumulated { double cumulated[]; };
layout(std430, binding = 10) SHARE_ACCESS buffer Spacings { double spacing[]; };

uniform uint most_nodes, draws;

struct Tile {
  uint first_node, nodes;    // of the cut, in tile_word
  uint first_range, ranges;  // of channels, in tile_word
};

Tile tile_of(uint receiver) {
  const uint t = 4u * receiver_word[4u * receiver + 3u].x;
  return Tile(tile_word[t], tile_word[t + 1u], tile_word[t + 2u], tile_word[t + 3u]);
}

vec3 receiver_position(uint r) { return uintBitsToFloat(receiver_word[4u * r].xyz); }
vec3 receiver_axis(uint r) { return uintBitsToFloat(receiver_word[4u * r + 1u].xyz); }
vec3 receiver_lifted(uint r) { return uintBitsToFloat(receiver_word[4u * r + 2u].xyz); }
uint receiver_kernel(uint r) { return receiver_word[4u * r + 3u].y; }
double receiver_shift(uint r) { return packDouble2x32(receiver_word[4u * r + 3u].zw); }
