// Light paths leaving luminaires: calc::Emitter and calc::WebSampler again, from the tables of
// path_tables.h.

uniform uint luminaire_count;

// u in [0, 1)
uint choose_luminaire(double u) {
  const double wanted = u * entry[1u + luminaire_count];
  uint low = 1u, high = luminaire_count;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (wanted < entry[1u + middle]) {
      high = middle;
    } else {
      low = middle + 1u;
    }
  }
  return low - 1u;
}

uint luminaire_at(uint luminaire) {
  return 2u + luminaire_count + LUMINAIRE_SIZE * luminaire;
}

// --- directions ---------------------------------------------------------------------------------

// Where a web's arrays begin.
struct Web {
  uint planes, gammas;
  bool is_lateral;
  uint c_rad, c_prefix, gamma_rad, sine, cosine, cd, prefix;
};

Web web_at(uint at) {
  Web web;
  web.planes = uint(entry[at]);
  web.gammas = uint(entry[at + 1u]);
  web.is_lateral = entry[at + 2u] != DBL(0.0);
  web.c_rad = at + 3u;
  web.c_prefix = web.c_rad + web.planes;
  web.gamma_rad = web.c_prefix + max(web.planes, 2u);
  web.sine = web.gamma_rad + web.gammas;
  web.cosine = web.sine + web.gammas;
  web.cd = web.cosine + web.gammas;
  web.prefix = web.cd + web.planes * web.gammas;
  return web;
}

// A plane between table planes.
struct WebPlane {
  uint below, above;
  double fraction;
};

double on_plane(uint array, uint gammas, WebPlane plane, uint gamma) {
  return mixed(entry[array + plane.below * gammas + gamma],
               entry[array + plane.above * gammas + gamma], plane.fraction);
}

// interval_with_mass() of C++ for the sums of gamma on a plane.
uint gamma_interval(Web web, WebPlane plane, double target) {
  uint low = 0u, high = web.gammas - 1u;
  const double total = on_plane(web.prefix, web.gammas, plane, high);
  if (!(target < total)) {
    while (high > 1u && !(on_plane(web.prefix, web.gammas, plane, high - 1u) < total)) --high;
    return high - 1u;
  }
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (on_plane(web.prefix, web.gammas, plane, middle) <= target) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

// The same for the sums over C.
uint c_interval(Web web, double target) {
  uint low = 0u, high = web.planes - 1u;
  const double total = entry[web.c_prefix + high];
  if (!(target < total)) {
    while (high > 1u && !(entry[web.c_prefix + high - 1u] < total)) --high;
    return high - 1u;
  }
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (entry[web.c_prefix + middle] <= target) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

double plane_total(Web web, uint plane) {
  return entry[web.prefix + (plane + 1u) * web.gammas - 1u];
}

// Sine and cosine of gamma.
SineCosine sample_gamma(Web web, WebPlane plane, double u) {
  const double target = u * on_plane(web.prefix, web.gammas, plane, web.gammas - 1u);
  const uint i = gamma_interval(web, plane, target);
  const double width_rad = entry[web.gamma_rad + i + 1u] - entry[web.gamma_rad + i];
  SegmentShape segment;
  segment.start_cd = on_plane(web.cd, web.gammas, plane, i);
  segment.slope = (on_plane(web.cd, web.gammas, plane, i + 1u) - segment.start_cd) / width_rad;
  segment.sin_gamma = entry[web.sine + i];
  segment.cos_gamma = entry[web.cosine + i];
  const double x_rad = invert_segment(
      segment, width_rad, target - on_plane(web.prefix, web.gammas, plane, i));
  const SineCosine half_x = half_angle(x_rad);
  const double sin_x = DBL(2.0) * half_x.sine * half_x.cosine;
  const double cos_x = DBL(1.0) - DBL(2.0) * half_x.sine * half_x.sine;
  SineCosine gamma;
  gamma.sine = segment.sin_gamma * cos_x + segment.cos_gamma * sin_x;
  gamma.cosine = segment.cos_gamma * cos_x - segment.sin_gamma * sin_x;
  return gamma;
}

// Unit, in the luminaire's axes.
dvec3 sample_web(Web web, double u0, double u1) {
  WebPlane plane;
  plane.below = 0u;
  plane.above = 0u;
  plane.fraction = DBL(0.0);
  double c_turns = u0;
  if (web.planes > 1u) {
    const double target = u0 * entry[web.c_prefix + web.planes - 1u];
    const uint i = c_interval(web, target);
    const double below = entry[web.c_prefix + i];
    const double share = (target - below) / (entry[web.c_prefix + i + 1u] - below);
    const double begin = plane_total(web, i), end = plane_total(web, i + 1u);
    plane.below = i;
    plane.above = i + 1u;
    plane.fraction = share_of_linear_density(begin, end, clamp(share, DBL(0.0), DBL(1.0)));
    c_turns = mixed(entry[web.c_rad + i], entry[web.c_rad + i + 1u], plane.fraction) / kTwoPi;
    // On a dark plane next to a lit one the limit of gamma's distribution is that of the lit one.
    if (on_plane(web.prefix, web.gammas, plane, web.gammas - 1u) <= DBL(0.0)) {
      plane.fraction = begin > DBL(0.0) ? DBL(0.0) : DBL(1.0);
    }
  }
  const SineCosine gamma = sample_gamma(web, plane, u1);
  const SineCosine c = sine_cosine_of_turns(c_turns);
  const dvec3 direction = dvec3(gamma.sine * c.cosine, gamma.sine * c.sine, -gamma.cosine);
  // calc::TableAxis::lateral
  return web.is_lateral ? dvec3(direction.y, -direction.z, -direction.x) : direction;
}

struct EmittedRay {
  dvec3 origin_m, direction;  // lifted; unit
};

EmittedRay emit(uint luminaire, double direction_u0, double direction_u1, double opening_u0,
                double opening_u1) {
  const uint at = luminaire_at(luminaire);
  const dvec3 centre_m = triple(at);
  const dvec3 x = triple(at + 3u), y = triple(at + 6u), z = triple(at + 9u);
  const dvec3 half_m = triple(at + 12u);
  const uint shape = uint(entry[at + 15u]);
  const dvec3 local =
      sample_web(web_at(uint(entry[at + 18u])), direction_u0, direction_u1);
  EmittedRay ray;
  ray.direction = x * local.x + y * local.y + z * local.z;
  if (shape < SHAPE_BOX) {
    dvec2 unit = dvec2(DBL(0.0));  // in [-1, 1]^2
    if (shape == SHAPE_RECTANGLE) unit = DBL(2.0) * dvec2(opening_u0, opening_u1) - DBL(1.0);
    if (shape == SHAPE_DISK) unit = unit_disk(opening_u0, opening_u1);
    const double side = dot(z, ray.direction) <= DBL(0.0) ? DBL(1.0) : DBL(-1.0);
    ray.origin_m = centre_m + unit.x * half_m.x * x + unit.y * half_m.y * y -
                   side * offset_of_rays_m() * z;
    return ray;
  }
  const dvec3 towards =
      dvec3(dot(x, ray.direction), dot(y, ray.direction), dot(z, ray.direction));
  const OpeningPoint point = body_point(shape, half_m, towards, opening_u0, opening_u1);
  const dvec3 lifted_m = point.position_m + offset_of_rays_m() * point.normal;
  ray.origin_m = centre_m + x * lifted_m.x + y * lifted_m.y + z * lifted_m.z;
  return ray;
}
