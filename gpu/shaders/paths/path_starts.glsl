// The start of every path of a pass.

layout(local_size_x = GROUP_SIZE) in;

uniform uint path_count, job_count;

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

void main() {
  const uint slot = gl_GlobalInvocationID.x;
  if (slot < path_count) store(slot, emitted(slot));
}
