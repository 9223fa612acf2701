#pragma once
// Chooses which backend computes which part, and says why.

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
// The parts of the calculation that a GPU does.
using GpuStages = calc::DeviceStages;
// Returns the names of the stages that are set, in this order: "direct-light", "light-paths",
// "connections" and "near-field".
std::vector<std::string_view> gpu_stage_names(const GpuStages& stages);
// Returns the stage of this name; null if there is none.
bool GpuStages::*find_gpu_stage(std::string_view name);

// The backend that a user requests.
struct BackendRequest {
  Backend backend = Backend::automatic;
  int gl_device = -1;               // as `luxgate devices` numbers them; -1 = not given
  std::optional<GpuStages> stages;  // empty: not given, all
};

// Returns the fault for a value of LUXGATE_GL_FAULT, by which tests let OpenGL fail: "" or a name
// of gpu::Fault with dashes; empty if it is neither.
std::optional<gpu::Fault> find_gl_fault(std::string_view name);

// The requested backend, or the answer to `auto`, with the reason in words.
struct BackendChoice {
  Backend backend = Backend::cpu;  // never automatic
  int device = -1;                 // for the gpu, of gpu::DeviceRequest
  std::string why;
  GpuStages stages{};                   // of the gpu
  std::uint32_t shadow_map_texels = 0;  // as in calc::RadiositySettings; > 0 only for the gpu
};

// Returns the answer to --backend auto: a GPU that is not software, if it gains more than it costs
// to open and to feed, with the stages that it does faster. The cost model decides, for first
// sampling rounds of all projects on all threads. work and rates are only called if there is such a
// device.
BackendChoice choose_automatically(const gpu::DeviceList& hardware,
                                   const std::function<calc::DeviceWork()>& work,
                                   const RatesOf& rates_of);
// Returns the choice for --backend on this machine; devices are only listed if they matter.
// shadow_map_texels: as in calc::RadiositySettings; without --backend gpu the faster device draws
// such maps (choose_to_draw()).
BackendChoice choose_backend(const BackendRequest& request, std::uint32_t shadow_map_texels,
                             Hardware& hardware, const std::function<calc::DeviceWork()>& work);

// Returns "backend: cpu: this machine has no graphics device\n"; for a GPU also its stages.
std::string backend_line(const BackendChoice& choice);

// The devices that compute each part, once opened.
struct OpenBackend {
  std::unique_ptr<calc::Gatherer> gatherer;
  std::unique_ptr<calc::PathTracer> path_tracer;      // null: the CPU
  std::unique_ptr<calc::ShortRayCaster> short_rays;   // null: the CPU
  std::unique_ptr<calc::DirectTracer> direct_tracer;  // null: the CPU
  std::shared_ptr<gpu::DeviceThread> device;          // that they use; null: none
  // For reports: "cpu", "gpu (...): light-paths; cpu: connections, ...".
  std::string description;
  // The description with everything that bits may depend on, including the driver's version; stored
  // sampling rounds are keyed by it.
  std::string identity;

  calc::Stages stages() const {
    return {*gatherer, path_tracer.get(), short_rays.get(), direct_tracer.get()};
  }
};

// Opens the chosen backend. Empty: `problem` says why; another backend is never used instead. If
// OpenGL turns out to be software that was not requested, `warning` names its renderer, and why
// existing hardware was not found. program_folder: holds compiled shaders, "" = none.
std::optional<OpenBackend> open_backend(const BackendChoice& choice, gpu::Fault fault,
                                        const std::string& program_folder, std::string& problem,
                                        std::string& warning);

}  // namespace check
