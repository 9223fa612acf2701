// One connection of a receiver to a light vertex. results: what gather_pass.h says.

layout(local_size_x = LOCAL_SIZE) in;

layout(std430, binding = 4) readonly buffer Receivers { vec4 receiver[]; };
layout(std430, binding = 5) readonly buffer Connections { uint connection[]; };
layout(std430, binding = 12) writeonly buffer Results { uint result[]; };

uniform uint connection_count;
uniform float bounded_from_per_m2, lift_m;

uint gathered(uint i) {
  const uint r = 3u * connection[3u * i];
  const uint v = connection[3u * i + 1u];
  const vec4 at = receiver[r];
  const vec4 axis = receiver[r + 1u];
  const vec4 position_and_flux = vertex_position[v];
  const float g = lifted_connection_geometry(uint(axis.w), axis.xyz, vertex_normal[v].xyz,
                                             position_and_flux.xyz - at.xyz,
                                             lift_at(position_and_flux.xyz, lift_m));
  if (!(g > 0.0)) return NO_RAY;
#if HAS_SHADOWS
  bool is_cut;
  if (is_blocked(receiver[r + 2u].xyz, position_and_flux.xyz, is_cut)) return ADDS_NOTHING;
  if (is_cut) return NOT_DONE;
#endif
  if (g > bounded_from_per_m2) return floatBitsToUint(-g);
  const float weight = uintBitsToFloat(connection[3u * i + 2u]);
  const float lx = connection_lx(weight, position_and_flux.w, g);
  return lx > 0.0 ? floatBitsToUint(lx) : ADDS_NOTHING;
}

void main() {
  if (gl_GlobalInvocationID.x >= connection_count) return;
  result[gl_GlobalInvocationID.x] = gathered(gl_GlobalInvocationID.x);
}
