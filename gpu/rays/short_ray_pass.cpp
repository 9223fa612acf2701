#include "gpu/rays/short_ray_pass.h"

#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/number_table.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace gpu {
namespace {

// Rays of one dispatch.
constexpr std::size_t kFewestRays = std::size_t{1} << 12;
constexpr std::size_t kMostRays = std::size_t{1} << 22;
constexpr std::size_t kFirstRays = std::size_t{1} << 16;

}  // namespace

std::vector<ShortRayPart> parts_of(const calc::NearFieldBatch& batch, std::size_t most_points) {
  std::vector<ShortRayPart> parts;
  std::size_t begin = 0, end = 0;  // receivers of the block at hand
  for (std::size_t k = 0; k < batch.points.size(); ++k) {
    const calc::PointRays& point = batch.points[k];
    if (parts.empty() || point.receiver >= end || parts.back().points() >= most_points) {
      ShortRayPart& part = parts.emplace_back();
      part.block = batch.tiles.group_of(point.receiver) / kTilesPerBlock;
      part.requests.push_back({0, 0});  // the end
      const std::size_t first = part.block * kTilesPerBlock;
      begin = batch.tiles.receivers_before(first);
      end = batch.tiles.receivers_before(
          std::min(first + kTilesPerBlock, batch.tiles.groups().size()));
    }
    ShortRayRequest& last = parts.back().requests.back();
    last.receiver = static_cast<std::uint32_t>(point.receiver - begin);
    const std::uint32_t behind = last.first_ray + point.rays;
    parts.back().requests.push_back({0, behind});
  }
  return parts;
}

std::uint32_t ShortRayPart::most_rays() const {
  std::uint32_t most = 0;
  for (std::size_t k = 0; k < points(); ++k) {
    most = std::max(most, requests[k + 1].first_ray - requests[k].first_ray);
  }
  return most;
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

void ShortRayPass::bind(DeviceState& device, const ShortRayJob& job,
                        const ShortRayBuffers& buffers) const {
  words_.bind(kWords);
  buffers.hits.bind(kHits);
  buffers.requests.bind(kRequests);
  device.near_points.find_or_send(job.tracer, job.batch.tiles, job.part.block, job.packed)
      .receivers.bind(kPoints);
}

void ShortRayPass::set_keys(const GlProgram& program, const ShortRayJob& job) {
  const std::uint64_t key = job.batch.key.bits();
  program.set("key_low", static_cast<std::uint32_t>(key));
  program.set("key_high", static_cast<std::uint32_t>(key >> 32));
}

bool ShortRayPass::trace(DeviceState& device, const ShortRayJob& job, ShortRayBuffers& buffers) {
  const GlProgram& shader = program(job.has_light);
  buffers.requests.assign(job.part.requests);
  const std::size_t rays = job.part.rays();
  const std::size_t bytes =
      job.has_light ? kLitHitSize * sizeof(std::uint32_t) : sizeof(calc::FirstHit);
  buffers.hits.assign(rays * bytes, calc::FirstHit::kNotDone);
  const DeviceScene& scene = device.scenes.of(job.tracer);
  shader.use();
  scene.bind();
  scene.bind_surfaces();
  bind(device, job, buffers);
  set_keys(shader, job);
  shader.set("node_count", scene.nodes);
  shader.set("request_count", static_cast<std::uint32_t>(job.part.points()));
  shader.set("least_m", job.least_m);
  shader.set("most_m", job.most_m);
  for (std::size_t first = 0; first < rays;) {
    if (calc::is_past(job.deadline_s)) return false;
    const std::size_t count = std::min(pacer_.items(), rays - first);
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
