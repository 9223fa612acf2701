// How the nodes of tiles lie in memory: for each tile TILE_HEAD words (how many nodes, how many
// channels have some, the last of these, TILE_CHOSEN), begin and end of each channel, and the nodes.

uniform uint most_nodes, most_ranges;

uint tile_size() { return TILE_HEAD + 2u * most_ranges + most_nodes; }
