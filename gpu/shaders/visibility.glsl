// Whether anything stands between two points: any-hit traversal of the tree in bvh.h.
// calc::Tracer::blocked() is what it must answer like.

layout(std430, binding = 0) readonly buffer Nodes { uvec4 bvh_node[]; };
layout(std430, binding = 1) readonly buffer Triangles { vec4 bvh_corner[]; };

uniform uint node_count;
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

// Rays along an axis would divide by 0.
float reciprocal(float component) {
  return 1.0 / (abs(component) > 1.0e-30 ? component : 1.0e-30);
}

// Whether a ray misses a node of the tree between two places of it.
bool misses_box(uvec4 low, uvec4 high, vec3 from, vec3 per_along, float t_near, float t_far) {
  const float rounding = 1.0e-6;  // of the distances to box planes
  const vec3 t0 = (uintBitsToFloat(low.xyz) - from) * per_along;
  const vec3 t1 = (uintBitsToFloat(high.xyz) - from) * per_along;
  const vec3 first = min(t0, t1), last = max(t0, t1);
  const float enter = max(max(first.x, first.y), max(first.z, t_near));
  const float leave = min(min(last.x, last.y), min(last.z, t_far));
  return !(enter * (1.0 - rounding) <= leave * (1.0 + rounding));
}

// Whether anything stands between from + t_near along and from + t_far along. is_cut: the driver
// left the loop early, so that the answer means nothing: llvmpipe does after 65535 turns, without a
// word.
bool is_crossed_by_any(vec3 from, vec3 along, float t_near, float t_far, out bool is_cut) {
  is_cut = false;
  // Two points nearer than the margins have nothing between them.
  if (!(t_near < t_far)) return false;
  const vec3 per_along = vec3(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
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
      if (is_hit(k, from, along, t_near, t_far)) return true;
    }
    ++at;
  }
  is_cut = at < node_count;
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
