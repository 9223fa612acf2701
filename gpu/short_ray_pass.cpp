#include "gpu/short_ray_pass.h"

#include "calc/radiosity/low_discrepancy.h"
#include "calc/radiosity/phase_timer.h"
#include "gpu/number_table.h"
#include "gpu/path_shader_text.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace gpu {
namespace {

// Rays of one dispatch.
constexpr std::size_t kFewestRays = std::size_t{1} << 12;
constexpr std::size_t kMostRays = std::size_t{1} << 22;
constexpr std::size_t kFirstRays = std::size_t{1} << 16;

}  // namespace

std::vector<GpuRequest> gpu_requests(const calc::Tracer& tracer,
                                     std::span<const calc::NearFieldRequest> requests) {
  std::vector<GpuRequest> result;
  result.reserve(requests.size());
  std::uint32_t first_ray = 0;
  for (const calc::NearFieldRequest& request : requests) {
    const calc::ScrambledSobol sobol(request.key);
    const std::uint64_t key = request.key.bits();
    result.push_back({request.receiver.position_m,
                      request.receiver.axis,
                      glm::vec3(tracer.lift(request.receiver)),
                      static_cast<std::uint32_t>(request.receiver.kernel),
                      {sobol.scramble(0), sobol.scramble(1)},
                      {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)},
                      first_ray,
                      request.rays});
    first_ray += request.rays;
  }
  return result;
}

ShortRayPass::ShortRayPass(const ProgramCache& programs)
    : programs_(programs),
      words_("random numbers", BufferUse::fixed),
      pacer_({kFewestRays, kMostRays, kFirstRays}) {
  words_.assign(sobol_words(2));
}

const GlProgram& ShortRayPass::program(bool has_light) {
  std::unique_ptr<GlProgram>& made = program_[has_light ? 1 : 0];
  if (!made) {
    made = std::make_unique<GlProgram>("short rays", short_ray_shader(has_light), programs_);
  }
  return *made;
}

void ShortRayPass::bind(const ShortRayBuffers& buffers) const {
  words_.bind(kWords);
  buffers.hits.bind(kHits);
  buffers.requests.bind(kRequests);
}

bool ShortRayPass::trace(DeviceState& device, const ShortRayJob& job, ShortRayBuffers& buffers) {
  const GlProgram& shader = program(job.has_light);
  buffers.requests.assign(job.requests);
  const std::size_t bytes =
      job.has_light ? kLitHitSize * sizeof(std::uint32_t) : sizeof(calc::FirstHit);
  buffers.hits.assign(job.rays * bytes, calc::FirstHit::kNotDone);
  const DeviceScene& scene = device.scenes.of(*job.tracer);
  shader.use();
  scene.bind();
  scene.bind_surfaces();
  bind(buffers);
  shader.set("node_count", scene.nodes);
  shader.set("request_count", static_cast<std::uint32_t>(job.requests.size()));
  shader.set("least_m", job.least_m);
  shader.set("most_m", job.most_m);
  for (std::size_t first = 0; first < job.rays;) {
    if (calc::is_past(job.deadline_s)) return false;
    const std::size_t count = std::min(pacer_.items(), job.rays - first);
    pacer_.run(count, "tracing short rays", [&] {
      shader.set("first_ray", static_cast<std::uint32_t>(first));
      shader.set("ray_count", static_cast<std::uint32_t>(count));
      glDispatchCompute(static_cast<GLuint>((count + kGroupSize - 1) / kGroupSize), 1, 1);
    });
    first += count;
  }
  return true;
}

}  // namespace gpu
