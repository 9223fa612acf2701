// Numbers of luminaires, as path_tables.h or lamp_tables.h says; the first of both is the offset of
// rays.

layout(std430, binding = 3) readonly buffer Tables { double entry[]; };

double offset_of_rays_m() { return entry[0]; }

// calc::Tracer::lift()
dvec3 lifted_m_of(dvec3 position_m, dvec3 normal) {
  return position_m + lift_at(position_m, offset_of_rays_m()) * normal;
}

dvec3 triple(uint at) { return dvec3(entry[at], entry[at + 1u], entry[at + 2u]); }

// std::lerp() of values >= 0.
double mixed(double a, double b, double share) {
  if (a <= DBL(0.0) || b <= DBL(0.0)) return share * b + (DBL(1.0) - share) * a;
  return share == DBL(1.0) ? b : a + share * (b - a);
}
