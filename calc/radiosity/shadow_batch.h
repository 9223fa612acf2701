#pragma once
// Sums light contributions at one point whose visibility is still open, sixteen shadow rays at a
// time.

#include "calc/radiosity/rays.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace calc {

// add() and flush() add visible contributions to sums[channel * stride] in the order in which they
// were added, so that the sum is the same in bits whatever else runs at the same time.
class ShadowBatch {
 public:
  // from_m: lifted receiver, local. sums must outlive the batch.
  ShadowBatch(const Tracer& tracer, const glm::dvec3& from_m, double* sums, std::size_t stride)
      : tracer_(tracer), from_m_(from_m), sums_(sums), stride_(stride) {}

  // to_m: lifted source, local.
  void add(const glm::vec3& to_m, double contribution, std::uint32_t channel) {
    const auto k = static_cast<std::size_t>(packet_.count);
    packet_.to_x[k] = to_m.x;
    packet_.to_y[k] = to_m.y;
    packet_.to_z[k] = to_m.z;
    contribution_[k] = contribution;
    channel_[k] = channel;
    if (++packet_.count == SegmentPacket::kSize) flush();
  }

  void flush() {
    if (packet_.count == 0) return;
    const std::uint32_t blocked = tracer_.blocked(from_m_, packet_);
    for (std::size_t k = 0; k < static_cast<std::size_t>(packet_.count); ++k) {
      if (((blocked >> k) & 1u) == 0) sums_[channel_[k] * stride_] += contribution_[k];
    }
    rays_ += static_cast<std::uint64_t>(packet_.count);
    packet_.count = 0;
  }

  std::uint64_t rays() const { return rays_; }

 private:
  const Tracer& tracer_;
  glm::vec3 from_m_;
  double* sums_;
  std::size_t stride_;
  SegmentPacket packet_;
  std::array<double, SegmentPacket::kSize> contribution_;
  std::array<std::uint32_t, SegmentPacket::kSize> channel_;
  std::uint64_t rays_ = 0;
};

}  // namespace calc
