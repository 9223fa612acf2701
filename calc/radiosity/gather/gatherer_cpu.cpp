#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/shadow_batch.h"
#include "calc/rays/triangle_tree.h"

#include <cstddef>
#include <vector>

namespace calc {
namespace {

class CpuGatherer : public Gatherer {
 public:
  // Single precision for the geometry of a pair: rounding is 1e-6 of a contribution and averages
  // out; the sums are double.
  std::uint64_t gather(const GatherBatch& batch, const GatherSums& sums) override {
    ShadowBatch shadows(batch.tracer, batch.has_shadows, kReceiverToVertex);
    const auto near_m = static_cast<float>(batch.tracer.offset_m());
    const bool has_far = batch.tracer.scene().far_extent_m > 0.0;
    std::uint32_t current = ~0u;
    glm::vec3 from(0.0f), x(0.0f), axis(0.0f);
    ReceiverKernel kernel = ReceiverKernel::planar;
    for (const Connection& connection : batch.connections) {
      if (connection.receiver != current) {
        current = connection.receiver;
        const Receiver& receiver = batch.receivers[current];
        from = glm::vec3(batch.tracer.lift(receiver));
        x = glm::vec3(receiver.position_m);
        axis = glm::vec3(receiver.axis);
        kernel = receiver.kernel;
      }
      const LightVertex& v = batch.vertices[connection.vertex];
      const float lift_m = has_far ? lift_at(v.position_m, near_m) : near_m;
      const float g = lifted_connection_geometry(kernel, axis, v.normal, v.position_m - x, lift_m);
      if (!(g > 0.0f)) continue;
      const float bounded = batch.bounds.limited(connection.vertex, g);
      const double lx = static_cast<double>(connection_lx(connection.weight, v.flux_lm, bounded));
      shadows.add(from, v.position_m, lx, &sums.lx[v.channel * sums.stride + current],
                  &sums.largest_lx[current]);
    }
    shadows.flush();
    return shadows.rays();
  }

  std::uint64_t draw_and_gather(const DrawBatch& batch) override {
    thread_local Cut cut;
    thread_local std::vector<float> scratch;
    thread_local std::vector<Connection> connections;
    std::uint64_t rays = 0;
    for (std::size_t t = 0; t < batch.sums.size(); ++t) {
      if (is_past(batch.deadline_s)) break;
      const ReceiverGroup& tile = batch.group(t);
      cut.build(batch.tree, tile_of(tile.receiver, batch.tracer.scene().whole_extent_m()),
                batch.cut);
      connections.clear();
      for (std::uint32_t k = 0; k < tile.receiver.size(); ++k) {
        draw_connections(batch.tree, cut, tile.receiver[k], k, batch.draws,
                         batch.shift_of(tile.point[k]), scratch, connections);
      }
      rays += gather({batch.tracer, batch.tree.vertices(), batch.bounds, tile.receiver, connections,
                      batch.has_shadows, batch.tree.identity()},
                     batch.sums[t]);
    }
    return rays;
  }

  std::string description() const override { return "cpu"; }
};

}  // namespace

std::unique_ptr<Gatherer> make_cpu_gatherer() { return std::make_unique<CpuGatherer>(); }

}  // namespace calc
