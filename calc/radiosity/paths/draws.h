#pragma once
// Connections of receivers to light vertices: which ones, and with which weight.

#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/random.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

// The estimate is the sum over connections of weight * flux_v / pi * min(G, b) V.
struct Connection {
  std::uint32_t receiver;  // index in the tile
  std::uint32_t vertex;    // index in the sorted pool
  float weight;            // 1 / expected number of times that the vertex is drawn, > 0
};

// Of all weight: what a channel must have to be raised to its share. Less may be a denormal number,
// which devices take for 0 and processors do not: they would not draw the same.
inline constexpr double kLeastShare = 1e-30;

// Draws of one receiver, `draws` of them, spaced evenly in cumulated probability from the shift u
// in [0, 1): systematic sampling, by importance among nodes and by flux within them. Appends to
// `connections`. Where there are several channels, half of the draws go evenly to all of them, so
// that a weak group is known as well as a strong one. `scratch` is overwritten. [METHOD, 5.4]
void draw_connections(const VertexTree& tree, const Cut& cut, const Receiver& receiver,
                      std::uint32_t index, std::uint32_t draws, double u,
                      std::vector<float>& scratch, std::vector<Connection>& connections);

}  // namespace calc
