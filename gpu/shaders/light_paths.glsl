// Some reflections of every path of a pass, each path by itself: calc::trace_light_paths() again.
// path_pass.h says what the buffers hold.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 5) buffer States { uvec4 state[]; };
layout(std430, binding = 6) writeonly buffer Vertices { uvec4 vertex[]; };
layout(std430, binding = 7) writeonly buffer Counts { uint count[]; };

uniform uint path_count, first_reflection, reflections, job_count;

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

Path emitted(uint slot) {
  Path path;
  path.job = 0u;
  while (path.job + 1u < job_count &&
         slot >= word[JOBS_AT + JOB_SIZE * (path.job + 1u) + JOB_FIRST_SLOT]) {
    ++path.job;
  }
  const uint at = JOBS_AT + JOB_SIZE * path.job;
  path.index = word[at + JOB_FIRST_PATH] + slot - word[at + JOB_FIRST_SLOT];
  const uint luminaire = choose_luminaire(path_sample(path.job, path.index, LUMINAIRE_DIMENSION));
  const EmittedRay ray =
      emit(luminaire, path_sample(path.job, path.index, DIRECTION_DIMENSION),
           path_sample(path.job, path.index, DIRECTION_DIMENSION + 1u),
           path_sample(path.job, path.index, OPENING_DIMENSION),
           path_sample(path.job, path.index, OPENING_DIMENSION + 1u));
  path.origin_m = vec3(ray.origin_m);
  path.direction = vec3(ray.direction);
  path.channel = uint(entry[luminaire_at(luminaire) + 17u]);
  path.weight_lm = entry[luminaire_at(luminaire) + 16u] / double(word[at + JOB_BATCH_PATHS]);
  path.survival = DBL(1.0);
  path.absorbed_lm = DBL(0.0);
  path.escaped_lm = DBL(0.0);
  return path;
}

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

void main() {
  const uint slot = gl_GlobalInvocationID.x;
  if (slot >= path_count) return;
#if EMITS
  Path path = emitted(slot);
#else
  Path path = restored(slot);
#endif
  const double roulette = path_sample(path.job, path.index, ROULETTE_DIMENSION);
  uint vertices = 0u, ending = PATH_LIVES;
  for (uint k = 0u; k < reflections; ++k) {
    uint triangle;
    vec2 share;
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
    const dvec3 lifted_m = position_on(triangle, share) + offset_of_rays_m() * normal;
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
  state[4u * slot] = uvec4(floatBitsToUint(path.origin_m), path.index);
  state[4u * slot + 1u] =
      uvec4(floatBitsToUint(path.direction), path.channel | (path.job << 24u));
  state[4u * slot + 2u] =
      uvec4(unpackDouble2x32(path.weight_lm), unpackDouble2x32(path.survival));
  state[4u * slot + 3u] =
      uvec4(unpackDouble2x32(path.absorbed_lm), unpackDouble2x32(path.escaped_lm));
  count[slot] = vertices | ending;
}
