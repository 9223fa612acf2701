// Light at hits, stage 6: draws of hit_far whose vertex is so near that the geometry term is above
// the smallest bound. The vertex's own bound, and with it what the draw brings.

layout(local_size_x = GROUP_SIZE) in;

// What hit_far listed, in any order: NEAR_HEAD words, then the draws.
layout(std430, binding = 14) readonly buffer Near { uint near_word[]; };

vec3 near_triple(uint at) {
  return uintBitsToFloat(uvec3(near_word[at], near_word[at + 1u], near_word[at + 2u]));
}

void main() {
  const uint n = gl_GlobalInvocationID.x;
  if (n >= near_word[NEAR_COUNT]) return;
  const uint at = NEAR_HEAD + NEAR_SIZE * n;
  const dvec3 position_m = dvec3(near_triple(at + 4u)), normal = dvec3(near_triple(at + 7u));
  const float bound_per_m2 = float(bound_at(position_m, normal));
  if (is_cut) return;  // not done
  const float geometry = uintBitsToFloat(near_word[at + 3u]);
  precise float lm_per_m2 = uintBitsToFloat(near_word[at + 2u]) * min(geometry, bound_per_m2);
  write_draw(near_word[at], uvec2(near_word[at + 1u], floatBitsToUint(lm_per_m2)));
}
