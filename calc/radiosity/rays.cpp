#include "calc/radiosity/rays.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <xmmintrin.h>

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

struct Tracer::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

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

  hit.triangle = query.hit.primID;
  const glm::uvec3 corner = scene_.triangle[hit.triangle];
  const glm::dvec3 a(scene_.vertex_m[corner.x]);
  const glm::dvec3 b(scene_.vertex_m[corner.y]);
  const glm::dvec3 c(scene_.vertex_m[corner.z]);
  const double u = static_cast<double>(query.hit.u);
  const double v = static_cast<double>(query.hit.v);
  hit.position_m = a + u * (b - a) + v * (c - a);
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  hit.normal = glm::dot(normal, direction) < 0.0 ? normal : -normal;
  return true;
}

bool Tracer::is_blocked(const glm::dvec3& from_m, const glm::dvec3& to_m) const {
  SegmentPacket packet;
  packet.to_x[0] = static_cast<float>(to_m.x);
  packet.to_y[0] = static_cast<float>(to_m.y);
  packet.to_z[0] = static_cast<float>(to_m.z);
  packet.count = 1;
  return blocked(glm::vec3(from_m), packet) != 0;
}

std::uint32_t Tracer::blocked(const glm::vec3& from_m, const SegmentPacket& packet) const {
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
    const float dx = is_used ? packet.to_x[i] - from_m.x : 0.0f;
    const float dy = is_used ? packet.to_y[i] - from_m.y : 0.0f;
    const float dz = is_used ? packet.to_z[i] - from_m.z : 1.0f;
    const float margin = offset / std::sqrt(dx * dx + dy * dy + dz * dz);
    ray.org_x[k] = from_m.x;
    ray.org_y[k] = from_m.y;
    ray.org_z[k] = from_m.z;
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
