#pragma once
// Chooses connections of receivers to light vertices, with their weights.

#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/random.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

// A connection. The estimate is the sum over connections of weight * flux_v / pi * min(G, b) V.
struct Connection {
  std::uint32_t receiver;  // index in the tile
  std::uint32_t vertex;    // index in the sorted pool
  float weight;            // 1 / expected number of times that the vertex is drawn, > 0
};

// Least share of all weight for which a channel is raised to its share. A smaller weight may be a
// denormal number, which devices flush to 0 and processors do not: their draws would differ.
inline constexpr double kLeastShare = 1e-30;

// Makes `draws` draws of one receiver, spaced evenly in cumulated probability from the shift u in
// [0, 1): systematic sampling, by importance among nodes and by flux within them. Appends to
// `connections`. With several channels, half of the draws are even among them, so that a weak group
// is sampled as well as a strong one. `scratch` is overwritten. [METHOD, 5.4]
void draw_connections(const VertexTree& tree, const Cut& cut, const Receiver& receiver,
                      std::uint32_t index, std::uint32_t draws, double u,
                      std::vector<float>& scratch, std::vector<Connection>& connections);

}  // namespace calc
