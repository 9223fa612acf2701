// Light at hits, stage 1: the geometry bound there, calc::GeometryBound::at(), and with it the
// weight of the hit's light; what the next stages need to know of the place. Of later steps only
// chains that roulette lets go on have a weight.

layout(local_size_x = GROUP_SIZE) in;

#if IS_FIRST_STEP
layout(std430, binding = 6) readonly buffer Hits { uint hit[]; };
layout(std430, binding = 7) readonly buffer List { uvec2 list[]; };
layout(std430, binding = 8) readonly buffer Order { uint triangle_of[]; };
#else
layout(std430, binding = 7) readonly buffer Chains { uint chain_word[]; };  // hit_further.glsl
#endif
// As draw_arrays.glsl reads them: four words of a DrawReceiver.
layout(std430, binding = 14) writeonly buffer Receivers { uvec4 receiver_word[]; };

uniform uint first_hit;  // of the piece, in the list
#if IS_FIRST_STEP
uniform uint request_count;
#endif

// Places of the step, with the weight of their light if its bound were 0; how near they are.
#if IS_FIRST_STEP
HitPlace place_of(uint i, out uint triangle_and_side, out dvec2 share, out double g) {
  const uvec2 at = list[first_hit + i];
  const Request request = request_at(at.x);
  const uint ray = LIT_HIT_SIZE * (request.first_ray + at.y);
  triangle_and_side = hit[ray];
  share = dvec2(packDouble2x32(uvec2(hit[ray + 1u], hit[ray + 2u])),
                packDouble2x32(uvec2(hit[ray + 3u], hit[ray + 4u])));
  const uint triangle = triangle_and_side & ~HIT_FROM_BEHIND;
  HitPlace place;
  place.position_m = position_on(triangle, share);
  place.normal = normal_of(triangle, (triangle_and_side & HIT_FROM_BEHIND) == 0u);
  place.key = key_with(request.key, at.y);
  place.weight = ray_weight(request, at.y);
  g = connection_geometry(request.kernel, request.axis, place.normal,
                          place.position_m - request.position_m);
  return place;
}

// Else the list is not done, and neither is the hit.
bool has_place(uint i) { return list[first_hit + i].x < request_count; }

// The first step weighs less, where later ones end some chains.
double weight_with(HitPlace place, double factor) { return place.weight * factor; }

void write_hit(uint i, uint triangle_and_side, dvec2 share) {
  const uvec2 at = list[first_hit + i];
  write_light(i, LIGHT_TRIANGLE, triangle_of[triangle_and_side & ~HIT_FROM_BEHIND] |
                                     (triangle_and_side & HIT_FROM_BEHIND));
  write_light(i, LIGHT_PLACE, share.x);
  write_light(i, LIGHT_PLACE + 2u, share.y);
  write_light(i, LIGHT_REQUEST, at.x);
  write_light(i, LIGHT_RAY, at.y);
}
#else
double chain_double(uint at) {
  return packDouble2x32(uvec2(chain_word[at], chain_word[at + 1u]));
}

HitPlace place_of(uint i, out uint triangle_and_side, out dvec2 share, out double g) {
  const uint at = CHAIN_HEAD + CHAIN_SIZE * i;
  triangle_and_side = chain_word[at + 10u];
  share = dvec2(chain_double(at), chain_double(at + 2u));
  g = chain_double(at + 4u);
  const uint triangle = triangle_and_side & ~HIT_FROM_BEHIND;
  HitPlace place;
  place.position_m = position_on(triangle, share);
  place.normal = normal_of(triangle, (triangle_and_side & HIT_FROM_BEHIND) == 0u);
  place.weight = chain_double(at + 6u);
  place.key = uvec2(chain_word[at + 8u], chain_word[at + 9u]);
  return place;
}

bool has_place(uint i) { return i < chain_word[depth]; }

double weight_with(HitPlace place, double factor) {
  return fraction_of(key_with(key_of(place), PART_0)) < factor ? place.weight : DBL(0.0);
}

void write_hit(uint i, uint triangle_and_side, dvec2 share) {}
#endif

void main() {
  if (gl_GlobalInvocationID.x >= item_count) return;
  const uint i = first_item + gl_GlobalInvocationID.x;
  if (!has_place(i)) return;
  uint triangle_and_side;
  dvec2 share;
  double g;
  HitPlace place = place_of(i, triangle_and_side, share, g);
  const dvec3 lifted_m = lifted_m_of(place.position_m, place.normal);
  const double missing = DBL(1.0) - bound_at(lifted_m, place.normal) / g;
  const double rho = reflectance_of(triangle_and_side & ~HIT_FROM_BEHIND);
  place.weight = missing > DBL(0.0) ? weight_with(place, missing * rho) : DBL(0.0);
  store(i, place);
  const bool is_wanted = !is_cut && place.weight > DBL(0.0);
  receiver_word[4u * i] = uvec4(floatBitsToUint(vec3(place.position_m)), 0u);
  receiver_word[4u * i + 1u] = uvec4(floatBitsToUint(vec3(place.normal)), 0u);
  receiver_word[4u * i + 2u] = uvec4(floatBitsToUint(vec3(lifted_m)), 0u);
  receiver_word[4u * i + 3u] =
      uvec4(is_wanted ? TILE_OF_ALL : TILE_OF_NOTHING, KERNEL_PLANAR,
            unpackDouble2x32(fraction_of(key_with(key_of(place), PART_2))));
  if (is_cut) return;  // not done
  write_hit(i, triangle_and_side, share);
  write_light(i, LIGHT_WEIGHT, place.weight);
}
