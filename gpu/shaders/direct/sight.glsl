// What a point sees of a parallelogram, by proof: calc::sight_of() again, in double, but for the
// four rays to the corners.

uniform uint corner_count;  // 4

struct HalfSpace {
  dvec3 normal;   // unit, outward; 0: there is none
  double height;  // inside: dot(normal, p) <= height
};

bool is_none(HalfSpace plane) { return plane.normal == dvec3(DBL(0.0)); }

double above(HalfSpace plane, dvec3 p) { return dot(plane.normal, p) - plane.height; }

// Through three places, with `inner` on its inner side.
HalfSpace half_space(dvec3 a, dvec3 b, dvec3 c, dvec3 inner) {
  const dvec3 u = b - a, v = c - a, across = cross(u, v);
  const double area = length(across);
  HalfSpace plane;
  const bool is_flat = !(area > DBL(1.0e-9) * length(u) * length(v));
  plane.normal = is_flat ? dvec3(DBL(0.0)) : across / area;
  const double side = dot(plane.normal, inner - a);
  if (side == DBL(0.0)) plane.normal = dvec3(DBL(0.0));
  if (side > DBL(0.0)) plane.normal = -plane.normal;
  plane.height = dot(plane.normal, a);
  return plane;
}

struct SightQuery {
  dvec3 from_m;
  dvec3 corner_m[4];  // in order around it
  double margin_m, clear_m;
};

dvec3 corner_of(uint triangle, uint k) { return dvec3(bvh_corner[3u * triangle + k].xyz); }

// --- free: nothing in the hull of point and corners ---------------------------------------------

struct Pyramid {
  dvec3 place[5];  // the point, the corners
  dvec3 edge[6];   // directions: from the point, along the parallelogram
  HalfSpace plane[5];
  dvec3 low_m, high_m;
  double margin_m;
};

Pyramid pyramid_of(SightQuery query) {
  Pyramid pyramid;
  pyramid.margin_m = query.margin_m;
  pyramid.place[0] = query.from_m;
  for (int k = 0; k < 4; ++k) pyramid.place[k + 1] = query.corner_m[k];
  const dvec3 middle = DBL(0.5) * (pyramid.place[1] + pyramid.place[3]);
  for (int k = 0; k < 4; ++k) {
    pyramid.edge[k] = pyramid.place[k + 1] - pyramid.place[0];
    pyramid.plane[k] =
        half_space(pyramid.place[0], pyramid.place[k + 1], pyramid.place[(k + 1) % 4 + 1], middle);
  }
  pyramid.edge[4] = pyramid.place[2] - pyramid.place[1];
  pyramid.edge[5] = pyramid.place[3] - pyramid.place[2];
  pyramid.plane[4] =
      half_space(pyramid.place[1], pyramid.place[2], pyramid.place[3], pyramid.place[0]);
  pyramid.low_m = pyramid.high_m = pyramid.place[0];
  for (int k = 0; k < 5; ++k) {
    pyramid.plane[k].height += query.margin_m;
    pyramid.low_m = min(pyramid.low_m, pyramid.place[k]);
    pyramid.high_m = max(pyramid.high_m, pyramid.place[k]);
  }
  pyramid.low_m -= query.margin_m;
  pyramid.high_m += query.margin_m;
  return pyramid;
}

// The pyramid about its point, in float, which tells of nearly all boxes and triangles that they lie
// outside. It only says so where roundings cannot matter: what it cannot tell is left to double, so
// that no proof hangs on it.
struct FloatPyramid {
  vec3 point_m;
  vec3 normal[5];      // of planes, outward
  float offset_m[5];   // what is beyond -offset along the normal lies outside
  vec3 low_m, high_m;  // about the point
  float rounding_m;    // of what does not depend on what is tested
};

// Twice what eight roundings can add up to, of the numbers that are rounded.
const float kFloatRounding = 1.0e-6;

