// Stage 3: one point and channel. Sums of what is known and of what its rest may be, luminaire by
// luminaire; each luminaire's rest becomes the sum up to it.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 7) buffer Light { double light_lx[]; };
// [channel][point] known lx, then [channel][point] rest lx.
layout(std430, binding = 10) writeonly buffer Known { double known_sum_lx[]; };

uniform uint channel_count;

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= channel_count * point_count) return;
  const uint channel = i / point_count, p = i % point_count;
  dvec2 sum = dvec2(DBL(0.0));
  uint lamp = 0u;
  for (; lamp < luminaire_count; ++lamp) {
    const uint pair = pair_of(lamp, p);
    if (pair_word[pair] == NOT_DONE) return;
    if (channel_of(lamp) != channel) continue;
    sum += dvec2(light_lx[2u * pair], light_lx[2u * pair + 1u]);
    light_lx[2u * pair + 1u] = sum.y;
  }
  if (lamp < luminaire_count) return;  // not done: the driver left the loop
  known_sum_lx[i] = sum.x;
  known_sum_lx[channel_count * point_count + i] = sum.y;
}
