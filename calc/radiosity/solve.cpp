#include "calc/radiosity/solve.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/emission.h"
#include "calc/radiosity/light_paths.h"
#include "calc/radiosity/near_field.h"
#include "calc/radiosity/phase_timer.h"
#include "calc/statistics.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>

namespace calc {
namespace {

class Solver {
 public:
  Solver(const PreparedScene& scene, const RadiositySettings& settings, double confidence,
         Gatherer& gatherer, const LookTest& test, const ProgressSink& progress)
      : settings_(settings),
        confidence_(confidence),
        gatherer_(gatherer),
        test_(test),
        progress_(progress),
        start_s_(now_s()),
        tracer_(scene),
        emitter_(scene) {
    solution_.times.build_s = now_s() - start_s_;
    solution_.balance.emitted_lm = emitter_.flux_lm();
    const bool has_reflection = std::any_of(scene.reflectance.begin(), scene.reflectance.end(),
                                            [](double rho) { return rho > 0.0; });
    samples_indirect_ = has_reflection && emitter_.flux_lm() > 0.0;
    samples_openings_ = has_extended_luminaires(scene);
  }

  SpaceSolution run(const std::vector<PlaneTask>& tasks) {
    planes_.reserve(tasks.size());
    for (const PlaneTask& task : tasks) {
      planes_.emplace_back(tracer_, task.plane_id, *task.grid, settings_.seed, replicates());
    }
    for (PlaneWork& plane : planes_) {
      if (plane.is_active()) plane.add_exact(solution_.times);
    }
    if (samples_indirect_ || samples_openings_) {
      take_looks();
    } else {
      finish_active(StopReason::exact);
    }
    for (PlaneWork& plane : planes_) solution_.fields.push_back(plane.take_field());
    if (!absorbed_lm_.empty()) {
      solution_.balance.absorbed_lm = t_interval(absorbed_lm_, confidence_);
      solution_.balance.escaped_lm = t_interval(escaped_lm_, confidence_);
    }
    return std::move(solution_);
  }

 private:
  std::size_t replicates() const { return static_cast<std::size_t>(settings_.replicates); }

  bool any_active() const {
    return std::any_of(planes_.begin(), planes_.end(),
                       [](const PlaneWork& p) { return p.is_active(); });
  }

  void finish_active(StopReason reason) {
    for (PlaneWork& plane : planes_) {
      if (plane.is_active()) plane.finish(reason);
    }
  }

  void refuse_active(const std::string& problem) {
    for (PlaneWork& plane : planes_) {
      if (plane.is_active()) plane.refuse(problem);
    }
  }

  // Looks with doubling numbers of paths until every plane is accurate, or a limit ends the work.
  void take_looks() {
    std::uint64_t done_paths = 0;
    Look look_number{0, std::countr_zero(settings_.max_paths / settings_.first_paths) + 1};
    for (std::uint64_t paths = settings_.first_paths; any_active();
         paths *= 2, ++look_number.index) {
      if (const auto stopped = look(done_paths, paths)) {
        if (done_paths == 0) {
          refuse_active(*stopped == StopReason::time_limit
                            ? "the time limit was reached before the first result"
                            : "the calculation was interrupted before the first result");
        }
        return finish_active(*stopped);
      }
      done_paths = paths;
      for (std::size_t p = 0; p < planes_.size(); ++p) {
        PlaneWork& plane = planes_[p];
        if (!plane.is_active()) continue;
        plane.publish();
        LookAnswer answer = test_(p, plane.field(), look_number);
        if (answer.finished) {
          plane.finish(*answer.finished);
        } else if (paths * 2 > settings_.max_paths) {
          plane.finish(StopReason::path_limit);
        }
      }
    }
  }

  // Adds paths done_paths..paths of every replicate to every active plane. Gives a reason if it was
  // stopped half-way; what was published before then stands.
  std::optional<StopReason> look(std::uint64_t done_paths, std::uint64_t paths) {
    for (PlaneWork& plane : planes_) {
      if (samples_openings_ && plane.is_active()) plane.sample_openings(solution_.times);
    }
    if (!samples_indirect_) return reason_to_stop(paths);

    const std::uint64_t batch_paths = paths - done_paths;
    const GeometryBound bound(tracer_, emitter_, batch_paths);
    for (std::size_t r = 0; r < replicates(); ++r) {
      const TracedPaths traced = trace(bound, r, done_paths, paths);
      if (traced.has_endless_path) {
        refuse_active(
            fmt::format("a light path did not end after {} reflections: a closed space whose "
                        "surfaces absorb next to "
                        "nothing has no steady state within reach",
                        kMostReflections));
        return std::nullopt;
      }
      for (PlaneWork& plane : planes_) {
        if (plane.is_active()) {
          plane.connect({traced.vertices, bound, r, batch_paths}, gatherer_, solution_.times);
        }
      }
      if (const auto stopped = reason_to_stop(paths)) return stopped;
    }
    for (PlaneWork& plane : planes_) {
      if (plane.is_active()) plane.finish_look(paths, batch_paths);
    }
    return std::nullopt;
  }

  TracedPaths trace(const GeometryBound& bound, std::size_t replicate, std::uint64_t first,
                    std::uint64_t last) {
    const PhaseTimer timer(solution_.times.pool_s);
    TracedPaths traced =
        trace_light_paths(tracer_, emitter_, bound,
                          {settings_.seed, replicate, static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>(last)});
    // Running means over all batches, weighted by paths.
    absorbed_lm_.resize(replicates());
    escaped_lm_.resize(replicates());
    const double share = static_cast<double>(last - first) / static_cast<double>(last);
    absorbed_lm_[replicate] += share * (traced.absorbed_lm - absorbed_lm_[replicate]);
    escaped_lm_[replicate] += share * (traced.escaped_lm - escaped_lm_[replicate]);
    solution_.pool_rays += traced.rays;
    return traced;
  }

  std::optional<StopReason> reason_to_stop(std::uint64_t paths) const {
    if (settings_.time_limit_s > 0.0 && now_s() - start_s_ > settings_.time_limit_s) {
      return StopReason::time_limit;
    }
    if (!progress_) return std::nullopt;
    SolveProgress state;
    state.planes = planes_.size();
    state.planes_done = static_cast<std::size_t>(std::count_if(
        planes_.begin(), planes_.end(), [](const PlaneWork& p) { return !p.is_active(); }));
    state.paths_per_replicate = paths;
    if (!progress_(state)) return StopReason::interrupted;
    return std::nullopt;
  }

  const RadiositySettings& settings_;
  double confidence_;
  Gatherer& gatherer_;
  const LookTest& test_;
  const ProgressSink& progress_;
  double start_s_;
  Tracer tracer_;
  Emitter emitter_;
  std::vector<PlaneWork> planes_;
  std::vector<double> absorbed_lm_, escaped_lm_;  // per replicate
  bool samples_openings_ = false, samples_indirect_ = false;
  SpaceSolution solution_;
};

}  // namespace

SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence,
                                Gatherer& gatherer, const LookTest& test,
                                const ProgressSink& progress) {
  tbb::task_arena arena(settings.jobs > 0 ? settings.jobs : tbb::task_arena::automatic);
  return arena.execute(
      [&] { return Solver(scene, settings, confidence, gatherer, test, progress).run(tasks); });
}

}  // namespace calc