FloatPyramid in_float(Pyramid pyramid) {
  FloatPyramid quick;
  quick.point_m = vec3(pyramid.place[0]);
  quick.low_m = vec3(pyramid.low_m - pyramid.place[0]);
  quick.high_m = vec3(pyramid.high_m - pyramid.place[0]);
  const vec3 reach_m = max(abs(quick.low_m), abs(quick.high_m));
  const vec3 size_m = abs(quick.point_m) + reach_m;
  quick.rounding_m = kFloatRounding * (size_m.x + size_m.y + size_m.z);
  for (int k = 0; k < 5; ++k) {
    // Beyond a plane that is none lies nothing.
    quick.normal[k] = vec3(pyramid.plane[k].normal);
    quick.offset_m[k] =
        float(above(pyramid.plane[k], pyramid.place[0]) - pyramid.margin_m / DBL(64.0));
  }
  return quick;
}

// false: no triangle in that box, which is given about the point, meets the pyramid.
bool may_meet_box(FloatPyramid quick, vec3 low, vec3 high, float rounding_m) {
  if (any(greaterThan(low - rounding_m, quick.high_m)) ||
      any(lessThan(high + rounding_m, quick.low_m))) {
    return false;
  }
  for (int k = 0; k < 5; ++k) {
    const vec3 n = quick.normal[k];
    const vec3 lowest = mix(high, low, greaterThan(n, vec3(0.0)));
    if (dot(n, lowest) + quick.offset_m[k] > rounding_m) return false;
  }
  return true;
}

// Beyond one of the planes.
bool is_outside(FloatPyramid quick, uint triangle) {
  const vec3 corner_m[3] = vec3[3](bvh_corner[3u * triangle].xyz, bvh_corner[3u * triangle + 1u].xyz,
                                   bvh_corner[3u * triangle + 2u].xyz);
  const vec3 size_m = max(abs(corner_m[0]), max(abs(corner_m[1]), abs(corner_m[2])));
  const float rounding_m =
      quick.rounding_m + kFloatRounding * (size_m.x + size_m.y + size_m.z);
  for (int k = 0; k < 5; ++k) {
    const vec3 n = quick.normal[k];
    const float nearest = min(dot(n, corner_m[0] - quick.point_m),
                              min(dot(n, corner_m[1] - quick.point_m),
                                  dot(n, corner_m[2] - quick.point_m)));
    if (nearest + quick.offset_m[k] > rounding_m) return true;
  }
  return false;
}

bool separates(Pyramid pyramid, dvec3 axis, dvec3 a, dvec3 b, dvec3 c) {
  const double at_a = dot(axis, a), at_b = dot(axis, b), at_c = dot(axis, c);
  const double low = min(at_a, min(at_b, at_c)), high = max(at_a, max(at_b, at_c));
  double lowest = dot(axis, pyramid.place[0]), highest = lowest;
  for (int k = 1; k < 5; ++k) {
    const double at = dot(axis, pyramid.place[k]);
    lowest = min(lowest, at);
    highest = max(highest, at);
  }
  const double apart = max(low - highest, lowest - high);
  return apart > DBL(0.0) &&
         apart * apart > pyramid.margin_m * pyramid.margin_m * dot(axis, axis);
}

bool meets_triangle(Pyramid pyramid, uint triangle) {
  const dvec3 a = corner_of(triangle, 0u), b = corner_of(triangle, 1u), c = corner_of(triangle, 2u);
  for (int k = 0; k < 5; ++k) {
    const HalfSpace plane = pyramid.plane[k];
    if (!is_none(plane) && above(plane, a) > DBL(0.0) && above(plane, b) > DBL(0.0) &&
        above(plane, c) > DBL(0.0)) {
      return false;
    }
  }
  const dvec3 side[3] = dvec3[3](b - a, c - b, a - c);
  if (separates(pyramid, cross(side[0], side[1]), a, b, c)) return false;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 6; ++k) {
      if (separates(pyramid, cross(side[i], pyramid.edge[k]), a, b, c)) return false;
    }
  }
  return true;
}

