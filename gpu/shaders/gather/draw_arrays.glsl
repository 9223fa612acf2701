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
// Of each receiver how far apart its draws are, and its shift.
layout(std430, binding = 10) SHARE_ACCESS buffer Spacings { dvec2 spacing_and_shift[]; };

uniform uint draws;
uniform uint first_receiver, first_tile;  // of the piece: where they lie among those of their block

struct Tile {
  bool is_chosen;            // false: the device did not do its work
  uint first_node, nodes;    // of the cut, in tile_word
  uint first_range, ranges;  // in tile_word: begin and end for each channel; ranges that hold some
  uint last_range;           // of those
};

// r: of the piece, as below.
uvec4 words_of(uint r, uint part) { return receiver_word[4u * (first_receiver + r) + part]; }

Tile tile_of(uint r) {
  const uint at = tile_size() * (words_of(r, 3u).x - first_tile);
  const uint first = at + TILE_HEAD;
  if (tile_word[at + 3u] != TILE_CHOSEN) return Tile(false, first, 0u, first, 0u, 0u);
  return Tile(true, first + 2u * most_ranges, tile_word[at], first, tile_word[at + 1u],
              tile_word[at + 2u]);
}

vec3 receiver_position(uint r) { return uintBitsToFloat(words_of(r, 0u).xyz); }
vec3 receiver_axis(uint r) { return uintBitsToFloat(words_of(r, 1u).xyz); }
vec3 receiver_lifted(uint r) { return uintBitsToFloat(words_of(r, 2u).xyz); }
uint receiver_kernel(uint r) { return words_of(r, 3u).y; }
