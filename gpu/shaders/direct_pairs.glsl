// What every point has of every luminaire. Pair = luminaire * points + point; calc::add_openings()
// and calc::add_point_sources() again.

layout(std430, binding = 6) PAIR_ACCESS buffer Pairs { uint pair_word[]; };

uniform uint point_count, luminaire_count, has_shadows;

uint pair_of(uint lamp, uint p) { return lamp * point_count + p; }

// Of a pair's word; above it, of what is sampled, how many samples a round has.
uint kind_of(uint pair) { return pair_word[pair] % PAIR_STEP; }
