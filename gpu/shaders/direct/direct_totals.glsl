// Stage 5: one point, channel and replicate. What was sampled of it, and samples of the rest of
// openings that are seen in full, each of a patch that is chosen by how large its rest may be:
// SeenOpenings::sample_rest_lx() of opening_light.cpp.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 7) readonly buffer Light { double light_lx[]; };
layout(std430, binding = 10) readonly buffer Known { double known_sum_lx[]; };
// [replicate][channel][point] lx, then [replicate][point]: largest sample (float), flags and rays.
layout(std430, binding = 11) writeonly buffer Totals { double total[]; };

uniform uint channel_count, first_point;  // of the points in the list

uint rest_samples(double rest_lx, double known_lx) {
  const double share =
      MEAN_REST * rest_lx / (REST_WANTED_ERROR * double(error_factor) * known_lx);
  if (!(share * share < double(MOST_REST_SAMPLES))) return MOST_REST_SAMPLES;
  return max(FEWEST_REST_SAMPLES, uint(ceil(share * share)));
}

// Of the patch at which the sum of rests, `sum_lx` before this luminaire, passes `wanted_lx`.
double sample_of_lamp(uint index, Point point, double sum_lx, double wanted_lx, double weight_lx,
                      uvec2 key) {
  const Lamp lamp = lamp_of(index);
  Place place = Place(0u, 0u);
  for (uint patches = 0u; patches < MOST_PARTS; ++patches) {
    Patch part;
    if (!find_patch(lamp, point, place, part)) break;
    fit(lamp, point, part);
    const double rest_lx = part.share * part.rest_lx;
    sum_lx += rest_lx;
    const bool is_last = !go_on(place);
    if (!is_last && !(sum_lx > wanted_lx)) continue;
    if (!(rest_lx > DBL(0.0))) return DBL(0.0);
    return weight_lx / rest_lx * rest_at_lx(lamp, point, part, fraction_of(key_with(key, PART_1)),
                                            fraction_of(key_with(key, PART_2)));
  }
  is_cut = true;
  return DBL(0.0);
}

// One round. Numbers that choose ascend, so that luminaires are passed once.
double round_lx(uint p, Point point, uint channel, uvec2 key, uint samples, double rest_lx) {
  double sum_lx = DBL(0.0), passed_lx = DBL(0.0), wanted_lx = DBL(-1.0);
  uvec2 sample_key = uvec2(0u);
  uint lamp = 0u, k = 0u;
  for (; lamp < luminaire_count && k < samples; ++lamp) {
    const uint pair = pair_of(lamp, p);
    if (kind_of(pair) != PAIR_SEEN || channel_of(lamp) != channel) continue;
    const double up_to_lx = light_lx[2u * pair + 1u];
    for (; k < samples; ++k) {
      if (wanted_lx < DBL(0.0)) {
        sample_key = key_with(key, k);
        wanted_lx = (double(k) + fraction_of(key_with(sample_key, PART_0))) / double(samples) * rest_lx;
      }
      if (!(up_to_lx > wanted_lx) && up_to_lx < rest_lx) break;
      sum_lx += sample_of_lamp(lamp, point, passed_lx, wanted_lx, rest_lx / double(samples),
                               sample_key);
      wanted_lx = DBL(-1.0);  // the next one's is to be found
    }
    passed_lx = up_to_lx;
  }
  if (k < samples) is_cut = true;
  return sum_lx;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= replicate_count * channel_count * listed_points) return;
  const uint at = i % listed_points, p = first_point + at;
  const uint channel = i / listed_points % channel_count;
  const uint replicate = i / (listed_points * channel_count);
  double sum_lx = DBL(0.0);
  float largest_lx = 0.0;
  uint flags = 0u, rays = 0u, chunk = list[at];
  for (; chunk < list[at + 1u]; ++chunk) {
    const uvec4 sum = chunk_sum[chunk * replicate_count + replicate];
    if (sum.w == NOT_DONE) return;
    largest_lx = max(largest_lx, uintBitsToFloat(sum.z));
    flags |= sum.w & ((1u << CHUNK_FLAGS) - 1u);
    rays += sum.w >> CHUNK_FLAGS;
    if (channel_of(chunk_at(chunk).y) == channel) sum_lx += packDouble2x32(sum.xy);
  }
  if (chunk < list[at + 1u]) is_cut = true;
  const uint known_at = channel * point_count + p;
  const double rest_lx = known_sum_lx[channel_count * point_count + known_at];
  if (rest_lx > DBL(0.0)) {
    const Point point = point_of(p);
    uvec2 key = key_with(point.key, replicate);
    key = key_with(key, PART_4);  // "rest", as calc::RandomKey::with() takes words
    key = key_with(key_with(key_with(key_with(key, PART_114), PART_101), PART_115), PART_116);
    key = key_with(key, channel);
    const uint samples = rest_samples(rest_lx, known_sum_lx[known_at]);
    for (uint number = first_round; number < last_round; ++number) {
      sum_lx += round_lx(p, point, channel, key_with(key, number), samples, rest_lx);
    }
  }
  if (is_cut || isnan(rest_lx)) return;  // not done
  total[(replicate * channel_count + channel) * point_count + p] = sum_lx;
  if (channel != 0u) return;
  total[(replicate_count * channel_count + replicate) * point_count + p] =
      packDouble2x32(uvec2(floatBitsToUint(largest_lx), flags | (rays << CHUNK_FLAGS)));
}
