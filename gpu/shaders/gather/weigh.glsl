// Stage 1: the weight of every node of a tile's cut for every receiver. x: nodes, y: receivers.

uniform float smallest_bound_per_m2;

void main() {
  const uint r = gl_WorkGroupID.y;
  const uint c = gl_GlobalInvocationID.x;
  const Tile tile = tile_of(r);
  if (c >= tile.nodes) return;
  const uint n = tile_word[tile.first_node + c];
  const vec4 sphere = node_sphere[n];
  const uvec4 rest = node_rest[n];
  const uint v = rest.z + rest.w / 2u;
  const vec3 at = receiver_position(r);
  precise vec3 u = sphere.xyz - at;
  precise vec3 d = vertex_position[v].xyz - at;
  const vec3 normal = vertex_normal[v].xyz;
  const float bound = node_bound_per_m2(smallest_bound_per_m2, uintBitsToFloat(rest.y));
  const float d2 = node_softened_m2(sphere.w, d.x, d.y, d.z);
  const float facing = node_facing(normal.x, normal.y, normal.z, d.x, d.y, d.z);
  float kernel = 0.0;
#if HAS_PLANAR
  const vec3 a = receiver_axis(r);
  kernel = node_kernel_planar(d2, facing, a.x, a.y, a.z, d.x, d.y, d.z);
#endif
#if HAS_ROUND
#if HAS_PLANAR
  if (receiver_kernel(r) != KERNEL_PLANAR)
#endif
    kernel = node_kernel_round(d2, facing);
#endif
  weight[r * most_nodes + c] =
      node_mixed(uintBitsToFloat(rest.x), kernel, sphere.w, bound, u.x, u.y, u.z);
}
