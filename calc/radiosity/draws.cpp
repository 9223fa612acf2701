#include "calc/radiosity/draws.h"

#include <algorithm>

namespace calc {
namespace {

// Nodes of a cut lie in order of channels.
void share_among_channels(const Cut& cut, std::vector<float>& probability) {
  const std::size_t nodes = probability.size();
  float total = 0.0f;
  int lit_channels = 0;
  for (std::size_t c = 0; c < nodes; ++c) {
    total += probability[c];
    if (c == 0 || cut.channel(c) != cut.channel(c - 1)) ++lit_channels;
  }
  for (std::size_t begin = 0; begin < nodes;) {
    std::size_t end = begin;
    float sum = 0.0f;
    for (; end < nodes && cut.channel(end) == cut.channel(begin); ++end) sum += probability[end];
    const float factor = 0.5f + 0.5f * total / (static_cast<float>(lit_channels) * sum);
    for (std::size_t c = begin; c < end; ++c) probability[c] *= factor;
    begin = end;
  }
}

}  // namespace

void draw_connections(const Cut& cut, std::size_t channels, const Receiver& receiver,
                      std::uint32_t index, std::uint32_t draws, double u,
                      std::vector<float>& scratch, std::vector<Connection>& connections) {
  cut.weigh(receiver, scratch);
  if (channels > 1) share_among_channels(cut, scratch);
  double total = 0.0;
  for (const float q : scratch) total += static_cast<double>(q);
  if (!(total > 0.0)) return;
  const double spacing = total / draws;
  double next = u * spacing;  // of cumulated probability
  double begin = 0.0;
  for (std::size_t c = 0; c < scratch.size(); ++c) {
    const double q = static_cast<double>(scratch[c]);
    const double end = begin + q;
    if (next < end) {
      const std::uint32_t count = cut.count(c);
      const double vertices_per_probability = count / q;
      const auto weight = static_cast<float>(spacing * vertices_per_probability);
      do {
        const auto place = static_cast<std::uint32_t>((next - begin) * vertices_per_probability);
        connections.push_back({index, cut.first(c) + std::min(place, count - 1), weight});
        next += spacing;
      } while (next < end);
    }
    begin = end;
  }
}

}  // namespace calc
