// A plane's sums so far as a field, and how much they are to be trusted.
#include "calc/base/statistics.h"
#include "calc/radiosity/plane_work.h"

#include <algorithm>
#include <numeric>

namespace calc {
namespace {

// Share of the indirect part's variance below which openings need no more samples.
constexpr double kNegligibleVariance = 0.1;

}  // namespace

bool PlaneWork::opening_error_matters() const {
  if (std::find(field_.unseen.begin(), field_.unseen.end(), 1) != field_.unseen.end()) return true;
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

void PlaneWork::finish_look(std::uint64_t batch_paths) {
  for (std::size_t i = 0; i < points(); ++i) {
    if (active_[i] == 0) continue;
    paths_[i] += batch_paths;
    if (has_indirect_[i] != 0) {
      possible_sample_lx_[i] = std::max(possible_sample_lx_[i], look_sample_lx_);
    }
  }
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
    find_largest_share();
  }
}

void PlaneWork::find_unseen() {
  field_.unseen = may_be_sampled_;
  for (const std::vector<double>* sums : {&direct_sum_lx_, &indirect_sum_lx_}) {
    for (std::size_t k = 0; k < sums->size(); ++k) {
      if ((*sums)[k] > 0.0) field_.unseen[k % points()] = 0;
    }
  }
}

void PlaneWork::find_largest_share() {
  field_.largest_share.assign(points(), 0.0f);
  if (indirect_sum_lx_.empty()) return;
  const auto replicates = static_cast<double>(field_.replicates);
  for (std::size_t i = 0; i < points(); ++i) {
    double total_lx = 0.0;
    // What was drawn, or could have been where vertices are so few that none was.
    double largest = possible_sample_lx_[i];
    for (std::size_t c = 0; c < channels(); ++c) {
      total_lx += field_.direct_exact_lx[c * points() + i];
    }
    for (std::size_t row = 0; row < field_.replicates * channels(); ++row) {
      const std::size_t k = row * points() + i;
      total_lx += field_.indirect_lx[k] / replicates;
      if (!field_.direct_sampled_lx.empty()) total_lx += field_.direct_sampled_lx[k] / replicates;
    }
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      largest = std::max(largest, static_cast<double>(largest_sum_lx_[r * points() + i]));
    }
    if (!(total_lx > 0.0) || paths_[i] == 0) continue;
    field_.largest_share[i] =
        static_cast<float>(largest / (static_cast<double>(paths_[i]) * replicates * total_lx));
  }
}

}  // namespace calc
