#include "calc/radiosity/rays.h"

#include "calc/radiosity/rays_embree.h"
#include "calc/radiosity/short_rays.h"

#include <fmt/format.h>
#include <xmmintrin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace calc {
namespace {

constexpr unsigned kFlushToZeroAndDenormalsAreZero = 0x8040;  // MXCSR bits FTZ and DAZ

void throw_embree_error(void* /*user*/, RTCError code, const char* text) {
  throw std::runtime_error(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

template <class T>
void fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<T>& from) {
  void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), from.size());
  std::memcpy(to, from.data(), from.size() * sizeof(T));
}

}  // namespace

Tracer::Tracer(const PreparedScene& scene)
    : scene_(scene), offset_m_(scene.ray_offset_m()), embree_(std::make_unique<Embree>()) {
  if (scene.triangle.empty()) return;  // nothing to hit: Embree is not even started
  embree_->device = rtcNewDevice(nullptr);
  if (embree_->device == nullptr) throw std::runtime_error("Embree gives no device");
  rtcSetDeviceErrorFunction(embree_->device, throw_embree_error, nullptr);
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);  // without it rays leak at shared edges
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, scene.vertex_m);
  fill_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, scene.triangle);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree_->scene);
  triangle_normal_.reserve(scene.triangle.size());
  for (const glm::uvec3& corner : scene.triangle) {
    const glm::dvec3 a(scene.vertex_m[corner.x]);
    const glm::dvec3 b(scene.vertex_m[corner.y]);
    const glm::dvec3 c(scene.vertex_m[corner.z]);
    triangle_normal_.push_back(glm::normalize(glm::cross(b - a, c - a)));
  }
}

Tracer::~Tracer() = default;

bool Tracer::closest_hit(const glm::dvec3& origin_m, const glm::dvec3& direction,
                         double max_distance_m, SurfaceHit& hit) const {
  if (embree_->scene == nullptr) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin_m.x);
  query.ray.org_y = static_cast<float>(origin_m.y);
  query.ray.org_z = static_cast<float>(origin_m.z);
  query.ray.dir_x = static_cast<float>(direction.x);
  query.ray.dir_y = static_cast<float>(direction.y);
  query.ray.dir_z = static_cast<float>(direction.z);
  query.ray.tnear = 0.0f;
  query.ray.tfar = static_cast<float>(max_distance_m);
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

  hit = surface_hit(query.hit.primID, static_cast<double>(query.hit.u),
                    static_cast<double>(query.hit.v), direction);
  return true;
}

glm::dvec3 Tracer::point_on(std::uint32_t triangle, double u, double v) const {
  const glm::uvec3 corner = scene_.triangle[triangle];
  const glm::dvec3 a(scene_.vertex_m[corner.x]);
  const glm::dvec3 b(scene_.vertex_m[corner.y]);
  const glm::dvec3 c(scene_.vertex_m[corner.z]);
  return a + u * (b - a) + v * (c - a);
}

SurfaceHit Tracer::surface_hit(std::uint32_t triangle, double u, double v,
                               const glm::dvec3& direction) const {
  const glm::dvec3& normal = triangle_normal_[triangle];
  return {triangle, point_on(triangle, u, v), glm::dot(normal, direction) < 0.0 ? normal : -normal};
}

SurfaceHit Tracer::surface_hit(const FirstHit& first) const {
  const std::uint32_t triangle = first.triangle_and_side & ~FirstHit::kFromBehind;
  const glm::dvec3& normal = triangle_normal_[triangle];
  return {triangle, point_on(triangle, static_cast<double>(first.u), static_cast<double>(first.v)),
          (first.triangle_and_side & FirstHit::kFromBehind) == 0 ? normal : -normal};
}

