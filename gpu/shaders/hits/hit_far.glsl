// Light at hits, stage 5, after `weigh` and `share`: one of the vertices that the hit's light from
// afar is drawn from. add_far_draws() of near_field.cpp.

uniform float lift_m, bounded_from_per_m2;
uniform uint has_shadows;

// Draws whose vertex is near, in any order: how many groups of the next stage they fill, one in each
// other direction, how many they are; then of each its number among the draws, the vertex's channel,
// the flux that it stands for, the geometry term, its place and normal.
layout(std430, binding = 14) buffer Near { uint near_word[]; };

void list_near(uint draw, uint channel, float flux_lm, float geometry, vec3 position_m, vec3 normal) {
  const uint n = atomicAdd(near_word[NEAR_COUNT], 1u);
  if (n > 0u && n % GROUP_SIZE == 0u) atomicAdd(near_word[0], 1u);
  const uint at = NEAR_HEAD + NEAR_SIZE * n;
  near_word[at] = draw;
  near_word[at + 1u] = channel;
  near_word[at + 2u] = floatBitsToUint(flux_lm);
  near_word[at + 3u] = floatBitsToUint(geometry);
  for (uint k = 0u; k < 3u; ++k) {
    near_word[at + 4u + k] = floatBitsToUint(position_m[k]);
    near_word[at + 7u + k] = floatBitsToUint(normal[k]);
  }
}

// LIGHT_NOT_DONE: it was listed.
uvec2 drawn(uint draw, uint i) {
  const uvec2 nothing = uvec2(LIGHT_NOTHING, 0u);
  uint v;
  float inverse_count;
  if (!find_draw(i, draw % places(), v, inverse_count)) return nothing;
  const vec4 position_and_flux = vertex_position[v], normal_and_channel = vertex_normal[v];
  const HitPlace place = place_at(i);
  const double g = lifted_connection_geometry(
      KERNEL_PLANAR, place.normal, dvec3(normal_and_channel.xyz),
      dvec3(position_and_flux.xyz) - place.position_m,
      lift_at(dvec3(position_and_flux.xyz), double(lift_m)));
  if (!(g > DBL(0.0))) return nothing;
  if (has_shadows != 0u) {
    bool is_left_early;
    const bool is_hidden =
        is_blocked_from_hit(receiver_lifted(i), position_and_flux.xyz, is_left_early);
    if (is_left_early) is_cut = true;
    if (is_hidden) return uvec2(LIGHT_HIDDEN, 0u);
  }
  const float geometry = float(g);
  const uint channel = uint(normal_and_channel.w);
  precise float flux_lm = inverse_count * position_and_flux.w;
  if (geometry > bounded_from_per_m2) {
    if (!is_cut) {
      list_near(draw, channel, flux_lm, geometry, position_and_flux.xyz, normal_and_channel.xyz);
    }
    return uvec2(LIGHT_NOT_DONE);
  }
  precise float lm_per_m2 = flux_lm * geometry;
  return uvec2(channel, floatBitsToUint(lm_per_m2));
}

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint draw = first_item + gl_GlobalInvocationID.x, i = draw / places();
  if (!is_lit(i) || spacing_and_shift[i].x < DBL(0.0)) return;  // nothing to do, or not done
  const uvec2 found = drawn(draw, i);
  if (is_cut || found.x == LIGHT_NOT_DONE) return;
  write_draw(draw, found);
}
