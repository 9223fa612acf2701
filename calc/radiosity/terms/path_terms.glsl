// Formulas of light paths and short rays: one text for C++ (path_terms.h) and GLSL (gpu/), in
// double, so that both choose the same directions. See calc/base/shader_words.h.

TERM UINT reverse_bits(UINT x) {
  x = ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  return (x << 16) | (x >> 16);
}

// Flips each bit depending on the more significant ones only: a nested uniform scramble in base 2,
// by hashing the reversed word with a permutation whose carries run upwards.  [Burley20; constants:
// Vegdahl21]
// reversed: of the word's bits.
TERM UINT nested_scramble_reversed(UINT reversed, UINT seed) {
  UINT x = reversed;
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return reverse_bits(x);
}

TERM UINT nested_scramble(UINT x, UINT seed) {
  return nested_scramble_reversed(reverse_bits(x), seed);
}

// The number that decides how long a path lives, never 0: a path with 0 would not end.
// u: k 2^-32; survival probabilities stay exact to 2^-32.
TERM double roulette_number(double u) { return u + DBL(1.1641532182693481e-10); }  // + 2^-33

// Unit direction with density cos / pi about a unit normal.  u in [0, 1)^2
TERM DVEC3 cosine_direction(IN_DVEC3 normal, double u0, double u1) {
  // Frame without a branch at the poles [Duff17].
  const double sign = SIGN_OF(normal.z);
  const double a = DBL(-1.0) / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const DVEC3 s = DVEC3(DBL(1.0) + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const DVEC3 t = DVEC3(b, sign + normal.y * normal.y * a, -normal.y);
  const double radius = sqrt(u0);
  const SineCosine angle = sine_cosine_of_turns(u1);
  return radius * angle.cosine * s + radius * angle.sine * t + sqrt(DBL(1.0) - u0) * normal;
}

// Unit direction spread evenly over the sphere.
TERM DVEC3 sphere_direction(double u0, double u1) {
  const double z = DBL(1.0) - DBL(2.0) * u0;
  const double radius = sqrt(max(DBL(0.0), DBL(1.0) - z * z));
  const SineCosine angle = sine_cosine_of_turns(u1);
  return DVEC3(radius * angle.cosine, radius * angle.sine, z);
}
