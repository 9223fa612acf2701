#include "gpu/gather/gather_pass.h"

#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>

namespace gpu {
namespace {

static_assert(sizeof(GpuReceiver) == 48);
static_assert(sizeof(calc::Connection) == 12);

}  // namespace

std::vector<GpuReceiver> gpu_receivers(const calc::Tracer& tracer,
                                       std::span<const calc::Receiver> receivers) {
  std::vector<GpuReceiver> result;
  result.reserve(receivers.size());
  for (const calc::Receiver& receiver : receivers) {
    result.push_back({glm::vec4(glm::vec3(receiver.position_m), 0.0f),
                      glm::vec4(glm::vec3(receiver.axis), static_cast<float>(receiver.kernel)),
                      glm::vec4(glm::vec3(tracer.lift(receiver)), 0.0f)});
  }
  return result;
}

GatherPass::GatherPass()
    : receivers_("calculation points"),
      connections_("connections"),
      results_("results", BufferUse::by_device) {}

void GatherPass::run(DeviceState& device, DevicePools& pools, const GatherJob& job) {
  const DevicePool* pool = pools.find(job.vertices_identity, false);
  if (pool == nullptr) pool = &pools.send(job.vertices_identity, pack_pool(job.vertices));
  pool->bind_vertices();
  upload(job);
  dispatch(device, job);
  results_.read(0, std::as_writable_bytes(job.results));
  device.check("gathering light");
}

void GatherPass::upload(const GatherJob& job) {
  connections_.assign(job.connections);
  receivers_.assign(job.receivers);
  results_.assign(job.connections.size() * sizeof(std::uint32_t), kNotDone);
  receivers_.bind(4);
  connections_.bind(5);
  results_.bind(12);
  check_gl("sending connections");
}

void GatherPass::dispatch(DeviceState& device, const GatherJob& job) {
  const bool has_shadows = job.has_shadows && !job.tracer->scene().triangle.empty();
  const GlProgram& shader = program(device, has_shadows);
  shader.use();
  if (has_shadows) {
    const DeviceScene& scene = device.scenes.of(*job.tracer);
    scene.bind();
    shader.set("node_count", scene.nodes);
    shader.set("offset_m", static_cast<float>(job.tracer->offset_m()));
  }
  const auto count = static_cast<std::uint32_t>(job.connections.size());
  shader.set("connection_count", count);
  shader.set("lift_m", static_cast<float>(job.tracer->offset_m()));
  shader.set("bounded_from_per_m2", std::min(job.bounded_from_per_m2, FLT_MAX));
  glDispatchCompute((count + kGroupSize - 1) / kGroupSize, 1, 1);
  check_gl("tracing shadow rays");
}

const GlProgram& GatherPass::program(DeviceState& device, bool has_shadows) {
  std::unique_ptr<GlProgram>& made = program_[has_shadows ? 1 : 0];
  if (!made)
    made = std::make_unique<GlProgram>("gather", gather_shader(has_shadows), device.programs);
  return *made;
}

}  // namespace gpu
