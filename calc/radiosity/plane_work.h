#pragma once
// One plane while it is being computed: its points, its random keys, and the sums that become its
// field.

#include "calc/field.h"
#include "calc/radiosity/gatherer.h"
#include "calc/radiosity/near_field.h"
#include "calc/radiosity/rays.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// Seconds of the calling thread's clock, by phase.
struct SolveTimes {
  double build_s = 0, direct_s = 0, pool_s = 0, connect_s = 0, near_s = 0;
};

// Light vertices of one replicate and how they came about.
struct VertexBatch {
  const LightVertices& vertices;
  const GeometryBound& bound;
  std::size_t replicate = 0;
  std::uint64_t paths = 0;  // of this batch
};

class PlaneWork {
 public:
  // The plane's id and the point's index key all random numbers: other planes do not matter.
  PlaneWork(const Tracer& tracer, const std::string& plane_id, const SensorGrid& grid,
            std::uint64_t seed, std::size_t replicates);

  // Whether looks still add to this plane.
  bool is_active() const { return is_active_; }
  void refuse(std::string problem);  // ends the work; field().problem says why
  void finish(StopReason reason);    // ends the work with what was published last
  const PlaneField& field() const { return field_; }
  PlaneField take_field() { return std::move(field_); }

  // Direct light from point openings, once.
  void add_exact(SolveTimes& times);
  // Doubles the rounds of samples on extended openings, but only while their error matters beside
  // the indirect part.
  void sample_openings(SolveTimes& times);
  // One replicate's indirect light: connections and near field.
  void connect(const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times);
  // All replicates of a look are in: `paths` in all per replicate, `batch_paths` of them new.
  void finish_look(std::uint64_t paths, std::uint64_t batch_paths);
  // Turns the sums so far into field().
  void publish();

 private:
  std::size_t points() const { return position_m_.size(); }
  std::size_t channels() const { return field_.channels.size(); }
  std::size_t values() const { return field_.replicates * channels() * points(); }
  bool opening_error_matters() const;
  // Marks points that sampled light may reach but has not.
  void find_unseen();
  double squared_error(const std::vector<double>& values_lx) const;

  const Tracer& tracer_;
  RandomKey opening_key_, near_key_;
  std::vector<glm::dvec3> position_m_, normal_;  // local
  std::vector<double> direct_sum_lx_;            // [replicate][channel][point], sum over rounds
  std::vector<double> indirect_sum_lx_;       // the same, sum over batches of estimate times paths
  std::vector<std::uint8_t> may_be_sampled_;  // [point]
  std::uint32_t rounds_ = 0;
  std::uint32_t near_rays_ = 0;
  std::uint64_t paths_ = 0;
  bool is_active_ = true;
  PlaneField field_;
};

}  // namespace calc
