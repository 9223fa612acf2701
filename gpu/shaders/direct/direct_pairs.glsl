// What every point has of every luminaire. Pair = luminaire * points + point; calc::add_openings()
// and calc::add_point_sources() again.

layout(std430, binding = 2) readonly buffer Points { uvec4 point_words[]; };
layout(std430, binding = 6) PAIR_ACCESS buffer Pairs { uint pair_word[]; };

uniform uint point_count, luminaire_count, has_shadows;

Point point_of(uint p) {
  const uvec4 a = point_words[4u * p], b = point_words[4u * p + 1u], c = point_words[4u * p + 2u],
              d = point_words[4u * p + 3u];
  Point point;
  point.position_m = dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy));
  point.axis = dvec3(packDouble2x32(b.zw), packDouble2x32(c.xy), packDouble2x32(c.zw));
  point.kernel = d.x;
  point.key = d.yz;
  return point;
}

// Whether this pass asks for it.
bool is_asked(uint lamp) { return word[ASKED_AT + lamp] != 0u; }

uint pair_of(uint lamp, uint p) { return lamp * point_count + p; }

// Of a pair's word; above it, of what is sampled, how many samples a round has.
uint kind_of(uint pair) { return pair_word[pair] % PAIR_STEP; }
