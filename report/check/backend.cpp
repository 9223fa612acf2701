#include "report/check/backend.h"

#include "gpu/device/calibration.h"
#include "gpu/raster/shadow_map_gatherer.h"
#include "gpu/rays/gl_direct_tracer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"
#include "report/check/drawing_device.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace check {
namespace {

constexpr std::pair<std::string_view, bool GpuStages::*> kGpuStages[] = {
    {"direct-light", &GpuStages::direct_light},
    {"light-paths", &GpuStages::light_paths},
    {"connections", &GpuStages::connections},
    {"near-field", &GpuStages::near_field}};

std::string describe(const gpu::Device& device, const GpuStages& stages) {
  const std::string gpu =
      fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  const GpuStages rest{!stages.direct_light, !stages.light_paths, !stages.connections,
                       !stages.near_field};
  if (stages == GpuStages()) return gpu;
  return fmt::format("{}: {}; cpu: {}", gpu, fmt::join(gpu_stage_names(stages), ", "),
                     fmt::join(gpu_stage_names(rest), ", "));
}

// Measuring takes a second: less than that cannot be won by it.
constexpr double kWorthMeasuring_s = gpu::kCalibrationLimit_s;

std::string stage_times(const calc::Seconds& s) {
  return fmt::format(
      "direct light {:.2g}, light paths {:.2g}, connections {:.2g}, near field {:.2g}", s.direct,
      s.pool, s.connect, s.near_field);
}

std::string rates_words(const std::optional<calc::DeviceRates>& rates) {
  const calc::DeviceRates used = calc::with_assumptions(rates.value_or(calc::DeviceRates{}));
  const std::string numbers = fmt::format(
      "{:.2g} any-hit rays/s, {:.2g} closest-hit rays/s, {:.2g} rays of light paths/s, {:.2g} B/s "
      "up, "
      "{:.2g} B/s down, {:.2g} s a round trip",
      used.any_hit_per_s, used.closest_hit_per_s, used.path_rays_per_s, used.up_bytes_per_s,
      used.down_bytes_per_s, used.round_trip_s);
  if (!rates) return "rates are assumed, none was measured on it: " + numbers;
  return (used == *rates ? "rates were measured on it: "
                         : "some rates were measured on it, the rest is assumed: ") +
         numbers;
}

}  // namespace

std::vector<std::string_view> gpu_stage_names(const GpuStages& stages) {
  std::vector<std::string_view> names;
  for (const auto& [name, member] : kGpuStages) {
    if (stages.*member) names.push_back(name);
  }
  return names;
}

bool GpuStages::*find_gpu_stage(std::string_view name) {
  for (const auto& [known, member] : kGpuStages) {
    if (known == name) return member;
  }
  return nullptr;
}

std::optional<gpu::Fault> find_gl_fault(std::string_view name) {
  if (name.empty()) return gpu::Fault::none;
  if (name == "no-egl") return gpu::Fault::no_egl;
  if (name == "out-of-memory") return gpu::Fault::out_of_memory;
  if (name == "context-lost") return gpu::Fault::context_lost;
  if (name == "fence-lost") return gpu::Fault::fence_lost;
  if (name == "results-lost") return gpu::Fault::results_lost;
  if (name == "no-buffer-storage") return gpu::Fault::no_buffer_storage;
  return std::nullopt;
}

BackendChoice choose_automatically(const gpu::DeviceList& hardware,
                                   const std::function<calc::DeviceWork()>& work,
                                   const RatesOf& rates_of) {
  const int device = gpu::hardware_device(hardware);
  if (device < 0) {
    return {Backend::cpu, -1,
            why_no_hardware(hardware, "is software, slower than the CPU backend")};
  }
  const gpu::Device& found = hardware.devices[static_cast<std::size_t>(device)];
  const calc::DeviceWork amount = work();
  const GpuStages possible;
  const calc::DeviceCost ideal = calc::weigh_ideal_device(amount, possible);
  const std::string on_cpu =
      fmt::format("first looks take some {:.2g} s on {} thread{} ({})", ideal.cpu_s(),
                  amount.threads, amount.threads == 1 ? "" : "s", stage_times(ideal.cpu));
  if (!calc::is_device_worth_it(ideal)) {
    return {Backend::cpu, -1,
            fmt::format("too little work for {}: {}, {:.2g} s or more with the fastest of devices",
                        found.renderer, on_cpu, ideal.device_s())};
  }
  std::string problem;
  const std::optional<calc::DeviceRates> rates =
      rates_of(found, ideal.cpu_s() - ideal.device_s() > kWorthMeasuring_s, problem);
  if (!problem.empty()) {
    return {
        Backend::cpu, -1,
        fmt::format("OpenGL device {} failed when its speed was measured: {}", device, problem)};
  }
  const calc::DeviceCost cost = calc::weigh_device(
      amount, calc::with_assumptions(rates.value_or(calc::DeviceRates{})), possible);
  const bool is_worth_it = calc::is_device_worth_it(cost);
  const std::string why = fmt::format(
      "{} work for {}: {}, {:.2g} s with it ({:.2g} to open it, {:.2g} to send the scene, {}); {}",
      is_worth_it ? "enough" : "too little", found.renderer, on_cpu, cost.device_s(), cost.open_s,
      cost.send_s, stage_times(cost.with_device), rates_words(rates));
  if (!is_worth_it) return {Backend::cpu, -1, why};
  return {Backend::gpu, device, why, cost.stages};
}

