#pragma once
// The calculation of one plane: its points, its random keys, and the sums that become its field.

#include "calc/base/field.h"
#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/direct/direct_tracer.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/gather/plane_state.h"
#include "calc/radiosity/gather/settings.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/tiles.h"
#include "calc/scene/sensor_grid.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace calc {

// Seconds by phase. Phases of simultaneous replicates share the elapsed time in proportion to their
// work.
struct SolveTimes {
  double build_s = 0, direct_s = 0, pool_s = 0, maps_s = 0, connect_s = 0, near_s = 0;
};

// Light vertices of one replicate and sampling round, shared by all planes.
struct VertexBatch {
  const VertexTree& tree;
  const VertexBounds& bounds;
  const GeometryBound* near_bound;  // null: no near field
  const LuminaireChoice& luminaires;
  const Cut& global_cut;  // continues short rays
  std::size_t replicate = 0;
  std::uint64_t first_path = 0, paths = 0;  // of this batch
  double deadline_s = 0.0;  // see is_past(); the rest is then left undone, to be thrown away
  ShortRayCaster* short_rays = nullptr;            // see Stages
  std::atomic<bool>* has_endless_chain = nullptr;  // see NearField
};

// The limits of a light vertex on paths that were not sampled.
struct PossibleVertex {
  double flux_lm = 0.0;           // the largest of any path, times the paths of the round
  double mean_reflectance = 0.0;  // of the surfaces, [0, 1]
  double most_per_m2 = 0.0;       // bound of its geometry term; 0: no such vertex
};

// Returns the connections that each point draws from a pool of so many paths: fewer where many
// points of the plane, which share the pool, take part in the round. A power of two.  [METHOD, 5.5]
std::uint32_t draws_per_point(std::uint64_t paths, std::size_t points);

// Returns the short rays of a point for one replicate and round, a power of two: a quarter of the
// draws where a surface touches the point, two where it is nearly out of reach and the near field
// is tiny; and `factor` times that. clear_m in [0, reach_m].
std::uint32_t short_rays_per_point(std::uint32_t draws, double clear_m, double reach_m,
                                   double factor = 1.0);

// Returns the factor for the next round from the measurements of this one: variances of the short
// rays' part and of the connections' over the replicates. Time and variance are shared best where
// each ray, and each draw, reduces the variance equally for its time.  [METHOD, 4.4]
double next_short_ray_factor(double factor, double near_variance, double drawn_variance,
                             std::uint32_t draws, std::uint32_t rays);

// Adds sampling rounds to a plane's state.
class PlaneWork {
 public:
  // The plane's id and the point's index key all random numbers: other planes do not matter.
  // decision: of this plane; must outlive the work, as must the state.
  PlaneWork(const Tracer& tracer, const SensorGrid& grid, const PlaneDecision& decision,
            const RadiositySettings& settings, PlaneState& state);

  const PlaneDecision& decision() const { return decision_; }

  // Starts a plane without rounds yet: refuses it where a point cannot be computed.
  void begin(const SensorGrid& grid);
  // Adds direct light from point openings, or the glare of all openings, once. deadline_s: as in
  // VertexBatch, also for all functions below; direct: null = the CPU, likewise.
  void add_exact(DirectTracer* direct, double deadline_s, SolveTimes& times);
  // Doubles the rounds of samples on extended openings, but only while their error matters beside
  // the indirect part.
  void sample_openings(DirectTracer* direct, double deadline_s, SolveTimes& times);
  // Starts a round before its first replicate. near_reach_m: of short rays, 0 = none.
  void start_look(double near_reach_m, const PossibleVertex& possible);
  // Adds one replicate's indirect light: connections and near field. Replicates may run at the same
  // time.
  void connect(const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times);
  // Do the same in two steps, for gatherers that connect all planes at once (shared_gather.h): the
  // points of this round, and the sums gathered at them, [channel * stride + point] in their order.
  std::span<const ReceiverGroup> tiles() const { return tiles_.groups(); }
  bool has_shadows() const { return !decision_.is_unobstructed; }
  void take_shared(const VertexBatch& batch, const GatherSums& sums, std::uint64_t pairs);
  // Ends a round once all its replicates are in, with batch_paths new paths each.
  void finish_look(std::uint64_t batch_paths);

 private:
  struct TileSums;

  void add_glare(double deadline_s);
  void prove_openings(double deadline_s);
  bool has_fine_beams();
  void sample_openings_by_points(std::uint32_t last_round, double deadline_s);
  void sample_openings_by(DirectTracer& direct, std::uint32_t last_round, double deadline_s);
  void sample_batch(DirectTracer& direct, std::span<const std::size_t> chosen,
                    const OpeningRounds& rounds, double deadline_s);
  void take_opening_rays(std::size_t point, const DirectRays& rays, std::uint32_t last_round);
  std::size_t points() const { return receiver_.size(); }
  std::size_t channels() const { return field_.channels.size(); }
  std::uint64_t connect_tiles(std::size_t first, std::size_t last, const VertexBatch& batch,
                              Gatherer& gatherer, std::span<TileSums> sums) const;
  std::uint64_t connect_all(const ReceiverGroup& tile, const VertexBatch& batch, Gatherer& gatherer,
                            TileSums& sums) const;
  // Returns the key of all points in a batch.
  RandomKey near_key(const VertexBatch& batch) const;
  // Returns 0 if no surface is within reach.
  std::uint32_t short_rays_of(std::uint32_t point, const VertexBatch& batch) const;
  struct ShortRays;
  std::size_t tiles_per_cast(const VertexBatch& batch, std::size_t tiles_each) const;
  std::size_t tiles_per_task(const VertexBatch& batch, const Gatherer& gatherer) const;
  NearField near_field(const VertexBatch& batch) const;
  ShortRays cast_short_rays(std::size_t first_tile, std::size_t last_tile,
                            const VertexBatch& batch) const;
  std::uint64_t add_near(const ReceiverGroup& tile, const VertexBatch& batch, ShortRays& short_rays,
                         TileSums& sums) const;
  void store(const ReceiverGroup& tile, const VertexBatch& batch, const TileSums& sums);
  void share_short_rays(std::uint64_t batch_paths);
  double possible_sample_lx(std::size_t point) const;

  const Tracer& tracer_;
  const RadiositySettings& settings_;
  const PlaneDecision& decision_;
  PlaneState& state_;
  PlaneField& field_;  // of the state, as the sums
  PlaneSums& sums_;
  RandomKey opening_key_, near_key_, draw_key_;
  std::vector<Receiver> receiver_;            // local
  std::vector<std::uint32_t> spatial_order_;  // of points, neighbours together
  // Free openings for every kPointsPerProof points of that order: [group][luminaire].
  std::vector<std::vector<std::uint8_t>> free_openings_;
  std::optional<bool> has_fine_beams_;            // once it is asked for
  std::vector<std::uint8_t> gathers_reflection_;  // [receiver]
  ReceiverTiles tiles_;                           // of this round
  std::size_t look_points_ = 0;                   // in them
  std::vector<std::uint8_t> has_indirect_;        // [point], 0 = proved that indirect light is 0
  PossibleVertex possible_vertex_;                // of this round
  double reach_m_ = 0.0;                          // of this round's short rays
  std::vector<double> look_near_lx_, look_drawn_lx_;  // [replicate][point], of this round only
};

}  // namespace calc
