// Receiver x with the light vertex of map y, whose nearest surfaces are in the atlas.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 0) readonly buffer Vertices { vec4 vertex[]; };
layout(std430, binding = 1) readonly buffer Receivers { vec4 receiver[]; };
layout(std430, binding = 2) writeonly buffer Results { uint result[]; };
layout(binding = 0) uniform sampler2D atlas;

uniform uint first_vertex, first_receiver, receiver_count, maps_per_row, map_texels;
uniform float most_per_m2, offset_m, depth_unit_m;
uniform uint has_shadows;

// Whether a surface of the map lies before the receiver. The map knows one depth per texel, that of
// its centre; a plane through the receiver across its axis has a depth there, too, and is what is
// compared: a surface that the receiver lies in does not hide it, however steep. But what is not
// nearer than the receiver itself never hides it: in a corner that plane reaches behind the wall.
// Receivers without such a plane are taken as near as a texel is wide.
bool is_hidden(uint map, vec3 from_m, vec3 normal, vec3 to_m, uint kernel, vec3 axis) {
  const mat3 frame = frame_about(normal);
  const vec3 p = (to_m - from_m) * frame;
  const uint face = face_of(p);
  const vec3 f = on_face(face, p);
  if (!(f.z > 0.0)) return false;
  const uvec4 part = face_texels(map, face, maps_per_row, map_texels);
  const vec2 size = vec2(part.zw);
  const vec2 texel = clamp(floor((f.xy / f.z * 0.5 + 0.5) * size), vec2(0.0), size - 1.0);
  const vec3 towards = from_face(face, (texel + 0.5) / size * 2.0 - 1.0);
  float depth_m = f.z * (1.0 - 2.0 / float(map_texels));
  if (kernel == KERNEL_PLANAR) {
    const vec3 plane = axis * frame;
    const float slope = dot(plane, towards);
    depth_m = slope < 0.0 ? min(dot(plane, p) / slope, f.z) : f.z;
  }
  const float nearest_m = depth_unit_m * texelFetch(atlas, ivec2(part.xy) + ivec2(texel), 0).r;
  return nearest_m < depth_m * (1.0 - DEPTH_BIAS) - 2.0 * offset_m;
}

uint gathered(uint map, uint i) {
  const vec4 position_and_flux = vertex[2u * (first_vertex + map)];
  const vec3 normal = vertex[2u * (first_vertex + map) + 1u].xyz;
  const vec3 at = receiver[3u * i].xyz;
  const vec4 axis = receiver[3u * i + 1u];
  const uint kernel = uint(axis.w);
  const float g = lifted_connection_geometry(kernel, axis.xyz, normal,
                                             position_and_flux.xyz - at,
                                             lift_at(position_and_flux.xyz, offset_m));
  if (!(g > 0.0)) return NO_RAY;
  if (has_shadows != 0u && is_hidden(map, position_and_flux.xyz, normal, receiver[3u * i + 2u].xyz,
                                     kernel, axis.xyz)) {
    return ADDS_NOTHING;
  }
  const float lx = connection_lx(1.0, position_and_flux.w, min(g, most_per_m2));
  return lx > 0.0 ? floatBitsToUint(lx) : ADDS_NOTHING;
}

void main() {
  if (gl_GlobalInvocationID.x >= receiver_count) return;
  const uint map = gl_GlobalInvocationID.y;
  result[map * receiver_count + gl_GlobalInvocationID.x] =
      gathered(map, first_receiver + gl_GlobalInvocationID.x);
}