// Of the planes of eight boxes along an axis.
float plane_at(float low, float cell, uvec2 bytes, uint slot) {
  return low + cell * float((bytes[slot >> 2u] >> (8u * (slot & 3u))) & 255u);
}

// Slots of a node (visibility.glsl) with a child whose box the pyramid may meet.
uint boxes_met_by(FloatPyramid quick, uint children, uvec4 grid, uvec4 a, uvec4 b, uvec4 c) {
  const uvec3 exponent = (uvec3(grid.w) << uvec3(23u, 15u, 7u)) & 0x7f800000u;
  const vec3 cell = uintBitsToFloat(exponent), low_m = uintBitsToFloat(grid.xyz);
  const vec3 size_m = abs(low_m) + 255.0 * cell;
  const float rounding_m =
      quick.rounding_m + kFloatRounding * (size_m.x + size_m.y + size_m.z);
  uint met = 0u;
  for (; children != 0u; children &= children - 1u) {
    const uint slot = uint(findLSB(children));
    const vec3 low = vec3(plane_at(low_m.x, cell.x, a.xy, slot), plane_at(low_m.y, cell.y, a.zw, slot),
                          plane_at(low_m.z, cell.z, b.xy, slot));
    const vec3 high = vec3(plane_at(low_m.x, cell.x, b.zw, slot),
                           plane_at(low_m.y, cell.y, c.xy, slot),
                           plane_at(low_m.z, cell.z, c.zw, slot));
    if (may_meet_box(quick, low - quick.point_m, high - quick.point_m, rounding_m)) {
      met |= 1u << slot;
    }
  }
  if (children != 0u) is_cut = true;
  return met;
}

// Slots of leaves, from four bits for each.
uint slots_of(uint triangles) {
  uint slots = triangles | (triangles >> 1u);
  slots = (slots | (slots >> 2u)) & 0x11111111u;
  slots = (slots | (slots >> 3u)) & 0x03030303u;
  slots = (slots | (slots >> 6u)) & 0x000f000fu;
  return (slots | (slots >> 12u)) & 255u;
}

bool is_free(SightQuery query) {
  const Pyramid pyramid = pyramid_of(query);
  const FloatPyramid quick = in_float(pyramid);
  Search search = search_of_tree(0u);
  uint triangles = 0u;
  while (goes_on(search)) {
    const uint at = next_node(search, 0u);
    const uvec4 grid = bvh_node[at], links = bvh_node[at + 1u];
    const uint met = boxes_met_by(quick, inner_slots(grid) | slots_of(links.z), grid,
                                  bvh_node[at + 2u], bvh_node[at + 3u], bvh_node[at + 4u]);
    triangles = links.z & four_times(met);
    while (triangles != 0u) {
      const uint bit = uint(findLSB(triangles));
      triangles &= triangles - 1u;
      const uint triangle = links.y + place_among(links.z, bit);
      if (!is_outside(quick, triangle) && meets_triangle(pyramid, triangle)) return false;
    }
    open_children(search, grid, links, met & inner_slots(grid));
  }
  if (goes_on(search) || triangles != 0u) is_cut = true;
  return true;
}

// --- hidden: one triangle, or two at an edge, in the way of all ---------------------------------

// All ends lie beyond the triangle's plane.
bool stands_between(SightQuery query, uint triangle) {
  const HalfSpace plane = half_space(corner_of(triangle, 0u), corner_of(triangle, 1u),
                                     corner_of(triangle, 2u), query.from_m);
  if (is_none(plane) || above(plane, query.from_m) > -query.clear_m) return false;
  for (int k = 0; k < 4; ++k) {
    if (!(above(plane, query.corner_m[k]) >= query.clear_m)) return false;
  }
  return true;
}

