#pragma once
// How steeply illuminance changes over a plane: ratios between neighbouring points of its grid.

#include "calc/scene/sensor_grid.h"
#include "rules/measure/derived_points.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rules {

// E of one point / E of the other, for two points whose cells share a side. Each pair is there
// twice, once either way, so the largest of all ratios is >= 1. The limits follow Fieller's
// theorem, from the replicates of both points, so that their common part does not count twice.
class NeighbourPairs : public DerivedPoints {
 public:
  // values: of the chosen points of the grid, in their order.
  NeighbourPairs(const PointValues& values, const calc::SensorGrid& grid,
                 const std::vector<std::size_t>& chosen);

  std::size_t points() const override { return pairs_.size(); }  // number of ratios
  // A ratio to a point that is surely dark is infinite.
  Limits limits(std::size_t pair, double t) const override;

  // Returns the places of numerator and denominator among the chosen points.
  const std::array<std::size_t, 2>& pair(std::size_t index) const { return pairs_[index]; }

 private:
  void add(const PointValues& values, std::size_t a, std::size_t b);

  std::vector<std::array<std::size_t, 2>> pairs_;
  std::vector<MeanPair> means_;
};

}  // namespace rules
