// Vertices of each chunk without gaps, by reflections, then by paths; and the paths that live on.
// One group for each chunk. path_pass.h says what the buffers hold.

layout(local_size_x = CHUNK_SIZE) in;

layout(std430, binding = 0) readonly buffer Chunks { uint chunk_slot[]; };
// First vertex, first living path and first index of each chunk; PATH_DROPPED as the first vertex:
// nobody wants this chunk any more.
layout(std430, binding = 1) readonly buffer Places { uvec4 chunk_place[]; };
layout(std430, binding = 2) writeonly buffer PackedVertices { uvec4 packed_vertex[]; };
layout(std430, binding = 3) writeonly buffer NextStates { uvec4 next_state[]; };
layout(std430, binding = 4) writeonly buffer Balances { uvec4 balance[]; };
layout(std430, binding = 5) readonly buffer States { uvec4 state[]; };
layout(std430, binding = 6) readonly buffer Vertices { uvec4 vertex[]; };
layout(std430, binding = 7) readonly buffer Counts { uint count[]; };

uniform uint path_count;

shared uint counted[CHUNK_SIZE];

void main() {
  const uint chunk = gl_WorkGroupID.x;
  const uint own = gl_LocalInvocationID.x;
  const uint first = chunk_slot[chunk];
  const uint paths = chunk_slot[chunk + 1u] - first;
  counted[own] = own < paths ? count[first + own] : 0u;
  barrier();
  const uvec4 place = chunk_place[chunk];
  if (own >= paths || place.x == PATH_DROPPED) return;
  const uint slot = first + own;
  const uint vertices = counted[own] & ~PATH_ENDINGS;
  for (uint k = 0u; k < vertices; ++k) {
    uint before = 0u;
    for (uint i = 0u; i < paths; ++i) {
      const uint others = counted[i] & ~PATH_ENDINGS;
      before += min(others, k) + (i < own && others > k ? 1u : 0u);
    }
    const uint from = 2u * (k * path_count + slot), to = 2u * (place.x + before);
    packed_vertex[to] = vertex[from];
    packed_vertex[to + 1u] = vertex[from + 1u];
  }
  if ((counted[own] & PATH_ENDINGS) != PATH_LIVES) {
    balance[CHUNK_SIZE * chunk + state[4u * slot].w - place.z] = state[4u * slot + 3u];
    return;
  }
  uint before = 0u;
  for (uint i = 0u; i < own; ++i) {
    if ((counted[i] & PATH_ENDINGS) == PATH_LIVES) ++before;
  }
  for (uint k = 0u; k < 4u; ++k) {
    next_state[4u * (place.y + before) + k] = state[4u * slot + k];
  }
}
