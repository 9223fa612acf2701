// Stage 4: the samples of one chunk in one replicate, with shadow rays: calc::add_opening_samples().

layout(local_size_x = GROUP_SIZE) in;

uniform uint first_job, last_job;

struct ChunkSum {
  double lx;
  float largest_lx;
  uint flags, rays;
};

void add_sample(inout ChunkSum sum, Lamp lamp, View view, Point point, vec3 from_m, double s,
                double t, double weight) {
  vec3 to_m;
  const double lx = opening_lx(lamp, view, point, s, t, to_m);
  if (!(lx > DBL(0.0))) return;
  sum.flags |= CHUNK_IS_LIT;
  if (has_shadows != 0u) {
    ++sum.rays;
    bool is_left_early;
    const bool is_hidden = is_blocked_between(from_m, to_m, is_left_early);
    if (is_left_early) is_cut = true;
    if (is_hidden) {
      sum.flags |= CHUNK_HAS_HIDDEN;
      return;
    }
  }
  sum.flags |= CHUNK_HAS_SEEN;
  sum.lx += weight * lx;
  sum.largest_lx = max(sum.largest_lx, float(weight * lx));
}

ChunkSum sampled(uvec4 chunk, uint replicate) {
  const Point point = point_of(chunk.x);
  const Lamp lamp = lamp_of(chunk.y);
  const View view = view_from(lamp, point.position_m);
  const vec3 from_m = vec3(lifted_point_m(point));
  const uvec2 key = key_with(key_with(point.key, replicate), chunk.y);
  ChunkSum sum = ChunkSum(DBL(0.0), 0.0, 0u, 0u);
  const uint begin = chunk.z, end = chunk.z + chunk.w;
  uint before = 0u, cell = 0u;  // samples of cells before; of this one
  Walk walk = kBegin;
  for (; cell < MOST_PARTS; ++cell) {
    CellAt at;
    if (!find_cell(lamp, view, point.position_m, walk, at)) break;
    const uint samples = cell_samples(at);
    const uint after = before + samples * (last_round - first_round);
    const uvec2 cell_key = key_with(key, cell);
    const uint scramble_s = key_with(cell_key, PART_0).y, scramble_t = key_with(cell_key, PART_1).y;
    const double weight = at.cell.size_s * at.cell.size_t / double(samples);
    for (uint j = max(begin, before); j < min(end, after); ++j) {
      const uint i = first_round * samples + (j - before);
      add_sample(sum, lamp, view, point, from_m,
                 at.cell.s + at.cell.size_s * sobol_sample(i, 0u, scramble_s),
                 at.cell.t + at.cell.size_t * sobol_sample(i, 32u, scramble_t), weight);
    }
    if (after >= end) return sum;
    before = after;
    if (!go_on(view, walk)) break;
  }
  is_cut = true;  // the list asks for more samples than there are
  return sum;
}

void main() {
  const uint job = first_job + gl_GlobalInvocationID.x;
  if (job >= last_job) return;
  const ChunkSum sum = sampled(chunk_at(job / replicate_count), job % replicate_count);
  if (is_cut) return;  // not done
  chunk_sum[job] = uvec4(unpackDouble2x32(sum.lx), floatBitsToUint(sum.largest_lx),
                         sum.flags | (sum.rays << CHUNK_FLAGS));
}
