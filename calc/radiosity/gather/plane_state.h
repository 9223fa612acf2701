#pragma once
// The contributions of sampling rounds to one plane so far, without the means to add more: its
// sums, and the field made of them.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// All that the next round and the field need of earlier rounds. r: replicate, c: channel, p: point;
// empty where no such quantity was sampled.
struct PlaneSums {
  std::vector<double> direct_sum_lx;             // [r][c][p], sum over rounds
  std::vector<std::uint32_t> rounds;             // [p]
  std::vector<float> largest_opening_lx;         // [p], largest sample of a round
  std::vector<std::uint8_t> has_hidden_opening;  // [p], 1: some sample was not seen
  std::vector<std::uint8_t> has_seen_opening;    // [p], 1: some sample was
  std::uint32_t most_rounds = 0;
  std::vector<std::uint8_t> may_be_sampled;    // [p]
  std::vector<double> indirect_sum_lx;         // [r][c][p], sum over batches, each times its paths
  std::vector<std::uint64_t> paths;            // [p], per replicate
  std::vector<float> largest_sum_lx;           // [r][p], largest sample times its paths
  std::vector<double> possible_sample_lx;      // [p], the largest of its rounds
  std::vector<double> short_ray_factor;        // [p]
  std::vector<double> clear_m;                 // [p], up to a limit set by the first round
  std::vector<std::uint64_t> connection_rays;  // [r]
  std::vector<std::uint64_t> near_rays;        // [r]
};

class PlaneState {
 public:
  // channels: as PreparedScene::channels.
  PlaneState(const std::string& plane_id, const SensorGrid& grid,
             const std::vector<LightChannel>& channels, std::size_t replicates);

  // Returns whether sampling rounds still add to this plane.
  bool is_active() const { return is_active_; }
  void refuse(Message problem);    // ends the work; field().problem says why
  void finish(StopReason reason);  // ends the work with what was published last
  PlaneField& field() { return field_; }
  const PlaneField& field() const { return field_; }
  PlaneSums& sums() { return sums_; }
  const PlaneSums& sums() const { return sums_; }
  std::size_t points() const { return field_.points; }
  std::size_t channels() const { return field_.channels.size(); }
  std::size_t values() const { return field_.replicates * channels() * points(); }

  // Returns [point], 1: sampling rounds add to it.
  const std::vector<std::uint8_t>& active() const { return active_; }
  // Limits further rounds to these points; empty: to all.
  void narrow(const std::vector<std::uint8_t>& active);
  // Returns whether the error of openings' samples matters beside the indirect part.
  bool opening_error_matters() const;
  // Turns the sums so far into field(). looks_planned: see PlaneField.
  void publish(int looks_planned);

 private:
  // Marks points that sampled light may reach but has not.
  void find_unseen();
  void find_largest_samples();
  double largest_reflected_sample_lx(std::size_t point) const;
  double largest_opening_sample_lx(std::size_t point) const;
  double squared_error(const std::vector<double>& values_lx) const;

  bool are_all_active() const;
  void publish_even();

  // Sums over the rounds in which all points took part, once a point was left out of a round.
  struct EvenSums {
    bool is_needed = false;
    std::vector<double> indirect_lx, before_lx;      // [r][c][p]; before: without this round
    std::vector<std::uint64_t> paths, before_paths;  // [p]
  };

  std::vector<std::uint8_t> active_;
  EvenSums even_;
  bool is_active_ = true;
  PlaneField field_;
  PlaneSums sums_;
};

}  // namespace calc
