#include "gpu/gl_short_rays.h"

#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/low_discrepancy.h"
#include "gpu/dispatch_pacer.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_error.h"
#include "gpu/gl_program.h"
#include "gpu/gl_read_back.h"
#include "gpu/path_shader_text.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

namespace gpu {
namespace {

enum Binding : unsigned { kRequests = 3, kWords, kHits = 6 };  // others are those of DeviceScene

// Rays of one dispatch.
constexpr std::size_t kFewestRays = std::size_t{1} << 12;
constexpr std::size_t kMostRays = std::size_t{1} << 22;
constexpr std::size_t kFirstRays = std::size_t{1} << 16;
constexpr const char* kDoing = "tracing short rays";

// One point as the shader reads it: four uvec4.
struct GpuRequest {
  glm::dvec3 axis;
  std::array<std::uint32_t, 2> unused{};
  glm::vec3 origin_m;      // local, lifted
  std::uint32_t has_back;  // 0: rays all around
  std::array<std::uint32_t, 2> scramble;
  std::uint32_t first_ray;
  std::uint32_t unused_too = 0;
};
static_assert(sizeof(GpuRequest) == 64);

class ShortRayPass {
 public:
  explicit ShortRayPass(const ProgramCache& programs)
      : program_("short rays", short_ray_shader(), programs),
        words_("random numbers", BufferUse::fixed),
        requests_("calculation points"),
        hits_("hits of short rays", BufferUse::by_device),
        read_back_("hits of short rays"),
        pacer_({kFewestRays, kMostRays, kFirstRays}) {
    std::vector<std::uint32_t> words;
    for (int dimension = 0; dimension < 2; ++dimension) {
      for (int bit = 0; bit < 32; ++bit) {
        words.push_back(calc::ScrambledSobol::direction_number(dimension, bit));
      }
    }
    words_.assign(words);
  }

  void run(DeviceState& device, const calc::Tracer& tracer, float least_m, float most_m,
           std::span<const GpuRequest> requests, std::span<calc::FirstHit> hits) {
    requests_.assign(requests);
    hits_.assign(hits.size_bytes(), calc::FirstHit::kNotDone);
    const DeviceScene& scene = device.scenes.of(tracer);
    program_.use();
    scene.bind();
    scene.bind_surfaces();
    requests_.bind(kRequests);
    words_.bind(kWords);
    hits_.bind(kHits);
    program_.set("node_count", scene.nodes);
    program_.set("request_count", static_cast<std::uint32_t>(requests.size()));
    program_.set("least_m", least_m);
    program_.set("most_m", most_m);
    for (std::size_t first = 0; first < hits.size();) {
      const std::size_t count = std::min(pacer_.items(), hits.size() - first);
      pacer_.run(count, kDoing, [&] {
        program_.set("first_ray", static_cast<std::uint32_t>(first));
        program_.set("ray_count", static_cast<std::uint32_t>(count));
        glDispatchCompute(static_cast<GLuint>((count + kGroupSize - 1) / kGroupSize), 1, 1);
      });
      first += count;
    }
    // Their "not done" is a word of its own: all ones mean that a ray met nothing.
    read_back_.start({{hits_, 0, hits.size_bytes()}}, calc::FirstHit::kNotDone);
    read_back_.wait(kDoing);
    read_back_.copy(0, std::as_writable_bytes(hits));
    device.check(kDoing);
  }

 private:
  GlProgram program_;
  GlBuffer words_, requests_, hits_;
  GlReadBack read_back_;
  DispatchPacer pacer_;
};

std::vector<GpuRequest> gpu_requests(const calc::Tracer& tracer,
                                     std::span<const calc::NearFieldRequest> requests) {
  std::vector<GpuRequest> result;
  result.reserve(requests.size());
  std::uint32_t first_ray = 0;
  for (const calc::NearFieldRequest& request : requests) {
    const calc::ScrambledSobol sobol(request.key);
    GpuRequest& to = result.emplace_back();
    to.axis = request.receiver.axis;
    to.origin_m = glm::vec3(tracer.lift(request.receiver));
    to.has_back = calc::has_back(request.receiver.kernel) ? 1 : 0;
    to.scramble = {sobol.scramble(0), sobol.scramble(1)};
    to.first_ray = first_ray;
    first_ray += request.rays;
  }
  return result;
}

class GlShortRays : public calc::ShortRayCaster {
 public:
  explicit GlShortRays(std::shared_ptr<DeviceThread> thread) : thread_(std::move(thread)) {}
  ~GlShortRays() override {
    thread_->clean_up([this](DeviceState&) { pass_.reset(); });
  }
  GlShortRays(const GlShortRays&) = delete;
  GlShortRays& operator=(const GlShortRays&) = delete;

  void cast(const calc::Tracer& tracer, float least_m, float most_m,
            std::span<const calc::NearFieldRequest> requests,
            std::span<calc::FirstHit> hits) override {
    if (hits.empty()) return;
    const std::vector<GpuRequest> sent = gpu_requests(tracer, requests);
    thread_->run([&](DeviceState& device) {
      try {
        if (!pass_) pass_ = std::make_unique<ShortRayPass>(device.programs);
        pass_->run(device, tracer, least_m, most_m, sent, hits);
      } catch (const std::exception&) {
        pass_.reset();  // what it kept may be what left no room
        throw;
      }
    });
    for (const calc::FirstHit& hit : hits) {
      if (hit.triangle_and_side == calc::FirstHit::kNotDone) {
        throw calc::BackendFailure("the device did not finish its work");
      }
    }
  }

 private:
  const std::shared_ptr<DeviceThread> thread_;
  std::unique_ptr<ShortRayPass> pass_;  // of the device's thread alone
};

}  // namespace

std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread) {
  return std::make_unique<GlShortRays>(std::move(thread));
}

}  // namespace gpu
