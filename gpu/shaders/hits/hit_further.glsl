// Light at hits, stage 3: one further ray from each, and whether the chain may go on at what it
// meets: of add_step() in near_field.cpp what can be told without the bound there. Where it may, a
// place of the next step, in any order: what is found there is added by the way from hit to hit.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 10) readonly buffer Field { double field[]; };
// CHAIN_HEAD words: of each step how many places it has; then these.
layout(std430, binding = 7) buffer Chains { uint chain_word[]; };
// Of each row of lights that of the chain's next step, HIT_NOTHING if there is none here.
layout(std430, binding = 9) writeonly buffer Links { uint next_row[]; };

uniform float most_m;
uniform uint last_depth;  // further ones are the CPU's
uniform uint next_light;  // the next step's first row

double geometry_at(HitPlace place, uint triangle, vec3 along, dvec2 share) {
  return connection_geometry(KERNEL_PLANAR, place.normal, facing_normal(triangle, along),
                             position_on(triangle, share) - place.position_m);
}

bool goes_on(HitPlace place, uint triangle, double g) {
  const double rho = reflectance_of(triangle);
  if (rho <= DBL(0.0) || g <= field[FIELD_SMALLEST]) return false;
  const double roulette = fraction_of(key_with(key_with(place.key, depth + 1u), PART_0));
  return roulette < (DBL(1.0) - field[FIELD_SMALLEST] / g) * rho;
}

void write_chain(uint at, uvec2 words) {
  chain_word[at] = words.x;
  chain_word[at + 1u] = words.y;
}

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint i = first_item + gl_GlobalInvocationID.x;
  if (!is_lit(i)) return;
  const HitPlace place = place_at(i);
  const uvec2 key = key_of(place);
  const vec3 from = vec3(lifted_m_of(place.position_m, place.normal));
  const vec3 along = vec3(cosine_direction(place.normal, fraction_of(key_with(key, PART_3)),
                                           fraction_of(key_with(key, PART_4))));
  uint triangle;
  dvec2 share;
  const bool is_met = closest_hit(from, along, 0.0, most_m, triangle, share);
  if (is_cut) return;  // not done
  const double g = is_met ? geometry_at(place, triangle, along, share) : DBL(0.0);
  if (!is_met || !goes_on(place, triangle, g)) {
    next_row[first_light + i] = HIT_NOTHING;
    write_light(i, LIGHT_NEXT_TRIANGLE, HIT_NOTHING);
    return;
  }
  const uint side = is_met_in_front(triangle, along) ? 0u : HIT_FROM_BEHIND;
  uint row = HIT_NOTHING;
  if (depth < last_depth) {
    const uint next = atomicAdd(chain_word[depth + 1u], 1u);
    row = next_light + next;
    const uint at = CHAIN_HEAD + CHAIN_SIZE * next;
    write_chain(at, unpackDouble2x32(share.x));
    write_chain(at + 2u, unpackDouble2x32(share.y));
    write_chain(at + 4u, unpackDouble2x32(g));
    write_chain(at + 6u, unpackDouble2x32(place.weight));
    write_chain(at + 8u, place.key);
    chain_word[at + 10u] = triangle | side;
  }
  next_row[first_light + i] = row;
  write_light(i, LIGHT_NEXT_TRIANGLE, triangle_of[triangle] | side);
  write_light(i, LIGHT_NEXT_PLACE, share.x);
  write_light(i, LIGHT_NEXT_PLACE + 2u, share.y);
}
