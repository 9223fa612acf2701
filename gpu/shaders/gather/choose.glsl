// Before stage 1, a group for each tile: the nodes that its receivers choose from, the same as
// calc::Cut::select() takes, in pool order, and the channels' ranges of them.

layout(local_size_x = LOCAL_SIZE) in;

layout(std430, binding = 4) readonly buffer TileViews { vec4 tile_view[]; };  // 3 each, device_points.h
layout(std430, binding = 5) writeonly buffer Tiles { uint tile_word[]; };
layout(std430, binding = 6) readonly buffer NodeSpheres { vec4 node_sphere[]; };
layout(std430, binding = 7) readonly buffer NodeRests { uvec4 node_rest[]; };
layout(std430, binding = 8) readonly buffer NodeHalves { vec4 node_half[]; };  // w: cos_spread
layout(std430, binding = 9) readonly buffer NodeAxes { uvec4 node_axis[]; };   // w: child

uniform float smallest_bound_per_m2;
uniform uint wanted_nodes, leave_out_hidden;
uniform uint first_tile;  // of the piece, among those of its block

const uint NO_NODE = 0xffffffffu;
const int HIDDEN = -2, NOTHING_TO_OPEN = -1;

// Nodes that are taken, and places that became free.
shared uint slot_node[MOST_CHOSEN], slot_first[MOST_CHOSEN];
shared int slot_step[MOST_CHOSEN];
shared uint slots, taken, candidates, limit;
shared int top;
shared uint candidate_bits[MOST_CHOSEN / 32u];
shared uint lit_ranges, last_range;
shared uint is_cut;  // set by any invocation that notices

struct View {
  vec3 centre_m, axis;
  float radius_m, softening_m, slack_m, lowest_m;
  bool has_axis;
};

View view_of(uint tile) {
  const vec4 a = tile_view[3u * tile], b = tile_view[3u * tile + 1u], c = tile_view[3u * tile + 2u];
  return View(a.xyz, b.xyz, a.w, b.w, c.x, c.y, c.z != 0.0);
}

// As in cut.cpp.
int step_of(View tile, uint n) {
  const vec4 sphere = node_sphere[n], half_and_spread = node_half[n];
  const uvec4 axis_and_child = node_axis[n], rest = node_rest[n];
  const vec3 c = sphere.xyz, h = half_and_spread.xyz, a = tile.axis;
  const vec3 normal = uintBitsToFloat(axis_and_child.xyz);
  if (leave_out_hidden != 0u && tile.has_axis &&
      cut_is_behind(a.x, a.y, a.z, tile.slack_m, tile.lowest_m, c.x, c.y, c.z, h.x, h.y, h.z)) {
    return HIDDEN;
  }
  precise vec3 to = tile.centre_m - c;
  const float distance_m = cut_distance_m(to.x, to.y, to.z);
  precise float reach_m = sphere.w + tile.radius_m;
  if (leave_out_hidden != 0u &&
      cut_faces_away(normal.x, normal.y, normal.z, half_and_spread.w, h.x, h.y, h.z, tile.radius_m,
                     tile.slack_m, reach_m, to.x, to.y, to.z, distance_m)) {
    return HIDDEN;
  }
  if (axis_and_child.w == 0u) return NOTHING_TO_OPEN;
  const float bound = node_bound_per_m2(smallest_bound_per_m2, uintBitsToFloat(rest.y));
  return cut_step(cut_error(uintBitsToFloat(rest.x), sphere.w, half_and_spread.w, bound, distance_m,
                            tile.softening_m, tile.radius_m));
}

void put(uint slot, uint n, int step) {
  slot_node[slot] = n;
  slot_step[slot] = step;
  slot_first[slot] = n == NO_NODE ? NO_NODE : node_rest[n].z;
}

// Parts that can light the tile take the slot, and one more if there are two of them.
void open_slot(View tile, uint slot) {
  const uint child = node_axis[slot_node[slot]].w;
  uint kept = 0u;
  for (uint k = 0u; k < two; ++k) {
    const int step = step_of(tile, child + k);
    if (step == HIDDEN) continue;
    put(kept == 0u ? slot : atomicAdd(slots, 1u), child + k, step);
    ++kept;
  }
  if (kept == 0u) put(slot, NO_NODE, NOTHING_TO_OPEN);
  atomicAdd(taken, kept - 1u);
}

