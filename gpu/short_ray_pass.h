#pragma once
// First short rays of some points on the device. For the thread that owns the context.

#include "calc/radiosity/short_rays.h"
#include "gpu/device_thread.h"
#include "gpu/dispatch_pacer.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_program.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gpu {

// One point as shaders/short_ray_requests.glsl reads it: six uvec4.
struct GpuRequest {
  glm::dvec3 position_m, axis;
  glm::vec3 origin_m;    // of its rays: local, lifted
  std::uint32_t kernel;  // calc::ReceiverKernel
  std::array<std::uint32_t, 2> scramble, key;
  std::uint32_t first_ray, rays;
  std::array<std::uint32_t, 2> unused{};
};
static_assert(sizeof(GpuRequest) == 96);

struct ShortRayJob {
  const calc::Tracer* tracer = nullptr;
  float least_m = 0.0f, most_m = 0.0f;
  std::span<const GpuRequest> requests{};
  std::size_t rays = 0;     // of all of them
  bool has_light = false;   // for HitPass
  double deadline_s = 0.0;  // see calc::is_past()
};

// One for each of the requests, whose rays are numbered one after the other.
std::vector<GpuRequest> gpu_requests(const calc::Tracer& tracer,
                                     std::span<const calc::NearFieldRequest> requests);

// Rays of one call, from their start until what is at their ends was found.
struct ShortRayBuffers {
  GlBuffer requests{"calculation points"};
  // What the rays met, kNotDone before: calc::FirstHit; has_light: as short_ray_shader() says.
  GlBuffer hits{"hits of short rays", BufferUse::by_device};
};

class ShortRayPass {
 public:
  explicit ShortRayPass(const ProgramCache& programs);  // must outlive it

  // Bindings that the stages after it share; others are those of DeviceScene.
  enum Binding : unsigned { kWords = 4, kHits = 6, kRequests = 9, kField };

  // Sends the points and starts their rays; has_light: with the field's numbers bound. False: the
  // deadline passed. Throws GlError.
  bool trace(DeviceState& device, const ShortRayJob& job, ShortRayBuffers& buffers);
  void bind(const ShortRayBuffers& buffers) const;

 private:
  const GlProgram& program(bool has_light);

  const ProgramCache& programs_;
  std::array<std::unique_ptr<GlProgram>, 2> program_;  // [has_light], made when first needed
  GlBuffer words_;
  DispatchPacer pacer_;
};

}  // namespace gpu
