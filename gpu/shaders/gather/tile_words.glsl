// How the nodes of tiles lie in memory: for each tile TILE_HEAD words (how many nodes, how many
// channels have some, the last of these, TILE_CHOSEN), begin and end of each channel, and the nodes.

uniform uint most_nodes, most_ranges;
uniform uint two;  // 2: a bound of loops that compilers cannot write out

shared uint probe;

// Mesa's llvmpipe leaves all loops of an invocation after 65535 turns together, without a word, and
// each one that comes later after its first turn: this one, too, if any before it.
bool is_loop_left() {
  uint turns = 0u;
  for (; turns < two; ++turns) atomicOr(probe, turns);
  return turns < two;
}

uint tile_size() { return TILE_HEAD + 2u * most_ranges + most_nodes; }