// In pool order, free slots last: a bitonic sort.
void sort_slots() {
  const uint lane = gl_LocalInvocationID.x;
  const uint used = slots;
  uint size = 2u;
  while (size < used) size *= 2u;
  for (uint i = used + lane; i < size; i += GROUP_SIZE) put(i, NO_NODE, NOTHING_TO_OPEN);
  barrier();
  for (uint width = 2u; width <= size; width *= 2u) {
    for (uint apart = width / 2u; apart > 0u; apart /= 2u) {
      for (uint pair = lane; pair < size / 2u; pair += GROUP_SIZE) {
        const uint a = 2u * apart * (pair / apart) + pair % apart, b = a + apart;
        const bool is_rising = (a & width) == 0u;
        if ((slot_first[a] > slot_first[b]) == is_rising) {
          const uint node = slot_node[a], first = slot_first[a];
          const int step = slot_step[a];
          slot_node[a] = slot_node[b];
          slot_first[a] = slot_first[b];
          slot_step[a] = slot_step[b];
          slot_node[b] = node;
          slot_first[b] = first;
          slot_step[b] = step;
        }
      }
      barrier();
    }
  }
  if (lane == 0u) slots = taken;
  barrier();
}

// The slot after the candidate that is the last of so many, in their order.
uint slot_after(uint count) {
  for (uint word = 0u; word < MOST_CHOSEN / 32u; ++word) {
    const uint here = uint(bitCount(candidate_bits[word]));
    if (count > here) {
      count -= here;
      continue;
    }
    uint bits = candidate_bits[word];
    for (; count > 1u; --count) bits &= bits - 1u;
    return 32u * word + uint(findLSB(bits)) + 1u;
  }
  return MOST_CHOSEN;
}

// First of the slots in pool order that begins at or after the vertex.
uint slot_at(uint vertex) {
  uint low = 0u, high = taken;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (slot_first[middle] < vertex) low = middle + 1u;
    else high = middle;
  }
  return low;
}

void write_tile(uint tile) {
  const uint lane = gl_LocalInvocationID.x;
  const uint at = tile * tile_size();
  if (lane == 0u) {
    lit_ranges = 0u;
    last_range = 0u;
  }
  barrier();
  for (uint i = lane; i < taken; i += GROUP_SIZE) {
    tile_word[at + TILE_HEAD + 2u * most_ranges + i] = slot_node[i];
  }
  for (uint root = lane; root < most_ranges; root += GROUP_SIZE) {
    const uvec4 rest = node_rest[root];
    const uint begin = slot_at(rest.z), end = slot_at(rest.z + rest.w);
    tile_word[at + TILE_HEAD + 2u * root] = begin;
    tile_word[at + TILE_HEAD + 2u * root + 1u] = end;
    if (begin < end) {
      atomicAdd(lit_ranges, 1u);
      atomicMax(last_range, root);
    }
  }
  if (is_loop_left()) atomicOr(is_cut, 1u);
  barrier();
  if (lane == 0u && is_cut == 0u) {
    tile_word[at] = taken;
    tile_word[at + 1u] = lit_ranges;
    tile_word[at + 2u] = last_range;
    tile_word[at + 3u] = TILE_CHOSEN;
  }
}

void main() {
  const uint lane = gl_LocalInvocationID.x;
  const View tile = view_of(first_tile + gl_WorkGroupID.x);
  if (lane == 0u) {
    slots = most_ranges;
    taken = 0u;
    is_cut = 0u;
  }
  barrier();
  for (uint root = lane; root < most_ranges; root += GROUP_SIZE) {
    const int step = step_of(tile, root);  // roots are the first nodes
    put(root, step == HIDDEN ? NO_NODE : root, step == HIDDEN ? NOTHING_TO_OPEN : step);
    if (step != HIDDEN) atomicAdd(taken, 1u);
  }
  int lowest = MOST_STEPS;
  while (true) {
    if (lane == 0u) {
      top = NOTHING_TO_OPEN;
      candidates = 0u;
    }
    barrier();
    const uint used = slots;
    int own = NOTHING_TO_OPEN;
    for (uint i = lane; i < used; i += GROUP_SIZE) own = max(own, slot_step[i]);
    atomicMax(top, own);
    barrier();
    const bool is_done = taken >= wanted_nodes || top < 0;
    lowest = min(lowest, top);
    uint count = 0u;
    for (uint i = lane; i < used; i += GROUP_SIZE) count += slot_step[i] >= lowest ? 1u : 0u;
    atomicAdd(candidates, count);
    barrier();
    const uint room = wanted_nodes - taken;  // without meaning at the end
    const bool are_too_many = candidates > room;
    if (is_done || are_too_many || used + candidates > MOST_CHOSEN) sort_slots();
    if (is_done) break;
    if (are_too_many) {
      for (uint word = lane; word < MOST_CHOSEN / 32u; word += GROUP_SIZE) candidate_bits[word] = 0u;
      barrier();
      for (uint i = lane; i < slots; i += GROUP_SIZE) {
        if (slot_step[i] >= lowest) atomicOr(candidate_bits[i / 32u], 1u << (i % 32u));
      }
      barrier();
    }
    if (lane == 0u) limit = are_too_many ? slot_after(room) : slots;
    barrier();
    const uint end = limit;
    for (uint i = lane; i < end; i += GROUP_SIZE) {
      if (slot_step[i] >= lowest) open_slot(tile, i);
    }
    barrier();
  }
  write_tile(gl_WorkGroupID.x);
}
