// A plane's sums so far as a field, and how much they are to be trusted.
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "calc/radiosity/plane_work.h"

#include <algorithm>
#include <numeric>

namespace calc {
namespace {

// Share of the indirect part's variance below which openings need no more samples.
constexpr double kNegligibleVariance = 0.1;
// Share of a point's light above which a single sample on an opening is too much of it, half of
// what makes it doubtful.
constexpr double kLargestOpeningShare = 0.05;
constexpr double kMostRepeated = 0.9;  // of a vertex's light around a point, reflectance for ever

}  // namespace

bool PlaneWork::opening_error_matters() const {
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
double PlaneWork::squared_error(const std::vector<double>& values_lx) const {
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

// Times the paths of the look. No vertex is nearer than the point is clear. What stands near a
// point is near the surfaces around it, too, and comes from them once more by short rays.
double PlaneWork::possible_sample_lx(std::size_t point) const {
  const double most = possible_vertex_.most_per_m2,
               clear_m = clear_m_.empty() ? 0.0 : clear_m_[point];
  const double geometry = clear_m * clear_m * most > 1.0 ? 1.0 / (clear_m * clear_m) : most;
  const double vertex_lx = possible_vertex_.flux_lm * geometry / kPi;
  if (!(clear_m < reach_m_)) return vertex_lx;
  return vertex_lx / (1.0 - std::min(possible_vertex_.mean_reflectance, kMostRepeated));
}

void PlaneWork::finish_look(std::uint64_t batch_paths) {
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;
    paths_[i] += batch_paths;
    if (has_indirect_[i] != 0) {
      possible_sample_lx_[i] = std::max(possible_sample_lx_[i], possible_sample_lx(i));
    }
  }
  if (reach_m_ > 0.0) share_short_rays(batch_paths);
  SolveCounters& counters = field_.counters;
  counters.paths += batch_paths * field_.replicates;
  counters.connection_rays = std::accumulate(replicate_connection_rays_.begin(),
                                             replicate_connection_rays_.end(), std::uint64_t{0});
  counters.near_rays =
      std::accumulate(replicate_near_rays_.begin(), replicate_near_rays_.end(), std::uint64_t{0});
}

void PlaneWork::publish(int looks_planned) {
  field_.looks_planned = looks_planned;
  field_.counters.active_points.push_back(
      static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1)));
  const std::size_t rows = field_.replicates * channels();
  if (most_rounds_ > 0) field_.direct_sampled_lx.resize(values());
  if (!indirect_sum_lx_.empty()) field_.indirect_lx.resize(values());
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;  // nothing new
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t k = row * points() + i;
      if (most_rounds_ > 0) field_.direct_sampled_lx[k] = direct_sum_lx_[k] / rounds_[i];
      if (!indirect_sum_lx_.empty()) {
        field_.indirect_lx[k] = indirect_sum_lx_[k] / static_cast<double>(paths_[i]);
      }
    }
  }
  if (!field_.is_exact()) {
    find_unseen();
    find_largest_samples();
  }
}

void PlaneWork::find_unseen() {
  field_.unseen = may_be_sampled_;
  for (std::size_t i = 0; i < points(); ++i) {
    if (has_seen_opening_[i] != 0) field_.unseen[i] = 0;
  }
  for (std::size_t k = 0; k < indirect_sum_lx_.size(); ++k) {
    if (indirect_sum_lx_[k] > 0.0) field_.unseen[k % points()] = 0;
  }
}

void PlaneWork::find_largest_samples() {
  field_.largest_share.assign(points(), 0.0f);
  if (!indirect_sum_lx_.empty()) field_.largest_sample_lx.assign(points(), 0.0);
  for (std::size_t i = 0; i < points(); ++i) {
    double largest_lx = largest_opening_sample_lx(i);
    if (!indirect_sum_lx_.empty()) {
      field_.largest_sample_lx[i] = largest_reflected_sample_lx(i);
      largest_lx = std::max(largest_lx, field_.largest_sample_lx[i]);
    }
    const double total_lx = field_.mean_lx(i);
    if (total_lx > 0.0) field_.largest_share[i] = static_cast<float>(largest_lx / total_lx);
  }
}

// What was drawn, or could have been where vertices are so few that none was.
double PlaneWork::largest_reflected_sample_lx(std::size_t point) const {
  if (paths_[point] == 0) return 0.0;
  double largest = possible_sample_lx_[point];
  for (std::size_t r = 0; r < field_.replicates; ++r) {
    largest = std::max(largest, static_cast<double>(largest_sum_lx_[r * points() + point]));
  }
  return largest / static_cast<double>(paths_[point] * field_.replicates);
}

// Where every sample on an opening arrives, few are enough: they are spread evenly. Where some are
// hidden, those that are not may be few by chance.
double PlaneWork::largest_opening_sample_lx(std::size_t point) const {
  if (rounds_[point] == 0 || has_hidden_opening_[point] == 0) return 0.0;
  return static_cast<double>(largest_opening_lx_[point]) /
         static_cast<double>(rounds_[point] * field_.replicates);
}

}  // namespace calc
