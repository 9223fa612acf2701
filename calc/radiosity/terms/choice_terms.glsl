// About the most light that a luminaire could send to a surface point, by which LuminaireChoice
// chooses: one text for C++ (choice_terms.h) and for GLSL (gpu/), which must choose the same one. So
// there are only operations that IEEE 754 rounds exactly, in the order written, as in
// node_terms.glsl.  [METHOD, 2.4]
// What it may use: EXACT (no contraction), QUOTIENT(a, b) and ROOT(a), rounded to nearest; LOBE, the
// intensities of a web, and MOST_CD(lobe, band) and LARGEST_CD(lobe) of it.

struct ChoiceSource {
  FVEC3 position_m;
  FVEC3 x, y, z;    // the luminaire's axes
  FVEC3 half_m;     // half sizes of its opening along them
  float reach_m;    // half the diagonal of its opening
  float scale;
  UINT lobe, channel;
};

TERM float choice_larger(float a, float b) { return a > b ? a : b; }
TERM float choice_smaller(float a, float b) { return a < b ? a : b; }
TERM float choice_size(float a) { return choice_larger(a, -a); }

TERM float choice_dot(IN_FVEC3 a, IN_FVEC3 b) {
  EXACT float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

// The band of equal solid angle about the luminaire's axis in which it sends light to the point.
// way_m: from the point to the luminaire's centre; centre2: squared.
TERM UINT choice_band(IN_FVEC3 z, IN_FVEC3 way_m, float centre2) {
  EXACT float along = choice_dot(z, way_m);
  EXACT float size = QUOTIENT(choice_size(along), ROOT(choice_larger(centre2, 1.0e-30f)));
  EXACT float cosine = along < 0.0f ? -size : size;
  EXACT float place = (1.0f - cosine) * (0.5f * float(CHOICE_BANDS));
  return UINT(choice_smaller(choice_larger(place, 0.0f), float(CHOICE_BANDS) - 1.0f));
}

// Nearer than the opening is long: the intensity of as much of each side as is about as near as the
// nearest place, at that distance. Where that is next to 0 it is four luminances.
TERM float choice_nearby_lx(IN_SOURCE source, float largest_cd, IN_FVEC3 way_m) {
  EXACT float x = choice_larger(choice_size(choice_dot(source.x, way_m)) - source.half_m.x, 0.0f);
  EXACT float y = choice_larger(choice_size(choice_dot(source.y, way_m)) - source.half_m.y, 0.0f);
  EXACT float z = choice_larger(choice_size(choice_dot(source.z, way_m)) - source.half_m.z, 0.0f);
  EXACT float gap2 = x * x + y * y + z * z;
  EXACT float least = 1.0e-6f * source.reach_m;  // a line has no width
  EXACT float distance = choice_larger(ROOT(gap2), least);
  const float shortest =
      choice_smaller(choice_smaller(source.half_m.x, source.half_m.y), source.half_m.z);
  // Of three sides the two longer ones count.
  const bool is_without_x = source.half_m.x == shortest;
  const bool is_without_y = !is_without_x && source.half_m.y == shortest;
  float per_m2 = 1.0f;
  if (!is_without_x) per_m2 = QUOTIENT(per_m2, choice_larger(source.half_m.x, distance));
  if (!is_without_y) per_m2 = QUOTIENT(per_m2, choice_larger(source.half_m.y, distance));
  if (is_without_x || is_without_y) {
    per_m2 = QUOTIENT(per_m2, choice_larger(source.half_m.z, distance));
  }
  EXACT float lx = source.scale * largest_cd * per_m2;
  return lx;
}

TERM float choice_most_lx(IN_SOURCE source, LOBE lobe, IN_FVEC3 position_m, IN_FVEC3 normal) {
  EXACT float way_x = source.position_m.x - position_m.x;
  EXACT float way_y = source.position_m.y - position_m.y;
  EXACT float way_z = source.position_m.z - position_m.z;
  const FVEC3 way_m = FVEC3(way_x, way_y, way_z);
  EXACT float height_m = choice_dot(normal, way_m) + source.reach_m;
  EXACT float centre2 = choice_dot(way_m, way_m);
  EXACT float reach2 = source.reach_m * source.reach_m;
  EXACT float distance2 = centre2 + reach2;
  if (!(height_m > 0.0f) || !(distance2 > 0.0f)) return 0.0f;
  EXACT float near2 = 4.0f * source.reach_m * source.reach_m;
  if (centre2 < near2) return choice_nearby_lx(source, LARGEST_CD(lobe), way_m);
  EXACT float most = source.scale * MOST_CD(lobe, choice_band(source.z, way_m, centre2)) * height_m;
  EXACT float distance3 = distance2 * ROOT(distance2);
  return QUOTIENT(most, distance3);
}
