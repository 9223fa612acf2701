// The first surface that a ray meets: the tree and triangles of visibility.glsl. Children are
// visited in the order of the tree, not of the ray; what is found shortens the rest of the way.
// calc::Tracer::closest_hits() is what it must answer like.

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

// share: of the triangle's second and third corner at the place that is met.
bool closest_hit(vec3 from, vec3 along, float t_near, float t_far, out uint triangle,
                 out dvec2 share) {
  const vec3 per_along = vec3(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
  bool is_found = false;
  triangle = 0u;
  share = dvec2(DBL(0.0));
  uint at = 0u;
  while (at < node_count) {
    const uvec4 low = bvh_node[2u * at];
    const uvec4 high = bvh_node[2u * at + 1u];
    if (misses_box(low, high, from, per_along, t_near, t_far)) {
      at = low.w;
      continue;
    }
    const uint begin = high.w / LEAF_STEP;
    const uint end = begin + high.w % LEAF_STEP;  // the same for an inner node
    for (uint k = begin; k < end; ++k) {
      float t;
      if (!is_crossed(k, from, along, t)) continue;
      if (!(t > t_near && t <= t_far) || (is_found && t == t_far)) continue;
      is_found = true;
      t_far = t;
      triangle = k;
    }
    ++at;
  }
  if (at < node_count) is_cut = true;
  if (is_found) share = place_on(triangle, from, along);
  return is_found;
}
