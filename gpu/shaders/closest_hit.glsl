// The first surface that a ray meets: the tree and triangles of visibility.glsl. Children are
// visited in the order of the tree, not of the ray; what is found shortens the rest of the way.
// calc::Tracer::closest_hits() is what it must answer like.

// a * b + c, rounded once, where fma() may be a product and a sum.
float fused(float a, float b, float c) { return float(double(a) * double(b) + double(c)); }

// dot(cross(a, b), c), each step rounded as by Embree.
float volume(vec3 a, vec3 b, vec3 c) {
  const float x = fused(a.y, b.z, -(a.z * b.y));
  const float y = fused(a.z, b.x, -(a.x * b.z));
  const float z = fused(a.x, b.y, -(a.y * b.x));
  return fused(x, c.x, fused(y, c.y, z * c.z));
}

// Shares of the triangle's second and third corner at the place that a ray meets. Light paths carry
// rounding on and enlarge it: hence to the bit, nearly always, what Embree finds on processors with
// fused operations.
vec2 place_on(uint triangle, vec3 from, vec3 along) {
  const vec3 v0 = bvh_corner[3u * triangle].xyz - from;
  const vec3 v1 = bvh_corner[3u * triangle + 1u].xyz - from;
  const vec3 v2 = bvh_corner[3u * triangle + 2u].xyz - from;
  precise float volume0 = volume(v2 - v0, v2 + v0, along);
  precise float volume1 = volume(v0 - v1, v0 + v1, along);
  precise float volume2 = volume(v1 - v2, v1 + v2, along);
  precise float sum = volume0 + volume1 + volume2;
  if (sum == 0.0) return vec2(1.0 / 3.0);
  return clamp(vec2(volume0, volume1) * (1.0 / sum), vec2(0.0), vec2(1.0));
}

// share: of the triangle's second and third corner at the place that is met.
bool closest_hit(vec3 from, vec3 along, float t_near, float t_far, out uint triangle,
                 out vec2 share) {
  const vec3 per_along = vec3(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
  bool is_found = false;
  triangle = 0u;
  share = vec2(0.0);
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