// All ends lie on one side of the plane through the point and an edge, that of `inner`.
bool is_within(SightQuery query, dvec3 a, dvec3 b, dvec3 inner) {
  const HalfSpace plane = half_space(query.from_m, a, b, inner);
  if (is_none(plane)) return false;
  for (int k = 0; k < 4; ++k) {
    if (!(above(plane, query.corner_m[k]) <= -query.margin_m)) return false;
  }
  return true;
}

bool hides(SightQuery query, uint triangle) {
  const dvec3 a = corner_of(triangle, 0u), b = corner_of(triangle, 1u), c = corner_of(triangle, 2u);
  return stands_between(query, triangle) && is_within(query, a, b, c) &&
         is_within(query, b, c, a) && is_within(query, c, a, b);
}

bool bounds(SightQuery query, dvec3 p, dvec3 q, dvec3 near, dvec3 far) {
  const HalfSpace plane = half_space(query.from_m, p, q, near);
  return !is_none(plane) && above(plane, far) < DBL(0.0) && is_within(query, p, q, near);
}

// Triangles a b c and a b d: as seen from the point, a convex figure a c b d that holds all ends.
bool hides_quad(SightQuery query, dvec3 a, dvec3 b, dvec3 c, dvec3 d) {
  const HalfSpace seam = half_space(query.from_m, a, b, c);
  return !is_none(seam) && above(seam, d) > DBL(0.0) && bounds(query, a, c, b, d) &&
         bounds(query, c, b, a, d) && bounds(query, b, d, a, c) && bounds(query, d, a, b, c);
}

bool hide(SightQuery query, uint first, uint second) {
  if (!stands_between(query, first) || !stands_between(query, second)) return false;
  uint edge = 3u, other = 3u;  // that they share: of the first, of the second
  for (uint i = 0u; i < 3u; ++i) {
    const dvec3 a = corner_of(first, i), b = corner_of(first, (i + 1u) % 3u);
    for (uint k = 0u; k < 3u; ++k) {
      const dvec3 d = corner_of(second, k), e = corner_of(second, (k + 1u) % 3u);
      if (edge == 3u && ((d == a && e == b) || (d == b && e == a))) {
        edge = i;
        other = k;
      }
    }
  }
  return edge < 3u && hides_quad(query, corner_of(first, edge), corner_of(first, (edge + 1u) % 3u),
                                 corner_of(first, (edge + 2u) % 3u),
                                 corner_of(second, (other + 2u) % 3u));
}

bool is_covered(SightQuery query, uvec4 hits) {
  const uint first = hits.x;
  uint second = first;
  for (int k = 1; k < 4; ++k) {
    if (hits[k] == first) continue;
    if (second != first && hits[k] != second) return false;
    second = hits[k];
  }
  return second == first ? hides(query, first) : hide(query, first, second);
}

uint sight_of(SightQuery query) {
  if (node_count == 0u) return SIGHT_FREE;
  for (int k = 0; k < 4; ++k) {
    if (length(query.corner_m[k] - query.from_m) < query.clear_m) return SIGHT_UNKNOWN;
  }
  uvec4 hits = uvec4(0u);
  uint met = 0u;
  const vec3 from = vec3(query.from_m);
  // As many as there are, told so that compilers do not write the search out.
  for (uint k = 0u; k < corner_count; ++k) {
    uint triangle;
    dvec2 share;
    if (closest_hit(from, vec3(query.corner_m[k]) - from, 0.0, 1.0, triangle, share)) {
      hits[k] = triangle;
      ++met;
    }
  }
  if (met == 4u) return is_covered(query, hits) ? SIGHT_HIDDEN : SIGHT_UNKNOWN;
  if (met != 0u) return SIGHT_UNKNOWN;
  return is_free(query) ? SIGHT_FREE : SIGHT_UNKNOWN;
}
