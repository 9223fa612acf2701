// Parts of luminous openings: calc::opening_cells(), and the patches of opening_light.cpp. Parts are
// leaves of a binary tree of halves, visited in depth-first order; a place in it is the path from
// the root, one bit for each step.

uniform float error_factor;  // calc::OpeningRounds::error_factor
uniform uint cell_places;    // 9

struct Cell {
  double s, t, size_s, size_t;
};

struct Place {
  uint path, depth;
};

const Cell kWholeOpening = Cell(DBL(0.0), DBL(0.0), DBL(1.0), DBL(1.0));

Cell half_of(Cell cell, bool is_along_s, bool is_second) {
  if (is_along_s) {
    cell.size_s *= DBL(0.5);
    if (is_second) cell.s += cell.size_s;
  } else {
    cell.size_t *= DBL(0.5);
    if (is_second) cell.t += cell.size_t;
  }
  return cell;
}

bool is_second_half(Place place, uint step) {
  return ((place.path >> (place.depth - 1u - step)) & 1u) != 0u;
}

Place first_half(Place place) { return Place(place.path << 1u, place.depth + 1u); }

// False: it was the last. Once a part that is not halved further is done with.
bool go_on(inout Place place) {
  while (place.depth > 0u && (place.path & 1u) != 0u) {
    place.path >>= 1u;
    --place.depth;
  }
  if (place.depth == 0u) return false;
  place.path |= 1u;
  return true;
}

// --- openings that are seen in full: patches ----------------------------------------------------

struct Patch {
  dvec3 centre_m, u_m, v_m;
  double share, ratio;  // of the opening; of its size to its distance
  bool is_disk, is_small;
  dvec3 c0, c1, c2;  // [power of x][power of y] of the polynomial
  double rest_lx;
};

Cell patch_cell(Lamp lamp, Place place) {
  Cell cell = kWholeOpening;
  for (uint step = 0u; step < place.depth; ++step) {
    const bool is_along_s = cell.size_s * lamp.half_m.x >= cell.size_t * lamp.half_m.y;
    cell = half_of(cell, is_along_s, is_second_half(place, step));
  }
  return cell;
}

Patch patch_of(Lamp lamp, Point point, Place place) {
  const Cell cell = patch_cell(lamp, place);
  Patch part;
  part.is_disk = lamp.shape == SHAPE_DISK;
  part.share = cell.size_s * cell.size_t;
  part.is_small = !(part.share > DBL(9.094947017729282e-13));  // 2^-40: it touches the point
  part.u_m = cell.size_s * lamp.half_m.x * lamp.x;
  part.v_m = cell.size_t * lamp.half_m.y * lamp.y;
  part.centre_m = lamp.centre_m +
                   (DBL(2.0) * cell.s + cell.size_s - DBL(1.0)) * lamp.half_m.x * lamp.x +
                   (DBL(2.0) * cell.t + cell.size_t - DBL(1.0)) * lamp.half_m.y * lamp.y;
  const double size_m =
      DBL(2.0) * sqrt(dot(part.u_m, part.u_m) + dot(part.v_m, part.v_m));
  part.ratio = size_m / length(part.centre_m - point.position_m);
  part.c0 = part.c1 = part.c2 = dvec3(DBL(0.0));
  part.rest_lx = DBL(0.0);
  return part;
}

// Larger parts are halved: the rest falls with the third power.
bool is_halved(Patch part) {
  return part.ratio > LARGEST_PATCH && !part.is_disk && !part.is_small;
}

// The first patch at a place of the tree or below it. False: it lies deeper than places go.
bool find_patch(Lamp lamp, Point point, inout Place place, out Patch part) {
  for (;;) {
    part = patch_of(lamp, point, place);
    if (!is_halved(part)) return true;
    if (place.depth == DEEPEST_PLACE) return false;
    place = first_half(place);
  }
  is_cut = true;  // the driver left the loop
  return false;
}

// Light of centre + x u + y v, by the sketch.
double place_lx(Lamp lamp, Point point, Patch part, double x, double y) {
  const dvec3 to_source_m =
      part.centre_m - point.position_m + x * part.u_m + y * part.v_m;
  const double response_times_m = response_times_distance(point.kernel, point.axis, to_source_m);
  return double(sketched_lx(lamp, in_table(lamp, -to_source_m),
                            lamp.flux_scale * max(DBL(0.0), response_times_m)));
}

const double kGauss = DBL(0.7745966692414834);  // sqrt(3/5)

// p(-h), p(0), p(h) -> coefficients of x and x^2.
dvec2 curve(double before, double middle, double after) {
  return dvec2((after - before) / (DBL(2.0) * kGauss),
               (after - DBL(2.0) * middle + before) / (DBL(2.0) * kGauss * kGauss));
}

