// Stage 2: one pair. Light of openings that are seen in full, and about how large the rest may be.

layout(local_size_x = GROUP_SIZE) in;

// Two for each pair: known lx, rest lx.
layout(std430, binding = 7) writeonly buffer Light { double light_lx[]; };

uniform uint first_pair, last_pair;

dvec2 seen_lx(uint index, uint p) {
  const Lamp lamp = lamp_of(index);
  const Point point = point_of(p);
  if (lamp.shape == SHAPE_POINT) {
    return dvec2(point_illuminance_lx(lamp, lamp.centre_m, point), DBL(0.0));
  }
  dvec2 lx = dvec2(DBL(0.0));
  Place place = Place(0u, 0u);
  for (uint patches = 0u; patches < MOST_PARTS; ++patches) {
    Patch part;
    if (!find_patch(lamp, point, place, part)) break;
    fit(lamp, point, part);
    lx += dvec2(known_lx(part), part.share * part.rest_lx);
    if (!go_on(place)) return lx;
  }
  is_cut = true;  // stage 1 let none pass that has more
  return lx;
}

void main() {
  const uint pair = first_pair + gl_GlobalInvocationID.x;
  if (pair >= last_pair) return;
  dvec2 lx = dvec2(DBL(0.0));
  if (pair_word[pair] == NOT_DONE) return;
  if (kind_of(pair) == PAIR_SEEN) lx = seen_lx(pair / point_count, pair % point_count);
  if (is_cut) return;  // not done
  light_lx[2u * pair] = lx.x;
  light_lx[2u * pair + 1u] = lx.y;
}
