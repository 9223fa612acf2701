// Stage 1: one pair. What is proved of the opening, or whether a point opening is seen.

layout(local_size_x = GROUP_SIZE) in;

uniform uint first_pair, last_pair;

uint sampled_cells(Lamp lamp, Point point) {
  const View view = view_from(lamp, point.position_m);
  Walk walk = kBegin;
  uint samples = 0u;
  for (uint cells = 0u; cells < MOST_PARTS; ++cells) {
    CellAt at;
    if (!find_cell(lamp, view, point.position_m, walk, at)) return PAIR_LEFT;
    samples += cell_samples(at);
    if (!go_on(view, walk)) return PAIR_SAMPLED + PAIR_STEP * samples;
  }
  return PAIR_LEFT;
}

// As many patches as a later stage can visit.
uint seen_patches(Lamp lamp, Point point) {
  Place place = Place(0u, 0u);
  for (uint patches = 0u; patches < MOST_PARTS; ++patches) {
    Patch part;
    if (!find_patch(lamp, point, place, part)) return PAIR_LEFT;
    if (!go_on(place)) return PAIR_SEEN;
  }
  return PAIR_LEFT;
}

uint point_opening(Lamp lamp, Point point) {
  if (!is_reached(lamp, point.position_m)) return PAIR_NOTHING;
  if (!(point_illuminance_lx(lamp, lamp.centre_m, point) > DBL(0.0))) return PAIR_NOTHING;
  if (has_shadows == 0u) return PAIR_SEEN;
  bool is_left_early;
  const bool is_hidden =
      is_blocked_between(vec3(lifted_point_m(point)),
                         vec3(lifted_source_m(lamp, lamp.centre_m, point.position_m)),
                         is_left_early);
  if (is_left_early) is_cut = true;
  return is_hidden ? PAIR_HIDDEN : PAIR_SEEN;
}

uint sight_of_opening(Lamp lamp, Point point) {
  SightQuery query;
  query.from_m = lifted_point_m(point);
  const dvec3 u = lamp.half_m.x * lamp.x, v = lamp.half_m.y * lamp.y;
  const dvec3 corner[4] = dvec3[4](-u - v, u - v, u + v, v - u);
  for (int k = 0; k < 4; ++k) {
    query.corner_m[k] = lifted_source_m(lamp, lamp.centre_m + corner[k], point.position_m);
  }
  query.margin_m = entry[1];
  query.clear_m = entry[2];
  return sight_of(query);
}

// Whether a disk is one cell: cell_at() of its root, whose places lie on one diameter.
bool is_one_cell(Lamp lamp, Point point) {
  const View view = view_from(lamp, point.position_m);
  if (view.size_m <= view.distance_m) return true;
  const double middle = sqrt(DBL(0.5));
  const dvec3 centre_m = lamp.centre_m - middle * lamp.half_m.x * lamp.x;
  return DBL(2.0) * (DBL(1.0) + middle) * lamp.half_m.x <= length(centre_m - point.position_m);
}

// Few cells, each a smooth part of the opening.
bool has_patches(Lamp lamp, Point point) {
  return lamp.shape == SHAPE_RECTANGLE ||
         (lamp.shape == SHAPE_DISK && is_one_cell(lamp, point));
}

uint classified(uint index, uint p) {
  if (!is_asked(index)) return PAIR_NOTHING;
  const Lamp lamp = lamp_of(index);
  const Point point = point_of(p);
  if (lamp.shape == SHAPE_POINT) return point_opening(lamp, point);
  if (has_patches(lamp, point)) {
    const uint sight = has_shadows != 0u ? sight_of_opening(lamp, point) : SIGHT_FREE;
    if (sight == SIGHT_HIDDEN) return PAIR_HIDDEN;
    if (sight == SIGHT_FREE) return seen_patches(lamp, point);
  }
  return sampled_cells(lamp, point);
}

void main() {
  const uint pair = first_pair + gl_GlobalInvocationID.x;
  if (pair >= last_pair) return;
  const uint kind = classified(pair / point_count, pair % point_count);
  if (!is_cut) pair_word[pair] = kind;  // else not done
}
