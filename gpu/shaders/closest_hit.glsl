// The first surface that a ray meets: the tree and triangles of visibility.glsl. Children are
// visited in the order of the tree, not of the ray; what is found shortens the rest of the way.
// calc::Tracer::closest_hits() is what it must answer like.

// share: of the triangle's second and third corner at the place that is met.
bool closest_hit(vec3 from, vec3 along, float t_near, float t_far, out uint triangle,
                 out vec2 share) {
  const vec3 per_along = vec3(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
  const float rounding = 1.0e-6;  // of the distances to box planes
  bool is_found = false;
  triangle = 0u;
  share = vec2(0.0);
  uint at = 0u;
  while (at < node_count) {
    const uvec4 low = bvh_node[2u * at];
    const uvec4 high = bvh_node[2u * at + 1u];
    const vec3 t0 = (uintBitsToFloat(low.xyz) - from) * per_along;
    const vec3 t1 = (uintBitsToFloat(high.xyz) - from) * per_along;
    const vec3 first = min(t0, t1), last = max(t0, t1);
    const float enter = max(max(first.x, first.y), max(first.z, t_near));
    const float leave = min(min(last.x, last.y), min(last.z, t_far));
    if (!(enter * (1.0 - rounding) <= leave * (1.0 + rounding))) {
      at = low.w;
      continue;
    }
    const uint begin = high.w / LEAF_STEP;
    const uint end = begin + high.w % LEAF_STEP;  // the same for an inner node
    for (uint k = begin; k < end; ++k) {
      float t;
      vec2 place;
      if (!is_crossed(k, from, along, t, place)) continue;
      if (!(t > t_near && t <= t_far) || (is_found && t == t_far)) continue;
      is_found = true;
      t_far = t;
      triangle = k;
      share = place;
    }
    ++at;
  }
  share = clamp(share, vec2(0.0), vec2(1.0));
  return is_found;
}
