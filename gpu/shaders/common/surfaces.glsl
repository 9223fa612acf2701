// What surfaces are like, in double as the CPU has them, for hits of closest_hit.glsl.

// Two for each triangle in the order of the tree: unit normal and reflectance.
layout(std430, binding = 2) readonly buffer Surfaces { uvec4 surface[]; };

double reflectance_of(uint triangle) { return packDouble2x32(surface[2u * triangle + 1u].zw); }

bool is_met_in_front(uint triangle, vec3 along) {
  const uvec4 a = surface[2u * triangle], b = surface[2u * triangle + 1u];
  return dot(dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy)),
             dvec3(along)) < DBL(0.0);
}

// On one of the triangle's sides. By sign bits, which zeros have too: cosine_direction() looks at
// them.
dvec3 normal_of(uint triangle, bool is_front) {
  const uint flip = is_front ? 0u : 0x80000000u;
  const uvec4 a = surface[2u * triangle], b = surface[2u * triangle + 1u];
  return dvec3(packDouble2x32(uvec2(a.x, a.y ^ flip)), packDouble2x32(uvec2(a.z, a.w ^ flip)),
               packDouble2x32(uvec2(b.x, b.y ^ flip)));
}

// Towards the side that the ray came from.
dvec3 facing_normal(uint triangle, vec3 along) {
  return normal_of(triangle, is_met_in_front(triangle, along));
}

dvec3 position_on(uint triangle, dvec2 share) {
  const dvec3 a = dvec3(bvh_corner[3u * triangle].xyz);
  const dvec3 b = dvec3(bvh_corner[3u * triangle + 1u].xyz);
  const dvec3 c = dvec3(bvh_corner[3u * triangle + 2u].xyz);
  return a + share.x * (b - a) + share.y * (c - a);
}
