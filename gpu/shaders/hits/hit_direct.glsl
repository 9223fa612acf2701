// Light at hits, stage 2: direct light, of one luminaire that is chosen as
// calc::LuminaireChoice::choose() does, from one point of its opening: calc::add_direct_sample_of().

layout(local_size_x = GROUP_SIZE) in;

// Rows of the piece's hits: sums of weights of each channel.
layout(std430, binding = 14) buffer ChannelWeights { double channel_weight[]; };

uniform uint luminaire_count, channel_count, has_shadows;
uniform uint row;    // hits of the piece
uniform uint looks;  // 2

ChoiceSource source_of(uint lamp) {
  const uint at = CHOICE_SIZE * lamp;
  return ChoiceSource(
      vec3(choice[at], choice[at + 1u], choice[at + 2u]),
      vec3(choice[at + 3u], choice[at + 4u], choice[at + 5u]),
      vec3(choice[at + 6u], choice[at + 7u], choice[at + 8u]),
      vec3(choice[at + 9u], choice[at + 10u], choice[at + 11u]),
      vec3(choice[at + 12u], choice[at + 13u], choice[at + 14u]), choice[at + 15u],
      choice[at + 16u], uint(choice[at + 17u]), uint(choice[at + 18u]));
}

double weight_of(ChoiceSource source, vec3 at_m, vec3 normal) {
  const uint lobe = CHOICE_SIZE * luminaire_count + LOBE_SIZE * source.lobe;
  return double(choice_most_lx(source, lobe, at_m, normal));
}

struct Choice {
  uint luminaire;
  double probability;  // 0: no luminaire can light the point
};

Choice choose(uint i, vec3 at_m, vec3 normal, double u) {
  if (luminaire_count == 1u) return Choice(0u, DBL(1.0));
  uint channel = 0u, lamp = 0u;
  for (; channel < channel_count; ++channel) channel_weight[channel * row + i] = DBL(0.0);
  for (; lamp < luminaire_count; ++lamp) {
    const ChoiceSource source = source_of(lamp);
    const uint at = source.channel * row + i;
    precise double sum = channel_weight[at] + weight_of(source, at_m, normal);
    channel_weight[at] = sum;
  }
  if (channel < channel_count || lamp < luminaire_count) is_cut = true;
  precise double all = DBL(0.0);
  for (channel = 0u; channel < channel_count; ++channel) {
    all = all + channel_weight[channel * row + i];
  }
  Choice chosen = Choice(0u, DBL(0.0));
  if (!(all > DBL(0.0))) return chosen;
  precise double least = LEAST_SHARE * all;
  double lit_channels = DBL(0.0);
  for (channel = 0u; channel < channel_count; ++channel) {
    if (channel_weight[channel * row + i] > least) lit_channels += DBL(1.0);
  }
  for (channel = 0u; channel < channel_count; ++channel) {
    const uint at = channel * row + i;
    const double weight = channel_weight[at];
    precise double share = DBL(0.5) / all;
    if (weight > least) share = share + DBL(0.5) / (lit_channels * weight);
    channel_weight[at] = share;
  }
  precise double left = u;
  bool is_passed = true;
  for (lamp = 0u; lamp < luminaire_count && is_passed; ++lamp) {
    const ChoiceSource source = source_of(lamp);
    precise double p =
        weight_of(source, at_m, normal) * channel_weight[source.channel * row + i];
    if (!(p > DBL(0.0))) continue;
    chosen = Choice(lamp, p);
    is_passed = !(left < p);
    left = left - p;
  }
  if (is_passed && lamp < luminaire_count) is_cut = true;
  return chosen;
}

struct DrawnCell {
  Cell cell;
  double probability;  // 0: all parts are behind the point
};

// draw_cell() of direct.cpp. False: more parts than a shader visits.
bool draw_cell(Lamp lamp, View view, Point point, double u, out DrawnCell drawn) {
  drawn = DrawnCell(kWholeOpening, DBL(0.0));
  precise double sum = DBL(0.0);
  // Twice, in one loop so that compilers write the search down once: what all parts weigh, and the
  // part at which their sum passes its share.
  for (uint look = 0u; look < looks; ++look) {
    const double whole = sum, wanted = u * whole;
    sum = DBL(0.0);
    Walk walk = kBegin;
    bool is_last = false;
    uint cells = 0u;
    for (; cells < MOST_PARTS && !is_last; ++cells) {
      CellAt at;
      if (!find_cell(lamp, view, point.position_m, walk, at)) return false;
      is_last = !go_on(view, walk);
      if (cells == 0u && is_last) {
        drawn = DrawnCell(at.cell, DBL(1.0));
        return true;
      }
      const dvec3 way_m = at.centre_m - point.position_m;
      const double distance_m = max(length(way_m), offset_of_rays_m());
      const double cosine = dot(way_m, point.axis) / distance_m;
      precise double weight = at.cell.size_s * at.cell.size_t *
                              max(DBL(0.0), cosine + DBL(0.5)) / (distance_m * distance_m);
      precise double before = sum;
      sum = sum + weight;
      if (look == 0u || !(is_last || sum > wanted)) continue;
      drawn = DrawnCell(at.cell, (sum - before) / whole);
      return true;
    }
    if (!is_last) {
      if (cells < MOST_PARTS) is_cut = true;  // the driver left the loop
      return false;
    }
    if (!(sum > DBL(0.0))) return true;
  }
  is_cut = true;
  return false;
}

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint i = first_item + gl_GlobalInvocationID.x;
  if (!is_lit(i)) return;
  const HitPlace place = place_at(i);
  const uvec2 key = key_with(key_of(place), PART_1);
  uint luminaire = LIGHT_NOTHING;
  double direct_lx = DBL(0.0);
  Choice chosen = Choice(0u, DBL(0.0));
  if (luminaire_count > 0u) {
    chosen = choose(i, vec3(place.position_m), vec3(place.normal), fraction_of(key_with(key, PART_2)));
  }
  if (chosen.probability > DBL(0.0)) {
    const Lamp lamp = lamp_of(chosen.luminaire);
    const Point point = Point(place.position_m, place.normal, KERNEL_PLANAR, key);
    const View view = view_from(lamp, place.position_m);
    DrawnCell drawn;
    if (!draw_cell(lamp, view, point, fraction_of(key_with(key, PART_3)), drawn)) {
      luminaire = LIGHT_LEFT;
    } else if (drawn.probability > DBL(0.0)) {
      const Cell cell = drawn.cell;
      vec3 to_m;
      const double lx =
          opening_lx(lamp, view, point, cell.s + cell.size_s * fraction_of(key_with(key, PART_0)),
                     cell.t + cell.size_t * fraction_of(key_with(key, PART_1)), to_m);
      if (lx > DBL(0.0)) {
        luminaire = chosen.luminaire;
        direct_lx = place.weight / chosen.probability * cell.size_s * cell.size_t /
                    drawn.probability * lx;
        if (has_shadows != 0u) {
          bool is_left_early;
          if (is_blocked_from_hit_to_source(vec3(lifted_point_m(point)), to_m, is_left_early)) {
            luminaire = LIGHT_HIDDEN;
          }
          if (is_left_early) is_cut = true;
        }
      }
    }
  }
  if (is_cut) return;  // not done
  write_light(i, LIGHT_LUMINAIRE, luminaire);
  write_light(i, LIGHT_DIRECT, direct_lx);
}
