#pragma once
// Sums light contributions whose visibility is still open, sixteen shadow rays at a time.

#include "calc/radiosity/sampling/rays.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace calc {

// Sums visible contributions in the order in which they were added, so that every sum has the same
// bits whatever else runs at the same time.
class ShadowBatch {
 public:
  // has_shadows: false if all ends are proved to see each other. left_out: margins at the ends of
  // all its segments.
  ShadowBatch(const Tracer& tracer, bool has_shadows, SegmentMargins left_out)
      : tracer_(tracer), has_shadows_(has_shadows), left_out_(left_out) {}

  // Adds a contribution. from_m, to_m: lifted ends, local. *sum must live until flush(). largest:
  // raised to the largest visible contribution; may be null.
  void add(const glm::vec3& from_m, const glm::vec3& to_m, double contribution, double* sum,
           float* largest = nullptr) {
    const std::size_t k = packet_.add(from_m, to_m, left_out_);
    contribution_[k] = contribution;
    sum_[k] = sum;
    largest_[k] = largest;
    if (packet_.is_full()) flush();
  }

  void flush() {
    if (packet_.count == 0) return;
    has_contributions_ = true;
    const std::uint32_t blocked = has_shadows_ ? tracer_.blocked(packet_) : 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(packet_.count); ++k) {
      if (((blocked >> k) & 1u) != 0) {
        has_hidden_ = true;
        continue;
      }
      *sum_[k] += contribution_[k];
      has_seen_ = true;
      if (largest_[k] != nullptr && static_cast<float>(contribution_[k]) > *largest_[k]) {
        *largest_[k] = static_cast<float>(contribution_[k]);
      }
    }
    if (has_shadows_) rays_ += static_cast<std::uint64_t>(packet_.count);
    packet_.count = 0;
  }

  std::uint64_t rays() const { return rays_; }  // traced
  // Returns whether any contribution was not 0 before visibility.
  bool has_contributions() const { return has_contributions_; }
  // Returns whether any contribution was hidden.
  bool has_hidden() const { return has_hidden_; }
  bool has_seen() const { return has_seen_; }

 private:
  const Tracer& tracer_;
  bool has_shadows_;
  SegmentMargins left_out_;
  SegmentPacket packet_;
  std::array<double, SegmentPacket::kSize> contribution_;
  std::array<double*, SegmentPacket::kSize> sum_;
  std::array<float*, SegmentPacket::kSize> largest_;
  std::uint64_t rays_ = 0;
  bool has_contributions_ = false, has_hidden_ = false, has_seen_ = false;
};

}  // namespace calc
