// Whether anything stands between two points: any-hit traversal of the tree in bvh.h.
// calc::Tracer::blocked() is what it must answer like.

// For benchmarks.
#ifndef COUNT_NODE
#define COUNT_NODE
#define COUNT_TRIANGLE
#endif

layout(std430, binding = 0) readonly buffer Nodes { uvec4 bvh_node[]; };
layout(std430, binding = 1) readonly buffer Triangles { vec4 bvh_corner[]; };

uniform uint node_count;  // 0: no scene
uniform float offset_m;  // the stretch that is left out where a segment begins

// Edge tests by volumes, which are the same with opposite sign for both triangles at an edge: no
// ray slips through between them. [Woop13 for the problem; volumes as in Embree's robust mode]
bool is_crossed(uint triangle, vec3 from, vec3 along, out float t) {
  t = 0.0;
  const vec4 a = bvh_corner[3u * triangle];
  const vec4 b = bvh_corner[3u * triangle + 1u];
  const vec4 c = bvh_corner[3u * triangle + 2u];
  const vec3 v0 = a.xyz - from, v1 = b.xyz - from, v2 = c.xyz - from;
  precise float volume0 = dot(cross(v2 - v0, v2 + v0), along);
  precise float volume1 = dot(cross(v0 - v1, v0 + v1), along);
  precise float volume2 = dot(cross(v1 - v2, v1 + v2), along);
  const float rounding = 1.2e-7 * abs(volume0 + volume1 + volume2);
  const bool is_inside = min(volume0, min(volume1, volume2)) >= -rounding ||
                         max(volume0, max(volume1, volume2)) <= rounding;
  if (!is_inside) return false;
  const vec3 normal = vec3(a.w, b.w, c.w);
  const float slope = dot(normal, along);
  if (slope == 0.0) return false;
  t = dot(normal, v0) / slope;
  return true;
}

bool is_hit(uint triangle, vec3 from, vec3 along, float t_near, float t_far) {
  float t;
  return is_crossed(triangle, from, along, t) && t_near <= t && t <= t_far;
}

// Rays along an axis would divide by 0. What is put in its place moves them by less than
// boxes_met() allows for, see least_step_m().
float reciprocal(float component) {
  return 1.0 / (abs(component) > 1.0e-28 ? component : 1.0e-28);
}

