// How large the dispatches of a later step are. One invocation.

layout(local_size_x = 1) in;

layout(std430, binding = 7) readonly buffer Chains { uint chain_word[]; };  // hit_further.glsl
layout(std430, binding = 4) writeonly buffer Sizes { uint size[]; };  // three for each dispatch

uniform uint depth;
uniform uint most_places;      // there are no more
uniform uint items_per_place;  // of the stage that draws
uniform uint most_nodes;

uint groups(uint items) { return (items + GROUP_SIZE - 1u) / GROUP_SIZE; }

void write(uint dispatch, uint x, uint y) {
  size[3u * dispatch] = x;
  size[3u * dispatch + 1u] = y;
  size[3u * dispatch + 2u] = 1u;
}

void main() {
  const uint places = min(chain_word[depth], most_places);
  write(DISPATCH_PLACES, groups(places), 1u);
  write(DISPATCH_NODES, places == 0u ? 0u : groups(most_nodes), places);
  write(DISPATCH_ROWS, places, 1u);
  write(DISPATCH_DRAWS, groups(places * items_per_place), 1u);
}
