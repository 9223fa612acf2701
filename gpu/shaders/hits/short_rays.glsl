// What the first short rays of calculation points meet: calc::add_near_field() again. HAS_LIGHT:
// only what may give light counts, and triangles are those of the tree.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 6) writeonly buffer Hits { uint hit[]; };
#if HAS_LIGHT
layout(std430, binding = 10) readonly buffer Field { double field[]; };
#endif

uniform uint request_count, first_ray, ray_count;
uniform float least_m, most_m;

#if HAS_LIGHT
bool may_give_light(Request request, uint triangle, vec3 along, dvec2 share) {
  if (!(reflectance_of(triangle) > DBL(0.0))) return false;
  return connection_geometry(request.kernel, request.axis, facing_normal(triangle, along),
                             position_on(triangle, share) - request.position_m) >
         field[FIELD_SMALLEST];
}
#endif

void main() {
  if (gl_GlobalInvocationID.x >= ray_count) return;
  const uint ray = first_ray + gl_GlobalInvocationID.x;
  const Request request = request_at(request_of(ray, request_count));
  const vec3 along = vec3(ray_direction(request, ray - request.first_ray));
  uint triangle;
  dvec2 share;
  const bool is_met = closest_hit(request.origin_m, along, least_m, most_m, triangle, share);
  if (is_cut) return;  // not done
  const uint side = is_met_in_front(triangle, along) ? 0u : HIT_FROM_BEHIND;
#if HAS_LIGHT
  const uint at = LIT_HIT_SIZE * ray;
  if (!is_met || !may_give_light(request, triangle, along, share)) {
    hit[at] = HIT_NOTHING;
    return;
  }
  hit[at] = triangle | side;
  const uvec2 u = unpackDouble2x32(share.x), v = unpackDouble2x32(share.y);
  hit[at + 1u] = u.x;
  hit[at + 2u] = u.y;
  hit[at + 3u] = v.x;
  hit[at + 4u] = v.y;
#else
  if (!is_met) {
    hit[3u * ray] = HIT_NOTHING;
    return;
  }
  hit[3u * ray] = triangle_of[triangle] | side;
  hit[3u * ray + 1u] = floatBitsToUint(float(share.x));
  hit[3u * ray + 2u] = floatBitsToUint(float(share.y));
#endif
}
