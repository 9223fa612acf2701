// The list of hits that may give light, in the order of rays: each its request and which of its rays
// it is. One invocation for each block of rays; block_first: where its hits begin in the list.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 6) readonly buffer Hits { uint hit[]; };
layout(std430, binding = 5) readonly buffer Firsts { uint block_first[]; };
layout(std430, binding = 7) writeonly buffer List { uvec2 list[]; };

uniform uint request_count, ray_count, blocks;

void main() {
  const uint block = gl_GlobalInvocationID.x;
  if (block >= blocks) return;
  const uint begin = block * RAYS_PER_BLOCK, end = min(begin + RAYS_PER_BLOCK, ray_count);
  uint request = request_of(begin, request_count);
  uint at = block_first[block];
  for (uint ray = begin; ray < end; ++ray) {
    while (request + 1u < request_count && first_ray_of(request + 1u) <= ray) ++request;
    if (hit[LIT_HIT_SIZE * ray] == HIT_NOTHING) continue;
    list[at] = uvec2(request, ray - first_ray_of(request));
    ++at;
  }
}
