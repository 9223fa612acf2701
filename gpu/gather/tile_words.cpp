#include "gpu/gather/tile_words.h"

#include <algorithm>

namespace gpu {

void append_tile(const calc::VertexTree& tree, std::size_t most_nodes,
                 std::span<const std::uint32_t> nodes,
                 std::span<const calc::Cut::ChannelRange> channels,
                 std::vector<std::uint32_t>& words) {
  const std::size_t roots = tree.roots().size(), at = words.size();
  words.resize(at + words_per_tile(most_nodes, roots));
  const std::span<std::uint32_t> tile = std::span(words).subspan(at);
  const auto channel_of = [&](std::uint32_t node) { return tree.nodes()[node].channel; };
  std::uint32_t last_range = 0;
  std::size_t k = 0;
  for (std::uint32_t root = 0; root < roots && k < channels.size(); ++root) {
    if (channel_of(nodes[channels[k].begin]) != channel_of(tree.roots()[root])) continue;
    tile[kTileHead + 2 * root] = channels[k].begin;
    tile[kTileHead + 2 * root + 1] = channels[k].end;
    last_range = root;
    ++k;
  }
  tile[0] = static_cast<std::uint32_t>(nodes.size());
  tile[1] = static_cast<std::uint32_t>(channels.size());
  tile[2] = last_range;
  tile[3] = kTileChosen;
  std::copy(nodes.begin(), nodes.end(), tile.subspan(kTileHead + 2 * roots).begin());
}

}  // namespace gpu
