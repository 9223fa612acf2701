// Speed of light paths, short rays and the light at their hits by CPU and by OpenGL, and the
// processor time that the device's work costs outside the device: what a fast GPU would wait for.
// Of the thread that owns the context, which all others wait for, and of the caller's, of which
// there may be many. What llvmpipe fills and copies inside OpenGL's calls a GPU would do itself;
// what a GPU's driver costs there is not known.
//   bench_gpu_stages [paths] [rays per point]
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"
#include "tests/bench/gl_clock.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/near_points.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

// Mesa traces on threads of its own.
struct Busy {
  double caller_s, device_s, opengl_s;  // device_s: but for OpenGL

  static Busy so_far(gpu::DeviceThread& device) {
    Busy busy{bench::thread_s(), 0.0, 0.0};
    device.run([&](gpu::DeviceState&) {
      const bench::OpenGlTime opengl = bench::opengl_time();
      busy.device_s = bench::thread_s() - opengl.calls_s - opengl.clock_s;
      busy.opengl_s = opengl.calls_s;
    });
    return busy;
  }
};

void measure(const char* name, gpu::DeviceThread& device, double items,
             const std::function<void()>& cpu, const std::function<void()>& gl) {
  const double begin_s = calc::now_s();
  cpu();
  const double cpu_s = calc::now_s() - begin_s;
  // The driver compiles, and memory to read back grows, of which there is more than one.
  for (int k = 0; k < 3; ++k) gl();
  const Busy before = Busy::so_far(device);
  const double gl_begin_s = calc::now_s();
  gl();
  const double gl_s = calc::now_s() - gl_begin_s;
  const Busy after = Busy::so_far(device);
  const auto us_each = [&](double s) { return 1e6 * s / items; };
  fmt::print("{}: cpu, one thread {:.3g} /s; {} {:.3g} /s\n", name, items / cpu_s,
             device.device().name(), items / gl_s);
  fmt::print(
      "  us each: the caller's thread {:.3g}, the device's {:.3g}, its OpenGL calls {:.3g}\n",
      us_each(after.caller_s - before.caller_s), us_each(after.device_s - before.device_s),
      us_each(after.opengl_s - before.opengl_s));
}

}  // namespace

int main(int argc, char** argv) {
  const auto paths = static_cast<std::uint32_t>(argc > 1 ? std::atoi(argv[1]) : 32768);
  const auto rays = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 32);
  std::string problem;
  const auto device = gpu::DeviceThread::open({}, problem);
  if (!device) {
    fmt::print("no OpenGL: {}\n", problem);
    return 2;
  }
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const test_support::LampHall hall(0.6);
  const calc::Tracer tracer(hall.scene);
  const calc::Emitter emitter(hall.scene);
  const auto path_tracer = gpu::make_gl_path_tracer(device);
  const auto short_rays = gpu::make_gl_short_rays(device);
  const calc::PathBatch batch{1, 0, 0, paths};
  std::size_t vertices = 0;
  measure(
      "light paths", *device, paths,
      [&] { vertices = calc::trace_light_paths(tracer, emitter, batch).vertices.size(); },
      [&] { path_tracer->trace(tracer, emitter, batch); });
  fmt::print("  {:.2f} vertices per path\n", static_cast<double>(vertices) / paths);

  std::vector<calc::Receiver> receivers;
  for (std::uint32_t i = 0; i < 8192; ++i) {
    const calc::RandomKey key = calc::RandomKey(3).with(i);
    receivers.push_back({{7.0 * key.with(0).uniform() - 3.5, 5.0 * key.with(1).uniform() - 2.5,
                          0.1 + key.with(2).uniform()},
                         {0, 0, 1},
                         calc::ReceiverKernel::planar});
  }
  const test_support::NearPoints open(receivers, rays);
  const float least_m = 1e-4f, most_m = 0.7f;
  std::vector<calc::FirstHit> hits(receivers.size() * rays);
  std::vector<calc::SurfaceHit> met;
  measure(
      "short rays", *device, static_cast<double>(hits.size()),
      [&] {
        std::array<calc::SurfaceHit, calc::RayPacket::kSize> hit;
        for (const calc::NearFieldRequest& request : open.requests) {
          const calc::ScrambledSobol sobol(request.key);
          for (std::uint32_t first = 0; first < rays; first += calc::RayPacket::kSize) {
            calc::RayPacket packet;
            for (std::uint32_t k = first; k < rays && !packet.is_full(); ++k) {
              const auto u = sobol.sample_pair(k, 0);
              packet.add(tracer.lift(request.receiver),
                         calc::cosine_direction(request.receiver.axis, u[0], u[1]));
            }
            if (tracer.closest_hits(packet, least_m, most_m, hit) == ~0u) met.push_back(hit[0]);
          }
        }
      },
      [&] { short_rays->cast(tracer, least_m, most_m, open.batch(), hits); });

  const test_support::NearScene scene(hall.scene, 4096);
  const test_support::NearPoints points = test_support::points_in_hall(2048, rays);
  calc::ShortRayLight found;
  std::uint64_t near_rays = 0;
  const auto add = [&](bool is_found) {
    near_rays = 0;
    for (std::size_t r = 0; r < points.requests.size(); ++r) {
      double sums[2] = {};
      float largest = 0.0f;
      std::optional<calc::PointLight> own;
      if (is_found) own = found.of(r);
      near_rays += calc::add_near_field(scene.near(), points.requests[r], own, sums, 1, largest);
    }
  };
  measure(
      "near field", *device, static_cast<double>(points.requests.size() * rays),
      [&] { add(false); },
      [&] {
        found = {};
        short_rays->find_light(scene.near(), points.batch(), found);
        add(true);
      });
  fmt::print(
      "  {:.4f} left to the processor and {:.2f} rays per short ray\n",
      static_cast<double>(found.left.size()) / static_cast<double>(points.requests.size() * rays),
      static_cast<double>(near_rays) / static_cast<double>(points.requests.size() * rays));
  return 0;
}
