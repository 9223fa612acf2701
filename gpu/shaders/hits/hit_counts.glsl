// How many rays of each block met what may give light. One invocation for each block.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 6) readonly buffer Hits { uint hit[]; };
layout(std430, binding = 5) writeonly buffer Counts { uint block_count[]; };

uniform uint ray_count, blocks;

void main() {
  const uint block = gl_GlobalInvocationID.x;
  if (block >= blocks) return;
  const uint end = min((block + 1u) * RAYS_PER_BLOCK, ray_count);
  uint hits = 0u;
  for (uint ray = block * RAYS_PER_BLOCK; ray < end; ++ray) {
    const uint one = hit[LIT_HIT_SIZE * ray];
    if (one == HIT_NOT_DONE) return;  // nor is this
    if (one != HIT_NOTHING) ++hits;
  }
  block_count[block] = hits;
}
