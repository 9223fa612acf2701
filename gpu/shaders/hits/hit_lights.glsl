// What is found at hits of short rays, and at the later steps of their chains: a calc::HitLight each,
// rows of a piece's hits one step behind the other.

layout(std430, binding = 12) LIGHT_ACCESS buffer Lights { uint light_word[]; };

uint light_at(uint row, uint what) { return light_word[LIGHT_SIZE * row + what]; }

double light_double(uint row, uint what) {
  return packDouble2x32(uvec2(light_at(row, what), light_at(row, what + 1u)));
}
