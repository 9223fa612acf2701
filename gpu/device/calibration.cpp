#include "gpu/device/calibration.h"

#include "calc/base/units.h"
#include "calc/photometry/web.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/gather_pass.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// In the place of a shader's source: what is measured, by which version of it.
constexpr std::string_view kKept = "luxgate rates 1";

constexpr std::pair<std::string_view, double calc::DeviceRates::*> kRates[] = {
    {"any-hit", &calc::DeviceRates::any_hit_per_s},
    {"closest-hit", &calc::DeviceRates::closest_hit_per_s},
    {"path-rays", &calc::DeviceRates::path_rays_per_s},
    {"up-bytes", &calc::DeviceRates::up_bytes_per_s},
    {"down-bytes", &calc::DeviceRates::down_bytes_per_s},
    {"round-trip", &calc::DeviceRates::round_trip_s},
    {"open", &calc::DeviceRates::open_s}};

bool is_whole(const calc::DeviceRates& rates) {
  return std::all_of(std::begin(kRates), std::end(kRates),
                     [&](const auto& rate) { return rates.*rate.second > 0.0; });
}

void add_box(calc::PreparedScene& scene, const glm::vec3& low, const glm::vec3& size) {
  const auto first = static_cast<std::uint32_t>(scene.vertex_m.size());
  for (int k = 0; k < 8; ++k) {
    scene.vertex_m.push_back(low + size * glm::vec3(k & 1, (k >> 1) & 1, k >> 2));
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  for (const auto& f : kFaces) {
    scene.triangle.emplace_back(first + f[0], first + f[1], first + f[2]);
    scene.triangle.emplace_back(first + f[0], first + f[2], first + f[3]);
    for (int k = 0; k < 2; ++k) {
      scene.reflectance.push_back(0.6);
      scene.body.push_back(0);
    }
  }
}

// A hall of 12 x 8 x 3 m with a hundred boxes of the height of desks: 1200 triangles, like the
// furnished offices that most projects are.
struct CalibrationRoom {
  calc::PhotometricWeb web = calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi / 4, calc::kPi / 2},
                                                        {300.0, 212.0, 0.0}, {}, {});
  calc::PreparedScene scene;

  CalibrationRoom() {
    add_box(scene, {-6.0f, -4.0f, 0.0f}, {12.0f, 8.0f, 3.0f});
    for (int k = 0; k < 100; ++k) {
      const auto x = static_cast<float>(k % 10), y = static_cast<float>(k / 10);
      add_box(scene, {1.1f * x - 5.4f, 0.75f * y - 3.7f, 0.0f}, {0.6f, 0.4f, 0.72f});
    }
    calc::PlacedLuminaire lamp{};
    lamp.position_m = {0.3, 0.2, 2.9};
    lamp.web = &web;
    lamp.opening = web.opening();
    scene.luminaires.push_back(lamp);
    scene.channels.push_back({"", 1.0});
    scene.extent_m = std::sqrt(12.0 * 12.0 + 8.0 * 8.0 + 3.0 * 3.0);
  }
  CalibrationRoom(const CalibrationRoom&) = delete;
  CalibrationRoom& operator=(const CalibrationRoom&) = delete;
};

class Calibration {
 public:
  Calibration(std::shared_ptr<DeviceThread> thread, double end_s)
      : thread_(std::move(thread)), end_s_(end_s) {}

  calc::DeviceRates run(double context_s, bool keeps_programs) {
    measure_way();
    measure_any_hit();
    measure_closest_hit();
    measure_paths();
    // A program that is kept loads in next to no time.
    rates_.open_s = context_s + (keeps_programs ? 0.1 : 1.0) * programs_s_;
    return rates_;
  }

 private:
  // Seconds for each of `items`, more of them until the device is busy for long enough to tell; 0
  // where time runs out. The first call, which compiles and sends, is left out.
  double seconds_each(std::size_t first_items, std::size_t most_items,
                      const std::function<void(std::size_t)>& work) {
    constexpr double kEnough_s = 0.02;
    if (calc::is_past(end_s_)) return 0.0;
    const double begin_s = calc::now_s();
    work(first_items);
    const double first_s = calc::now_s() - begin_s;
    double each_s = 0.0;
    for (std::size_t items = first_items; !calc::is_past(end_s_);) {
      const double turn_s = calc::now_s();
      std::size_t done = 0;
      // At the largest size again and again.
      do {
        work(items);
        done += items;
      } while (items == most_items && calc::now_s() - turn_s < kEnough_s && !calc::is_past(end_s_));
      const double took_s = calc::now_s() - turn_s;
      each_s = took_s / static_cast<double>(done);
      if (items == first_items) programs_s_ += std::max(0.0, first_s - took_s);
      if (items == most_items || took_s >= kEnough_s) break;
      items = std::min(most_items, 4 * items);
    }
    return each_s;
  }

