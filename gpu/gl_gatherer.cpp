#include "gpu/gl_gatherer.h"

#include "gpu/draw_piece.h"
#include "gpu/draw_queue.h"
#include "gpu/gather_pass.h"
#include "gpu/gl_error.h"
#include "gpu/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// A piece of work should be large beside the way to the device and back, a tenth of a millisecond,
// and small beside a replicate.
constexpr std::size_t kTilesPerBatch = 64;

GpuReceiver gpu_receiver(const calc::Tracer& tracer, const calc::Receiver& receiver) {
  return {glm::vec4(glm::vec3(receiver.position_m), 0.0f),
          glm::vec4(glm::vec3(receiver.axis), static_cast<float>(receiver.kernel)),
          glm::vec4(glm::vec3(tracer.lift(receiver)), 0.0f)};
}

// Adds the results of some connections in their order; returns the rays.
std::uint64_t add_results(const calc::GatherBatch& batch,
                          std::span<const calc::Connection> connections,
                          std::span<const std::uint32_t> results, const calc::GatherSums& sums) {
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < connections.size(); ++i) {
    if (results[i] == kNoRay) continue;
    if (results[i] == kNotDone) throw calc::BackendFailure("the device did not finish its work");
    ++rays;
    if (results[i] == kAddsNothing) continue;
    const calc::Connection& connection = connections[i];
    const calc::LightVertex& v = batch.vertices[connection.vertex];
    auto lx = std::bit_cast<float>(results[i]);
    if (lx < 0.0f) {
      lx = calc::connection_lx(connection.weight, v.flux_lm,
                               batch.bounds.limited(connection.vertex, -lx));
    }
    sums.lx[v.channel * sums.stride + connection.receiver] += static_cast<double>(lx);
    float& largest = sums.largest_lx[connection.receiver];
    largest = std::max(largest, lx);
  }
  return batch.has_shadows ? rays : 0;
}

class GlGatherer : public calc::Gatherer {
 public:
  GlGatherer(std::shared_ptr<DeviceThread> thread, const DrawLimits& limits)
      : thread_(std::move(thread)), limits_(limits) {}
  ~GlGatherer() override {
    thread_->clean_up([this](DeviceState&) {
      gather_pass_.reset();
      draws_.clear();
      pools_.clear();
    });
  }
  GlGatherer(const GlGatherer&) = delete;
  GlGatherer& operator=(const GlGatherer&) = delete;

  std::uint64_t gather(const calc::GatherBatch& batch, const calc::GatherSums& sums) override {
    std::vector<GpuReceiver> receivers;
    receivers.reserve(batch.receivers.size());
    for (const calc::Receiver& receiver : batch.receivers) {
      receivers.push_back(gpu_receiver(batch.tracer, receiver));
    }
    std::vector<std::uint32_t> results;
    std::uint64_t rays = 0;
    for (std::size_t first = 0; first < batch.connections.size();) {
      const auto connections = batch.connections.subspan(
          first, std::min(GatherPass::kMostConnections, batch.connections.size() - first));
      results.assign(connections.size(), kNotDone);  // also if reading back does nothing
      run({&batch.tracer, batch.vertices, batch.vertices_identity, receivers, connections,
           batch.bounds.lowest_per_m2(), batch.has_shadows, results});
      rays += add_results(batch, connections, results, sums);
      first += connections.size();
    }
    return rays;
  }

  std::uint64_t draw_and_gather(const calc::DrawBatch& batch) override {
    PackedPool packed;
    const bool has_to_send = !pools_.holds(batch.tree.identity());
    if (has_to_send) packed = pack_pool(batch.tree);
    DrawPacker packer(batch, limits_);
    DrawPiece piece;
    std::uint64_t rays = 0;
    while (packer.next(piece)) {
      draws_.run(*thread_, pools_, piece, has_to_send ? &packed : nullptr);
      if (piece.is_cut_short) break;
      rays += packer.add(piece);
    }
    return rays;
  }

  std::size_t tiles_per_batch() const override { return kTilesPerBatch; }

  std::string description() const override {
    const Device& device = thread_->device();
    return fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  }

 private:
  void run(const GatherJob& job) {
    thread_->run([&](DeviceState& device) {
      try {
        if (!gather_pass_) gather_pass_ = std::make_unique<GatherPass>();
        gather_pass_->run(device, pools_, job);
      } catch (const OutOfMemory&) {
        pools_.clear();  // what is kept for later may be what leaves no room
        throw;
      }
    });
  }

  const std::shared_ptr<DeviceThread> thread_;
  const DrawLimits limits_;
  DevicePools pools_;
  DrawQueue draws_;
  std::unique_ptr<GatherPass> gather_pass_;  // of the device's thread alone
};

}  // namespace

std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread,
                                                 const DrawLimits& limits) {
  return std::make_unique<GlGatherer>(std::move(thread), limits);
}

}  // namespace gpu
