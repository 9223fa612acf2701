#pragma once
// Evaluates given connections on the device: uploads, one invocation each, results back. For the
// thread that owns the context.

#include "calc/radiosity/paths/draws.h"
#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/sampling/rays.h"
#include "gpu/device/device_thread.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/scene/device_pool.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gpu {

// A receiver in the shader's layout: three vec4.
struct GpuReceiver {
  glm::vec4 position_m;  // local; last component unused
  glm::vec4 axis;        // last component: the calc::ReceiverKernel
  glm::vec4 lifted_m;    // where its rays begin; last component unused
};

std::vector<GpuReceiver> gpu_receivers(const calc::Tracer& tracer,
                                       std::span<const calc::Receiver> receivers);

struct GatherJob {
  const calc::Tracer* tracer = nullptr;
  std::span<const calc::LightVertex> vertices;
  std::uint64_t vertices_identity = 0;  // as in calc::GatherBatch
  std::span<const GpuReceiver> receivers;
  std::span<const calc::Connection> connections;  // of these receivers, at most kMostConnections
  float bounded_from_per_m2 = 0.0f;               // VertexBounds::lowest_per_m2()
  bool has_shadows = true;
  // Results, one for each connection:
  //   kNoRay        one end faces away from the other
  //   kAddsNothing  something is between, or the contribution is 0
  //   kNotDone      the device did not do its work
  //   else a float: > 0 the contribution, lx; < 0 the geometry term, negative, which is above
  //   bounded_from_per_m2: the caller has to find its bound.
  std::span<std::uint32_t> results;
};

class GatherPass {
 public:
  GatherPass();

  // Runs the job. Throws GlError, and can be used again after OutOfMemory.
  void run(DeviceState& device, DevicePools& pools, const GatherJob& job);

  // Short enough for the watchdogs of desktop drivers.
  static constexpr std::size_t kMostConnections = std::size_t{1} << 18;

 private:
  void upload(const GatherJob& job);
  void dispatch(DeviceState& device, const GatherJob& job);
  const GlProgram& program(DeviceState& device, bool has_shadows);

  std::array<std::unique_ptr<GlProgram>, 2> program_;  // [has_shadows], made when first needed
  GlBuffer receivers_, connections_, results_;
};

}  // namespace gpu
