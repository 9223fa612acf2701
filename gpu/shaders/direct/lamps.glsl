// Direct light of a luminaire at a point: calc::point_illuminance_lx() and
// calc::PhotometricWeb::intensity_cd() in double, calc::WebSketch in float, from the tables of
// lamp_tables.h.

layout(std430, binding = 5) readonly buffer Sketches { float sketch_cd[]; };

const double kPi = DBL(0.5) * kTwoPi;

struct Point {
  dvec3 position_m, axis;
  uint kernel;
  uvec2 key;  // low, high
};

// calc::Tracer::lift()
dvec3 lifted_point_m(Point point) {
  return point.kernel == KERNEL_PLANAR ? lifted_m_of(point.position_m, point.axis)
                                       : point.position_m;
}

struct Lamp {
  dvec3 centre_m, x, y, z, half_m;
  uint shape, channel, web, at;
  double flux_scale;
};

uint channel_of(uint lamp) { return uint(entry[LAMPS_AT + LAMP_SIZE * lamp + 16u]); }

Lamp lamp_of(uint lamp) {
  const uint at = LAMPS_AT + LAMP_SIZE * lamp;
  Lamp result;
  result.at = at;
  result.centre_m = triple(at);
  result.x = triple(at + 3u);
  result.y = triple(at + 6u);
  result.z = triple(at + 9u);
  result.half_m = triple(at + 12u);
  result.shape = uint(entry[at + 15u]);
  result.channel = uint(entry[at + 16u]);
  result.web = uint(entry[at + 17u]);
  result.flux_scale = entry[at + 18u];
  return result;
}

double most_cd_of(Lamp lamp) { return entry[lamp.at + 19u]; }
double sketch_error_of(Lamp lamp) { return entry[lamp.at + 20u]; }

// calc::LightReach::holds()
bool is_reached(Lamp lamp, dvec3 point_m) {
  if (entry[lamp.at + 21u] == DBL(0.0)) return true;
  const dvec2 along = dvec2(entry[lamp.at + 22u], entry[lamp.at + 23u]);
  const dvec2 way_m = point_m.xy - lamp.centre_m.xy;
  const double along_m = dot(way_m, along);
  const double across_m = along.x * way_m.y - along.y * way_m.x;
  return max(abs(along_m), abs(across_m)) <= entry[lamp.at + 24u] + DBL(1.0e-9);
}

// From the luminaire's axes to those of its table, calc::PhotometricWeb::to_table().
dvec3 in_table(Lamp lamp, dvec3 world) {
  const dvec3 own = dvec3(dot(lamp.x, world), dot(lamp.y, world), dot(lamp.z, world));
  return entry[lamp.web + 2u] != DBL(0.0) ? dvec3(-own.z, own.x, -own.y) : own;
}

// atan2 in double: the float one, put right by the sine of what it is off by, 1e-7.
double angle_of(double y, double x) {
  const double radius = sqrt(x * x + y * y);
  if (!(radius > DBL(0.0))) return DBL(0.0);
  const double guess = double(turn_of(float(y / radius), float(x / radius)));
  double turns = guess / kTwoPi;
  if (turns < DBL(0.0)) turns += DBL(1.0);
  const SineCosine at = sine_cosine_of_turns(turns);
  const double rest = (y * at.cosine - x * at.sine) / radius;
  return guess + rest * (DBL(1.0) + rest * rest / DBL(6.0));
}

