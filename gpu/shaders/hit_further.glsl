// Light at hits, stage 3: one further ray from each, and whether the chain may go on at what it
// meets: of add_step() in near_field.cpp what can be told without the bound there.

layout(local_size_x = GROUP_SIZE) in;

layout(std430, binding = 10) readonly buffer Field { double field[]; };

uniform float most_m;

bool goes_on(HitPlace place, uint triangle, vec3 along, dvec2 share) {
  const double rho = reflectance_of(triangle);
  const double g = connection_geometry(KERNEL_PLANAR, place.normal, facing_normal(triangle, along),
                                       position_on(triangle, share) - place.position_m);
  if (rho <= DBL(0.0) || g <= field[FIELD_SMALLEST]) return false;
  const double roulette = fraction_of(key_with(key_with(place.key, PART_1), PART_0));
  return roulette < (DBL(1.0) - field[FIELD_SMALLEST] / g) * rho;
}

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint i = first_item + gl_GlobalInvocationID.x;
  if (!is_lit(i)) return;
  const HitPlace place = place_at(i);
  const uvec2 key = key_with(place.key, PART_0);
  const vec3 from = vec3(place.position_m + offset_of_rays_m() * place.normal);
  const vec3 along = vec3(cosine_direction(place.normal, fraction_of(key_with(key, PART_3)),
                                           fraction_of(key_with(key, PART_4))));
  uint triangle;
  dvec2 share;
  const bool is_met = closest_hit(from, along, 0.0, most_m, triangle, share);
  if (is_cut) return;  // not done
  if (!is_met || !goes_on(place, triangle, along, share)) {
    write_light(i, LIGHT_NEXT_TRIANGLE, HIT_NOTHING);
    return;
  }
  const uint side = is_met_in_front(triangle, along) ? 0u : HIT_FROM_BEHIND;
  write_light(i, LIGHT_NEXT_TRIANGLE, triangle_of[triangle] | side);
  write_light(i, LIGHT_NEXT_PLACE, share.x);
  write_light(i, LIGHT_NEXT_PLACE + 2u, share.y);
}
