// Stage 3: one draw. result: what gather_pass.h says of a connection.

layout(std430, binding = 12) writeonly buffer Results { uint result[]; };

uniform uint first_place, place_count;
uniform float bounded_from_per_m2, lift_m;

uint drawn(uint r, uint k) {
  uint v;
  float inverse_count;
  if (!find_draw(r, k, v, inverse_count)) return NO_RAY;
  const vec4 position_and_flux = vertex_position[v];
#if HAS_ROUND
  const uint kernel = receiver_kernel(r);
#else
  const uint kernel = KERNEL_PLANAR;
#endif
  const float g =
      lifted_connection_geometry(kernel, receiver_axis(r), vertex_normal[v].xyz,
                                 position_and_flux.xyz - receiver_position(r),
                                 lift_at(position_and_flux.xyz, lift_m));
  if (!(g > 0.0)) return NO_RAY;
#if HAS_SHADOWS
  bool is_cut;
  if (is_blocked(receiver_lifted(r), position_and_flux.xyz, is_cut)) return ADDS_NOTHING;
  if (is_cut) return NOT_DONE;
#endif
#if HAS_BOUND
  if (g > bounded_from_per_m2) return floatBitsToUint(-g);
#endif
  const float lx = connection_lx(inverse_count, position_and_flux.w, g);
  return lx > 0.0 ? floatBitsToUint(lx) : ADDS_NOTHING;
}

void main() {
  if (gl_GlobalInvocationID.x >= place_count) return;
  const uint i = first_place + gl_GlobalInvocationID.x;
  result[i] = drawn(i / places(), i % places());
}
