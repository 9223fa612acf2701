// Points of luminous openings: calc::OpeningView again.

const double kTwoPi = DBL(6.283185307179586476925286766559);

// In the luminaire's axes, from its centre.
struct OpeningPoint {
  dvec3 position_m, normal;
};

dvec2 unit_disk(double s, double t) {
  const SineCosine angle = sine_cosine_of_turns(t);
  return sqrt(s) * dvec2(angle.cosine, angle.sine);
}

int cylinder_axis(uint shape) {
  return shape == SHAPE_CYLINDER_C0 ? 0 : (shape == SHAPE_CYLINDER_C90 ? 1 : 2);
}

// Areas that each face of a body shows along a direction: across x, y, z, and its side.
dvec4 shown_m2(uint shape, dvec3 half_m, dvec3 direction) {
  const dvec3 d = abs(direction);
  const dvec3 across_m2 = dvec3(half_m.y * half_m.z, half_m.z * half_m.x, half_m.x * half_m.y);
  const double pi = DBL(0.5) * kTwoPi;
  if (shape == SHAPE_BOX) return dvec4(DBL(4.0) * across_m2 * d, DBL(0.0));
  dvec3 aside = across_m2 * direction;
  if (shape == SHAPE_ELLIPSOID) return dvec4(DBL(0.0), DBL(0.0), DBL(0.0), pi * length(aside));
  const int axis = cylinder_axis(shape);
  dvec4 shown = dvec4(DBL(0.0));
  shown[axis] = pi * across_m2[axis] * d[axis];
  aside[axis] = DBL(0.0);
  shown.w = DBL(4.0) * length(aside);
  return shown;
}

OpeningPoint face_point(int axis, bool is_disk, dvec3 half_m, dvec3 direction, double s, double t) {
  OpeningPoint point;
  dvec3 unit = dvec3(DBL(0.0));
  point.normal = dvec3(DBL(0.0));
  point.normal[axis] = direction[axis] >= DBL(0.0) ? DBL(1.0) : DBL(-1.0);
  unit[axis] = point.normal[axis];
  const dvec2 across =
      is_disk ? unit_disk(s, t) : dvec2(DBL(2.0) * s - DBL(1.0), DBL(2.0) * t - DBL(1.0));
  unit[(axis + 1) % 3] = across.x;
  unit[(axis + 2) % 3] = across.y;
  point.position_m = half_m * unit;
  return point;
}

// Evenly across the direction's outline: the angle from the middle of the side has the sine 2s - 1.
OpeningPoint cylinder_side(int axis, dvec3 half_m, dvec3 direction, double s, double t) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  dvec2 middle = dvec2(direction[a] * half_m[b], direction[b] * half_m[a]);
  const double size = length(middle);
  middle = size > DBL(0.0) ? middle / size : dvec2(DBL(1.0), DBL(0.0));
  const double sine = clamp(DBL(2.0) * s - DBL(1.0), DBL(-1.0), DBL(1.0));
  const double cosine = sqrt(DBL(1.0) - sine * sine);
  dvec3 unit = dvec3(DBL(0.0)), normal = dvec3(DBL(0.0));
  unit[axis] = DBL(2.0) * t - DBL(1.0);
  unit[a] = middle.x * cosine - middle.y * sine;
  unit[b] = middle.y * cosine + middle.x * sine;
  normal[a] = unit[a] * half_m[b];
  normal[b] = unit[b] * half_m[a];
  OpeningPoint point;
  point.position_m = half_m * unit;
  point.normal = normalize(normal);
  return point;
}

// Parallel projections keep even densities: on the unit sphere that the ellipsoid is an image of.
OpeningPoint ellipsoid_point(dvec3 half_m, dvec3 direction, double s, double t) {
  const dvec3 across_m2 = dvec3(half_m.y * half_m.z, half_m.z * half_m.x, half_m.x * half_m.y);
  const dvec3 m = normalize(direction * across_m2);
  const dvec3 aside = abs(m.x) < DBL(0.9) ? dvec3(DBL(1.0), DBL(0.0), DBL(0.0))
                                          : dvec3(DBL(0.0), DBL(1.0), DBL(0.0));
  const dvec3 x = normalize(cross(m, aside));
  const dvec2 disk = unit_disk(s, t);
  const dvec3 unit = disk.x * x + disk.y * cross(m, x) +
                     sqrt(max(DBL(0.0), DBL(1.0) - dot(disk, disk))) * m;
  OpeningPoint point;
  point.position_m = half_m * unit;
  point.normal = normalize(unit * across_m2);
  return point;
}

// Of a body, seen along a direction in its own axes.
OpeningPoint body_point(uint shape, dvec3 half_m, dvec3 direction, double s, double t) {
  const dvec4 shown = shown_m2(shape, half_m, direction);
  const double outline_m2 = shown.x + shown.y + shown.z + shown.w;
  if (!(outline_m2 > DBL(0.0))) {  // seen edge-on without thickness: a point
    OpeningPoint point;
    point.position_m = dvec3(DBL(0.0));
    point.normal = direction;
    return point;
  }
  int last_face = 3;
  while (!(shown[last_face] > DBL(0.0))) --last_face;
  double begin = DBL(0.0), end = DBL(1.0), sum_m2 = DBL(0.0);
  int face = 0;
  for (; face <= last_face; ++face) {
    if (!(shown[face] > DBL(0.0))) continue;
    sum_m2 += shown[face];
    end = face == last_face ? DBL(1.0) : min(DBL(1.0), sum_m2 / outline_m2);
    if (s < end || face == last_face) break;
    begin = end;
  }
  const double within = (s - begin) / (end - begin);
  if (shape == SHAPE_ELLIPSOID) return ellipsoid_point(half_m, direction, within, t);
  if (face < 3) return face_point(face, shape != SHAPE_BOX, half_m, direction, within, t);
  return cylinder_side(cylinder_axis(shape), half_m, direction, within, t);
}
