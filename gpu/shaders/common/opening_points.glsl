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

// A vector with what is along `axis` first and the two axes after it behind, and back. Vectors of
// doubles are not indexed by variables: NVIDIA's compiler (580) links no program that assigns so.
dvec3 axis_first(dvec3 v, int axis) { return axis == 0 ? v : (axis == 1 ? v.yzx : v.zxy); }
dvec3 axis_back(dvec3 v, int axis) { return axis == 0 ? v : (axis == 1 ? v.zxy : v.yzx); }

// As glm has it; what drivers call normalize() may know single precision alone.
dvec3 unit_of(dvec3 v) { return v * (DBL(1.0) / sqrt(dot(v, v))); }

int cylinder_axis(uint shape) {
  return shape == SHAPE_CYLINDER_C0 ? 0 : (shape == SHAPE_CYLINDER_C90 ? 1 : 2);
}

// Areas that each face of a body shows along a direction: across x, y, z, and its side.
double[4] shown_m2(uint shape, dvec3 half_m, dvec3 direction) {
  const dvec3 d = abs(direction);
  const dvec3 across_m2 = dvec3(half_m.y * half_m.z, half_m.z * half_m.x, half_m.x * half_m.y);
  const double pi = DBL(0.5) * kTwoPi, none = DBL(0.0);
  if (shape == SHAPE_BOX) {
    const dvec3 ends_m2 = DBL(4.0) * across_m2 * d;
    return double[4](ends_m2.x, ends_m2.y, ends_m2.z, none);
  }
  const dvec3 aside = across_m2 * direction;
  if (shape == SHAPE_ELLIPSOID) return double[4](none, none, none, pi * length(aside));
  const int axis = cylinder_axis(shape);
  const double end_m2 = pi * axis_first(across_m2, axis).x * axis_first(d, axis).x;
  const double side_m2 = DBL(4.0) * length(dvec3(none, axis_first(aside, axis).yz));
  return double[4](axis == 0 ? end_m2 : none, axis == 1 ? end_m2 : none,
                   axis == 2 ? end_m2 : none, side_m2);
}

double total_of(double shown_m2[4]) {
  return shown_m2[0] + shown_m2[1] + shown_m2[2] + shown_m2[3];
}

OpeningPoint face_point(int axis, bool is_disk, dvec3 half_m, dvec3 direction, double s, double t) {
  const double out_or_in = axis_first(direction, axis).x >= DBL(0.0) ? DBL(1.0) : DBL(-1.0);
  const dvec2 across =
      is_disk ? unit_disk(s, t) : dvec2(DBL(2.0) * s - DBL(1.0), DBL(2.0) * t - DBL(1.0));
  OpeningPoint point;
  point.normal = axis_back(dvec3(out_or_in, DBL(0.0), DBL(0.0)), axis);
  point.position_m = half_m * axis_back(dvec3(out_or_in, across), axis);
  return point;
}

// Evenly across the direction's outline: the angle from the middle of the side has the sine 2s - 1.
OpeningPoint cylinder_side(int axis, dvec3 half_m, dvec3 direction, double s, double t) {
  const dvec3 d = axis_first(direction, axis), half_first_m = axis_first(half_m, axis);
  dvec2 middle = d.yz * half_first_m.zy;
  const double size = length(middle);
  middle = size > DBL(0.0) ? middle / size : dvec2(DBL(1.0), DBL(0.0));
  const double sine = clamp(DBL(2.0) * s - DBL(1.0), DBL(-1.0), DBL(1.0));
  const double cosine = sqrt(DBL(1.0) - sine * sine);
  const dvec3 unit = dvec3(DBL(2.0) * t - DBL(1.0), middle.x * cosine - middle.y * sine,
                           middle.y * cosine + middle.x * sine);
  OpeningPoint point;
  point.position_m = half_m * axis_back(unit, axis);
  point.normal = unit_of(axis_back(dvec3(DBL(0.0), unit.yz * half_first_m.zy), axis));
  return point;
}

// Parallel projections keep even densities: on the unit sphere that the ellipsoid is an image of.
OpeningPoint ellipsoid_point(dvec3 half_m, dvec3 direction, double s, double t) {
  const dvec3 across_m2 = dvec3(half_m.y * half_m.z, half_m.z * half_m.x, half_m.x * half_m.y);
  const dvec3 m = unit_of(direction * across_m2);
  const dvec3 aside = abs(m.x) < DBL(0.9) ? dvec3(DBL(1.0), DBL(0.0), DBL(0.0))
                                          : dvec3(DBL(0.0), DBL(1.0), DBL(0.0));
  const dvec3 x = unit_of(cross(m, aside));
  const dvec2 disk = unit_disk(s, t);
  const dvec3 unit = disk.x * x + disk.y * cross(m, x) +
                     sqrt(max(DBL(0.0), DBL(1.0) - dot(disk, disk))) * m;
  OpeningPoint point;
  point.position_m = half_m * unit;
  point.normal = unit_of(unit * across_m2);
  return point;
}

// Of a body, seen along a direction in its own axes.
OpeningPoint body_point(uint shape, dvec3 half_m, dvec3 direction, double s, double t) {
  const double shown[4] = shown_m2(shape, half_m, direction);
  const double outline_m2 = total_of(shown);
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