vec3 reciprocals(vec3 along) {
  return vec3(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
}

vec4 bytes_of(uint word) { return vec4((uvec4(word) >> uvec4(0u, 8u, 16u, 24u)) & 255u); }

// Of four boxes, given the planes where rays enter and leave them.
uint four_boxes_met(uvec3 entry, uvec3 exit, vec3 cell, vec3 early, vec3 late, float t_near,
                    float t_far) {
  const vec4 enter_x = bytes_of(entry.x) * cell.x + early.x;
  const vec4 enter_y = bytes_of(entry.y) * cell.y + early.y;
  const vec4 enter_z = bytes_of(entry.z) * cell.z + early.z;
  const vec4 leave_x = bytes_of(exit.x) * cell.x + late.x;
  const vec4 leave_y = bytes_of(exit.y) * cell.y + late.y;
  const vec4 leave_z = bytes_of(exit.z) * cell.z + late.z;
  const vec4 enter = max(max(enter_x, enter_y), max(enter_z, vec4(t_near)));
  const vec4 leave = min(min(leave_x, leave_y), min(leave_z, vec4(t_far)));
  const uvec4 met = uvec4(not(greaterThan(enter, leave)));
  return met.x | (met.y << 1u) | (met.z << 2u) | (met.w << 3u);
}

// Slots of a node (given without its links) whose boxes a ray may meet between two places of it,
// those without a child among them: never too few.
uint boxes_met(uvec4 grid, uvec4 a, uvec4 b, uvec4 c, vec3 from, vec3 per_along, float t_near,
               float t_far) {
  // Of the longest ways to planes, twice what five roundings and a division of GLSL can add up to.
  const float rounding = 1.0e-6;
  const uvec3 exponent = (uvec3(grid.w) << uvec3(23u, 15u, 7u)) & 0x7f800000u;
  const vec3 cell = uintBitsToFloat(exponent) * per_along;
  const vec3 begin = (uintBitsToFloat(grid.xyz) - from) * per_along;
  const vec3 slack = rounding * (abs(begin) + 255.0 * abs(cell));
  const bvec3 is_down = lessThan(per_along, vec3(0.0));
  const uvec2 entry_x = is_down.x ? b.zw : a.xy, exit_x = is_down.x ? a.xy : b.zw;
  const uvec2 entry_y = is_down.y ? c.xy : a.zw, exit_y = is_down.y ? a.zw : c.xy;
  const uvec2 entry_z = is_down.z ? c.zw : b.xy, exit_z = is_down.z ? b.xy : c.zw;
  const vec3 early = begin - slack, late = begin + slack;
  const uint lower = four_boxes_met(uvec3(entry_x.x, entry_y.x, entry_z.x),
                                    uvec3(exit_x.x, exit_y.x, exit_z.x), cell, early, late, t_near,
                                    t_far);
  const uint upper = four_boxes_met(uvec3(entry_x.y, entry_y.y, entry_z.y),
                                    uvec3(exit_x.y, exit_y.y, exit_z.y), cell, early, late, t_near,
                                    t_far);
  return lower | (upper << 4u);
}

// Each of the lowest eight bits four times.
uint four_times(uint bits) {
  bits = (bits | (bits << 12u)) & 0x000f000fu;
  bits = (bits | (bits << 6u)) & 0x03030303u;
  bits = (bits | (bits << 3u)) & 0x11111111u;
  return bits * 15u;
}

// The bits of a mask below one of them, counted: where something stands among its like.
uint place_among(uint mask, uint bit) { return bitCount(mask & ((1u << bit) - 1u)); }

// Nodes that wait while others are searched: the first child of their parent, and their slots above
// its inner slots. One entry for each level of the tree at most, of which there are no more than
// kBvhLevels. Shared memory, because drivers put arrays of an invocation that are indexed freely
// into the slowest.
shared uvec2 waiting[MOST_WAITING * GROUP_SIZE];

// How far a search of the tree is: the nodes at hand, one after another from `siblings` on by slot,
// those of them that are still to be searched, and how many such groups wait.
struct Search {
  uint siblings, inner, open, height;
};

// The root as an only child. signs: 0, or as next_node() will have them.
Search search_of_tree(uint signs) {
  return Search(0u, 1u, node_count > 0u ? 1u << signs : 0u, 0u);
}

bool goes_on(Search search) { return (search.open | search.height) != 0u; }

// Where the words of the next node begin, of which there must be one. Open slots stand at slot ^
// signs, the next at the lowest bit.
uint next_node(inout Search search, uint signs) {
  const uint stack = gl_LocalInvocationIndex;
  if (search.open == 0u) {
    --search.height;
    const uvec2 group = waiting[search.height * GROUP_SIZE + stack];
    search.siblings = group.x;
    search.inner = group.y & 255u;
    search.open = group.y >> 8u;
  }
  const uint slot = uint(findLSB(search.open)) ^ signs;
  search.open &= search.open - 1u;
  if (search.open != 0u) {
    waiting[search.height * GROUP_SIZE + stack] =
        uvec2(search.siblings, search.inner | (search.open << 8u));
    ++search.height;
  }
  COUNT_NODE;
  return 5u * (search.siblings + place_among(search.inner, slot));
}

// Slots of a node's children that are nodes, from its first words.
uint inner_slots(uvec4 grid) { return grid.w >> 24u; }

// On to the children of the node that next_node() gave.
void open_children(inout Search search, uvec4 grid, uvec4 links, uint open) {
  search.siblings = links.x;
  search.inner = inner_slots(grid);
  search.open = open;
}

// Boxes of the children of a node whose first words are given, as boxes_met().
uint children_met(uint at, uvec4 grid, vec3 from, vec3 per_along, float t_near, float t_far) {
  return boxes_met(grid, bvh_node[at + 2u], bvh_node[at + 3u], bvh_node[at + 4u], from, per_along,
                   t_near, t_far);
}

// Whether anything stands between from + t_near along and from + t_far along. is_cut: the driver
// left the loop early, so that the answer means nothing: llvmpipe does after 65535 turns, without a
// word. Needs work groups of no more than GROUP_SIZE.
bool is_crossed_by_any(vec3 from, vec3 along, float t_near, float t_far, out bool is_cut) {
  is_cut = false;
  // Two points nearer than the margins have nothing between them.
  if (!(t_near < t_far)) return false;
  const vec3 per_along = reciprocals(along);
  Search search = search_of_tree(0u);
  uint triangles = 0u;
  while (goes_on(search)) {
    const uint at = next_node(search, 0u);
    const uvec4 grid = bvh_node[at], links = bvh_node[at + 1u];
    const uint met = children_met(at, grid, from, per_along, t_near, t_far);
    triangles = links.z & four_times(met);
    while (triangles != 0u) {
      const uint bit = uint(findLSB(triangles));
      triangles &= triangles - 1u;
      COUNT_TRIANGLE;
      if (is_hit(links.y + place_among(links.z, bit), from, along, t_near, t_far)) return true;
    }
    open_children(search, grid, links, met & inner_slots(grid));
  }
  is_cut = goes_on(search) || triangles != 0u;
  return false;
}

// Of what calc::SegmentMargins leaves out at an end, as a share of the way.
float margin_of(vec3 along) { return offset_m / sqrt(dot(along, along)); }

// from: a receiver, to: a light vertex (calc::kReceiverToVertex).
bool is_blocked(vec3 from, vec3 to, out bool is_cut) {
  const vec3 along = to - from;
  return is_crossed_by_any(from, along, margin_of(along), 1.0, is_cut);
}

// from: a receiver, to: a place of a luminaire (calc::kReceiverToSource).
bool is_blocked_between(vec3 from, vec3 to, out bool is_cut) {
  const vec3 along = to - from;
  const float margin = margin_of(along);
  return is_crossed_by_any(from, along, margin, 1.0 - margin, is_cut);
}

// from: a hit of a ray, lifted, to: a light vertex (calc::kHitToVertex).
bool is_blocked_from_hit(vec3 from, vec3 to, out bool is_cut) {
  return is_crossed_by_any(from, to - from, 0.0, 1.0, is_cut);
}

// from: the same, to: a place of a luminaire (calc::kHitToSource).
bool is_blocked_from_hit_to_source(vec3 from, vec3 to, out bool is_cut) {
  const vec3 along = to - from;
  return is_crossed_by_any(from, along, 0.0, 1.0 - margin_of(along), is_cut);
}
