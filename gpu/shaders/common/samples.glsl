// Scrambled Sobol' points: calc::ScrambledSobol again, to the last bit. After random_keys.

// A loop ended before its time: Mesa's llvmpipe leaves all loops of an invocation after 65535 turns,
// without a word. What follows is then worthless.
bool is_cut = false;

layout(std430, binding = 4) readonly buffer Words { uint word[]; };

// directions: where the 32 direction numbers of the dimension begin.
double sobol_sample(uint index, uint directions, uint scramble) {
  uint x = 0u;
  uint rest = index;
  for (; rest != 0u; rest >>= 1u) {
    if ((rest & 1u) != 0u) x ^= word[directions];
    ++directions;
  }
  if (rest != 0u) is_cut = true;
  return double(nested_scramble(x, scramble)) * DBL(2.3283064365386962890625e-10);
}
