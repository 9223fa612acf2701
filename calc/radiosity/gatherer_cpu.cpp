#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/shadow_batch.h"
#include "calc/units.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace calc {
namespace {

// Single precision for the geometry of a pair: rounding is 1e-6 of a contribution and averages out;
// the sums are double.
std::uint64_t gather_point(const Tracer& tracer, const glm::dvec3& position_m,
                           const glm::dvec3& normal, const LightVertices& vertices, double* sums,
                           std::size_t stride) {
  ShadowBatch batch(tracer, tracer.lift(position_m, normal), sums, stride);
  const glm::vec3 x(position_m);
  const glm::vec3 nx(normal);
  const auto offset = static_cast<float>(tracer.offset_m());
  for (std::uint32_t channel = 0; channel < vertices.channels(); ++channel) {
    for (std::size_t j = vertices.channel_begin[channel]; j < vertices.channel_begin[channel + 1];
         ++j) {
      const glm::vec3 w = vertices.position_m[j] - x;
      const float cx = glm::dot(nx, w);
      const float cy = -glm::dot(vertices.normal[j], w);
      if (!(cx > 0.0f) || !(cy > 0.0f)) continue;
      const float d2 = glm::dot(w, w);
      const float g = std::min(cx * cy / (d2 * d2), vertices.bound_per_m2[j]);
      const double lx = vertices.flux_lm[j] / kPi * static_cast<double>(g);
      batch.add(vertices.position_m[j] + offset * vertices.normal[j], lx, channel);
    }
  }
  batch.flush();
  return batch.rays();
}

class CpuGatherer : public Gatherer {
 public:
  std::uint64_t gather(const Tracer& tracer, const Receivers& receivers,
                       const LightVertices& vertices, std::span<double> sum_lx) override {
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(std::size_t{0}, receivers.size(), [&](std::size_t i) {
      const FlushDenormals flush;
      rays += gather_point(tracer, receivers.position_m[i], receivers.normal[i], vertices,
                           &sum_lx[i], receivers.size());
    });
    return rays;
  }

  std::string description() const override { return "cpu (" + tracer_version() + ")"; }
};

}  // namespace

std::unique_ptr<Gatherer> make_cpu_gatherer() { return std::make_unique<CpuGatherer>(); }

}  // namespace calc
