#include "gpu/raster/shadow_map_gatherer.h"

#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/raster/shadow_map_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

namespace gpu {
namespace {

class ShadowMapGatherer : public calc::Gatherer {
 public:
  ShadowMapGatherer(std::shared_ptr<DeviceThread> thread, std::uint32_t texels)
      : thread_(std::move(thread)), texels_(texels) {}
  ~ShadowMapGatherer() override {
    thread_->clean_up([this](DeviceState&) { pass_.reset(); });
  }
  ShadowMapGatherer(const ShadowMapGatherer&) = delete;
  ShadowMapGatherer& operator=(const ShadowMapGatherer&) = delete;

  bool connects_all() const override { return true; }

  std::uint64_t gather(const calc::GatherBatch&, const calc::GatherSums&) override {
    throw calc::BackendFailure("shadow maps need --method instant-radiosity");
  }

  std::uint64_t draw_and_gather(const calc::DrawBatch&) override {
    throw calc::BackendFailure("shadow maps need --method instant-radiosity");
  }

  calc::SharedGather gather_all(const calc::GatherBatch& batch,
                                const calc::GatherSums& sums) override {
    calc::SharedGather done;
    done.pairs.assign(batch.receivers.size(), 0);
    const std::vector<GpuReceiver> receivers = gpu_receivers(batch.tracer, batch.receivers);
    const ShadowMapJob job{&batch.tracer,
                           batch.vertices,
                           receivers,
                           batch.bounds.lowest_per_m2(),
                           batch.has_shadows && !batch.tracer.scene().triangle.empty(),
                           batch.deadline_s,
                           [&](std::size_t first, std::size_t first_receiver, std::size_t count,
                               std::span<const std::uint32_t> results) {
                             for (std::size_t k = 0; k < results.size(); k += count) {
                               add_results(batch.vertices[first++].channel, first_receiver,
                                           results.subspan(k, count), sums, done.pairs);
                             }
                           }};
    thread_->run([&](DeviceState& device) {
      if (!pass_) pass_ = std::make_unique<ShadowMapPass>(texels_, device.programs);
      const ShadowMapTimes times = pass_->run(device, job);
      done.maps_s = times.maps_s;
      done.gather_s = times.gather_s;
    });
    return done;
  }

  std::string description() const override {
    const Device& device = thread_->device();
    return fmt::format("gpu ({}{}), shadow maps of {} texels", device.name(),
                       device.is_software ? ", software" : "", texels_);
  }

 private:
  // Of one vertex at some receivers.
  static void add_results(std::uint32_t channel, std::size_t first_receiver,
                          std::span<const std::uint32_t> results, const calc::GatherSums& sums,
                          std::vector<std::uint32_t>& pairs) {
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (results[k] == kNoRay) continue;
      if (results[k] == kNotDone) throw_not_done();
      const std::size_t receiver = first_receiver + k;
      ++pairs[receiver];
      if (results[k] == kAddsNothing) continue;
      const auto lx = std::bit_cast<float>(results[k]);
      sums.lx[channel * sums.stride + receiver] += static_cast<double>(lx);
      sums.largest_lx[receiver] = std::max(sums.largest_lx[receiver], lx);
    }
  }

  const std::shared_ptr<DeviceThread> thread_;
  const std::uint32_t texels_;
  std::unique_ptr<ShadowMapPass> pass_;  // of the device's thread alone
};

}  // namespace

std::unique_ptr<calc::Gatherer> make_shadow_map_gatherer(std::shared_ptr<DeviceThread> thread,
                                                         std::uint32_t texels) {
  return std::make_unique<ShadowMapGatherer>(std::move(thread), texels);
}

}  // namespace gpu
