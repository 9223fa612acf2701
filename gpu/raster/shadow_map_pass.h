#pragma once
// Instant radiosity by rasterisation: a depth map of half a cube around every light vertex, in
// which all receivers are looked up. For the thread that owns the context.  [Keller97]

#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/sampling/rays.h"
#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/gather/gather_pass.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/raster/gl_render_program.h"
#include "gpu/raster/gl_target.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace gpu {

struct ShadowMapJob {
  const calc::Tracer* tracer = nullptr;
  std::span<const calc::LightVertex> vertices;
  std::span<const GpuReceiver> receivers;
  float most_per_m2 = 0.0f;  // larger geometry terms are cut off
  bool has_shadows = true;
  double deadline_s = 0.0;  // as in calc::GatherBatch; what was not yet told then never is
  // Called in order of vertices: results [vertex - first][receiver - first_receiver] of some
  // vertices and some receivers, as in GatherJob::results, all above 0 being lx.
  std::function<void(std::size_t first, std::size_t first_receiver, std::size_t receivers,
                     std::span<const std::uint32_t> results)>
      take;
};

struct ShadowMapTimes {
  double maps_s = 0.0, gather_s = 0.0;
};

class ShadowMapPass {
 public:
  // texels: along a cube's edge, a power of two, 16 to 2048.
  ShadowMapPass(std::uint32_t texels, const ProgramCache& programs);
  ~ShadowMapPass();
  ShadowMapPass(const ShadowMapPass&) = delete;
  ShadowMapPass& operator=(const ShadowMapPass&) = delete;

  // Runs the job. Throws GlError, and can be used again after OutOfMemory.
  ShadowMapTimes run(DeviceState& device, const ShadowMapJob& job);

 private:
  void upload(const ShadowMapJob& job);
  void upload_scene(const calc::Tracer& tracer);
  // Returns false at the deadline.
  bool render(const ShadowMapJob& job, std::size_t first, std::size_t count);
  void prepare(const ShadowMapJob& job, std::size_t count);
  bool gather(const ShadowMapJob& job, std::size_t first, std::size_t count);

  const std::uint32_t texels_;
  std::uint32_t maps_per_row_ = 1;
  std::size_t most_maps_ = 1;  // in the atlas
  GlRenderProgram draw_;
  GlProgram gather_;
  GlTarget atlas_;
  GlBuffer vertices_, receivers_, results_, corners_, triangles_;
  unsigned layout_ = 0;               // of the vertex shader's inputs
  std::uint64_t scene_identity_ = 0;  // in corners_ and triangles_
  std::uint32_t indices_ = 0;
  float depth_unit_m_ = 1.0f;  // beyond every surface
  DispatchPacer pacer_;        // items: maps of one draw call
};

}  // namespace gpu
