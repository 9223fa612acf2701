// Distances to the nearest surfaces.
#include "calc/radiosity/rays.h"
#include "calc/radiosity/rays_embree.h"

#include <algorithm>
#include <array>
#include <limits>

namespace calc {
namespace {

// Closest point of a triangle.  [Ericson, Real-Time Collision Detection, 5.1.5]
glm::dvec3 closest_on_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

// Distance to the part of a triangle that reaches more than `height_m` in front of the plane
// through the point with this unit normal; infinity if no part does.
double distance_in_front(const glm::dvec3& p, const glm::dvec3& normal, double height_m,
                         const std::array<glm::dvec3, 3>& corner) {
  std::array<glm::dvec3, 4> kept;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 &from = corner[k], &to = corner[(k + 1) % 3];
    const double h = glm::dot(normal, from - p) - height_m;
    const double next = glm::dot(normal, to - p) - height_m;
    if (h > 0.0) kept[count++] = from;
    if ((h > 0.0) != (next > 0.0)) kept[count++] = from + h / (h - next) * (to - from);
  }
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 2; k < count; ++k) {
    least_m =
        std::min(least_m, glm::length(closest_on_triangle(p, kept[0], kept[k - 1], kept[k]) - p));
  }
  return least_m;
}

struct ClearQuery {
  const PreparedScene& scene;
  glm::dvec3 position_m, normal;
  double margin_m;
};

bool narrow_query(RTCPointQueryFunctionArguments* arguments) {
  const auto& query = *static_cast<const ClearQuery*>(arguments->userPtr);
  const glm::uvec3 corner = query.scene.triangle[arguments->primID];
  const glm::dvec3 a(query.scene.vertex_m[corner.x]), b(query.scene.vertex_m[corner.y]),
      c(query.scene.vertex_m[corner.z]);
  if (query.normal != glm::dvec3(0.0)) {
    const double height = std::max({glm::dot(query.normal, a - query.position_m),
                                    glm::dot(query.normal, b - query.position_m),
                                    glm::dot(query.normal, c - query.position_m)});
    if (height <= query.margin_m) return false;
  }
  const double distance =
      glm::length(closest_on_triangle(query.position_m, a, b, c) - query.position_m);
  // Rounding of the query's float radius must not make the distance too large.
  const auto radius = static_cast<float>(std::max(0.0, distance * (1.0 - 1e-6) - query.margin_m));
  if (!(radius < arguments->query->radius)) return false;
  arguments->query->radius = radius;
  return true;
}

struct CloseSearch {
  const PreparedScene& scene;
  const ClosenessQuery& query;
  std::optional<CloseSurface> found;
};

bool look_closer(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<CloseSearch*>(arguments->userPtr);
  const ClosenessQuery& query = search.query;
  const glm::uvec3 t = search.scene.triangle[arguments->primID];
  const std::array<glm::dvec3, 3> corner{glm::dvec3(search.scene.vertex_m[t.x]),
                                         glm::dvec3(search.scene.vertex_m[t.y]),
                                         glm::dvec3(search.scene.vertex_m[t.z])};
  const auto distance_from = [&](const glm::dvec3& p) {
    return glm::length(closest_on_triangle(p, corner[0], corner[1], corner[2]) - p);
  };
  double distance_m = distance_from(query.position_m);
  if (distance_m <= query.touching_m) return false;
  double from_origin_m = distance_from(query.origin_m);
  if (query.normal != glm::dvec3(0.0)) {
    // Heights count from the point, distances from where its rays begin.
    const double height_m =
        query.touching_m - glm::dot(query.normal, query.origin_m - query.position_m);
    from_origin_m = distance_in_front(query.origin_m, query.normal, height_m, corner);
    distance_m = distance_in_front(query.position_m, query.normal, query.touching_m, corner);
  }
  if (!(from_origin_m < query.least_m)) return false;
  // Of equally near ones the first: the order of a search is not always the same.
  const bool is_nearer = !search.found || distance_m < search.found->distance_m ||
                         (distance_m == search.found->distance_m &&
                          arguments->primID < search.found->triangle);
  if (is_nearer) {
    search.found = {arguments->primID, distance_m};
  }
  return false;  // the radius stays
}

}  // namespace

double Tracer::clear_distance(const glm::dvec3& position_m, const glm::dvec3& normal,
                              double most_m) const {
  if (embree_->scene == nullptr) return most_m;
  ClearQuery user{scene_, position_m, normal, offset_m_};
  RTCPointQuery query;
  query.x = static_cast<float>(position_m.x);
  query.y = static_cast<float>(position_m.y);
  query.z = static_cast<float>(position_m.z);
  query.time = 0.0f;
  query.radius = static_cast<float>(most_m);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(embree_->scene, &query, &context, narrow_query, &user);
  // Untouched: nothing is near, and rounding most_m to float must not say otherwise.
  return query.radius < static_cast<float>(most_m) ? static_cast<double>(query.radius) : most_m;
}

std::optional<CloseSurface> Tracer::close_surface(const ClosenessQuery& query) const {
  if (embree_->scene == nullptr) return std::nullopt;
  CloseSearch user{scene_, query, std::nullopt};
  RTCPointQuery around;
  around.x = static_cast<float>(query.origin_m.x);
  around.y = static_cast<float>(query.origin_m.y);
  around.z = static_cast<float>(query.origin_m.z);
  around.time = 0.0f;
  around.radius = static_cast<float>(query.least_m + offset_m_);  // above all rounding
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(embree_->scene, &around, &context, look_closer, &user);
  return user.found;
}

}  // namespace calc
