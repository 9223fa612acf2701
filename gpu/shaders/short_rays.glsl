// What the first short rays of calculation points meet: calc::add_near_field() again. Requests and
// results as gl_short_rays.cpp says.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 3) readonly buffer Requests { uvec4 request[]; };
layout(std430, binding = 6) writeonly buffer Hits { uint hit[]; };

uniform uint request_count, first_ray, ray_count;
uniform float least_m, most_m;

// The last request that begins at or before the ray.
uint request_of(uint ray) {
  uint low = 0u, high = request_count;
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (request[4u * middle + 3u].z <= ray) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

void main() {
  if (gl_GlobalInvocationID.x >= ray_count) return;
  const uint ray = first_ray + gl_GlobalInvocationID.x;
  const uint at = 4u * request_of(ray);
  const uvec4 a = request[at], b = request[at + 1u], c = request[at + 2u], d = request[at + 3u];
  const uint index = ray - d.z;
  const double u0 = sobol_sample(index, 0u, d.x);
  const double u1 = sobol_sample(index, 32u, d.y);
  const dvec3 axis = dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy));
  const vec3 from = uintBitsToFloat(c.xyz);
  const vec3 along = vec3(c.w != 0u ? cosine_direction(axis, u0, u1) : sphere_direction(u0, u1));
  uint triangle;
  dvec2 share;
  const bool is_met = closest_hit(from, along, least_m, most_m, triangle, share);
  if (is_cut) return;  // not done
  if (!is_met) {
    hit[3u * ray] = HIT_NOTHING;
    return;
  }
  hit[3u * ray] = triangle_of[triangle] | (is_met_in_front(triangle, along) ? 0u : HIT_FROM_BEHIND);
  hit[3u * ray + 1u] = floatBitsToUint(float(share.x));
  hit[3u * ray + 2u] = floatBitsToUint(float(share.y));
}
