// Some reflections of every path of a pass, each path by itself: calc::trace_light_paths() again.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 6) writeonly buffer Vertices { uvec4 vertex[]; };
layout(std430, binding = 7) writeonly buffer Counts { uint count[]; };

uniform uint path_count, first_reflection, reflections;

void main() {
  const uint slot = gl_GlobalInvocationID.x;
  if (slot >= path_count) return;
  Path path = restored(slot);
  const double roulette = roulette_number(path_sample(path.job, path.index, ROULETTE_DIMENSION));
  uint vertices = 0u, ending = PATH_LIVES;
  for (uint k = 0u; k < reflections; ++k) {
    uint triangle;
    dvec2 share;
    if (!closest_hit(path.origin_m, path.direction, 0.0, 1.0e30, triangle, share)) {
      path.escaped_lm += path.weight_lm;
      ending = PATH_ENDED_BY_RAY;
      break;
    }
    const double rho = reflectance_of(triangle);
    path.absorbed_lm += path.weight_lm * (DBL(1.0) - rho);
    if (rho <= DBL(0.0)) {
      ending = PATH_ENDED_BY_RAY;
      break;
    }
    const dvec3 normal = facing_normal(triangle, path.direction);
    const dvec3 lifted_m = lifted_m_of(position_on(triangle, share), normal);
    path.origin_m = vec3(lifted_m);
    const uint place = 2u * (vertices * path_count + slot);
    vertex[place] = uvec4(floatBitsToUint(path.origin_m),
                          floatBitsToUint(float(path.weight_lm * rho)));
    vertex[place + 1u] = uvec4(floatBitsToUint(vec3(normal)), path.channel);
    ++vertices;
    const uint reflection = first_reflection + k;
    if (reflection < FREE_REFLECTIONS) {
      path.weight_lm *= rho;
    } else {
      path.survival *= rho;
      if (path.survival <= roulette) {
        ending = PATH_ENDED_BY_ROULETTE;
        break;
      }
    }
    const uint dimension = BOUNCE_DIMENSION + 2u * reflection;
    path.direction = vec3(cosine_direction(normal, path_sample(path.job, path.index, dimension),
                                           path_sample(path.job, path.index, dimension + 1u)));
  }
  store(slot, path);
  if (is_cut || (ending == PATH_LIVES && vertices != reflections)) return;  // not done
  count[slot] = vertices | ending;
}
