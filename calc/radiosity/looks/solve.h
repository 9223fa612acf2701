#pragma once
// Computes the illuminance of every plane of a space: direct light, light-vertex pool, connections,
// near field, sampling rounds.

#include "calc/base/field.h"
#include "calc/radiosity/gather/plane_work.h"
#include "calc/radiosity/gather/settings.h"
#include "calc/radiosity/looks/stages.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace calc {

class EntryStore;
struct VertexCache;

// The result cache, in which sampling rounds are kept between runs.
struct LookStore {
  EntryStore& entries;
  std::string backend;  // the computing code with versions; rounds of others differ
  // Computes nothing: a plane with a missing round is refused, with not_in_store or
  // too_large_for_store of calc/base/sentences.def.
  bool is_all_there_is = false;
};

// Counts of a space's sampling rounds; results omit them.
struct LookCounts {
  std::uint64_t read = 0;       // taken from the store, for each plane and round
  std::uint64_t computed = 0;   // and those that were not there
  std::uint64_t too_large = 0;  // planes whose rounds cannot be kept
  bool has_rays = false;        // something had to be prepared for rays; false: none was traced
};

// The number of a sampling round: a plane takes at most `planned` rounds (sample sizes double),
// fixed before the first, so that a test may divide its error probability among them.
struct Look {
  int index = 0;  // 0 = first
  int planned = 1;
};

// The answer of a test after a round.
struct LookAnswer {
  // Empty: go on. decided or accurate: the plane is finished.
  std::optional<StopReason> finished;
  // [point], 1: further rounds add to this point; empty: to all. Not used when finished. Other
  // points keep their estimate.
  std::vector<std::uint8_t> active;
};

// Called after every round of every unfinished plane, with the plane's results so far.
using LookTest = std::function<LookAnswer(std::size_t task, const PlaneField& field, Look look)>;

// Progress after every round; the sink may be empty. It returns false to stop the calculation
// (StopReason::interrupted).
struct SolveProgress {
  std::size_t planes_done = 0, planes = 0;
  std::uint64_t paths_per_replicate = 0;
};
using ProgressSink = std::function<bool(const SolveProgress&)>;

struct SpaceSolution {
  std::vector<PlaneField> fields;  // one per task, in order
  FluxBalance balance;             // of all light paths traced; emitted only when none was needed
  SolveTimes times;
  std::uint64_t pool_rays = 0;  // rays of all light paths
  LookCounts looks;
};

// Computes the planes of a space. Settings must be valid. Same scene, task and seed give the same
// bits for any settings.jobs and any other tasks, unless a time limit or the progress sink stopped
// the run. cache: light vertices that replace tracing paths, with the same bits; must be of this
// scene (scene_fingerprint()) and these settings (VertexCache::fit()). store: complete rounds are
// read from it and written to it, also with the same bits; not used beside a cache.
SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence,
                                const Stages& stages, const LookTest& test,
                                const ProgressSink& progress, const VertexCache* cache = nullptr,
                                const LookStore* store = nullptr);

}  // namespace calc
