// Stage 4, a group for each receiver: sums of its draws by channel, in double and in an order of
// their own, and a list of the draws whose bound is for the CPU to find. The place of a receiver's
// list among others is left to chance; its order is not.

layout(std430, binding = 12) readonly buffer Results { uint result[]; };
layout(std430, binding = 13) writeonly buffer Sums { uint sum_word[]; };
layout(std430, binding = 14) buffer Bounded {
  uint bounded_count;
  uint bounded_word[];
};

shared double sum_of[GROUP_SIZE];
shared uint count_of[GROUP_SIZE];
shared uint largest_of[GROUP_SIZE];
shared uint first_of_list;
// Mesa's llvmpipe leaves all loops of an invocation after 65535 turns, without a word: what was
// added until then is not the sum. Set by any invocation that notices.
shared uint is_cut;

// Adds up `number` of all invocations; all must call it.
uint group_sum(uint number) {
  const uint lane = gl_LocalInvocationID.x;
  barrier();
  count_of[lane] = number;
  barrier();
  uint step = GROUP_SIZE / 2u;
  for (; step > 0u; step /= 2u) {
    if (lane < step) count_of[lane] += count_of[lane + step];
    barrier();
  }
  if (step > 0u) is_cut = 1u;
  barrier();
  return count_of[0];
}

// Draws before the place in cumulated probability.
uint draws_before(uint r, double end) {
  uint low = 0u, high = places();
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (draw_at(r, middle) < end) low = middle + 1u;
    else high = middle;
  }
  return low;
}

void main() {
  const uint r = gl_WorkGroupID.x;
  const uint lane = gl_LocalInvocationID.x;
  const uint row = r * places();
  const uint head = r * (4u + 2u * most_ranges);
  const Tile tile = tile_of(r);
  is_cut = tile.is_chosen && spacing_and_shift[r].x >= 0.0 ? 0u : 1u;
  barrier();
  uint rays = 0u, bounded = 0u, undone = 0u, largest = 0u;
  uint first = 0u;
  uint range = 0u;
  for (; range < most_ranges; ++range) {
    uint last = first;
#if HAS_MANY_CHANNELS
    const uint begin = tile_word[tile.first_range + 2u * range];
    const uint end = tile_word[tile.first_range + 2u * range + 1u];
    if (begin < end && spacing_and_shift[r].x > 0.0) {
      last = range == tile.last_range ? places()
                                      : draws_before(r, cumulated[r * most_nodes + end - 1u]);
    }
#else
    last = places();
#endif
    precise double sum = 0.0;
    uint k = first + lane;
    for (; k < last; k += GROUP_SIZE) {
      const uint one = result[row + k];
      if (one == NO_RAY) continue;
      if (one == NOT_DONE) {
        ++undone;
        continue;
      }
      ++rays;
      if (one == ADDS_NOTHING) continue;
      if (one > ADDS_NOTHING) {
        ++bounded;
        continue;
      }
      sum = sum + double(uintBitsToFloat(one));
      largest = max(largest, one);  // positive floats are in the order of their bits
    }
    if (k < last) is_cut = 1u;
    sum_of[lane] = sum;
    barrier();
    uint step = GROUP_SIZE / 2u;
    for (; step > 0u; step /= 2u) {
      if (lane < step) {
        precise double pair = sum_of[lane] + sum_of[lane + step];
        sum_of[lane] = pair;
      }
      barrier();
    }
    if (step > 0u) is_cut = 1u;
    if (lane == 0u) {
      const uvec2 words = unpackDouble2x32(sum_of[0]);
      sum_word[head + 4u + 2u * range] = words.x;
      sum_word[head + 5u + 2u * range] = words.y;
    }
    barrier();
    first = last;
  }
  if (range < most_ranges) is_cut = 1u;
  largest_of[lane] = largest;
  const uint all_rays = group_sum(rays);
  const uint all_undone = group_sum(undone);
  const uint all_bounded = group_sum(bounded);
  if (lane == 0u) {
    uint k = 1u;
    for (; k < GROUP_SIZE; ++k) largest = max(largest, largest_of[k]);
    if (k < GROUP_SIZE) is_cut = 1u;
    first_of_list = 0u;
#if HAS_BOUND
    if (all_bounded > 0u) first_of_list = atomicAdd(bounded_count, all_bounded);
#endif
    sum_word[head] = all_undone > 0u || is_cut != 0u ? NOT_DONE : all_rays;
    sum_word[head + 1u] = all_bounded;
    sum_word[head + 2u] = first_of_list;
    sum_word[head + 3u] = largest;
  }
#if HAS_BOUND
  if (all_bounded == 0u) return;
  // A stretch of draws for each invocation, so that the list is in their order. Where a loop is cut,
  // fewer entries are written than were counted: the rest stays NOT_DONE.
  const uint each = (places() + GROUP_SIZE - 1u) / GROUP_SIZE;
  const uint begin = min(lane * each, places()), end = min(begin + each, places());
  uint own = 0u;
  for (uint k = begin; k < end; ++k) {
    if (result[row + k] > ADDS_NOTHING && result[row + k] != NOT_DONE) ++own;
  }
  barrier();  // the last sum has been read
  count_of[lane] = own;
  barrier();
  uint at = first_of_list;
  for (uint k = 0u; k < lane; ++k) at += count_of[k];
  for (uint k = begin; k < end; ++k) {
    const uint one = result[row + k];
    if (one <= ADDS_NOTHING || one == NOT_DONE) continue;
    uint v;
    float inverse_count;
    find_draw(r, k, v, inverse_count);
    bounded_word[3u * at] = v;
    bounded_word[3u * at + 1u] = floatBitsToUint(inverse_count);
    bounded_word[3u * at + 2u] = one & 0x7fffffffu;
    ++at;
  }
#endif
}