  static double per_s(double each_s) { return each_s > 0.0 ? 1.0 / each_s : 0.0; }

  void measure_way() {
    constexpr std::size_t kMost = std::size_t{1} << 25;
    std::vector<std::byte> bytes(kMost);
    std::unique_ptr<GlBuffer> buffer;
    const auto with_buffer = [&](const std::function<void()>& use) {
      thread_->run([&](DeviceState& device) {
        if (!buffer) {
          buffer = std::make_unique<GlBuffer>("calibration");
          buffer->reserve(kMost);
        }
        use();
        device.check("measuring");
      });
    };
    try {
      rates_.round_trip_s = seconds_each(1, 16, [&](std::size_t times) {
        for (std::size_t k = 0; k < times; ++k) {
          with_buffer([&] {
            buffer->write(0, std::span(bytes).first(4096));
            buffer->fill(4096, 0);
            buffer->read(0, std::span(bytes).first(4096));
          });
        }
      });
      rates_.up_bytes_per_s = per_s(seconds_each(kMost / 64, kMost, [&](std::size_t size) {
        with_buffer([&] {
          buffer->write(0, std::span(bytes).first(size));
          glFinish();
        });
      }));
      rates_.down_bytes_per_s = per_s(seconds_each(kMost / 64, kMost, [&](std::size_t size) {
        with_buffer([&] { buffer->read(0, std::span(bytes).first(size)); });
      }));
    } catch (...) {
      thread_->clean_up([&](DeviceState&) { buffer.reset(); });
      throw;
    }
    thread_->clean_up([&](DeviceState&) { buffer.reset(); });
  }

  // Receivers on the floor between the boxes and above, vertices at the ceiling; what is sent for
  // each connection is measured without rays and taken off.
  void measure_any_hit() {
    constexpr std::uint32_t kEnds = 4096;
    calc::LightVertices vertices;
    std::vector<calc::Receiver> receivers;
    for (std::uint32_t k = 0; k < kEnds; ++k) {
      const calc::RandomKey key = calc::RandomKey(1).with(k);
      const auto place = [&](int n, double low_z_m, double high_z_m) {
        const calc::RandomKey at = key.with(static_cast<std::uint64_t>(n));
        return glm::dvec3{11.8 * at.with(0).uniform() - 5.9, 7.8 * at.with(1).uniform() - 3.9,
                          low_z_m + (high_z_m - low_z_m) * at.with(2).uniform()};
      };
      receivers.push_back({place(0, 0.01, 1.0), {0, 0, 1}, calc::ReceiverKernel::planar});
      vertices.push_back({glm::vec3(place(1, 1.0, 2.99)), 1.0f, {0, 0, -1}, 0});
    }
    const std::vector<GpuReceiver> sent = gpu_receivers(tracer_, receivers);
    std::vector<calc::Connection> connections;
    for (std::uint32_t k = 0; k < GatherPass::kMostConnections; ++k) {
      // Neighbours in the list share a receiver, as draws of a point do.
      connections.push_back({k / 64 % kEnds, (k * 2654435761u) % kEnds, 1.0f});
    }
    std::vector<std::uint32_t> results(connections.size());
    std::unique_ptr<GatherPass> pass;
    DevicePools pools;
    const std::uint64_t identity = calc::new_identity();
    const auto each_s = [&](bool has_shadows) {
      return seconds_each(connections.size() / 64, connections.size(), [&](std::size_t count) {
        thread_->run([&](DeviceState& device) {
          if (!pass) pass = std::make_unique<GatherPass>();
          GatherJob job;
          job.tracer = &tracer_;
          job.vertices = vertices;
          job.vertices_identity = identity;
          job.receivers = sent;
          job.connections = std::span(connections).first(count);
          job.bounded_from_per_m2 = 1e9f;
          job.has_shadows = has_shadows;
          job.results = std::span(results).first(count);
          pass->run(device, pools, job);
        });
        if (std::find(results.begin(), results.begin() + static_cast<std::ptrdiff_t>(count),
                      kNotDone) != results.begin() + static_cast<std::ptrdiff_t>(count)) {
          throw_not_done();
        }
      });
    };
    const auto hand_back = [&] {
      thread_->clean_up([&](DeviceState&) {
        pass.reset();
        pools.clear();
      });
    };
    try {
      const double bare_s = each_s(false), whole_s = bare_s > 0.0 ? each_s(true) : 0.0;
      // The way cannot be all of it.
      rates_.any_hit_per_s = per_s(std::max(whole_s - bare_s, 0.05 * whole_s));
    } catch (...) {
      hand_back();
      throw;
    }
    hand_back();
  }