// What places may have missed.
double unseen_lx(Lamp lamp, Point point, Patch part) {
  const dvec3 away_m = part.centre_m - point.position_m;
  const double reach_m2 = dot(part.u_m, part.u_m) + dot(part.v_m, part.v_m);
  return (UNSEEN_FLOOR + sketch_error_of(lamp)) * most_cd_of(lamp) * lamp.flux_scale /
         max(dot(away_m, away_m), reach_m2);
}

// Places at which light is read: the middle, then west, east, south, north of it, then the corners;
// nine of Gauss's rule, the first five, or the first. Where all of them are dark, once more: four of
// Gauss's rule and the true corners, for light may still begin at a corner or be a narrow beam
// between.
dvec2 place_of(uint k, bool is_dark) {
  if (k == 0u) return dvec2(DBL(0.0));
  const double sign = (k & 1u) != 0u ? DBL(-1.0) : DBL(1.0);
  if (k < 3u) return dvec2(sign * kGauss, DBL(0.0));
  if (k < 5u) return dvec2(DBL(0.0), sign * kGauss);
  const double reach = is_dark ? DBL(1.0) : kGauss;
  return reach * dvec2(k < 7u ? DBL(-1.0) : DBL(1.0), sign);
}

void fit(Lamp lamp, Point point, inout Patch part) {
  const uint places = part.ratio < ONE_PLACE ? 1u : (part.ratio < FIVE_PLACES ? 5u : 9u);
  double lx[9] = double[9](DBL(0.0), DBL(0.0), DBL(0.0), DBL(0.0), DBL(0.0), DBL(0.0), DBL(0.0),
                           DBL(0.0), DBL(0.0));
  bool is_dark = false;
  double lowest_lx, highest_lx;
  // Twice at most; one loop, so that compilers write the photometry down once.
  for (uint count = places;; count = 9u) {
    lowest_lx = DBL(1.0e300);
    highest_lx = DBL(0.0);
    for (uint k = 0u; k < count; ++k) {
      const dvec2 at = place_of(k, is_dark);
      lx[k] = is_dark && k == 0u ? DBL(0.0) : place_lx(lamp, point, part, at.x, at.y);
      if (is_dark && k > 4u) continue;
      lowest_lx = min(lowest_lx, lx[k]);
      highest_lx = max(highest_lx, lx[k]);
    }
    if (is_dark || highest_lx > DBL(0.0)) break;
    is_dark = true;
  }
  part.c0.x = lx[0];
  if (places == 1u && !is_dark) {
    part.rest_lx = part.ratio * lx[0] + unseen_lx(lamp, point, part);
    return;
  }
  if (places == 9u && !is_dark) {
    // [x place]: coefficients of 1, y, y^2.
    const dvec3 west = dvec3(lx[1], curve(lx[5], lx[1], lx[6]));
    const dvec3 middle = dvec3(lx[0], curve(lx[3], lx[0], lx[4]));
    const dvec3 east = dvec3(lx[2], curve(lx[7], lx[2], lx[8]));
    part.c0 = middle;
    const dvec2 x0 = curve(west.x, middle.x, east.x), x1 = curve(west.y, middle.y, east.y),
                x2 = curve(west.z, middle.z, east.z);
    part.c1 = dvec3(x0.x, x1.x, x2.x);
    part.c2 = dvec3(x0.y, x1.y, x2.y);
  } else {
    const dvec2 x = curve(lx[1], lx[0], lx[2]), y = curve(lx[3], lx[0], lx[4]);
    part.c0.yz = y;
    part.c1.x = x.x;
    part.c2.x = x.y;
  }
  part.rest_lx = part.ratio * part.ratio * (highest_lx - lowest_lx) + PATCH_FLOOR * highest_lx +
                 unseen_lx(lamp, point, part);
  if (!is_dark) return;
  const double corner_lx = max(max(lx[5], lx[6]), max(lx[7], lx[8]));
  part.rest_lx += (part.ratio * part.ratio + PATCH_FLOOR) * corner_lx;
}

// Mean of the polynomial over the patch, times its share of the opening.
double known_lx(Patch part) {
  const double xx = part.is_disk ? DBL(0.25) : DBL(1.0) / DBL(3.0);
  const double xxyy = part.is_disk ? DBL(1.0) / DBL(24.0) : DBL(1.0) / DBL(9.0);
  return part.share *
         (part.c0.x + xx * (part.c2.x + part.c0.z) + xxyy * part.c2.z);
}

double power_series(dvec3 c, double y) { return c.x + y * (c.y + y * c.z); }

