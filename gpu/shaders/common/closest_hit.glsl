// The first surface that a ray meets: the tree and triangles of visibility.glsl. Children are
// visited about in the order of the ray; what is found shortens the rest of the way. Of equally
// near triangles the one that comes first in the scene counts, whatever the order of visits.
// calc::Tracer::closest_hits() is what it must answer like.

layout(std430, binding = 8) readonly buffer Order { uint triangle_of[]; };

// Shares of the triangle's second and third corner at the place that a ray meets, as
// calc::meets() has them: light paths carry rounding on and enlarge it.
dvec2 place_on(uint triangle, vec3 from, vec3 along) {
  const dvec3 side = sides_of(dvec3(from), dvec3(along), dvec3(bvh_corner[3u * triangle].xyz),
                              dvec3(bvh_corner[3u * triangle + 1u].xyz),
                              dvec3(bvh_corner[3u * triangle + 2u].xyz));
  EXACT double sum = side.x + side.y + side.z;
  if (sum == DBL(0.0)) return dvec2(DBL(1.0) / DBL(3.0));
  return clamp(side.yz / sum, dvec2(DBL(0.0)), dvec2(DBL(1.0)));
}

// Bits of slots moved to slot ^ signs: the ray's nearest lowest. It is its own reverse.
uint in_order_of_ray(uint slots, uint signs) {
  if ((signs & 1u) != 0u) slots = ((slots & 0x55u) << 1u) | ((slots >> 1u) & 0x55u);
  if ((signs & 2u) != 0u) slots = ((slots & 0x33u) << 2u) | ((slots >> 2u) & 0x33u);
  if ((signs & 4u) != 0u) slots = ((slots & 0x0fu) << 4u) | (slots >> 4u);
  return slots;
}

// share: of the triangle's second and third corner at the place that is met.
bool closest_hit(vec3 from, vec3 along, float t_near, float t_far, out uint triangle,
                 out dvec2 share) {
  const vec3 per_along = reciprocals(along);
  const uint signs = (per_along.x < 0.0 ? 1u : 0u) | (per_along.y < 0.0 ? 2u : 0u) |
                     (per_along.z < 0.0 ? 4u : 0u);
  bool is_found = false;
  triangle = 0u;
  share = dvec2(DBL(0.0));
  Search search = search_of_tree(signs);  // open slots in the order of the ray
  uint triangles = 0u;
  while (goes_on(search)) {
    const uint at = next_node(search, signs);
    const uvec4 grid = bvh_node[at], links = bvh_node[at + 1u];
    const uint met = children_met(at, grid, from, per_along, t_near, t_far);
    triangles = links.z & four_times(met);
    while (triangles != 0u) {
      const uint bit = uint(findLSB(triangles));
      triangles &= triangles - 1u;
      COUNT_TRIANGLE;
      const uint k = links.y + place_among(links.z, bit);
      float t;
      if (!is_crossed(k, from, along, t)) continue;
      if (!(t > t_near && t <= t_far)) continue;
      if (is_found && t == t_far && triangle_of[k] > triangle_of[triangle]) continue;
      is_found = true;
      t_far = t;
      triangle = k;
    }
    open_children(search, grid, links, in_order_of_ray(met & inner_slots(grid), signs));
  }
  if (goes_on(search) || triangles != 0u) is_cut = true;
  if (is_found) share = place_on(triangle, from, along);
  return is_found;
}
