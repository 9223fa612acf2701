#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/shadow_batch.h"

#include <cstddef>

namespace calc {
namespace {

class CpuGatherer : public Gatherer {
 public:
  // Single precision for the geometry of a pair: rounding is 1e-6 of a contribution and averages
  // out; the sums are double.
  std::uint64_t gather(const GatherBatch& batch, const GatherSums& sums) override {
    ShadowBatch shadows(batch.tracer, batch.has_shadows);
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
      const float g = connection_geometry(kernel, axis, v.normal, v.position_m - x);
      if (!(g > 0.0f)) continue;
      const float bounded = batch.bounds.limited(connection.vertex, g);
      const double lx = static_cast<double>(connection_lx(connection.weight, v.flux_lm, bounded));
      shadows.add(from, v.position_m, lx, &sums.lx[v.channel * sums.stride + current],
                  &sums.largest_lx[current]);
    }
    shadows.flush();
    return shadows.rays();
  }

  std::string description() const override { return "cpu (" + tracer_version() + ")"; }
};

}  // namespace

std::unique_ptr<Gatherer> make_cpu_gatherer() { return std::make_unique<CpuGatherer>(); }

}  // namespace calc
