// How many vertices, living paths and rays each chunk has. path_pass.h says what the buffers hold.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 0) readonly buffer Chunks { uint chunk_slot[]; };
layout(std430, binding = 1) writeonly buffer Sums { uvec4 sum[]; };
layout(std430, binding = 7) readonly buffer Counts { uint count[]; };

uniform uint chunk_count;

void main() {
  const uint chunk = gl_GlobalInvocationID.x;
  if (chunk >= chunk_count) return;
  uint vertices = 0u, alive = 0u, rays = 0u, is_done = 1u;
  for (uint slot = chunk_slot[chunk]; slot < chunk_slot[chunk + 1u]; ++slot) {
    const uint counted = count[slot];
    const uint ending = counted & PATH_ENDINGS;
    if (ending == PATH_NOT_DONE) is_done = 0u;
    vertices += counted & ~PATH_ENDINGS;
    rays += (counted & ~PATH_ENDINGS) + (ending == PATH_ENDED_BY_RAY ? 1u : 0u);
    if (ending == PATH_LIVES) ++alive;
  }
  sum[chunk] = uvec4(vertices, alive, rays, is_done);
}