// The rest at a place of [0, 1)^2.
double rest_at_lx(Lamp lamp, Point point, Patch part, double s, double t) {
  const dvec2 at = part.is_disk ? unit_disk(s, t)
                                 : dvec2(DBL(2.0) * s - DBL(1.0), DBL(2.0) * t - DBL(1.0));
  const double polynomial =
      power_series(part.c0, at.y) +
      at.x * (power_series(part.c1, at.y) + at.x * power_series(part.c2, at.y));
  const double lx = point_illuminance_lx(
      lamp, part.centre_m + at.x * part.u_m + at.y * part.v_m, point);
  return part.share * (lx - polynomial);
}

// --- openings that are sampled: cells -----------------------------------------------------------

// The opening from the point, calc::OpeningView.
struct View {
  dvec3 towards, local_towards;
  double outline_m2;  // of a body; 0: it shows nothing, and counts as a point
  double size_m, distance_m;  // of the whole opening
  // Where the first coordinate passes from one face of a body to the next: the ends of its pieces.
  double piece_end[4];
  int pieces;
};

dvec3 in_lamp(Lamp lamp, dvec3 world) {
  return dvec3(dot(lamp.x, world), dot(lamp.y, world), dot(lamp.z, world));
}

double outline_of(Lamp lamp, dvec3 local_direction) {
  return total_of(shown_m2(lamp.shape, lamp.half_m, local_direction));
}

View view_from(Lamp lamp, dvec3 point_m) {
  const dvec3 way_m = point_m - lamp.centre_m;
  const double distance_m = length(way_m);
  View view;
  view.towards = distance_m > DBL(0.0) ? way_m / distance_m : -lamp.z;
  view.local_towards = in_lamp(lamp, view.towards);
  view.size_m = DBL(2.0) * length(lamp.half_m);
  view.distance_m = distance_m;
  view.outline_m2 = DBL(0.0);
  view.piece_end = double[4](DBL(1.0), DBL(1.0), DBL(1.0), DBL(1.0));
  view.pieces = 1;
  if (lamp.shape < SHAPE_BOX) return view;
  view.outline_m2 = outline_of(lamp, view.local_towards);
  if (!(view.outline_m2 > DBL(0.0))) return view;
  const double shown[4] = shown_m2(lamp.shape, lamp.half_m, view.local_towards);
  double sum_m2 = DBL(0.0);
  view.pieces = 0;
  for (int face = 0; face < 4; ++face) {
    if (!(shown[face] > DBL(0.0))) continue;
    sum_m2 += shown[face];
    view.piece_end[view.pieces++] = min(DBL(1.0), sum_m2 / view.outline_m2);
  }
  view.piece_end[view.pieces - 1] = DBL(1.0);
  return view;
}

Cell piece_of(View view, int piece) {
  const double begin = piece > 0 ? view.piece_end[piece - 1] : DBL(0.0);
  return Cell(begin, DBL(0.0), view.piece_end[piece] - begin, DBL(1.0));
}

// In the world.
OpeningPoint opening_point(Lamp lamp, View view, double s, double t) {
  OpeningPoint point;
  if (lamp.shape >= SHAPE_BOX) {
    point = body_point(lamp.shape, lamp.half_m, view.local_towards, s, t);
    point.position_m = lamp.centre_m + lamp.x * point.position_m.x +
                       lamp.y * point.position_m.y + lamp.z * point.position_m.z;
    point.normal =
        lamp.x * point.normal.x + lamp.y * point.normal.y + lamp.z * point.normal.z;
    return point;
  }
  const dvec2 unit = lamp.shape == SHAPE_DISK
                         ? unit_disk(s, t)
                         : dvec2(DBL(2.0) * s - DBL(1.0), DBL(2.0) * t - DBL(1.0));
  point.position_m =
      lamp.centre_m + unit.x * lamp.half_m.x * lamp.x + unit.y * lamp.half_m.y * lamp.y;
  point.normal = view.local_towards.z > DBL(0.0) ? lamp.z : -lamp.z;
  return point;
}

// What light of a body's point towards the unit direction counts for.
double view_weight(Lamp lamp, View view, OpeningPoint at, dvec3 direction) {
  if (!(view.outline_m2 > DBL(0.0))) return DBL(1.0);
  const double leaving = dot(at.normal, direction), facing = dot(at.normal, view.towards);
  if (!(leaving > DBL(0.0)) || !(facing > DBL(0.0))) return DBL(0.0);
  return view.outline_m2 / outline_of(lamp, in_lamp(lamp, direction)) * leaving / facing;
}

