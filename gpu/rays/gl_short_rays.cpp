#include "gpu/rays/gl_short_rays.h"

#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/near_field.h"
#include "gpu/opengl/buffer_sets.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/gl_read_back.h"
#include "gpu/rays/hit_pass.h"
#include "gpu/rays/short_ray_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

namespace gpu {
namespace {

constexpr const char* kDoing = "tracing short rays";

// kNotDone makes a double that is no number, too.
bool is_done(const calc::HitLight& light, bool has_far_light) {
  if (light.ray == calc::HitLight::kNotDone || !(light.weight > 0.0)) return false;
  const auto is_draw_done = [](const calc::HitLight::Draw& draw) {
    return draw.channel != calc::HitLight::kNotDone;
  };
  return light.luminaire != calc::HitLight::kNotDone && !std::isnan(light.direct_lx) &&
         light.next_triangle_and_side != calc::HitLight::kNotDone &&
         (!has_far_light || std::all_of(light.draws.begin(), light.draws.end(), is_draw_done));
}

bool is_before(const calc::HitLight& a, const calc::HitLight& b) {
  return a.request < b.request || (a.request == b.request && a.ray < b.ray);
}

// Appends the points of one call; each of its hits must be in it once.
void append(const HitAnswers& answers, std::size_t points, bool has_far_light,
            calc::ShortRayLight& found) {
  const std::size_t before = found.points(), left_before = found.left.size();
  found.lx.resize((before + points) * found.channels, 0.0);
  found.largest_lx.resize(before + points, 0.0f);
  found.rays.resize(before + points, 0);
  if (answers.hits == 0) return;
  const std::size_t bytes = hit_answer_bytes(found.channels);
  std::size_t hits = 0, left = 0;
  for (std::size_t k = 0; k < points; ++k) {
    const std::byte* const at = answers.requests.bytes().data() + k * bytes;
    HitAnswer answer;
    std::memcpy(&answer, at, sizeof answer);
    double* const lx = found.lx.data() + (before + k) * found.channels;
    std::memcpy(lx, at + sizeof answer, found.channels * sizeof(double));
    if (std::isnan(answer.largest_lx) ||
        std::any_of(lx, lx + found.channels, [](double x) { return std::isnan(x); })) {
      throw_not_done();
    }
    found.largest_lx[before + k] = answer.largest_lx;
    found.rays[before + k] = answer.rays;
    hits += answer.hits;
    left += answer.left;
  }
  for (const HitAnswers::Left& some : answers.left) {
    if (some.count == 0) continue;
    const std::size_t first = found.left.size();
    found.left.resize(first + some.count);
    std::memcpy(found.left.data() + first, some.lights().data(), some.lights().size());
  }
  const auto own = found.left.begin() + static_cast<std::ptrdiff_t>(left_before);
  std::sort(own, found.left.end(), is_before);
  if (hits != answers.hits || left != found.left.size() - left_before) throw_not_done();
  for (auto light = own; light != found.left.end(); ++light) {
    if (!has_far_light) light->draws.fill({calc::HitLight::kNothing, 0.0f});
    if (!is_done(*light, has_far_light) || light->request >= points) throw_not_done();
    if (light != own && !is_before(*(light - 1), *light)) throw_not_done();
  }
  for (auto light = own; light != found.left.end(); ++light) {
    light->request += static_cast<std::uint32_t>(before);
  }
}

class GlShortRays : public calc::ShortRayCaster {
 public:
  GlShortRays(std::shared_ptr<DeviceThread> thread, const HitLimits& limits)
      : thread_(std::move(thread)), limits_(limits) {}
  ~GlShortRays() override {
    thread_->clean_up([this](DeviceState& device) {
      clear();
      device.near_points.clear();
    });
  }
  GlShortRays(const GlShortRays&) = delete;
  GlShortRays& operator=(const GlShortRays&) = delete;

