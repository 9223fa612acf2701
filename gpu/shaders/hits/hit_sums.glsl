// Light at hits, at last: the sums of each request over its hits of the piece, in their order:
// calc::PointLight. x: requests, y: channels; the first channel's invocation also has what is of all.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 7) readonly buffer List { uvec2 list[]; };
// Of each hit END_SIZE words: its fate, rays, light (two words), portions; see hit_ends.glsl.
layout(std430, binding = 4) readonly buffer Ends { uint end_word[]; };
layout(std430, binding = 5) readonly buffer Portions { uint portion_word[]; };
// Of each request ANSWER_HEAD words and its channels: HitAnswer of hit_answer.h.
layout(std430, binding = 14) buffer Answers { uint answer[]; };

uniform uint request_count, first_hit, hit_count, channel_count;
uniform uint is_first_piece;

uint first_of(uint request) {
  uint low = 0u, high = hit_count;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (list[first_hit + middle].x < request) low = middle + 1u;
    else high = middle;
  }
  return low;
}

double double_of(uint low, uint high) { return packDouble2x32(uvec2(low, high)); }

// A channel's light of a hit. False: the driver left the loop.
bool add_portions(uint hit, uint channel, inout double lx) {
  const uint portions = end_word[END_SIZE * hit + 4u];
  uint k = 0u;
  for (; k < portions; ++k) {
    const uint at = 3u * (MOST_PORTIONS * hit + k);
    if (portion_word[at] != channel) continue;
    lx += double_of(portion_word[at + 1u], portion_word[at + 2u]);
  }
  return k == portions;
}

void main() {
  const uint request = gl_GlobalInvocationID.x, channel = gl_GlobalInvocationID.y;
  if (request >= request_count) return;
  uint h = first_of(request);
  const uint end = first_of(request + 1u);
  const uint head = (ANSWER_HEAD + 2u * channel_count) * request;
  const uint at = head + ANSWER_HEAD + 2u * channel;
  const bool is_first = is_first_piece != 0u;
  float largest_lx = is_first ? 0.0 : uintBitsToFloat(answer[head]);
  uint rays = is_first ? 0u : answer[head + 1u], hits = is_first ? 0u : answer[head + 2u],
       left = is_first ? 0u : answer[head + 3u];
  double sum_lx = is_first ? DBL(0.0) : double_of(answer[at], answer[at + 1u]);
  bool is_done = true;
  for (; h < end && is_done; ++h) {
    const uint one = END_SIZE * h, fate = end_word[one];
    ++hits;
    if (fate == FATE_LEFT) ++left;
    if (fate != FATE_DONE) {
      is_done = fate == FATE_LEFT;
      continue;
    }
    const double lx = double_of(end_word[one + 2u], end_word[one + 3u]);
    rays += end_word[one + 1u];
    largest_lx = max(largest_lx, float(lx));
    if (channel_count == 1u) {
      sum_lx += lx;
    } else {
      is_done = add_portions(h, channel, sum_lx);
    }
  }
  is_done = is_done && h == end;
  // What is not done is no number, and its hits are not counted: the CPU notices either.
  const uvec2 sum = is_done ? unpackDouble2x32(sum_lx) : uvec2(SUM_NOT_DONE);
  answer[at] = sum.x;
  answer[at + 1u] = sum.y;
  if (channel > 0u || !is_done) return;
  answer[head] = floatBitsToUint(largest_lx);
  answer[head + 1u] = rays;
  answer[head + 2u] = hits;
  answer[head + 3u] = left;
}