// Light of one of its points with all of the luminaire's light in it, and where shadow rays to it
// end: add_opening_point() of direct.cpp.
double opening_lx(Lamp lamp, View view, Point point, double s, double t, out vec3 to_m) {
  const OpeningPoint source = opening_point(lamp, view, s, t);
  double lx = point_illuminance_lx(lamp, source.position_m, point);
  if (lamp.shape < SHAPE_BOX) {
    to_m = vec3(lifted_source_m(lamp, source.position_m, point.position_m));
  } else {
    lx *= view_weight(lamp, view, source, unit_of(point.position_m - source.position_m));
    to_m = vec3(source.position_m + offset_of_rays_m() * source.normal);
  }
  return lx;
}

struct CellExtent {
  dvec3 centre_m;
  double diameter_m, length_s_m, length_t_m;
};

CellExtent cell_extent(Lamp lamp, View view, Cell cell) {
  const double inside = DBL(1.0e-9);  // where two faces meet
  dvec3 at[9];
  // As many as there are, told so that compilers do not write the loop out.
  for (uint k = 0u; k < cell_places; ++k) {
    const double s = k < 3u ? inside : (k < 6u ? DBL(0.5) : DBL(1.0) - inside);
    const uint column = k % 3u;
    const double t = column == 0u ? inside : (column == 1u ? DBL(0.5) : DBL(1.0) - inside);
    at[k] = opening_point(lamp, view, cell.s + s * cell.size_s, cell.t + t * cell.size_t)
                .position_m;
  }
  CellExtent extent;
  extent.centre_m = at[4];
  extent.diameter_m = extent.length_s_m = extent.length_t_m = DBL(0.0);
  for (int i = 0; i < 9; ++i) {
    extent.diameter_m = max(extent.diameter_m, DBL(2.0) * length(at[i] - extent.centre_m));
  }
  for (int i = 0; i < 3; ++i) {
    extent.length_s_m =
        max(extent.length_s_m, length(at[3 + i] - at[i]) + length(at[6 + i] - at[3 + i]));
    extent.length_t_m = max(extent.length_t_m, length(at[3 * i + 1] - at[3 * i]) +
                                                   length(at[3 * i + 2] - at[3 * i + 1]));
  }
  return extent;
}

// Where a walk through all cells is: in which piece, and where in its tree of halves.
struct Walk {
  int piece;
  Place place;
};

const Walk kBegin = Walk(0, Place(0u, 0u));

// False: it was the last.
bool go_on(View view, inout Walk walk) {
  if (go_on(walk.place)) return true;
  if (view.size_m <= view.distance_m) return false;  // one cell
  ++walk.piece;
  return walk.piece < view.pieces;
}

// A leaf, or what is to be halved.
struct CellAt {
  Cell cell;
  bool is_leaf;
  dvec3 centre_m;
  double diameter_m, distance_m;
};

CellAt cell_at(Lamp lamp, View view, dvec3 point_m, Walk walk) {
  CellAt result;
  if (view.size_m <= view.distance_m) {
    result.cell = kWholeOpening;
    result.centre_m = lamp.centre_m;
    result.diameter_m = view.size_m;
    result.distance_m = view.distance_m;
    result.is_leaf = true;
    return result;
  }
  result.cell = piece_of(view, walk.piece);
  CellExtent extent;
  for (uint step = 0u;; ++step) {
    extent = cell_extent(lamp, view, result.cell);
    if (step == walk.place.depth) break;
    result.cell = half_of(result.cell, extent.length_s_m >= ALIKE_SIDES * extent.length_t_m,
                          is_second_half(walk.place, step));
  }
  result.centre_m = extent.centre_m;
  result.diameter_m = extent.diameter_m;
  result.distance_m = length(extent.centre_m - point_m);
  result.is_leaf = result.diameter_m <= result.distance_m;
  return result;
}

// The first cell at a walk's place or below it, as find_patch().
bool find_cell(Lamp lamp, View view, dvec3 point_m, inout Walk walk, out CellAt at) {
  for (;;) {
    at = cell_at(lamp, view, point_m, walk);
    if (at.is_leaf) return true;
    if (walk.place.depth == DEEPEST_PLACE) return false;
    walk.place = first_half(walk.place);
  }
  is_cut = true;  // the driver left the loop
  return false;
}

// calc::cell_samples()
uint cell_samples(CellAt at) {
  const double wanted = CELL_ERROR * min(DBL(1.0), at.diameter_m / at.distance_m) /
                        (CELL_WANTED_ERROR * double(error_factor));
  double n = DBL(1.0);
  for (int k = 0; k < 31 && n * n * n < wanted * wanted; ++k) n *= DBL(2.0);
  return uint(n);
}
