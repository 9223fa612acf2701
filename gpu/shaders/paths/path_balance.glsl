// Flux that the paths of each chunk left, added in the order of paths. path_pass.h says what the
// buffers hold.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 0) readonly buffer Balances { uvec4 balance[]; };
layout(std430, binding = 1) readonly buffer Chunks { uint chunk_paths[]; };
layout(std430, binding = 2) writeonly buffer Sums { uvec4 sum[]; };

uniform uint chunk_count;

void main() {
  const uint chunk = gl_GlobalInvocationID.x;
  if (chunk >= chunk_count) return;
  double absorbed_lm = DBL(0.0), escaped_lm = DBL(0.0);
  for (uint i = 0u; i < chunk_paths[chunk]; ++i) {
    const uvec4 flux = balance[CHUNK_SIZE * chunk + i];
    absorbed_lm += packDouble2x32(flux.xy);
    escaped_lm += packDouble2x32(flux.zw);
  }
  sum[chunk] = uvec4(unpackDouble2x32(absorbed_lm), unpackDouble2x32(escaped_lm));
}
