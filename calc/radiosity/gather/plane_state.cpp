// A plane's sums so far as a field, and how much they are to be trusted.
#include "calc/radiosity/gather/plane_state.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"

#include <algorithm>
#include <utility>

namespace calc {
namespace {

// Share of the indirect part's variance below which openings need no more samples.
constexpr double kNegligibleVariance = 0.1;
// Share of a point's light above which a single sample on an opening is too much of it, half of
// what makes it doubtful.
constexpr double kLargestOpeningShare = 0.05;

}  // namespace

PlaneState::PlaneState(const std::string& plane_id, const SensorGrid& grid,
                       const std::vector<LightChannel>& channels, std::size_t replicates) {
  field_.plane_id = plane_id;
  field_.points = grid.position_m.size() * receivers_per_point(grid.derived);
  field_.point_weight = point_weights(grid);
  field_.replicates = replicates;
  field_.channels = channels;
  field_.direct_exact_lx.assign(channels.size() * points(), 0.0);
  sums_.connection_rays.assign(replicates, 0);
  sums_.near_rays.assign(replicates, 0);
  active_.assign(points(), 1);
  sums_.rounds.assign(points(), 0);
  sums_.paths.assign(points(), 0);
  sums_.possible_sample_lx.assign(points(), 0.0);
  sums_.largest_opening_lx.assign(points(), 0.0f);
  sums_.has_hidden_opening.assign(points(), 0);
  sums_.has_seen_opening.assign(points(), 0);
}

void PlaneState::refuse(Message problem) {
  is_active_ = false;
  field_.problem = std::move(problem);
}

void PlaneState::finish(StopReason reason) {
  is_active_ = false;
  field_.stop = reason;
}

bool PlaneState::are_all_active() const {
  return std::find(active_.begin(), active_.end(), 0) == active_.end();
}

void PlaneState::narrow(const std::vector<std::uint8_t>& active) {
  active_ = active;
  active_.resize(points(), 1);
  if (!are_all_active()) {
    if (even_.is_needed) return;
    even_.is_needed = true;
    even_.indirect_lx = sums_.indirect_sum_lx;
    even_.paths = sums_.paths;
    field_.even_direct_sampled_lx = field_.direct_sampled_lx;
    field_.even_indirect_lx = field_.indirect_lx;
  } else if (even_.is_needed) {
    even_.before_lx = sums_.indirect_sum_lx;
    even_.before_paths = sums_.paths;
  }
}

// After a look of all points, where others were not: what it added. Samples on openings are the
// same for all who have caught up with them, whatever they took part in.
void PlaneState::publish_even() {
  field_.even_direct_sampled_lx = field_.direct_sampled_lx;
  for (std::size_t i = 0; i < points(); ++i) {
    even_.paths[i] += sums_.paths[i] - even_.before_paths[i];
  }
  for (std::size_t k = 0; k < even_.indirect_lx.size(); ++k) {
    even_.indirect_lx[k] += sums_.indirect_sum_lx[k] - even_.before_lx[k];
    field_.even_indirect_lx[k] =
        even_.indirect_lx[k] / static_cast<double>(even_.paths[k % points()]);
  }
}

bool PlaneState::opening_error_matters() const {
  if (std::find(field_.unseen.begin(), field_.unseen.end(), 1) != field_.unseen.end()) return true;
  for (std::size_t i = 0; i < points(); ++i) {
    const double largest_lx = largest_opening_sample_lx(i);
    if (active_[i] != 0 && largest_lx > kLargestOpeningShare * field_.mean_lx(i)) return true;
  }
  if (field_.indirect_lx.empty()) return true;
  return squared_error(field_.direct_sampled_lx) >
         kNegligibleVariance * squared_error(field_.indirect_lx);
}

// Sum over active points of the squared standard error, all channels at full output.
double PlaneState::squared_error(const std::vector<double>& values_lx) const {
  double sum = 0.0;
  std::vector<double> at_point(field_.replicates);
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      at_point[r] = 0.0;
      for (std::size_t c = 0; c < channels(); ++c) {
        at_point[r] += values_lx[(r * channels() + c) * points() + i];
      }
    }
    const double error = replicate_mean(at_point).standard_error;
    sum += error * error;
  }
  return sum;
}

void PlaneState::publish(int looks_planned) {
  field_.looks_planned = looks_planned;
  field_.counters.active_points.push_back(
      static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1)));
  const std::size_t rows = field_.replicates * channels();
  if (sums_.most_rounds > 0) field_.direct_sampled_lx.resize(values());
  if (!sums_.indirect_sum_lx.empty()) field_.indirect_lx.resize(values());
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;  // nothing new
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t k = row * points() + i;
      if (sums_.most_rounds > 0)
        field_.direct_sampled_lx[k] = sums_.direct_sum_lx[k] / sums_.rounds[i];
      if (!sums_.indirect_sum_lx.empty()) {
        field_.indirect_lx[k] = sums_.indirect_sum_lx[k] / static_cast<double>(sums_.paths[i]);
      }
    }
  }
  if (even_.is_needed && are_all_active()) publish_even();
  if (!field_.is_exact()) {
    find_unseen();
    find_largest_samples();
  }
}

void PlaneState::find_unseen() {
  field_.unseen = sums_.may_be_sampled;
  for (std::size_t i = 0; i < points(); ++i) {
    if (sums_.has_seen_opening[i] != 0) field_.unseen[i] = 0;
  }
  for (std::size_t k = 0; k < sums_.indirect_sum_lx.size(); ++k) {
    if (sums_.indirect_sum_lx[k] > 0.0) field_.unseen[k % points()] = 0;
  }
}

void PlaneState::find_largest_samples() {
  field_.largest_share.assign(points(), 0.0f);
  if (!sums_.indirect_sum_lx.empty()) field_.largest_sample_lx.assign(points(), 0.0);
  for (std::size_t i = 0; i < points(); ++i) {
    double largest_lx = largest_opening_sample_lx(i);
    if (!sums_.indirect_sum_lx.empty()) {
      field_.largest_sample_lx[i] = largest_reflected_sample_lx(i);
      largest_lx = std::max(largest_lx, field_.largest_sample_lx[i]);
    }
    const double total_lx = field_.mean_lx(i);
    if (total_lx > 0.0) field_.largest_share[i] = static_cast<float>(largest_lx / total_lx);
  }
}

// What was drawn, or could have been where vertices are so few that none was.
double PlaneState::largest_reflected_sample_lx(std::size_t point) const {
  if (sums_.paths[point] == 0) return 0.0;
  double largest = sums_.possible_sample_lx[point];
  for (std::size_t r = 0; r < field_.replicates; ++r) {
    largest = std::max(largest, static_cast<double>(sums_.largest_sum_lx[r * points() + point]));
  }
  return largest / static_cast<double>(sums_.paths[point] * field_.replicates);
}

// Where every sample on an opening arrives, few are enough: they are spread evenly. Where some are
// hidden, those that are not may be few by chance.
double PlaneState::largest_opening_sample_lx(std::size_t point) const {
  if (sums_.rounds[point] == 0 || sums_.has_hidden_opening[point] == 0) return 0.0;
  return static_cast<double>(sums_.largest_opening_lx[point]) /
         static_cast<double>(sums_.rounds[point] * field_.replicates);
}

}  // namespace calc