  void cast(const calc::Tracer& tracer, float least_m, float most_m,
            const calc::NearFieldBatch& batch, std::span<calc::FirstHit> hits) override {
    for (const ShortRayPart& part : parts_of(batch, batch.points.size())) {
      const std::span<calc::FirstHit> own = hits.first(part.rays());
      hits = hits.subspan(part.rays());
      const auto packed = packed_points(tracer, batch, part);
      const ShortRayJob job{tracer, least_m, most_m, batch, part, packed.get()};
      run([&](DeviceState& device) {
        if (!cast_) cast_ = std::make_unique<ShortRayBuffers>();
        rays_->trace(device, job, *cast_);
        // Their "not done" is a word of its own: all ones mean that a ray met nothing.
        hits_back_->start({{cast_->hits, 0, own.size_bytes()}}, calc::FirstHit::kNotDone);
        hits_back_->wait(kDoing);
        hits_back_->copy(0, std::as_writable_bytes(own));
        device.check(kDoing);
      });
      for (const calc::FirstHit& hit : own) {
        if (hit.triangle_and_side == calc::FirstHit::kNotDone) throw_not_done();
      }
    }
  }

  void find_light(const calc::NearField& field, const calc::NearFieldBatch& batch,
                  calc::ShortRayLight& found) override {
    found.channels = field.channels;
    const std::size_t most_points =
        std::max<std::size_t>(1, limits_.answer_bytes / hit_answer_bytes(field.channels));
    for (const ShortRayPart& part : parts_of(batch, most_points)) {
      find_light_of(field, batch, part, found);
    }
  }

 private:
  std::shared_ptr<const NearPoints::Packed> packed_points(const calc::Tracer& tracer,
                                                          const calc::NearFieldBatch& batch,
                                                          const ShortRayPart& part) {
    return thread_->near_points().pack_unless_held(tracer, batch.tiles, part.block);
  }

  // Past the deadline as if there were no hits.
  void find_light_of(const calc::NearField& field, const calc::NearFieldBatch& batch,
                     const ShortRayPart& part, calc::ShortRayLight& found) {
    const bool has_far_light = field.cut.size() > 0;
    const auto append_to = [&](const HitAnswers& answers) {
      append(answers, part.points(), has_far_light, found);
    };
    if (part.rays() == 0) return append_to({});
    const std::shared_ptr<const PackedPool> packed = thread_->pools().pack_unless_held(field.tree);
    const auto points = packed_points(field.tracer, batch, part);
    const ShortRayJob job{field.tracer,
                          static_cast<float>(field.tracer.offset_m()),
                          static_cast<float>(field.bound.reach_m()),
                          batch,
                          part,
                          points.get(),
                          true,
                          field.deadline_s};
    const auto turn = sets_.take();
    bool goes_on = false;
    run([&](DeviceState& device) {
      goes_on = lights_of(device).start(device, *rays_, field, job, turn.buffers());
    });
    if (!goes_on) return append_to({});
    run([&](DeviceState& device) {
      goes_on = lights_of(device).find(device, *rays_, field, packed.get(), job, turn.buffers());
    });
    if (!goes_on) return append_to({});
    HitAnswers answers;
    run([&](DeviceState& device) {
      answers = lights_of(device).take(device, field, job, turn.buffers());
    });
    append_to(answers);  // before the next call has these buffers
  }

  HitPass& lights_of(DeviceState& device) {
    if (!lights_) lights_ = std::make_unique<HitPass>(device.programs, limits_);
    return *lights_;
  }
  void run(const DeviceThread::Work& work) {
    thread_->run([&](DeviceState& device) {
      try {
        if (!rays_) rays_ = std::make_unique<ShortRayPass>(device.programs);
        if (!hits_back_) hits_back_ = std::make_unique<GlReadBack>("hits of short rays");
        work(device);
      } catch (const std::exception&) {
        clear();  // what was kept may be what left no room
        throw;
      }
    });
  }
  void clear() {
    lights_.reset();
    hits_back_.reset();
    cast_.reset();
    rays_.reset();
    sets_.clear();
  }

  const std::shared_ptr<DeviceThread> thread_;
  const HitLimits limits_;
  BufferSets<HitBuffers> sets_{3};
  // Of the device's thread alone.
  std::unique_ptr<ShortRayPass> rays_;
  std::unique_ptr<ShortRayBuffers> cast_;
  std::unique_ptr<GlReadBack> hits_back_;
  std::unique_ptr<HitPass> lights_;
};

}  // namespace

std::unique_ptr<calc::ShortRayCaster> make_gl_short_rays(std::shared_ptr<DeviceThread> thread,
                                                         const HitLimits& limits) {
  return std::make_unique<GlShortRays>(std::move(thread), limits);
}

}  // namespace gpu
