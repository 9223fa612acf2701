#include "calc/radiosity/paths/draws.h"

#include "calc/radiosity/paths/node_weights.h"

#include <algorithm>
#include <limits>

namespace calc {
namespace {

// Total probability after the channels have got their shares.
double share_among_channels(const Cut& cut, std::vector<float>& probability) {
  const auto sum_of_range = [&](const Cut::ChannelRange& range) {
    return static_cast<double>(sum_of(&probability[range.begin], range.end - range.begin));
  };
  const std::span<const Cut::ChannelRange> channels = cut.channels();
  if (channels.empty()) return 0.0;
  if (channels.size() == 1) return sum_of_range(channels.front());
  double total = 0.0;
  for (const Cut::ChannelRange& range : channels) total += sum_of_range(range);
  double shared_total = 0.0;
  for (const Cut::ChannelRange& range : channels) {
    const double own = sum_of_range(range);
    const double even = total / static_cast<double>(channels.size());
    if (!(own > kLeastShare * total)) continue;  // next to no flux
    const auto factor = static_cast<float>(
        std::min(0.5 + 0.5 * even / own, static_cast<double>(std::numeric_limits<float>::max())));
    for (std::size_t c = range.begin; c < range.end; ++c) probability[c] *= factor;
    shared_total += sum_of_range(range);
  }
  return shared_total;
}

}  // namespace

void draw_connections(const VertexTree& tree, const Cut& cut, const Receiver& receiver,
                      std::uint32_t index, std::uint32_t draws, double u,
                      std::vector<float>& scratch, std::vector<Connection>& connections) {
  cut.weigh(receiver, scratch);
  const double total = share_among_channels(cut, scratch);
  if (!(total > 0.0)) return;
  const double spacing = total / draws;
  double next = u * spacing;  // of cumulated probability
  double begin = 0.0;
  for (std::size_t c = 0; c < scratch.size(); ++c) {
    const double q = static_cast<double>(scratch[c]);
    const double end = begin + q;
    if (next < end) {
      // Expected draws of a vertex: (q / spacing) (flux / node's flux).
      const double node_weight = spacing / q * static_cast<double>(cut.flux_lm(c));
      const std::uint32_t first = cut.first(c);
      const std::uint32_t last = first + cut.count(c);
      do {
        const std::uint32_t vertex =
            last - first == 1 ? first : tree.vertex_at(first, last, (next - begin) / q);
        const double flux = static_cast<double>(tree.vertices()[vertex].flux_lm);
        connections.push_back({index, vertex, static_cast<float>(node_weight / flux)});
        next += spacing;
      } while (next < end);
    }
    begin = end;
  }
}

}  // namespace calc
