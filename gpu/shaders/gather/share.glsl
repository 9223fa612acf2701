// Stage 2, a group for each receiver: the channels' shares, what each node adds up to, how far apart
// draws are and where they begin. The same sums as calc/radiosity/paths/draws.cpp, the floats bit by bit.

#if !HAS_GIVEN_SHIFTS
uniform uint key_low, key_high;  // calc::DrawBatch::key
#endif

// In [0, 1). Hits come with theirs.
double shift_of(uint r) {
  const uvec2 given = words_of(r, 3u).zw;
#if HAS_GIVEN_SHIFTS
  return packDouble2x32(given);
#else
  return fraction_of(key_with(uvec2(key_low, key_high), given.x));
#endif
}

shared float part[GROUP_SIZE];
shared double sum_before[GROUP_SIZE];
shared uint is_cut;  // set by any invocation that notices

// calc::sum_of() of values begin..end of this receiver's row after they were multiplied: 16 lanes,
// each by an invocation of its own.
float scaled_sum(uint row, uint begin, uint end, float factor) {
  const uint lane = gl_LocalInvocationID.x;
  precise float sum = 0.0;
  if (lane < 16u) {
    for (uint i = begin + lane; i < end; i += 16u) {
#if HAS_MANY_CHANNELS
      if (factor != 1.0) {
        precise float scaled = weight[row + i] * factor;
        weight[row + i] = scaled;
      }
#endif
      sum = sum + weight[row + i];
    }
  }
  barrier();  // the last sum has been read
  part[lane] = sum;
  barrier();
  for (uint step = 8u; step > 0u; step /= 2u) {
    if (lane < step) {
      precise float pair = part[lane] + part[lane + step];
      part[lane] = pair;
    }
    barrier();
  }
  return part[0];
}

double share_among_channels(uint row, Tile tile) {
#if HAS_MANY_CHANNELS
  precise double total = 0.0;
  for (uint k = 0u; k < most_ranges; ++k) {
    const uint at = tile.first_range + 2u * k;
    total = total + double(scaled_sum(row, tile_word[at], tile_word[at + 1u], 1.0));
  }
  if (tile.ranges <= 1u) return total;
  precise double shared_total = 0.0;
  for (uint k = 0u; k < most_ranges; ++k) {
    const uint at = tile.first_range + 2u * k;
    const uint begin = tile_word[at], end = tile_word[at + 1u];
    const double own = double(scaled_sum(row, begin, end, 1.0));
    precise double even = total / double(tile.ranges);
    if (!(own > LEAST_SHARE * total)) continue;  // none, or next to no flux
    precise double share = min(0.5LF + 0.5LF * even / own, double(3.402823466e38));
    shared_total = shared_total + double(scaled_sum(row, begin, end, float(share)));
  }
  return shared_total;
#else
  return double(scaled_sum(row, 0u, tile.nodes, 1.0));
#endif
}

void main() {
  const uint r = gl_WorkGroupID.x;
  const uint row = r * most_nodes;
  const uint lane = gl_LocalInvocationID.x;
  const Tile tile = tile_of(r);
  if (lane == 0u) is_cut = 0u;
  const double total = share_among_channels(row, tile);
  memoryBarrierBuffer();
  barrier();
  const uint each = (tile.nodes + GROUP_SIZE - 1u) / GROUP_SIZE;
  const uint begin = min(lane * each, tile.nodes), end = min(begin + each, tile.nodes);
  precise double own = 0.0;
  for (uint c = begin; c < end; ++c) own = own + double(weight[row + c]);
  sum_before[lane] = own;
  barrier();
  if (lane == 0u) {
    precise double before = 0.0;
    for (uint k = 0u; k < GROUP_SIZE; ++k) {
      precise double after = before + sum_before[k];
      sum_before[k] = before;
      before = after;
    }
    spacing_and_shift[r] = dvec2(total > 0.0 ? total / double(draws) : 0.0LF, shift_of(r));
  }
  barrier();
  precise double at = sum_before[lane];
  for (uint c = begin; c < end; ++c) {
    at = at + double(weight[row + c]);
    cumulated[row + c] = at;
  }
  if (is_loop_left()) atomicOr(is_cut, 1u);
  barrier();
  if (lane == 0u && is_cut != 0u) spacing_and_shift[r].x = -1.0LF;  // not done
}
