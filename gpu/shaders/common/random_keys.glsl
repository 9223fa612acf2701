// Hashed random numbers: calc::RandomKey again, to the last bit. 64-bit words are (low, high).

uvec2 product_of(uvec2 a, uvec2 b) {
  uint low, high;
  umulExtended(a.x, b.x, high, low);
  return uvec2(low, high + a.x * b.y + a.y * b.x);
}

// x ^ (x >> n), 0 < n < 32
uvec2 folded(uvec2 x, uint n) { return x ^ uvec2((x.x >> n) | (x.y << (32u - n)), x.y >> n); }

uvec2 mix_bits(uvec2 x) {
  uint carry;
  const uint low = uaddCarry(x.x, 0x7f4a7c15u, carry);
  x = uvec2(low, x.y + 0x9e3779b9u + carry);
  x = product_of(folded(x, 30u), uvec2(0x1ce4e5b9u, 0xbf58476du));
  x = product_of(folded(x, 27u), uvec2(0x133111ebu, 0x94d049bbu));
  return folded(x, 31u);
}

// mixed: PART_3 for a part that is the literal 3. Mesa 22.3 leaves the high word of umulExtended() out
// where it works out constants.
uvec2 key_with(uvec2 key, uvec2 mixed) { return mix_bits(key ^ mixed); }
uvec2 key_with(uvec2 key, uint part) { return key_with(key, mix_bits(uvec2(part, 0u))); }

// In [0, 1), 53 bits.
double fraction_of(uvec2 key) {
  return (double(key.y) * 2097152.0LF + double(key.x >> 11u)) * 1.1102230246251565404e-16LF;
}
