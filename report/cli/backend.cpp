#include "report/cli/backend.h"

#include "gpu/gl_path_tracer.h"
#include "gpu/gl_short_rays.h"
#include "report/cli/option_values.h"
#include "report/number_format.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cli {
namespace {

std::string why_no_hardware(const gpu::DeviceList& hardware) {
  if (!hardware.problem.empty()) return hardware.problem;
  std::string text;
  for (const gpu::Device& device : hardware.devices) {
    if (!text.empty()) text += "; ";
    text += fmt::format("OpenGL device {} ", device.index);
    text += device.is_software ? "is software, slower than the CPU backend"
                               : "cannot be used: " + device.problem;
  }
  return text;
}

std::optional<int> hardware_device(const gpu::DeviceList& hardware) {
  for (const gpu::Device& device : hardware.devices) {
    if (device.is_usable() && !device.is_software) return device.index;
  }
  return std::nullopt;
}

std::string describe(const gpu::Device& device, const GpuStages& stages) {
  const std::string gpu =
      fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  const GpuStages rest{!stages.light_paths, !stages.connections, !stages.near_field};
  if (stages == GpuStages()) return gpu;
  return fmt::format("{}: {}; cpu ({}): {}", gpu, fmt::join(gpu_stage_names(stages), ", "),
                     calc::tracer_version(), fmt::join(gpu_stage_names(rest), ", "));
}

}  // namespace

std::optional<gpu::Fault> find_gl_fault(std::string_view name) {
  if (name.empty()) return gpu::Fault::none;
  if (name == "no-egl") return gpu::Fault::no_egl;
  if (name == "out-of-memory") return gpu::Fault::out_of_memory;
  if (name == "context-lost") return gpu::Fault::context_lost;
  return std::nullopt;
}

BackendChoice choose_automatically(const gpu::DeviceList& hardware,
                                   const std::function<double()>& connections) {
  const std::optional<int> device = hardware_device(hardware);
  if (!device) return {Backend::cpu, -1, why_no_hardware(hardware)};
  const std::string name = hardware.devices[static_cast<std::size_t>(*device)].renderer;
  const double count = connections();
  const std::string amount =
      fmt::format("{} connections in the first look",
                  report::format_count(static_cast<std::uint64_t>(std::llround(count))));
  if (count < kConnectionsWorthAGpu) {
    return {Backend::cpu, -1, fmt::format("too little work for {}: {}", name, amount)};
  }
  return {Backend::gpu, *device, fmt::format("enough work for {}: {}", name, amount)};
}

BackendChoice choose_backend(const Options& options, gpu::Fault fault,
                             const std::function<double()>& connections) {
  if (options.backend != Backend::automatic) {
    return {options.backend, options.gl_device, "asked for with --backend",
            options.gpu_stages.value_or(GpuStages())};
  }
  return choose_automatically(gpu::list_hardware(fault), connections);
}

std::string backend_line(const BackendChoice& choice) {
  if (choice.backend != Backend::gpu) return fmt::format("backend: cpu: {}\n", choice.why);
  return fmt::format("backend: gpu: {}\ngpu stages: {}\n", choice.why,
                     fmt::join(gpu_stage_names(choice.stages), ", "));
}

std::optional<OpenBackend> open_backend(const BackendChoice& choice, gpu::Fault fault,
                                        std::string& problem, std::string& warning) {
  OpenBackend backend;
  if (choice.backend != Backend::gpu) {
    backend.gatherer = calc::make_cpu_gatherer();
    backend.description = backend.gatherer->description();
    return backend;
  }
  const auto thread = gpu::DeviceThread::open({choice.device, fault}, problem);
  if (!thread) return std::nullopt;
  if (thread->device().is_software) warning = thread->device().renderer;
  const GpuStages& stages = choice.stages;
  backend.gatherer = stages.connections ? gpu::make_gl_gatherer(thread) : calc::make_cpu_gatherer();
  if (stages.light_paths) backend.path_tracer = gpu::make_gl_path_tracer(thread);
  if (stages.near_field) backend.short_rays = gpu::make_gl_short_rays(thread);
  backend.description = describe(thread->device(), stages);
  return backend;
}

}  // namespace cli
