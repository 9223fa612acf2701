// Short rays by OpenGL against the CPU's, ray by ray.
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/terms/path_terms.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/near_points.h"
#include "tests/support/opengl.h"
#include "tests/support/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gpu_near_test {
namespace {

using namespace test_support;
using ::testing::HasSubstr;

struct Cast {
  bool is_hit;
  calc::SurfaceHit at;
};

std::vector<Cast> cast_by_cpu(const calc::Tracer& tracer, float least_m, float most_m,
                              const std::vector<calc::NearFieldRequest>& requests) {
  std::vector<Cast> casts;
  for (const calc::NearFieldRequest& request : requests) {
    const calc::ScrambledSobol sobol(request.key);
    for (std::uint32_t first = 0; first < request.rays; first += calc::RayPacket::kSize) {
      calc::RayPacket packet;
      for (std::uint32_t k = first; k < request.rays && !packet.is_full(); ++k) {
        const auto u = sobol.sample_pair(k, 0);
        const bool has_back = calc::has_back(request.receiver.kernel);
        packet.add(tracer.lift(request.receiver),
                   has_back ? calc::cosine_direction(request.receiver.axis, u[0], u[1])
                            : calc::sphere_direction(u[0], u[1]));
      }
      std::array<calc::SurfaceHit, calc::RayPacket::kSize> hit;
      const std::uint32_t hits = tracer.closest_hits(packet, least_m, most_m, hit);
      for (int k = 0; k < packet.count; ++k) {
        casts.push_back({((hits >> k) & 1u) != 0, hit[static_cast<std::size_t>(k)]});
      }
    }
  }
  return casts;
}

TEST(GlShortRays, MeetWhatTheCpuMeets) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const calc::Tracer tracer(hall.scene);
  const auto gl = gl_short_rays();
  const auto least_m = static_cast<float>(tracer.offset_m());
  const NearPoints points = points_in_hall(1000, 100);
  std::size_t total = 0, differing = 0, met = 0;
  double largest = 0.0;
  for (const float most_m : {0.5f, 2.0f, 1e30f}) {
    const double begin_s = calc::now_s();
    const std::vector<Cast> expected = cast_by_cpu(tracer, least_m, most_m, points.requests);
    const double middle_s = calc::now_s();
    std::vector<calc::FirstHit> hits(expected.size());
    gl->cast(tracer, least_m, most_m, points.batch(), hits);
    const double end_s = calc::now_s();
    for (std::size_t k = 0; k < hits.size(); ++k) {
      ++total;
      const bool is_hit = hits[k].triangle_and_side != calc::FirstHit::kNothing;
      if (is_hit) ++met;
      if (is_hit != expected[k].is_hit) {
        ++differing;
      } else if (is_hit) {
        const calc::SurfaceHit hit = tracer.surface_hit(hits[k]);
        const double distance = glm::distance(hit.position_m, expected[k].at.position_m);
        if (distance > 1e-5 * hall.scene.extent_m ||
            glm::distance(hit.normal, expected[k].at.normal) > 1e-6) {
          ++differing;
        } else {
          largest = std::max(largest, distance);
        }
      }
    }
    std::printf("reach %.2g m: %.3g us/ray, %.3g on the CPU\n", static_cast<double>(most_m),
                1e6 * (end_s - middle_s) / static_cast<double>(hits.size()),
                1e6 * (middle_s - begin_s) / static_cast<double>(hits.size()));
  }
  std::printf("%zu of %zu rays differ, %zu hits, places within %.2g of the extent\n", differing,
              total, met, largest / hall.scene.extent_m);
  EXPECT_EQ(total, 300'000u);
  EXPECT_GT(met, 100'000u);
  EXPECT_LE(differing, total / 20'000);
}

TEST(GlShortRays, GiveTheSameBitsAgainAndOnManyThreads) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5), other(0.5, true);
  const calc::Tracer tracer(hall.scene), other_tracer(other.scene);
  const auto gl = gl_short_rays();
  const NearPoints points = points_in_hall(100, 16);
  const auto cast = [&](calc::ShortRayCaster& caster, const calc::Tracer& with) {
    std::vector<calc::FirstHit> hits(1600);
    caster.cast(with, 1e-4f, 3.0f, points.batch(), hits);
    std::vector<std::uint32_t> bits;
    for (const calc::FirstHit& hit : hits) {
      bits.push_back(hit.triangle_and_side);
      if (hit.triangle_and_side == calc::FirstHit::kNothing) continue;
      bits.push_back(std::bit_cast<std::uint32_t>(hit.u));
      bits.push_back(std::bit_cast<std::uint32_t>(hit.v));
    }
    return bits;
  };
  const auto once = cast(*gl, tracer), elsewhere = cast(*gl, other_tracer);
  EXPECT_NE(once, elsewhere);
  EXPECT_EQ(once, cast(*gl_short_rays(), tracer));
  std::vector<std::vector<std::uint32_t>> all(20);
  tbb::parallel_for(std::size_t{0}, all.size(),
                    [&](std::size_t k) { all[k] = cast(*gl, k % 2 == 0 ? tracer : other_tracer); });
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k], k % 2 == 0 ? once : elsewhere);
}

