// The formulas of a connection between a receiver and a light vertex: one text for C++
// (connection_terms.h, in float and double) and for GLSL (gpu/), so that both compute the same sum.
// What it may use: REAL, VEC3, KERNEL, KERNEL_PLANAR and so on, dot, cross, length, sqrt.

// k(w / d) d for w = light - receiver (not normalised), d = |w|. 0 for a plane that faces away.
// [EN 13201-3 for the semicylindrical kernel; DIN 5031 for the others]
TERM REAL response_times_distance(KERNEL kernel, VEC3 axis, VEC3 w) {
  const REAL per_pi = REAL(0.31830988618379067154);
  const REAL along_axis = dot(axis, w);
  switch (kernel) {
    case KERNEL_PLANAR:
      break;
    case KERNEL_CYLINDRICAL:
      return per_pi * length(cross(axis, w));
    case KERNEL_SEMICYLINDRICAL:
      // The axis points from the flat back to the round front; the cylinder stands upright.
      return per_pi * (sqrt(w.x * w.x + w.y * w.y) + along_axis);
    case KERNEL_HEMISPHERICAL:
      return REAL(0.25) * (length(w) + along_axis);
    case KERNEL_SCALAR:
      return REAL(0.25) * length(w);
  }
  return along_axis > REAL(0) ? along_axis : REAL(0);
}

// How far a place is lifted off its surface: farther than near ones, whose lift is given, where
// coordinates are so large that rounding would take that away.
TERM REAL lift_at(VEC3 place, REAL near_m) {
  const REAL of_coordinate = REAL(2.0e-6);
  const REAL x = place.x < REAL(0) ? -place.x : place.x;
  const REAL y = place.y < REAL(0) ? -place.y : place.y;
  const REAL z = place.z < REAL(0) ? -place.z : place.z;
  const REAL across = x > y ? x : y;
  const REAL largest = across > z ? across : z;
  const REAL far_m = of_coordinate * largest;
  return far_m > near_m ? far_m : near_m;
}

// G = k(w) cos_v / d^2 in 1/m^2 for w = vertex - receiver; 0 if either faces away or both are at
// one place.
TERM REAL connection_geometry(KERNEL kernel, VEC3 axis, VEC3 vertex_normal, VEC3 w) {
  const REAL response = response_times_distance(kernel, axis, w);
  const REAL cosine = -dot(vertex_normal, w);
  if (!(response > REAL(0)) || !(cosine > REAL(0))) return REAL(0);
  const REAL d2 = dot(w, w);
  return response * cosine / (d2 * d2);
}

// The same for a vertex that is stored lifted off its surface by lift_m: G of its true place, which
// a receiver a few offsets off a wall needs. 0 where it faces away as it is stored: so do receivers
// in its surface.
TERM REAL lifted_connection_geometry(KERNEL kernel, VEC3 axis, VEC3 vertex_normal, VEC3 w,
                                     REAL lift_m) {
  if (!(-dot(vertex_normal, w) > REAL(0))) return REAL(0);
  return connection_geometry(kernel, axis, vertex_normal, w - lift_m * vertex_normal);
}

// What the connection adds if nothing stands between: `bounded` is the geometry after its limit.
TERM REAL connection_lx(REAL weight, REAL flux_lm, REAL bounded) {
  const REAL per_pi = REAL(0.31830988618379067154);
  return weight * flux_lm * per_pi * bounded;
}
