#pragma once
// Points whose quantity is more than one illuminance: glare ratings and modelling. Each has limits
// at any level; derived_metrics.h has their statistics.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/receiver_kernel.h"
#include "rules/measure/metrics.h"
#include "rules/measure/replicate_sample.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rules {

class DerivedPoints {
 public:
  virtual ~DerivedPoints() = default;
  virtual std::size_t points() const = 0;
  // Returns the value of a point and its two ends. The true value lies beyond each end with the
  // probability that belongs to t. Ends may be infinite; a value that does not exist is -infinity.
  virtual Limits limits(std::size_t point, double t) const = 0;
  std::size_t replicates() const { return replicates_; }
  bool is_unseen(std::size_t point) const { return unseen_[point] != 0; }
  bool rests_on_one_sample(std::size_t point) const { return single_sample_[point] != 0; }
  bool is_doubtful(std::size_t point) const {
    return is_unseen(point) || rests_on_one_sample(point);
  }

 protected:
  std::size_t replicates_ = 1;
  std::vector<std::uint8_t> unseen_, single_sample_;
};

// E_z / E of the plane across the axis. The limits follow Fieller's theorem, from the replicates of
// both at the same point, so that their common part does not count twice.
class ModellingPoints : public DerivedPoints {
 public:
  // receivers: of a plane of DerivedQuantity::modelling. points: chosen points of the grid.
  ModellingPoints(const PointValues& receivers, const std::vector<std::size_t>& points);
  std::size_t points() const override { return cylinder_.size(); }
  Limits limits(std::size_t point, double t) const override;
  // Returns the number of points where neither is lit, so that there is no ratio.
  std::size_t dark_points() const { return dark_points_; }

 private:
  struct Mean {
    double value, variance, largest_sample;
  };
  std::vector<Mean> cylinder_, plane_;
  std::vector<double> covariance_;
  std::size_t dark_points_ = 0;
};

// UGR = 8 log10(0.25 pi G / E), G = sum of L^2 w / p^2, E: illuminance of the eye by reflected
// light. It falls with E and rises with G, so the ends of their intervals give those of UGR, and
// the level of E's t-interval is kept. -infinity where G is 0: no glare source. The upper end is
// larger where an eye sees a source too large for the formula, see calc::kLuminousCeiling_lx.
class GlarePoints : public DerivedPoints {
 public:
  GlarePoints(const PointValues& indirect, const calc::GlareField& glare,
              const std::vector<double>& channel_weights, const std::vector<std::size_t>& points);
  std::size_t points() const override { return eye_.size(); }
  Limits limits(std::size_t point, double t) const override;
  bool sees_source(std::size_t point) const { return eye_[point].high_sum > 0.0; }
  // Returns the points as if the sums were exact: only the sampled light is in doubt.
  GlarePoints without_doubts() const;
  // Returns whether it is proved that no reflected light reaches the point.
  bool has_black_background(std::size_t point) const {
    return replicates_ == 1 && !(eye_[point].mean_lx > 0.0);
  }
  // Returns whether, at any point, a source is outside the formula or an opening partly hidden.
  bool has_inexact_sources() const;

 private:
  struct Eye {
    double sum, low_sum, high_sum;  // of L^2 w / p^2
    double mean_lx, error_lx, largest_sample_lx;
    bool is_large_seen;  // too large for the formula
  };
  std::vector<Eye> eye_;
};

// The number of points for which the formula is not stated, and the reason for the first of them in
// words; "" for none. channel_weights as above.
struct GlareDoubts {
  std::size_t points = 0;
  calc::Message first;
};
GlareDoubts glare_doubts(const calc::GlareField& glare, const std::vector<double>& channel_weights,
                         const std::vector<std::size_t>& points);

// Returns the mean of the four planes as the illuminance of each point. receivers: of a plane of
// DerivedQuantity::four_planes.
PointValues mean_of_four_planes(const PointValues& receivers);
// Returns the true cylindrical illuminance of the same points.
PointValues true_cylinders(const PointValues& receivers);

}  // namespace rules
