// Where a ray passes a triangle: one text for C++ (triangle_hit.cpp) and GLSL (gpu/), in double, so
// that both find the same place. See calc/base/shader_words.h; EXACT forbids to join the steps.

// Six times the volume between the ray and an edge, given its ends from the ray's origin; by its
// sign the ray passes on one side or the other. Exchanging the ends changes the sign and nothing
// else.
TERM double side_of(IN_DVEC3 direction, IN_DVEC3 edge, IN_DVEC3 begin, IN_DVEC3 end) {
  EXACT DVEC3 both = begin + end;
  EXACT double x = edge.y * both.z - both.y * edge.z;
  EXACT double y = edge.z * both.x - both.z * edge.x;
  EXACT double z = edge.x * both.y - both.x * edge.y;
  EXACT double side = x * direction.x + y * direction.y + z * direction.z;
  return side;
}

// The sides of the edges across from the corners a, b, c of a triangle; their shares of the sum are
// those of the corners in the place where the ray meets the triangle's plane.
TERM DVEC3 sides_of(IN_DVEC3 origin, IN_DVEC3 direction, IN_DVEC3 a, IN_DVEC3 b, IN_DVEC3 c) {
  EXACT DVEC3 from_a = a - origin, from_b = b - origin, from_c = c - origin;
  EXACT DVEC3 ab = b - a, bc = c - b, ca = a - c;
  return DVEC3(side_of(direction, bc, from_b, from_c), side_of(direction, ca, from_c, from_a),
               side_of(direction, ab, from_a, from_b));
}
