// Rays of TriangleTree against those of Embree itself: two programs, one geometry. They may differ
// where single precision does: within a few units of its last place of an edge or of an end.
#include "calc/rays/triangle_tree.h"

#if LUXGATE_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace embree_test {
namespace {

struct EmbreeScene {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  EmbreeScene(const std::vector<glm::vec3>& vertex_m, const std::vector<glm::uvec3>& triangle) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                        sizeof(glm::vec3), vertex_m.size()),
                vertex_m.data(), sizeof(glm::vec3) * vertex_m.size());
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                        sizeof(glm::uvec3), triangle.size()),
                triangle.data(), sizeof(glm::uvec3) * triangle.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  static RTCRay ray_of(const calc::Ray& ray) {
    return {ray.origin.x,
            ray.origin.y,
            ray.origin.z,
            ray.least,
            ray.direction.x,
            ray.direction.y,
            ray.direction.z,
            0.0f,
            ray.most,
            ~0u,
            0,
            0};
  }
  bool is_blocked(const calc::Ray& ray) const {
    RTCRay query = ray_of(ray);
    // Embree 3 must be given a context; Embree 4 may be given options instead.
#if LUXGATE_EMBREE == 3
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &query);
#else
    rtcOccluded1(scene, &query, nullptr);
#endif
    return query.tfar < 0.0f;
  }
  // Distance, or infinity.
  float first(const calc::Ray& ray, std::uint32_t& triangle) const {
    RTCRayHit query{};
    query.ray = ray_of(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if LUXGATE_EMBREE == 3
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
#else
    rtcIntersect1(scene, &query, nullptr);
#endif
    triangle = query.hit.primID;
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity()
                                                       : query.ray.tfar;
  }
};

TEST(TriangleTree, FindsWhatEmbreeFinds) {
  std::mt19937 random(11);
  const auto at = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<glm::vec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  for (std::uint32_t n = 0; n < 2000; ++n) {
    const glm::vec3 a(at(-8, 8), at(-5, 5), at(-2, 2));
    for (const glm::vec3& corner : {a, a + glm::vec3(at(-1, 1), at(-1, 1), at(-1, 1)),
                                    a + glm::vec3(at(-1, 1), at(-1, 1), at(-1, 1))}) {
      vertex_m.push_back(corner);
    }
    triangle.emplace_back(3 * n, 3 * n + 1, 3 * n + 2);
  }
  const calc::TriangleTree tree(vertex_m, triangle);
  const EmbreeScene embree(vertex_m, triangle);
  constexpr int kRays = 200000;
  int blocked = 0, blocked_differs = 0, first_differs = 0;
  double farthest_off_m = 0.0;
  for (int n = 0; n < kRays; ++n) {
    const glm::vec3 from(at(-8, 8), at(-5, 5), at(-2, 2)), to(at(-8, 8), at(-5, 5), at(-2, 2));
    calc::Ray ray{from, to - from, 0.0f, 1.0f};
    const bool is_blocked = tree.blocked({&ray, 1}) != 0;
    blocked += is_blocked ? 1 : 0;
    if (is_blocked != embree.is_blocked(ray)) ++blocked_differs;
    ray.direction = glm::normalize(ray.direction);
    ray.most = std::numeric_limits<float>::infinity();
    calc::TriangleHit hit;
    const bool is_met = tree.first_hits({&ray, 1}, {&hit, 1}) != 0;
    std::uint32_t other = 0;
    const float distance = embree.first(ray, other);
    if (is_met != std::isfinite(distance) || (is_met && hit.triangle != other)) {
      ++first_differs;
    } else if (is_met) {
      farthest_off_m = std::max(farthest_off_m, std::abs(hit.t - static_cast<double>(distance)));
    }
  }
  // Both kinds of answers occur, so that agreement means something.
  EXPECT_GT(blocked, kRays / 5);
  EXPECT_LT(blocked, kRays - kRays / 20);
  // A ray comes within 1e-6 m of one of some hundred edges about once in ten thousand.
  EXPECT_LE(blocked_differs, 20);
  EXPECT_LE(first_differs, 20);
  EXPECT_LT(farthest_off_m, 1e-3);
}

}  // namespace
}  // namespace embree_test
