#pragma once
// Given connections on the device: uploads, one invocation each, results back. For the thread that
// owns the context.

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

// A receiver as the shader reads it: three vec4.
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
  // One for each connection:
  //   kNoRay        one end faces away from the other
  //   kAddsNothing  something stands between, or what is added is 0
  //   kNotDone      the device did not do its work
  //   else a float: > 0 what the connection adds, lx; < 0 the geometry term, negative, which is
  //   above bounded_from_per_m2: its bound is for the caller to find.
  std::span<std::uint32_t> results;
};

class GatherPass {
 public:
  GatherPass();

  // Throws GlError, and can be used again after OutOfMemory.
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
