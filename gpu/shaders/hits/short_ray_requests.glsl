// Points whose short rays are asked for, as short_ray_pass.h says, and the directions of these.

// Which of the block's receivers, and the first of its rays; one more behind the last.
layout(std430, binding = 9) readonly buffer Requests { uvec2 request_words[]; };
layout(std430, binding = 15) readonly buffer Points { uvec4 point_words[]; };  // device_points.h

uniform uint key_low, key_high;  // of all points: calc::NearFieldBatch::key

struct Request {
  dvec3 position_m, axis;
  vec3 origin_m;  // of its rays
  uint kernel;
  uvec2 scramble, key;
  uint first_ray, rays;
};

uint first_ray_of(uint r) { return request_words[r].y; }

Request request_at(uint r) {
  const uint at = 5u * request_words[r].x;
  const uvec4 a = point_words[at], b = point_words[at + 1u], c = point_words[at + 2u],
              d = point_words[at + 3u];
  Request request;
  request.position_m = dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy));
  request.axis = dvec3(packDouble2x32(b.zw), packDouble2x32(c.xy), packDouble2x32(c.zw));
  request.origin_m = uintBitsToFloat(d.xyz);
  request.kernel = d.w;
  request.key = key_with(uvec2(key_low, key_high), point_words[at + 4u].x);
  // calc::ScrambledSobol::scramble() of its two dimensions
  request.scramble = uvec2(key_with(request.key, PART_0).y, key_with(request.key, PART_1).y);
  request.first_ray = first_ray_of(r);
  request.rays = first_ray_of(r + 1u) - request.first_ray;
  return request;
}

// The last of some requests that begins at or before the ray.
uint request_of(uint ray, uint requests) {
  uint low = 0u, high = requests;
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (first_ray_of(middle) <= ray) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}
