#include "gpu/gather/gl_gatherer.h"

#include "gpu/gather/draw_piece.h"
#include "gpu/gather/draw_queue.h"
#include "gpu/gather/gather_pass.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// Adds the results of some connections in their order; returns the rays.
std::uint64_t add_results(const calc::GatherBatch& batch,
                          std::span<const calc::Connection> connections,
                          std::span<const std::uint32_t> results, const calc::GatherSums& sums) {
  std::uint64_t rays = 0;
  for (std::size_t i = 0; i < connections.size(); ++i) {
    if (results[i] == kNoRay) continue;
    if (results[i] == kNotDone) throw_not_done();
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
      : thread_(std::move(thread)), limits_(limits), draws_(limits) {}
  ~GlGatherer() override {
    thread_->clean_up([this](DeviceState& device) {
      gather_pass_.reset();
      draws_.clear();
      device.pools.clear();
      device.draw_points.clear();
    });
  }
  GlGatherer(const GlGatherer&) = delete;
  GlGatherer& operator=(const GlGatherer&) = delete;

  std::uint64_t gather(const calc::GatherBatch& batch, const calc::GatherSums& sums) override {
    const std::vector<GpuReceiver> receivers = gpu_receivers(batch.tracer, batch.receivers);
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
    const std::shared_ptr<const PackedPool> pool = thread_->pools().pack_unless_held(batch.tree);
    DrawPacker packer(batch, limits_);
    DrawPiece piece;
    std::uint64_t rays = 0;
    while (packer.next(piece)) {
      const std::shared_ptr<const DrawPoints::Packed> points =
          thread_->draw_points().pack_unless_held(batch.tracer, batch.tiles, piece.block);
      draws_.run(*thread_, piece, pool.get(), points.get());
      if (piece.is_cut_short) break;
      rays += packer.add(piece);
    }
    return rays;
  }

  std::size_t tiles_per_batch(const calc::TileWork& work) const override {
    return gpu::tiles_per_batch(work, limits_, draws_.places_per_dispatch());
  }

  std::string description() const override {
    const Device& device = thread_->device();
    return fmt::format("gpu ({}{})", device.name(), device.is_software ? ", software" : "");
  }

 private:
  void run(const GatherJob& job) {
    thread_->run([&](DeviceState& device) {
      if (!gather_pass_) gather_pass_ = std::make_unique<GatherPass>();
      gather_pass_->run(device, device.pools, job);
    });
  }

  const std::shared_ptr<DeviceThread> thread_;
  const DrawLimits limits_;
  DrawQueue draws_;
  std::unique_ptr<GatherPass> gather_pass_;  // of the device's thread alone
};

}  // namespace

std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::shared_ptr<DeviceThread> thread,
                                                 const DrawLimits& limits) {
  return std::make_unique<GlGatherer>(std::move(thread), limits);
}

}  // namespace gpu
