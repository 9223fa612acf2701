// Division and square root rounded to nearest, which GLSL does not promise. From the mantissas as
// integers: a first guess by the device, then the exact remainder puts it right. For positive
// numbers whose result is neither huge nor denormal, and 0.

uint mantissa(uint bits) { return (bits & 0x7fffffu) | 0x800000u; }

float exact_quotient(float a, float b) {
  if (!(a > 0.0)) return 0.0;
  const uint a_bits = floatBitsToUint(a), b_bits = floatBitsToUint(b);
  uint m = mantissa(a_bits);
  const uint n = mantissa(b_bits);
  int exponent = int(a_bits >> 23) - int(b_bits >> 23) + 127;
  if (m < n) {
    m <<= 1;
    --exponent;
  }
  if (exponent <= 0) return 0.0;
  uint q = uint(float(m) / float(n) * 8388608.0);  // in [2^23, 2^24], off by a few
  int rest = int((m << 23) - q * n);               // m 2^23 - q n, which is small, modulo 2^32
  while (rest < 0) {
    rest += int(n);
    --q;
  }
  while (rest >= int(n)) {
    rest -= int(n);
    ++q;
  }
  if (2 * rest > int(n)) ++q;  // it is never a tie
  return uintBitsToFloat((uint(exponent) << 23) + (q - 0x800000u));
}

float exact_root(float a) {
  if (!(a > 0.0)) return 0.0;
  const uint bits = floatBitsToUint(a);
  int exponent = int(bits >> 23) - 127;
  uint m = mantissa(bits);
  if ((exponent & 1) != 0) {
    m <<= 1;
    --exponent;
  }
  uint s = uint(sqrt(float(m)) * 2896.3093757400984);  // sqrt(m 2^23) in [2^23, 2^24]
  int rest = int((m << 23) - s * s);
  while (rest < 0) {
    --s;
    rest += int(2u * s + 1u);
  }
  while (rest > int(2u * s)) {
    rest -= int(2u * s + 1u);
    ++s;
  }
  if (rest > int(s)) ++s;
  return uintBitsToFloat((uint(exponent / 2 + 127) << 23) + (s - 0x800000u));
}

#define EXACT precise
#define QUOTIENT(a, b) exact_quotient(a, b)
#define ROOT(a) exact_root(a)
#define BITS_OF(a) floatBitsToUint(a)