// calc::interval_of(): of `count` ascending nodes, at least 2.
uint interval_of(uint nodes, uint count, double x) {
  uint low = 0u, high = count - 1u;
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (entry[nodes + middle] <= x) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

double share_of_interval(uint nodes, uint i, double x) {
  const double begin = entry[nodes + i];
  return clamp((x - begin) / (entry[nodes + i + 1u] - begin), DBL(0.0), DBL(1.0));
}

// direction: unit, in the table's frame.
double intensity_cd(Lamp lamp, dvec3 direction) {
  const uint planes = uint(entry[lamp.web]), gammas = uint(entry[lamp.web + 1u]);
  const uint c_rad = lamp.web + 5u, gamma_rad = c_rad + planes, cd = gamma_rad + gammas;
  const double across = sqrt(direction.x * direction.x + direction.y * direction.y);
  if (across == DBL(0.0)) return entry[lamp.web + (direction.z > DBL(0.0) ? 4u : 3u)];
  const double gamma = angle_of(across, -direction.z);
  const double rounding_rad = DBL(1.0e-14);
  if (gamma < entry[gamma_rad] - rounding_rad) return DBL(0.0);
  if (gamma > entry[gamma_rad + gammas - 1u] + rounding_rad) return DBL(0.0);
  const uint g = interval_of(gamma_rad, gammas, gamma);
  const double down = share_of_interval(gamma_rad, g, gamma);
  if (planes == 1u) return mixed(entry[cd + g], entry[cd + g + 1u], down);
  double c = angle_of(direction.y, direction.x);
  if (c < DBL(0.0)) c += kTwoPi;
  const uint k = interval_of(c_rad, planes, c);
  const uint here = cd + k * gammas + g, next = here + gammas;
  return mixed(mixed(entry[here], entry[here + 1u], down),
               mixed(entry[next], entry[next + 1u], down), share_of_interval(c_rad, k, c));
}

// All of the luminaire's light put into one point.
double point_illuminance_lx(Lamp lamp, dvec3 source_m, Point point) {
  const dvec3 to_source_m = source_m - point.position_m;
  const double response_times_m = response_times_distance(point.kernel, point.axis, to_source_m);
  if (!(response_times_m > DBL(0.0))) return DBL(0.0);
  const double distance2 = dot(to_source_m, to_source_m);
  const double distance = sqrt(distance2);
  return intensity_cd(lamp, in_table(lamp, to_source_m / -distance)) * lamp.flux_scale *
         response_times_m / (distance2 * distance);
}

// calc::WebSketch::light_of() of one direction, in the table's frame. Where a sketch begins, its
// steps, and between which of them there is light: in the luminaire's row.
float sketched_lx(Lamp lamp, dvec3 way_m, double factor) {
  const uint cd = uint(entry[lamp.at + 25u]);
  const int planes = int(entry[lamp.at + 26u]), gammas = int(entry[lamp.at + 27u]);
  const float pi = 3.14159265;
  const float x = float(way_m.x), y = float(way_m.y), z = float(way_m.z);
  const float across2 = x * x + y * y;
  const float d2 = across2 + z * z;
  const float d3 = d2 * sqrt(d2);
  const float gamma = turn_of(sqrt(across2), -z) * (float(gammas) / pi);
  float c = turn_of(y, x);
  c = (c < 0.0 ? c + 2.0 * pi : c) * (float(planes) / (2.0 * pi));
  const int row = clamp(int(gamma), 0, gammas - 1), plane = clamp(int(c), 0, planes - 1);
  const float s = gamma - float(row), t = c - float(plane);
  const uint at = cd + uint(plane * (gammas + 1) + row);
  const uint above = at + uint(gammas + 1);
  const float here = sketch_cd[at] + s * (sketch_cd[at + 1u] - sketch_cd[at]);
  const float next = sketch_cd[above] + s * (sketch_cd[above + 1u] - sketch_cd[above]);
  const bool is_dark = gamma < float(entry[lamp.at + 28u]) || gamma > float(entry[lamp.at + 29u]);
  const float inside = is_dark ? 0.0 : float(factor);
  return inside * (here + t * (next - here)) / max(d3, 1.0e-30);
}

// calc::lifted_source_m()
dvec3 lifted_source_m(Lamp lamp, dvec3 source_m, dvec3 point_m) {
  const double side = dot(lamp.z, point_m - source_m) <= DBL(0.0) ? DBL(1.0) : DBL(-1.0);
  return source_m - side * offset_of_rays_m() * lamp.z;
}
