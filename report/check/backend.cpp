#include "report/check/backend.h"

#include "calc/forecast/cost_model.h"
#include "calc/rays/triangle_tree.h"
#include "gpu/gl_path_tracer.h"
#include "gpu/gl_short_rays.h"
#include "gpu/shadow_map_gatherer.h"
#include "report/text/number_format.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace check {
namespace {

constexpr std::pair<std::string_view, bool GpuStages::*> kGpuStages[] = {
    {"light-paths", &GpuStages::light_paths},
    {"connections", &GpuStages::connections},
    {"near-field", &GpuStages::near_field}};

std::string why_no_hardware(const gpu::DeviceList& hardware) {
  std::string text = hardware.problem;
  const auto add = [&](const std::string& part) { text += text.empty() ? part : "; " + part; };
  for (const gpu::Device& device : hardware.devices) {
    add(fmt::format("OpenGL device {} {}", device.index,
                    device.is_software ? "is software, slower than the CPU backend"
                                       : "cannot be used: " + device.problem));
  }
  if (!hardware.advice.empty()) add(hardware.advice);
  return text;
}

std::string describe(const gpu::Device& device, const GpuStages& stages) {
  const std::string gpu =
      fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  const GpuStages rest{!stages.light_paths, !stages.connections, !stages.near_field};
  if (stages == GpuStages()) return gpu;
  return fmt::format("{}: {}; cpu ({}): {}", gpu, fmt::join(gpu_stage_names(stages), ", "),
                     calc::tree_builder_version(), fmt::join(gpu_stage_names(rest), ", "));
}

// None of the device's was measured on hardware. Cores: of the machine that a GPU is likely to
// share, so that the answer is the same for any number of threads.
constexpr double kCores = 16.0;
constexpr double kOpen_s = 0.4;                // a context, programs; 0.15 to 0.5
constexpr double kDeviceConnection_ns = 1.0;   // assumed
constexpr double kBesideConnection_ns = 20.0;  // of one core: groups, packing [bench_gpu]
constexpr double kVertex_ns = 15.0;            // some 90 bytes, by one thread
constexpr double kTriangle_ns = 300.0;         // the tree

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

BackendCost backend_cost(const GatherWork& work) {
  BackendCost cost;
  cost.cpu_s = 1e-9 * calc::kConnection_ns / kCores * work.connections;
  cost.open_s = kOpen_s;
  cost.send_s = 1e-9 * (kVertex_ns * work.vertices + kTriangle_ns * work.triangles);
  cost.gather_s = 1e-9 * (kDeviceConnection_ns + kBesideConnection_ns / kCores) * work.connections;
  return cost;
}

std::optional<gpu::Fault> find_gl_fault(std::string_view name) {
  if (name.empty()) return gpu::Fault::none;
  if (name == "no-egl") return gpu::Fault::no_egl;
  if (name == "out-of-memory") return gpu::Fault::out_of_memory;
  if (name == "context-lost") return gpu::Fault::context_lost;
  return std::nullopt;
}

BackendChoice choose_automatically(const gpu::DeviceList& hardware,
                                   const std::function<GatherWork()>& work) {
  const int device = gpu::hardware_device(hardware);
  if (device < 0) return {Backend::cpu, -1, why_no_hardware(hardware)};
  const std::string name = hardware.devices[static_cast<std::size_t>(device)].renderer;
  const GatherWork amount = work();
  const BackendCost cost = backend_cost(amount);
  const bool is_worth_it = cost.gpu_s() < cost.cpu_s;
  const std::string why = fmt::format(
      "{} work for {}: {} connections in the first look take some {:.2g} s on {} processor cores, "
      "{:.2g} s with it: {:.2g} s to open it, {:.2g} s to send scene and light vertices, {:.2g} s "
      "to "
      "gather",
      is_worth_it ? "enough" : "too little", name,
      report::format_count(static_cast<std::uint64_t>(std::llround(amount.connections))),
      cost.cpu_s, kCores, cost.gpu_s(), cost.open_s, cost.send_s, cost.gather_s);
  if (!is_worth_it) return {Backend::cpu, -1, why};
  return {Backend::gpu, device, why};
}

BackendChoice choose_backend(const BackendRequest& request, std::uint32_t shadow_map_texels,
                             gpu::Fault fault, const std::function<GatherWork()>& work) {
  if (shadow_map_texels > 0) {
    // Maps make the connections, whatever else is chosen; instant radiosity has no near field.
    const GpuStages wanted = request.stages.value_or(GpuStages{false, true, false});
    return {Backend::gpu, request.gl_device, "--visibility shadow-map draws with OpenGL",
            GpuStages{wanted.light_paths, true, false}, shadow_map_texels};
  }
  if (request.backend != Backend::automatic) {
    return {request.backend, request.gl_device, "asked for with --backend",
            request.stages.value_or(GpuStages())};
  }
  return choose_automatically(gpu::list_hardware(fault), work);
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
  if (thread->device().is_software) {
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
  if (choice.shadow_map_texels == 0) {
    backend.description = describe(thread->device(), stages);
  } else {
    backend.description = backend.gatherer->description();
    if (stages.light_paths) backend.description += "; light paths too";
  }
  const gpu::Device& device = thread->device();
  backend.identity = fmt::format("{}; {}; {}; {}", backend.description, device.vendor,
                                 device.renderer, device.version);
  return backend;
}

}  // namespace check