// A driver that leaves long loops early must not look like a free view: half sheets one above the
// other, whose boxes the rays meet and which they pass by.
TEST(GlShortRays, DoNotTakeALoopCutShortForAnAnswer) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene pile;
  for (int k = 0; k < 70'000; ++k) {
    const double z = 1e-3 * k;
    add_triangle(pile, {-500, -500, z}, {500, -500, z}, {-500, 500, z}, 0.5);
  }
  set_extent(pile);
  const calc::Tracer tracer(pile);
  const NearPoints points({{{250, 250, 90}, {0, 0, -1}, calc::ReceiverKernel::planar}}, 16);
  const std::vector<Cast> expected = cast_by_cpu(tracer, 0.0f, 1e30f, points.requests);
  std::vector<calc::FirstHit> hits(16);
  const auto device = gl_device();
  try {
    gpu::make_gl_short_rays(device)->cast(tracer, 0.0f, 1e30f, points.batch(), hits);
  } catch (const calc::BackendFailure& failure) {
    EXPECT_TRUE(device->device().is_software);
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
    return;
  }
  for (std::size_t k = 0; k < hits.size(); ++k) {
    EXPECT_EQ(hits[k].triangle_and_side != calc::FirstHit::kNothing, expected[k].is_hit);
  }
}

TEST(GlShortRays, FailWithAReason) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const calc::Tracer tracer(hall.scene);
  const NearPoints points = points_in_hall(2, 4);
  for (const auto& [fault, text] : {std::pair{gpu::Fault::out_of_memory, "out of memory"},
                                    {gpu::Fault::context_lost, "reset"},
                                    {gpu::Fault::fence_lost, "has not answered"}}) {
    const auto gl = gl_short_rays(fault);
    for (int k = 0; k < 2; ++k) {  // not only the first time
      std::vector<calc::FirstHit> hits(8);
      try {
        gl->cast(tracer, 0.0f, 1.0f, points.batch(), hits);
        ADD_FAILURE() << text;
      } catch (const calc::BackendFailure& failure) {
        EXPECT_THAT(failure.what(), HasSubstr(text));
      }
    }
  }
}

// Hits of the cast before lie where those that do not come should be.
TEST(GlShortRays, TakeNoEarlierHits) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const calc::Tracer tracer(hall.scene);
  const NearPoints points = points_in_hall(20, 4);
  std::vector<calc::FirstHit> hits(80);
  const auto gl = gl_short_rays(gpu::Fault::results_lost);
  gl->cast(tracer, 0.0f, 1e30f, points.batch(), hits);
  try {
    gl->cast(tracer, 0.0f, 1e30f, points.batch(), hits);
    ADD_FAILURE();
  } catch (const calc::BackendFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did not finish"));
  }
}

// A driver older than OpenGL 4.4.
TEST(GlShortRays, GiveTheSameBitsWithoutBufferStorage) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  const calc::Tracer tracer(hall.scene);
  const NearPoints points = points_in_hall(20, 4);
  std::vector<calc::FirstHit> a(80), b(80);
  gl_short_rays()->cast(tracer, 0.0f, 1e30f, points.batch(), a);
  gl_short_rays(gpu::Fault::no_buffer_storage)->cast(tracer, 0.0f, 1e30f, points.batch(), b);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].triangle_and_side, b[k].triangle_and_side);
    if (a[k].triangle_and_side == calc::FirstHit::kNothing) continue;
    EXPECT_EQ(a[k].u, b[k].u);
    EXPECT_EQ(a[k].v, b[k].v);
  }
}

}  // namespace
}  // namespace gpu_near_test
