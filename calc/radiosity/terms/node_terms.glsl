// How likely a group of light vertices is drawn by a receiver: one text for C++ (node_terms.h) and
// for GLSL (gpu/). Both must give the same bits, or they would draw different vertices: so there
// are only operations that IEEE 754 rounds exactly, in the order written.
// [METHOD, 5.3]
// What it may use: REAL, EXACT (no contraction), QUOTIENT(a, b) and ROOT(a), rounded to nearest.

TERM REAL node_larger(REAL a, REAL b) { return a > b ? a : b; }
TERM REAL node_smaller(REAL a, REAL b) { return a < b ? a : b; }

// About the bound of the geometry term at the node's vertices. The bound is kappa times the density
// of first reflections, about a third of all vertices.
TERM REAL node_bound_per_m2(REAL smallest_bound_per_m2, REAL vertices_per_m2) {
  EXACT REAL expected = REAL(0.003) * vertices_per_m2;
  return node_larger(smallest_bound_per_m2, expected);
}

// flux (min(kernel, b) + e min(1 / gap^2, b)); u: from the receiver to the centre of the node's
// sphere, whose nearest point is `gap` away; e = 0.03, so that no contribution can be much larger
// than its probability.
TERM REAL node_mixed(REAL flux_lm, REAL kernel, REAL radius_m, REAL bound_per_m2, REAL ux, REAL uy,
                     REAL uz) {
  EXACT REAL u2 = ux * ux + uy * uy + uz * uz;
  EXACT REAL gap = node_larger(ROOT(u2) - radius_m, REAL(0));
  EXACT REAL gap2 = gap * gap + REAL(1e-12);
  EXACT REAL result = flux_lm * (node_smaller(kernel, bound_per_m2) +
                                 REAL(0.03) * node_smaller(QUOTIENT(REAL(1), gap2), bound_per_m2));
  return result;
}

// d: from the receiver to the vertex that stands for the node; its distance, softened by the node's
// radius, squared.
TERM REAL node_softened_m2(REAL radius_m, REAL dx, REAL dy, REAL dz) {
  EXACT REAL d2 = dx * dx + dy * dy + dz * dz + radius_m * radius_m + REAL(1e-12);
  return d2;
}

// n: the vertex's normal.
TERM REAL node_facing(REAL nx, REAL ny, REAL nz, REAL dx, REAL dy, REAL dz) {
  EXACT REAL cosine = -(nx * dx + ny * dy + nz * dz);
  return node_larger(cosine, REAL(0));
}

// cos_x cos_y / d^2 for a plane with normal a.
TERM REAL node_kernel_planar(REAL d2, REAL facing, REAL ax, REAL ay, REAL az, REAL dx, REAL dy,
                             REAL dz) {
  EXACT REAL cosine = ax * dx + ay * dy + az * dz;
  EXACT REAL product = node_larger(cosine, REAL(0)) * facing;
  EXACT REAL d4 = d2 * d2;
  return QUOTIENT(product, d4);
}

// The same with cos_x = 1, for receivers that look everywhere.
TERM REAL node_kernel_round(REAL d2, REAL facing) {
  EXACT REAL product = facing * ROOT(d2);
  EXACT REAL d4 = d2 * d2;
  return QUOTIENT(product, d4);
}
