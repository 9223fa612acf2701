// Where chains of short rays are at one of their steps: hits of a piece of the list, or what the
// further rays of the step before met.

layout(std430, binding = 13) buffer Places { uvec4 place_words[]; };

uniform uint first_item, item_count;  // of this dispatch
uniform uint depth;                   // the step; 0: the hits themselves
uniform uint first_light;             // its first row of what is found

struct HitPlace {
  dvec3 position_m, normal;
  double weight;  // of its light
  uvec2 key;      // of its ray
};

HitPlace place_at(uint i) {
  const uvec4 a = place_words[4u * i], b = place_words[4u * i + 1u], c = place_words[4u * i + 2u],
              d = place_words[4u * i + 3u];
  return HitPlace(dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy)),
                  dvec3(packDouble2x32(b.zw), packDouble2x32(c.xy), packDouble2x32(c.zw)),
                  packDouble2x32(d.xy), d.zw);
}

void store(uint i, HitPlace place) {
  place_words[4u * i] =
      uvec4(unpackDouble2x32(place.position_m.x), unpackDouble2x32(place.position_m.y));
  place_words[4u * i + 1u] =
      uvec4(unpackDouble2x32(place.position_m.z), unpackDouble2x32(place.normal.x));
  place_words[4u * i + 2u] =
      uvec4(unpackDouble2x32(place.normal.y), unpackDouble2x32(place.normal.z));
  place_words[4u * i + 3u] = uvec4(unpackDouble2x32(place.weight), place.key);
}

// The random numbers of this step.
uvec2 key_of(HitPlace place) { return key_with(place.key, depth); }

void write_light(uint i, uint what, uint value) {
  light_word[LIGHT_SIZE * (first_light + i) + what] = value;
}

void write_light(uint i, uint what, double value) {
  const uvec2 words = unpackDouble2x32(value);
  write_light(i, what, words.x);
  write_light(i, what + 1u, words.y);
}

// Of the step's draws from afar, PLACES_PER_HIT for each place.
void write_draw(uint draw, uvec2 found) {
  const uint i = draw / PLACES_PER_HIT, at = LIGHT_DRAWS + 2u * (draw % PLACES_PER_HIT);
  write_light(i, at, found.x);
  write_light(i, at + 1u, found.y);
}

// Whether anything is still to be found there: false, too, where the bound was not done, and behind
// the last of a step's places.
bool is_lit(uint i) {
  const uint row = first_light + i;
  return light_at(row, LIGHT_WEIGHT + 1u) != LIGHT_NOT_DONE &&
         light_double(row, LIGHT_WEIGHT) > DBL(0.0);
}
