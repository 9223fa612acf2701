// Which groups of light vertices a tile of points opens, and which it leaves out: one text for C++
// (node_terms.h) and for GLSL (gpu/), after node_terms.glsl. Both must give the same bits, or they
// would choose different groups: only operations that IEEE 754 rounds exactly. [METHOD, 5.2]
// What it may use beside: BITS_OF(a), the bits of a float.

TERM REAL cut_size_of(REAL a) { return node_larger(a, -a); }

// How far a box with half sizes h reaches along a.
TERM REAL cut_reach_m(REAL ax, REAL ay, REAL az, REAL hx, REAL hy, REAL hz) {
  EXACT REAL reach = cut_size_of(ax) * hx + cut_size_of(ay) * hy + cut_size_of(az) * hz;
  return reach;
}

// The node's box, with centre c and half sizes h, lies wholly behind the receivers, which look
// along a and lie no lower than lowest_m along it.
TERM bool cut_is_behind(REAL ax, REAL ay, REAL az, REAL slack_m, REAL lowest_m, REAL cx, REAL cy,
                        REAL cz, REAL hx, REAL hy, REAL hz) {
  EXACT REAL highest = ax * cx + ay * cy + az * cz + cut_reach_m(ax, ay, az, hx, hy, hz);
  EXACT REAL with_slack = highest + slack_m;
  return with_slack < lowest_m;
}

// Of the way from the node's centre to the tile's.
TERM REAL cut_distance_m(REAL tx, REAL ty, REAL tz) {
  EXACT REAL distance2 = tx * tx + ty * ty + tz * tz;
  return ROOT(distance2);
}

// No direction from the node to the tile lies within 90 degrees of any of its normals: these lie
// within an angle of cosine cos_spread around n, and reach_m holds the radii of both spheres. t:
// from the node's centre to the tile's.
TERM bool cut_faces_away(REAL nx, REAL ny, REAL nz, REAL cos_spread, REAL hx, REAL hy, REAL hz,
                         REAL tile_radius_m, REAL slack_m, REAL reach_m, REAL tx, REAL ty, REAL tz,
                         REAL distance_m) {
  EXACT REAL along_m = nx * tx + ny * ty + nz * tz;
  if (along_m >= REAL(0) || cos_spread <= REAL(0)) return false;
  if (cos_spread >= REAL(0.999999)) {  // one normal: a plain distance to the plane
    EXACT REAL highest = along_m + cut_reach_m(nx, ny, nz, hx, hy, hz) + tile_radius_m + slack_m;
    return highest < REAL(0);
  }
  if (distance_m <= reach_m) return false;
  // Beyond a right angle by more than spread and sphere together, which must be below a right
  // angle themselves; 0.001 is for what rounding may add.
  EXACT REAL beyond = QUOTIENT(-along_m, distance_m);  // the sine
  EXACT REAL sphere = QUOTIENT(reach_m, distance_m);
  EXACT REAL cos_sphere = ROOT(REAL(1) - sphere * sphere);
  EXACT REAL spread = ROOT(REAL(1) - cos_spread * cos_spread);
  EXACT REAL cosine_of_both = cos_spread * cos_sphere - spread * sphere;
  EXACT REAL both = spread * cos_sphere + cos_spread * sphere + REAL(0.001);
  return cosine_of_both > REAL(0) && beyond > both;
}

// How far the node's contribution may vary over its vertices: flux times the largest kernel, times
// the share of it that position and normals leave open. softening_m: see ReceiverTile.
TERM REAL cut_error(REAL flux_lm, REAL radius_m, REAL cos_spread, REAL bound_per_m2,
                    REAL distance_m, REAL softening_m, REAL tile_radius_m) {
  EXACT REAL gap = node_larger(distance_m + softening_m - tile_radius_m - radius_m, REAL(0));
  EXACT REAL gap2 = gap * gap + REAL(1e-12);
  EXACT REAL r2 = radius_m * radius_m;
  EXACT REAL sum2 = gap2 + r2;
  EXACT REAL largest = node_smaller(QUOTIENT(REAL(1), gap2), bound_per_m2);
  EXACT REAL open = QUOTIENT(r2, sum2) + (REAL(1) - cos_spread);
  EXACT REAL error = flux_lm * largest * open;
  return error;
}

// Errors in steps of 2^(1/4), exponent and two bits of the mantissa, from 2^-40 to 2^40. Below 0:
// nothing to open, not even where a device takes the least numbers for 0.
TERM int cut_step(REAL error) {
  if (!(error > REAL(1e-30))) return -1;
  int step = int(BITS_OF(error) >> 21) - 4 * (127 - 40);
  if (step < 0) step = 0;
  return step < 4 * 80 - 1 ? step : 4 * 80 - 1;
}
