#pragma once
// Illuminance of every plane of a space: direct light, light-vertex pool, connections, near field,
// looks.

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

// Where looks are kept from run to run.
struct LookStore {
  EntryStore& entries;
  std::string backend;  // who computes, with versions: looks of one are not another's
  // Nothing is computed: a plane of which a look is not there is refused, with not_in_store or
  // too_large_for_store of calc/base/sentences.def.
  bool is_all_there_is = false;
};

// What became of a space's looks; none of it is in a result.
struct LookCounts {
  std::uint64_t read = 0;       // taken from the store, one for each plane and look
  std::uint64_t computed = 0;   // and those that were not there
  std::uint64_t too_large = 0;  // planes whose looks cannot be kept
  bool has_rays = false;        // something had to be prepared for rays; false: none was traced
};

// Which look it is: a plane takes at most `planned` looks (sample sizes double), a number fixed
// before the first, so that a test may spend its error probability over them.
struct Look {
  int index = 0;  // 0 = first
  int planned = 1;
};

// What the answer to a look asks for next.
struct LookAnswer {
  // Empty: go on. decided or accurate: the plane is finished.
  std::optional<StopReason> finished;
  // [point], 1: further looks add to this point; empty: to all. Not used when finished. Points left
  // out keep the estimate they have.
  std::vector<std::uint8_t> active;
};

// Asked after every look of every plane that is still at work, with the plane's results so far.
using LookTest = std::function<LookAnswer(std::size_t task, const PlaneField& field, Look look)>;

// Told after every look; may be empty. Return false to stop the calculation
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

// Settings must be valid. Same scene, task and seed give the same bits for any settings.jobs and
// any other tasks, unless a time limit or the progress sink stopped the run. cache: light vertices
// to take instead of tracing paths, which gives the same bits; must be of this scene
// (scene_fingerprint()) and these settings (VertexCache::fit()). store: complete looks are taken
// from it and put there, which gives the same bits, too; not used beside a cache.
SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence,
                                const Stages& stages, const LookTest& test,
                                const ProgressSink& progress, const VertexCache* cache = nullptr,
                                const LookStore* store = nullptr);

}  // namespace calc
