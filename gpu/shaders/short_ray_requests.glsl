// Points whose short rays are asked for, as short_ray_pass.h says, and the directions of these.

layout(std430, binding = 9) readonly buffer Requests { uvec4 request_words[]; };

struct Request {
  dvec3 position_m, axis;
  vec3 origin_m;  // of its rays
  uint kernel;
  uvec2 scramble, key;
  uint first_ray, rays;
};

Request request_at(uint r) {
  const uvec4 a = request_words[6u * r], b = request_words[6u * r + 1u],
              c = request_words[6u * r + 2u], d = request_words[6u * r + 3u],
              e = request_words[6u * r + 4u], f = request_words[6u * r + 5u];
  Request request;
  request.position_m = dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy));
  request.axis = dvec3(packDouble2x32(b.zw), packDouble2x32(c.xy), packDouble2x32(c.zw));
  request.origin_m = uintBitsToFloat(d.xyz);
  request.kernel = d.w;
  request.scramble = e.xy;
  request.key = e.zw;
  request.first_ray = f.x;
  request.rays = f.y;
  return request;
}

uint first_ray_of(uint r) { return request_words[6u * r + 5u].x; }

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
