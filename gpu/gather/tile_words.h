#pragma once
// The nodes that a tile's receivers choose from, in the layout of shaders/gather/tile_words.glsl.

#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/vertex_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

inline constexpr std::uint32_t kTileHead = 4, kTileChosen = 1;

// Returns the words of a tile. most_ranges: channels of the pool, that is roots of its tree.
constexpr std::size_t words_per_tile(std::size_t most_nodes, std::size_t most_ranges) {
  return std::size_t{kTileHead} + 2 * most_ranges + most_nodes;
}

// Appends a tile with these nodes, at most most_nodes, in pool order; channels: their ranges.
void append_tile(const calc::VertexTree& tree, std::size_t most_nodes,
                 std::span<const std::uint32_t> nodes,
                 std::span<const calc::Cut::ChannelRange> channels,
                 std::vector<std::uint32_t>& words);

}  // namespace gpu