std::uint32_t Tracer::closest_hits(const RayPacket& packet, float least_m, float most_m,
                                   std::array<SurfaceHit, RayPacket::kSize>& hit) const {
  if (embree_->scene == nullptr) return 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) std::array<int, RayPacket::kSize> valid{};
  RTCRayHit16 query;
  for (int k = 0; k < RayPacket::kSize; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool is_used = k < packet.count;
    valid[i] = is_used ? -1 : 0;
    query.ray.org_x[k] = is_used ? packet.x[i] : 0.0f;
    query.ray.org_y[k] = is_used ? packet.y[i] : 0.0f;
    query.ray.org_z[k] = is_used ? packet.z[i] : 0.0f;
    query.ray.dir_x[k] = is_used ? packet.dx[i] : 0.0f;
    query.ray.dir_y[k] = is_used ? packet.dy[i] : 0.0f;
    query.ray.dir_z[k] = is_used ? packet.dz[i] : 1.0f;
    query.ray.tnear[k] = least_m;
    query.ray.tfar[k] = most_m;
    query.ray.time[k] = 0.0f;
    query.ray.mask[k] = ~0u;
    query.ray.id[k] = 0;
    query.ray.flags[k] = 0;
    query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid.data(), embree_->scene, &context, &query);
  std::uint32_t mask = 0;
  for (int k = 0; k < packet.count; ++k) {
    if (query.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
    const auto i = static_cast<std::size_t>(k);
    mask |= 1u << k;
    hit[i] = surface_hit(query.hit.primID[k], static_cast<double>(query.hit.u[k]),
                         static_cast<double>(query.hit.v[k]),
                         {static_cast<double>(packet.dx[i]), static_cast<double>(packet.dy[i]),
                          static_cast<double>(packet.dz[i])});
  }
  return mask;
}

bool Tracer::is_blocked(const glm::dvec3& from_m, const glm::dvec3& to_m) const {
  if (!has_shadows_) return false;
  SegmentPacket packet;
  packet.add(glm::vec3(from_m), glm::vec3(to_m));
  return blocked(packet) != 0;
}

std::uint32_t Tracer::blocked(const SegmentPacket& packet) const {
  if (embree_->scene == nullptr) return 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) std::array<int, SegmentPacket::kSize> valid{};
  RTCRay16 ray;
  const auto offset = static_cast<float>(offset_m_);
  for (int k = 0; k < SegmentPacket::kSize; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool is_used = k < packet.count;
    valid[i] = is_used ? -1 : 0;
    const float dx = is_used ? packet.to_x[i] - packet.from_x[i] : 0.0f;
    const float dy = is_used ? packet.to_y[i] - packet.from_y[i] : 0.0f;
    const float dz = is_used ? packet.to_z[i] - packet.from_z[i] : 1.0f;
    const float margin = offset / std::sqrt(dx * dx + dy * dy + dz * dz);
    ray.org_x[k] = is_used ? packet.from_x[i] : 0.0f;
    ray.org_y[k] = is_used ? packet.from_y[i] : 0.0f;
    ray.org_z[k] = is_used ? packet.from_z[i] : 0.0f;
    ray.dir_x[k] = dx;
    ray.dir_y[k] = dy;
    ray.dir_z[k] = dz;
    ray.tnear[k] = margin;
    ray.tfar[k] = 1.0f - margin;
    ray.time[k] = 0.0f;
    ray.mask[k] = ~0u;
    ray.id[k] = 0;
    ray.flags[k] = 0;
    // Two points nearer than both margins have nothing between them that could be told apart from
    // them.
    if (!(ray.tnear[k] < ray.tfar[k])) valid[i] = 0;
  }
  if (packet.count == 1) {
    if (valid[0] == 0) return 0;
    RTCRay single{ray.org_x[0],
                  ray.org_y[0],
                  ray.org_z[0],
                  ray.tnear[0],
                  ray.dir_x[0],
                  ray.dir_y[0],
                  ray.dir_z[0],
                  0.0f,
                  ray.tfar[0],
                  ~0u,
                  0,
                  0};
    rtcOccluded1(embree_->scene, &context, &single);
    return single.tfar < 0.0f ? 1u : 0u;
  }
  rtcOccluded16(valid.data(), embree_->scene, &context, &ray);
  std::uint32_t mask = 0;
  for (int k = 0; k < packet.count; ++k) {
    const bool is_hit = valid[static_cast<std::size_t>(k)] != 0 && ray.tfar[k] < 0.0f;
    mask |= (is_hit ? 1u : 0u) << k;
  }
  return mask;
}

FlushDenormals::FlushDenormals() : saved_(_mm_getcsr()) {
  _mm_setcsr(saved_ | kFlushToZeroAndDenormalsAreZero);
}

FlushDenormals::~FlushDenormals() { _mm_setcsr(saved_); }

std::string tracer_version() {
  return fmt::format("Embree {}.{}.{}", RTC_VERSION_MAJOR, RTC_VERSION_MINOR, RTC_VERSION_PATCH);
}

}  // namespace calc
