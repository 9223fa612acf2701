#include "gpu/gl_short_rays.h"

#include "calc/radiosity/cut.h"
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/near_field.h"
#include "gpu/gl_error.h"
#include "gpu/gl_read_back.h"
#include "gpu/hit_pass.h"
#include "gpu/short_ray_pass.h"
#include "gpu/turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

namespace gpu {
namespace {

constexpr const char* kDoing = "tracing short rays";

// kNotDone makes a double that is no number, too.
bool is_done(const calc::HitLight& light) {
  if (light.ray == calc::HitLight::kNotDone || std::isnan(light.weight)) return false;
  if (!(light.weight > 0.0)) return true;
  return light.luminaire != calc::HitLight::kNotDone && !std::isnan(light.direct_lx) &&
         light.next_triangle_and_side != calc::HitLight::kNotDone &&
         std::none_of(light.draws.begin(), light.draws.end(), [](const calc::HitLight::Draw& draw) {
           return draw.which == calc::HitLight::kNotDone;
         });
}

// Whoever takes them goes by it: one in another place would be lost.
bool are_in_order(const calc::HitLight& a, const calc::HitLight& b) {
  return a.request < b.request || (a.request == b.request && a.ray < b.ray);
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
    for (const ShortRayPart& part : parts_of(batch)) {
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
                  std::vector<calc::HitLight>& found) override {
    for (const ShortRayPart& part : parts_of(batch)) {
      const std::size_t before = found.size();
      find_light_of(field, batch, part, found);
      for (std::size_t k = before; k < found.size(); ++k) {
        found[k].request += static_cast<std::uint32_t>(part.first_point);
      }
    }
  }

 private:
  std::shared_ptr<const NearPoints::Packed> packed_points(const calc::Tracer& tracer,
                                                          const calc::NearFieldBatch& batch,
                                                          const ShortRayPart& part) {
    return thread_->near_points().pack_unless_held(tracer, batch.tiles, part.block);
  }

  void find_light_of(const calc::NearField& field, const calc::NearFieldBatch& batch,
                     const ShortRayPart& part, std::vector<calc::HitLight>& found) {
    if (part.rays() == 0) return;
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
    const auto turn = turns_.take();
    bool goes_on = false;
    run([&](DeviceState& device) {
      goes_on = lights_of(device).start(device, *rays_, field, job, turn.buffers());
    });
    if (!goes_on) return;
    run([&](DeviceState& device) {
      goes_on = lights_of(device).find(device, *rays_, field, packed.get(), job, turn.buffers());
    });
    if (!goes_on) return;
    std::vector<LentBytes> lights;
    run([&](DeviceState& device) { lights = lights_of(device).take(device, turn.buffers()); });
    const std::size_t before = found.size();
    for (const LentBytes& some : lights) {
      const auto* const first = reinterpret_cast<const calc::HitLight*>(some.bytes().data());
      found.insert(found.end(), first, first + some.bytes().size() / sizeof(calc::HitLight));
    }
    lights.clear();  // given back
    const bool has_far_light = field.cut.size() > 0;
    for (std::size_t k = before; k < found.size(); ++k) {
      if (!has_far_light) found[k].draws.fill({calc::HitLight::kNothing, 0.0f, 0.0f});
      if (!is_done(found[k])) throw_not_done();
      if (k > before && !are_in_order(found[k - 1], found[k])) throw_not_done();
    }
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
    turns_.clear();
  }

  const std::shared_ptr<DeviceThread> thread_;
  const HitLimits limits_;
  Turns<HitBuffers> turns_{3};
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
