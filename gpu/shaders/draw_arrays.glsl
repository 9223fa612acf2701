// What the stages of drawn connections share, see draw_pass.h: weigh, share, trace, add. After
// tile_words.

layout(local_size_x = LOCAL_SIZE) in;

layout(std430, binding = 4) readonly buffer Receivers { uvec4 receiver_word[]; };
layout(std430, binding = 5) readonly buffer Tiles { uint tile_word[]; };
layout(std430, binding = 6) readonly buffer NodeSpheres { vec4 node_sphere[]; };
layout(std430, binding = 7) readonly buffer NodeRests { uvec4 node_rest[]; };
// Rows of most_nodes values, one row for each receiver.
layout(std430, binding = 8) WEIGHT_ACCESS buffer Weights { float weight[]; };
layout(std430, binding = 9) SHARE_ACCESS buffer Cumulated { double cumulated[]; };
layout(std430, binding = 10) SHARE_ACCESS buffer Spacings { double spacing[]; };

uniform uint draws;

struct Tile {
  bool is_chosen;            // false: the device did not do its work
  uint first_node, nodes;    // of the cut, in tile_word
  uint first_range, ranges;  // in tile_word: begin and end for each channel; ranges that hold some
  uint last_range;           // of those
};

Tile tile_of(uint receiver) {
  const uint at = tile_size() * receiver_word[4u * receiver + 3u].x;
  const uint first = at + TILE_HEAD;
  if (tile_word[at + 3u] != TILE_CHOSEN) return Tile(false, first, 0u, first, 0u, 0u);
  return Tile(true, first + 2u * most_ranges, tile_word[at], first, tile_word[at + 1u],
              tile_word[at + 2u]);
}

vec3 receiver_position(uint r) { return uintBitsToFloat(receiver_word[4u * r].xyz); }
vec3 receiver_axis(uint r) { return uintBitsToFloat(receiver_word[4u * r + 1u].xyz); }
vec3 receiver_lifted(uint r) { return uintBitsToFloat(receiver_word[4u * r + 2u].xyz); }
uint receiver_kernel(uint r) { return receiver_word[4u * r + 3u].y; }
double receiver_shift(uint r) { return packDouble2x32(receiver_word[4u * r + 3u].zw); }