  void measure_closest_hit() {
    constexpr std::uint32_t kRays = 64;
    const std::unique_ptr<calc::ShortRayCaster> caster = make_gl_short_rays(thread_);
    const calc::RandomKey key(2);
    std::vector<calc::ReceiverGroup> tiles;
    std::vector<calc::PointRays> points;
    for (std::uint32_t k = 0; k < calc::kShortRaysPerCast / kRays; ++k) {
      const auto u = [&](std::uint64_t of) { return key.with(k).with(of).uniform(); };
      if (k % 32 == 0) tiles.emplace_back();
      tiles.back().point.push_back(k);
      tiles.back().receiver.push_back({{11.8 * u(0) - 5.9, 7.8 * u(1) - 3.9, 0.01 + u(2)},
                                       {0, 0, 1},
                                       calc::ReceiverKernel::planar});
      points.push_back({k, kRays});
    }
    const calc::ReceiverTiles all(std::move(tiles));
    std::vector<calc::FirstHit> hits(calc::kShortRaysPerCast);
    const double each_s = seconds_each(points.size() / 64, points.size(), [&](std::size_t count) {
      caster->cast(tracer_, 1e-4f, 1.0f, {all, key, std::span(points).first(count)},
                   std::span(hits).first(count * kRays));
    });
    rates_.closest_hit_per_s = kRays * per_s(each_s);
  }

  void measure_paths() {
    const std::unique_ptr<calc::PathTracer> tracer = make_gl_path_tracer(thread_);
    const calc::Emitter emitter(room_.scene);
    double rays_per_path = 0.0;
    const double each_s = seconds_each(512, 32768, [&](std::size_t paths) {
      calc::PathBatch batch{1, 0, 0, static_cast<std::uint32_t>(paths)};
      batch.deadline_s = end_s_;
      rays_per_path = static_cast<double>(tracer->trace(tracer_, emitter, batch).rays) /
                      static_cast<double>(paths);
    });
    // What the deadline ends is not done.
    if (!calc::is_past(end_s_)) rates_.path_rays_per_s = rays_per_path * per_s(each_s);
  }

  const std::shared_ptr<DeviceThread> thread_;
  const double end_s_;
  const CalibrationRoom room_;
  const calc::Tracer tracer_{room_.scene};
  calc::DeviceRates rates_;
  double programs_s_ = 0.0;
};

}  // namespace

std::string rates_text(const calc::DeviceRates& rates) {
  std::string text;
  for (const auto& [name, member] : kRates) {
    text += fmt::format("{} {}\n", name, rates.*member);
  }
  return text;
}

std::optional<calc::DeviceRates> read_rates(std::string_view text) {
  calc::DeviceRates rates;
  for (const auto& [name, member] : kRates) {
    if (!text.starts_with(name) || text.size() <= name.size() || text[name.size()] != ' ') {
      return std::nullopt;
    }
    text.remove_prefix(name.size() + 1);
    double& value = rates.*member;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || value < 0.0) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.starts_with('\n')) return std::nullopt;
    text.remove_prefix(1);
  }
  return text.empty() ? std::optional(rates) : std::nullopt;
}

std::optional<calc::DeviceRates> kept_rates(const Device& device,
                                            const std::filesystem::path& program_folder) {
  const auto kept = ProgramCache(program_folder, device.driver_key()).find(kKept);
  if (!kept) return std::nullopt;
  std::string text;
  for (const std::byte byte : kept->bytes) text += static_cast<char>(byte);
  return read_rates(text);
}

std::optional<calc::DeviceRates> measured_rates(const DeviceRequest& request, double limit_s,
                                                std::string& problem) {
  const double begin_s = calc::now_s();
  const std::shared_ptr<DeviceThread> thread = DeviceThread::open(request, problem);
  if (!thread) return std::nullopt;
  const double context_s = calc::now_s() - begin_s;
  if (const auto kept = kept_rates(thread->device(), request.program_folder)) return kept;
  try {
    const calc::DeviceRates rates =
        Calibration(thread, begin_s + limit_s).run(context_s, !request.program_folder.empty());
    if (!is_whole(rates)) return rates;  // another run may get further
    const std::string text = rates_text(rates);
    ProgramBinary binary;
    const auto bytes = std::as_bytes(std::span(text));
    binary.bytes.assign(bytes.begin(), bytes.end());
    ProgramCache(request.program_folder, thread->device().driver_key()).keep(kKept, binary);
    return rates;
  } catch (const calc::BackendFailure& failure) {
    problem = failure.what();
    return std::nullopt;
  }
}

}  // namespace gpu
