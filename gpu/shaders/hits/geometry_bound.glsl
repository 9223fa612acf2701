// calc::GeometryBound::at_lifted(). After lamps and visibility; sets is_cut where the driver left a
// loop.

layout(std430, binding = 10) readonly buffer Field { double field[]; };

uniform uint luminaire_count, has_shadows;

// Illuminance if the luminaire sent its largest intensity here and nothing stood between.
double most_of(uint lamp, dvec3 position_m, dvec3 normal) {
  const uint at = LAMPS_AT + LAMP_SIZE * lamp;
  const dvec3 way_m = triple(at) - position_m;
  const double height_m = dot(normal, way_m);
  if (!(height_m > DBL(0.0))) return DBL(0.0);
  const double d2 = dot(way_m, way_m);
  return entry[at + 19u] * entry[at + 18u] * height_m / (d2 * sqrt(d2));
}

// position_m: lifted.
double bound_at(dvec3 position_m, dvec3 normal) {
  double most_lx = DBL(0.0);
  uint index = 0u;
  for (; index < luminaire_count; ++index) most_lx += most_of(index, position_m, normal);
  if (index < luminaire_count) is_cut = true;
  if (most_lx <= field[FIELD_NEEDED]) return field[FIELD_SMALLEST];
  const Point point = Point(position_m, normal, KERNEL_PLANAR, uvec2(0u));
  double direct_lx = DBL(0.0);
  index = 0u;
  for (; index < luminaire_count; ++index) {
    if (most_of(index, position_m, normal) < field[FIELD_LEAST]) continue;
    const Lamp lamp = lamp_of(index);
    const double lx = point_illuminance_lx(lamp, lamp.centre_m, point);
    if (lx < field[FIELD_LEAST]) continue;
    if (has_shadows != 0u) {
      bool is_left_early;
      const bool is_hidden = is_blocked_from_hit_to_source(
          vec3(position_m), vec3(lifted_source_m(lamp, lamp.centre_m, position_m)), is_left_early);
      if (is_left_early) is_cut = true;
      if (is_hidden) continue;
    }
    direct_lx += lx;
  }
  if (index < luminaire_count) is_cut = true;
  return max(field[FIELD_SMALLEST], field[FIELD_PER_LUMEN] * direct_lx + field[FIELD_AMBIENT]);
}