BackendChoice choose_backend(const BackendRequest& request, std::uint32_t shadow_map_texels,
                             Hardware& hardware, const std::function<calc::DeviceWork()>& work) {
  if (shadow_map_texels > 0) {
    // Maps make the connections, whatever else is chosen; instant radiosity has no near field.
    const GpuStages wanted = request.stages.value_or(GpuStages{false, false, true, false});
    BackendChoice choice{
        Backend::gpu, request.gl_device, "--visibility shadow-map draws with OpenGL",
        GpuStages{wanted.direct_light, wanted.light_paths, true, false}, shadow_map_texels};
    if (request.backend == Backend::automatic) {
      const DrawingChoice drawing = choose_to_draw(hardware, [&] { return work().drawing; });
      choice.device = drawing.device;
      choice.why +=
          fmt::format("; {}: {}", drawing.is_hardware ? "a GPU" : "software", drawing.why);
    }
    return choice;
  }
  if (request.backend != Backend::automatic) {
    return {request.backend, request.gl_device, "selected with --backend",
            request.stages.value_or(GpuStages())};
  }
  return choose_automatically(hardware.list(), work, hardware.rates_of());
}

std::string backend_line(const BackendChoice& choice) {
  if (choice.backend != Backend::gpu) return fmt::format("backend: cpu: {}\n", choice.why);
  return fmt::format("backend: gpu: {}\ngpu stages: {}\n", choice.why,
                     fmt::join(gpu_stage_names(choice.stages), ", "));
}

std::optional<OpenBackend> open_backend(const BackendChoice& choice, gpu::Fault fault,
                                        const std::string& program_folder, std::string& problem,
                                        std::string& warning) {
  OpenBackend backend;
  if (choice.backend != Backend::gpu) {
    backend.gatherer = calc::make_cpu_gatherer();
    backend.description = backend.gatherer->description();
    backend.identity = backend.description;
    return backend;
  }
  const auto thread = gpu::DeviceThread::open({choice.device, fault, program_folder}, problem);
  if (!thread) return std::nullopt;
  if (thread->device().is_software && choice.device != gpu::kPreferSoftware) {
    warning = thread->device().renderer;
    const std::string advice =
        choice.device < 0 ? gpu::missing_hardware_advice(fault) : std::string();
    if (!advice.empty()) warning += "; " + advice;
  }
  const GpuStages& stages = choice.stages;
  if (choice.shadow_map_texels > 0) {
    backend.gatherer = gpu::make_shadow_map_gatherer(thread, choice.shadow_map_texels);
  } else {
    backend.gatherer =
        stages.connections ? gpu::make_gl_gatherer(thread) : calc::make_cpu_gatherer();
  }
  if (stages.light_paths) backend.path_tracer = gpu::make_gl_path_tracer(thread);
  if (stages.near_field) backend.short_rays = gpu::make_gl_short_rays(thread);
  if (stages.direct_light) backend.direct_tracer = gpu::make_gl_direct_tracer(thread);
  if (choice.shadow_map_texels == 0) {
    backend.description = describe(thread->device(), stages);
  } else {
    backend.description = backend.gatherer->description();
    if (stages.light_paths) backend.description += "; light paths too";
    if (stages.direct_light) backend.description += "; direct light too";
  }
  backend.device = thread;
  const gpu::Device& device = thread->device();
  backend.identity = fmt::format("{}; {}; {}; {}", backend.description, device.vendor,
                                 device.renderer, device.version);
  return backend;
}

}  // namespace check
