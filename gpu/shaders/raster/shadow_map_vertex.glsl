// Instance i: face i % 5 of map i / 5. Clip distances keep each face within its part of the atlas.

layout(location = 0) in vec3 corner_m;
layout(location = 1) in vec3 from_m;   // of the map: the light vertex
layout(location = 2) in vec3 normal;

uniform uint first_map, maps_per_row, map_texels;
uniform float atlas_width, atlas_height, near_m;

out gl_PerVertex {
  vec4 gl_Position;
  float gl_ClipDistance[5];
};
out float depth_m;

void main() {
  const uint instance = uint(gl_InstanceID);
  const uint face = instance % 5u;
  const vec3 f = on_face(face, (corner_m - from_m) * frame_about(normal));
  gl_ClipDistance[0] = f.z - f.x;
  gl_ClipDistance[1] = f.z + f.x;
  gl_ClipDistance[2] = f.z - f.y;
  gl_ClipDistance[3] = f.z + f.y;
  gl_ClipDistance[4] = f.z - near_m;
  const vec4 part = vec4(face_texels(first_map + instance / 5u, face, maps_per_row, map_texels));
  const vec2 scale = 2.0 / vec2(atlas_width, atlas_height);
  const vec2 centre = (part.xy + 0.5 * part.zw) * scale - 1.0;
  gl_Position = vec4(centre * f.z + 0.5 * part.zw * scale * f.xy, 0.0, f.z);
  depth_m = f.z;
}
