#pragma once
// Which backend computes what, and why.

#include "calc/forecast/device_cost.h"
#include "calc/radiosity/looks/stages.h"
#include "gpu/gather/gl_gatherer.h"
#include "report/check/hardware.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace check {

enum class Backend { automatic, cpu, gpu };
// Which parts of the calculation a gpu does.
using GpuStages = calc::DeviceStages;
// "direct-light", "light-paths", "connections" and "near-field": those that are set, in this order.
std::vector<std::string_view> gpu_stage_names(const GpuStages& stages);
// Of such a name; null if there is none.
bool GpuStages::*find_gpu_stage(std::string_view name);

// What a user wants.
struct BackendRequest {
  Backend backend = Backend::automatic;
  int gl_device = -1;               // as `luxgate devices` numbers them; -1 = not given
  std::optional<GpuStages> stages;  // empty: not given, all
};

// The value of LUXGATE_GL_FAULT, by which tests let OpenGL fail: "" or a name of gpu::Fault with
// dashes; empty if it is neither.
std::optional<gpu::Fault> find_gl_fault(std::string_view name);

// A backend that was asked for, or the answer to `auto`, and the reason in words.
struct BackendChoice {
  Backend backend = Backend::cpu;  // never automatic
  int device = -1;                 // for the gpu, of gpu::DeviceRequest
  std::string why;
  GpuStages stages{};                   // of the gpu
  std::uint32_t shadow_map_texels = 0;  // as in calc::RadiositySettings; > 0 only for the gpu
};

// The answer to --backend auto: a GPU if there is one that is not software, and it gains more than
// it costs to open and to feed; of its stages those that it does faster. By the cost model for
// first looks at all projects, on as many threads as there are. work and rates are only asked for
// if there is such a device.
BackendChoice choose_automatically(const gpu::DeviceList& hardware,
                                   const std::function<calc::DeviceWork()>& work,
                                   const RatesOf& rates_of);
// What --backend means on this machine, whose devices are only looked for if that matters.
// shadow_map_texels: as in calc::RadiositySettings; without --backend gpu the sooner device draws
// such maps (choose_to_draw()).
BackendChoice choose_backend(const BackendRequest& request, std::uint32_t shadow_map_texels,
                             Hardware& hardware, const std::function<calc::DeviceWork()>& work);

// "backend: cpu: this machine has no graphics device\n"; of a gpu also what runs on it.
std::string backend_line(const BackendChoice& choice);

// Who computes which part.
struct OpenBackend {
  std::unique_ptr<calc::Gatherer> gatherer;
  std::unique_ptr<calc::PathTracer> path_tracer;      // null: the CPU
  std::unique_ptr<calc::ShortRayCaster> short_rays;   // null: the CPU
  std::unique_ptr<calc::DirectTracer> direct_tracer;  // null: the CPU
  std::shared_ptr<gpu::DeviceThread> device;          // that they use; null: none
  // For reports: "cpu", "gpu (...): light-paths; cpu: connections, ...".
  std::string description;
  // The same with all that bits may depend on, the driver's version too: of looks that are kept.
  std::string identity;

  calc::Stages stages() const {
    return {*gatherer, path_tracer.get(), short_rays.get(), direct_tracer.get()};
  }
};

// Empty: `problem` says why. Another backend is never taken instead. Where OpenGL turns out to be
// software and nobody chose that, `warning` names its renderer, and why hardware that is there was
// not found.
// program_folder: where compiled shaders are kept, "" = nowhere.
std::optional<OpenBackend> open_backend(const BackendChoice& choice, gpu::Fault fault,
                                        const std::string& program_folder, std::string& problem,
                                        std::string& warning);

}  // namespace check
