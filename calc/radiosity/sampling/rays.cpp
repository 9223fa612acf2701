#include "calc/radiosity/sampling/rays.h"

#include "calc/base/triangle.h"
#include "calc/radiosity/sampling/short_rays.h"

#include <xmmintrin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace calc {
namespace {

constexpr unsigned kFlushToZeroAndDenormalsAreZero = 0x8040;  // MXCSR bits FTZ and DAZ

}  // namespace

Tracer::Tracer(const PreparedScene& scene)
    : scene_(scene), offset_m_(scene.ray_offset_m()), tree_(scene.vertex_m, scene.triangle) {
  triangle_normal_.reserve(tree_.size());
  for (std::size_t k = 0; k < tree_.size(); ++k) {
    const Triangle& triangle = tree_.triangle(k);
    triangle_normal_.push_back(
        glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a)));
  }
}

bool Tracer::closest_hit(const glm::dvec3& origin_m, const glm::dvec3& direction,
                         double max_distance_m, SurfaceHit& hit) const {
  const Ray ray{glm::vec3(origin_m), glm::vec3(direction), 0.0f,
                static_cast<float>(max_distance_m)};
  TriangleHit first;
  if (tree_.first_hits({&ray, 1}, {&first, 1}) == 0) return false;
  hit = surface_hit(first, direction);
  return true;
}

glm::dvec3 Tracer::point_on(std::uint32_t triangle, double u, double v) const {
  const auto& [a, b, c] = tree_.triangle(triangle);
  return a + u * (b - a) + v * (c - a);
}

SurfaceHit Tracer::surface_hit(const TriangleHit& hit, const glm::dvec3& direction) const {
  const glm::dvec3& normal = triangle_normal_[hit.triangle];
  return {hit.triangle, point_on(hit.triangle, hit.u, hit.v),
          glm::dot(normal, direction) < 0.0 ? normal : -normal};
}

SurfaceHit Tracer::surface_hit(const FirstHit& first) const {
  return surface_hit(first.triangle_and_side, static_cast<double>(first.u),
                     static_cast<double>(first.v));
}

SurfaceHit Tracer::surface_hit(std::uint32_t triangle_and_side, double u, double v) const {
  const std::uint32_t triangle = triangle_and_side & ~FirstHit::kFromBehind;
  const glm::dvec3& normal = triangle_normal_[triangle];
  return {triangle, point_on(triangle, u, v),
          (triangle_and_side & FirstHit::kFromBehind) == 0 ? normal : -normal};
}

std::uint32_t Tracer::closest_hits(const RayPacket& packet, float least_m, float most_m,
                                   std::array<SurfaceHit, RayPacket::kSize>& hit) const {
  std::array<Ray, RayPacket::kSize> rays;
  std::array<TriangleHit, RayPacket::kSize> first;
  const auto count = static_cast<std::size_t>(packet.count);
  for (std::size_t k = 0; k < count; ++k) {
    rays[k] = {packet.ray[k].origin, packet.ray[k].direction, least_m, most_m};
  }
  const std::uint32_t mask = tree_.first_hits({rays.data(), count}, {first.data(), count});
  for (std::size_t k = 0; k < count; ++k) {
    if (((mask >> k) & 1u) != 0) hit[k] = surface_hit(first[k], glm::dvec3(rays[k].direction));
  }
  return mask;
}

bool Tracer::is_blocked(const glm::dvec3& from_m, const glm::dvec3& to_m,
                        SegmentMargins left_out) const {
  if (!has_shadows_) return false;
  SegmentPacket packet;
  packet.add(glm::vec3(from_m), glm::vec3(to_m), left_out);
  return blocked(packet) != 0;
}

Sight Tracer::sight(const glm::dvec3& from_m, const std::array<glm::dvec3, 4>& corner_m) const {
  return sight_of(tree_, {from_m, corner_m, sight_margin_m(), sight_clear_m()});
}

std::uint32_t Tracer::blocked(const SegmentPacket& packet) const {
  std::array<Ray, SegmentPacket::kSize> rays;
  std::array<std::size_t, SegmentPacket::kSize> place;
  std::size_t count = 0;
  const auto offset = static_cast<float>(offset_m_);
  for (std::size_t k = 0; k < static_cast<std::size_t>(packet.count); ++k) {
    const auto& [from, way, least, most] = packet.segment[k];
    const float margin = offset / glm::length(way);
    const float begin = packet.margins[k].from * margin, end = 1.0f - packet.margins[k].to * margin;
    // Two points nearer than their margins have nothing between them that could be told apart from
    // them; two in one place have a margin that is no number.
    if (!(begin < end)) continue;
    place[count] = k;
    rays[count++] = {from, way, begin, end};
  }
  const std::uint32_t found = tree_.blocked({rays.data(), count});
  if (count == static_cast<std::size_t>(packet.count)) return found;
  std::uint32_t mask = 0;
  for (std::size_t k = 0; k < count; ++k) mask |= ((found >> k) & 1u) << place[k];
  return mask;
}

double Tracer::clear_distance(const glm::dvec3& position_m, const glm::dvec3& normal,
                              double most_m) const {
  // Rounding of positions to float must not make the distance too large.
  const auto certain = [&](double nearest_m) {
    return std::max(0.0, nearest_m * (1.0 - 1e-6) - offset_m_);
  };
  double nearest_m = (most_m + offset_m_) / (1.0 - 1e-6);
  const double enough_m = nearest_m;
  tree_.visit_near(position_m, nearest_m, [&](std::uint32_t index) {
    const Triangle& triangle = tree_.triangle(index);
    if (normal != glm::dvec3(0.0)) {
      const double height = std::max({glm::dot(normal, triangle.a - position_m),
                                      glm::dot(normal, triangle.b - position_m),
                                      glm::dot(normal, triangle.c - position_m)});
      if (height <= offset_m_) return nearest_m;
    }
    nearest_m = std::min(nearest_m, distance_m(position_m, triangle));
    return nearest_m;
  });
  return nearest_m < enough_m ? std::min(most_m, certain(nearest_m)) : most_m;
}

std::optional<CloseSurface> Tracer::close_surface(const ClosenessQuery& query) const {
  std::optional<CloseSurface> found;
  const double around_m = query.least_m + offset_m_;  // above all rounding
  tree_.visit_near(query.origin_m, around_m, [&](std::uint32_t index) {
    const Triangle& triangle = tree_.triangle(index);
    double from_point_m = distance_m(query.position_m, triangle);
    double from_origin_m = distance_m(query.origin_m, triangle);
    if (query.normal != glm::dvec3(0.0)) {
      // Heights count from the point, distances from where its rays begin.
      const double height_m =
          query.touching_m - glm::dot(query.normal, query.origin_m - query.position_m);
      from_origin_m = distance_in_front_m(query.origin_m, query.normal, height_m, triangle);
      from_point_m =
          distance_in_front_m(query.position_m, query.normal, query.touching_m, triangle);
    }
    if (!(from_origin_m < query.least_m)) return around_m;
    // Of equally near ones the first: a search has no order.
    const bool is_nearer = !found || from_point_m < found->distance_m ||
                           (from_point_m == found->distance_m && index < found->triangle);
    if (is_nearer) found = {index, from_point_m};
    return around_m;  // the radius stays
  });
  return found;
}

FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) {
  _mm_setcsr(saved_ | kFlushToZeroAndDenormalsAreZero);
}

FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }

}  // namespace calc
