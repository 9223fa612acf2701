// Light paths between two dispatches, and the numbers that they draw. path_pass.h says what the
// buffers hold.

layout(std430, binding = 5) buffer States { uvec4 state[]; };

double path_sample(uint job, uint index, uint dimension) {
  const uint at = JOBS_AT + JOB_SIZE * job;
  if (dimension >= SOBOL_DIMENSIONS) {
    const uvec2 key = uvec2(word[at + JOB_KEY], word[at + JOB_KEY + 1u]);
    return fraction_of(key_with(key_with(key, dimension), index));
  }
  return sobol_sample(index, 32u * dimension, word[at + dimension]);
}

struct Path {
  vec3 origin_m, direction;
  uint job, index, channel;
  double weight_lm, survival, absorbed_lm, escaped_lm;
};

Path restored(uint slot) {
  const uvec4 a = state[4u * slot], b = state[4u * slot + 1u], c = state[4u * slot + 2u],
              d = state[4u * slot + 3u];
  Path path;
  path.origin_m = uintBitsToFloat(a.xyz);
  path.index = a.w;
  path.direction = uintBitsToFloat(b.xyz);
  path.channel = b.w & 0xffffffu;
  path.job = b.w >> 24u;
  path.weight_lm = packDouble2x32(c.xy);
  path.survival = packDouble2x32(c.zw);
  path.absorbed_lm = packDouble2x32(d.xy);
  path.escaped_lm = packDouble2x32(d.zw);
  return path;
}

void store(uint slot, Path path) {
  state[4u * slot] = uvec4(floatBitsToUint(path.origin_m), path.index);
  state[4u * slot + 1u] =
      uvec4(floatBitsToUint(path.direction), path.channel | (path.job << 24u));
  state[4u * slot + 2u] =
      uvec4(unpackDouble2x32(path.weight_lm), unpackDouble2x32(path.survival));
  state[4u * slot + 3u] =
      uvec4(unpackDouble2x32(path.absorbed_lm), unpackDouble2x32(path.escaped_lm));
}
