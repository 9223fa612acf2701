// Light at hits, after the last step: of each hit whether all of its chain was done, or whether it is
// left to the CPU: then its first step goes there, in any order, as the CPU sorts them. Of what was
// done, the light by channels.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 9) readonly buffer Links { uint next_row[]; };  // hit_further.glsl
layout(std430, binding = 4) writeonly buffer Ends { uint end_word[]; };  // of each hit, see hit_sums
// Of each hit MOST_PORTIONS times a channel and its light, three words each.
layout(std430, binding = 14) writeonly buffer Portions { uint portion_word[]; };
layout(std430, binding = 5) writeonly buffer Left { uint left_word[]; };
layout(std430, binding = 6) buffer LeftCount { uint left_count; };
layout(std430, binding = 11) readonly buffer ChoiceTable { float choice[]; };

uniform uint hit_count, last_depth, has_far_light, has_shadows, leaves_all;

bool is_word_done(uint row, uint what) { return light_at(row, what) != LIGHT_NOT_DONE; }

bool has_light(uint row) { return light_double(row, LIGHT_WEIGHT) > DBL(0.0); }

// Of one step; its double words are written with the others.
uint fate_of(uint row) {
  if (!is_word_done(row, LIGHT_WEIGHT + 1u)) return FATE_NOT_DONE;
  if (!has_light(row)) return FATE_DONE;
  if (!is_word_done(row, LIGHT_LUMINAIRE) || !is_word_done(row, LIGHT_DIRECT + 1u) ||
      !is_word_done(row, LIGHT_NEXT_TRIANGLE)) {
    return FATE_NOT_DONE;
  }
  for (uint k = 0u; k < has_far_light * PLACES_PER_HIT; ++k) {
    if (!is_word_done(row, LIGHT_DRAWS + 2u * k)) return FATE_NOT_DONE;
  }
  return light_at(row, LIGHT_LUMINAIRE) == LIGHT_LEFT ? FATE_LEFT : FATE_DONE;
}

// Of the whole chain.
uint fate_of_chain(uint hit) {
  uint result = leaves_all != 0u ? FATE_LEFT : FATE_DONE, row = hit;
  for (uint d = 0u; row != HIT_NOTHING; ++d) {
    const uint one = d <= last_depth ? fate_of(row) : FATE_NOT_DONE;
    if (one == FATE_NOT_DONE) return FATE_NOT_DONE;
    if (!has_light(row)) break;
    if (one == FATE_LEFT) result = FATE_LEFT;
    if (light_at(row, LIGHT_NEXT_TRIANGLE) == HIT_NOTHING) break;
    row = next_row[row];
    if (row == LIGHT_NOT_DONE) return FATE_NOT_DONE;
    if (row == HIT_NOTHING) result = FATE_LEFT;
  }
  // Nothing is there to be left.
  return has_light(hit) ? result : FATE_DONE;
}

struct Sums {
  double lx, portion_lx;
  uint channel, portions, rays;  // of the portion at hand
};

void write_portion(uint hit, inout Sums sums) {
  const uint at = 3u * (MOST_PORTIONS * hit + sums.portions);
  const uvec2 lx = unpackDouble2x32(sums.portion_lx);
  portion_word[at] = sums.channel;
  portion_word[at + 1u] = lx.x;
  portion_word[at + 2u] = lx.y;
  ++sums.portions;
}

void add(uint hit, uint channel, double lx, inout Sums sums) {
  if (channel != sums.channel) {
    if (sums.channel != LIGHT_NOTHING) write_portion(hit, sums);
    sums.channel = channel;
    sums.portion_lx = DBL(0.0);
  }
  sums.portion_lx += lx;
  sums.lx += lx;
}

void add_row(uint hit, uint row, inout Sums sums) {
  ++sums.rays;  // the further one
  const uint luminaire = light_at(row, LIGHT_LUMINAIRE);
  if (luminaire != LIGHT_NOTHING) {
    sums.rays += has_shadows;
    if (luminaire != LIGHT_HIDDEN) {
      add(hit, uint(choice[CHOICE_SIZE * luminaire + 18u]), light_double(row, LIGHT_DIRECT), sums);
    }
  }
  const double weight = light_double(row, LIGHT_WEIGHT) / DBL(3.14159265358979323846);
  for (uint k = 0u; k < has_far_light * PLACES_PER_HIT; ++k) {
    const uint at = LIGHT_DRAWS + 2u * k, channel = light_at(row, at);
    if (channel == LIGHT_NOTHING) continue;
    sums.rays += has_shadows;
    if (channel == LIGHT_HIDDEN) continue;
    add(hit, channel, weight * double(uintBitsToFloat(light_at(row, at + 1u))), sums);
  }
}

void main() {
  const uint hit = gl_GlobalInvocationID.x;
  if (hit >= hit_count) return;
  const uint fate = fate_of_chain(hit);
  if (fate == FATE_NOT_DONE) return;
  Sums sums = Sums(DBL(0.0), DBL(0.0), LIGHT_NOTHING, 0u, 0u);
  if (fate == FATE_LEFT) {
    const uint at = LIGHT_SIZE * atomicAdd(left_count, 1u);
    for (uint w = 0u; w < LIGHT_SIZE; ++w) left_word[at + w] = light_at(hit, w);
  } else {
    uint row = hit;
    while (row != HIT_NOTHING && has_light(row)) {
      add_row(hit, row, sums);
      row = next_row[row];
    }
    if (sums.channel != LIGHT_NOTHING) write_portion(hit, sums);
  }
  const uvec2 lx = unpackDouble2x32(sums.lx);
  const uint at = END_SIZE * hit;
  end_word[at] = fate;
  end_word[at + 1u] = sums.rays;
  end_word[at + 2u] = lx.x;
  end_word[at + 3u] = lx.y;
  end_word[at + 4u] = sums.portions;
}
