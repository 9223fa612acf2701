// Light at hits, stage 5, after `weigh` and `share`: one of the vertices that the hit's light from
// afar is drawn from. add_far_draws() of near_field.cpp.

uniform float lift_m, bounded_from_per_m2;
uniform uint has_shadows;

uvec3 drawn(uint i, uint k) {
  const uvec3 nothing = uvec3(LIGHT_NOTHING, 0u, 0u);
  uint v;
  float inverse_count;
  if (!find_draw(i, k, v, inverse_count)) return nothing;
  const vec4 position_and_flux = vertex_position[v], normal_and_channel = vertex_normal[v];
  const HitPlace place = place_at(i);
  const double g = lifted_connection_geometry(
      KERNEL_PLANAR, place.normal, dvec3(normal_and_channel.xyz),
      dvec3(position_and_flux.xyz) - place.position_m, double(lift_m));
  if (!(g > DBL(0.0))) return nothing;
  if (has_shadows != 0u) {
    bool is_left_early;
    const bool is_hidden =
        is_blocked_from_hit(receiver_lifted(i), position_and_flux.xyz, is_left_early);
    if (is_left_early) is_cut = true;
    if (is_hidden) return uvec3(LIGHT_HIDDEN, 0u, 0u);
  }
  const float geometry = float(g);
  if (geometry > bounded_from_per_m2) {
    return uvec3(v, floatBitsToUint(inverse_count), floatBitsToUint(geometry));
  }
  precise float flux_lm = inverse_count * position_and_flux.w;
  precise float lm_per_m2 = flux_lm * geometry;
  return uvec3(uint(normal_and_channel.w), floatBitsToUint(lm_per_m2), 0u);
}

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint draw = first_item + gl_GlobalInvocationID.x;
  const uint i = draw / places(), k = draw % places();
  if (!is_lit(i) || spacing_and_shift[i].x < DBL(0.0)) return;  // nothing to do, or not done
  const uvec3 found = drawn(i, k);
  if (is_cut) return;  // not done
  for (uint w = 0u; w < 3u; ++w) write_light(i, LIGHT_DRAWS + 3u * k + w, found[w]);
}
