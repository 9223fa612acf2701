// The vertex of a draw, and 1 / the expected number of times it is drawn: see
// calc::draw_connections().

layout(std430, binding = 11) readonly buffer FluxBefore { double flux_before[]; };

// A receiver has one place more than draws: rounding may let one more in.
uint places() { return draws + 1u; }

// Cumulated probability at which draw k is made.
double draw_at(uint r, uint k) {
  const dvec2 spacing = spacing_and_shift[r];
  precise double at = (spacing.y + double(k)) * spacing.x;
  return at;
}

// First node of the tile whose cumulated probability is above `at`; below tile.nodes if
// `at` < cumulated[... + tile.nodes - 1].
uint node_at(uint r, uint nodes, double at) {
  uint low = 0u, high = nodes;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (at < cumulated[r * most_nodes + middle]) high = middle;
    else low = middle + 1u;
  }
  return low;
}

uint vertex_at(uint first, uint last, double share) {
  precise double wanted = flux_before[first] + share * (flux_before[last] - flux_before[first]);
  uint low = first;
  for (uint size = last - first; size > 1u;) {
    const uint part = size / 2u;
    if (flux_before[low + part] <= wanted) low += part;
    size -= part;
  }
  return low;
}

// False: there is no such draw.
bool find_draw(uint r, uint k, out uint vertex, out float inverse_count) {
  const Tile tile = tile_of(r);
  const double apart = spacing_and_shift[r].x;
  if (!(apart > 0.0)) return false;
  const double at = draw_at(r, k);
  const uint c = node_at(r, tile.nodes, at);
  if (c >= tile.nodes) return false;
  const uint row = r * most_nodes;
  const double before = c == 0u ? 0.0LF : cumulated[row + c - 1u];
  const double q = double(weight[row + c]);
  const uvec4 rest = node_rest[tile_word[tile.first_node + c]];
  const uint first = rest.z, last = rest.z + rest.w;
  vertex = rest.w == 1u ? first : vertex_at(first, last, (at - before) / q);
  precise double node_weight = apart / q * double(uintBitsToFloat(rest.x));
  inverse_count = float(node_weight / double(vertex_position[vertex].w));
  return true;
}
