#include "calc/radiosity/solve.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/emission.h"
#include "calc/radiosity/light_paths.h"
#include "calc/radiosity/near_field.h"
#include "calc/radiosity/random.h"
#include "calc/statistics.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>

namespace calc {
namespace {

constexpr std::uint64_t kPathsPerNearRay = 4;
constexpr std::uint64_t kFewestNearRays = 4;

double now_s() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Adds the time it lives to a phase.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& total_s) : total_s_(total_s), begin_s_(now_s()) {}
  ~PhaseTimer() { total_s_ += now_s() - begin_s_; }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& total_s_;
  double begin_s_;
};

// A plane while it is being worked on. Arrays as in PlaneField, but sums: of rounds (direct) and of
// batch estimates times the batch's paths (indirect).
struct PlaneWork {
  RandomKey opening_key{0}, near_key{0};
  std::vector<glm::dvec3> position_m;  // local
  std::vector<glm::dvec3> normal;
  std::vector<double> direct_sum_lx;
  std::vector<double> indirect_sum_lx;
  std::uint32_t direct_rounds = 0;
  std::uint64_t paths = 0;  // per replicate
  std::uint32_t near_rays = 0;
  bool is_active = false;
  PlaneField field;

  std::size_t points() const { return position_m.size(); }
};

class Solver {
 public:
  Solver(const PreparedScene& scene, const RadiositySettings& settings, double confidence,
         Gatherer& gatherer, const AccuracyTest& is_accurate, const ProgressSink& progress)
      : scene_(scene),
        settings_(settings),
        confidence_(confidence),
        gatherer_(gatherer),
        is_accurate_(is_accurate),
        progress_(progress),
        start_s_(now_s()),
        tracer_(scene),
        emitter_(scene) {
    solution_.times.build_s = now_s() - start_s_;
    solution_.balance.emitted_lm = emitter_.flux_lm();
  }

  SpaceSolution run(const std::vector<PlaneTask>& tasks) {
    for (const PlaneTask& task : tasks) planes_.push_back(make_work(task));
    solve_exact_part();
    const bool has_reflection = std::any_of(scene_.reflectance.begin(), scene_.reflectance.end(),
                                            [](double rho) { return rho > 0.0; });
    samples_indirect_ = has_reflection && emitter_.flux_lm() > 0.0;
    samples_direct_ = has_extended_luminaires(scene_);
    if (samples_indirect_ || samples_direct_) sample_until_accurate();
    for (PlaneWork& plane : planes_) solution_.fields.push_back(std::move(plane.field));
    if (!absorbed_lm_.empty()) finish_balance();
    return std::move(solution_);
  }

 private:
  std::size_t replicates() const { return static_cast<std::size_t>(settings_.replicates); }
  std::size_t channels() const { return scene_.channels.size(); }

  PlaneWork make_work(const PlaneTask& task) const {
    PlaneWork plane;
    plane.opening_key = stage_key(settings_.seed, RandomStage::opening).with(task.plane_id);
    plane.near_key = stage_key(settings_.seed, RandomStage::near_field).with(task.plane_id);
    for (const glm::dvec3& p : task.grid->position_m) plane.position_m.push_back(p - scene_.origin_m);
    plane.normal = task.grid->normal;
    plane.field.plane_id = task.plane_id;
    plane.field.points = plane.points();
    plane.field.replicates = replicates();
    plane.field.channels = scene_.channels;
    plane.field.direct_exact_lx.assign(channels() * plane.points(), 0.0);
    for (std::size_t i = 0; i < plane.points() && plane.field.problem.empty(); ++i) {
      if (find_touching_luminaire(scene_, plane.position_m[i], tracer_.offset_m()) < 0) continue;
      const glm::dvec3& p = task.grid->position_m[i];
      plane.field.problem = fmt::format(
          "the point ({:.6g} {:.6g} {:.6g}) lies at a luminaire without size: illuminance is unbounded there",
          p.x, p.y, p.z);
    }
    return plane;
  }

  void solve_exact_part() {
    const PhaseTimer timer(solution_.times.direct_s);
    for (PlaneWork& plane : planes_) {
      if (!plane.field.problem.empty()) continue;
      std::atomic<std::uint64_t> rays{0};
      tbb::parallel_for(std::size_t{0}, plane.points(), [&](std::size_t i) {
        const FlushDenormals flush;
        rays += add_point_sources(tracer_, plane.position_m[i], plane.normal[i],
                                  &plane.field.direct_exact_lx[i], plane.points());
      });
      plane.field.counters.direct_rays += rays;
    }
  }

  void sample_until_accurate() {
    for (PlaneWork& plane : planes_) {
      if (!plane.field.problem.empty()) continue;
      const std::size_t values = replicates() * channels() * plane.points();
      if (samples_direct_) plane.direct_sum_lx.assign(values, 0.0);
      if (samples_indirect_) plane.indirect_sum_lx.assign(values, 0.0);
      plane.is_active = true;
    }
    std::uint64_t done_paths = 0;
    for (std::uint64_t paths = settings_.first_paths; any_active(); paths *= 2) {
      const StopReason stopped = look(done_paths, paths);
      if (stopped != StopReason::accurate) {
        for (PlaneWork& plane : planes_) finish_if_active(plane, stopped);
        return;
      }
      done_paths = paths;
      for (std::size_t p = 0; p < planes_.size(); ++p) {
        PlaneWork& plane = planes_[p];
        if (!plane.is_active) continue;
        publish(plane);
        if (is_accurate_(p, plane.field)) {
          finish_if_active(plane, StopReason::accurate);
        } else if (paths * 2 > settings_.max_paths) {
          finish_if_active(plane, StopReason::path_limit);
        }
      }
    }
  }

  bool any_active() const {
    return std::any_of(planes_.begin(), planes_.end(), [](const PlaneWork& p) { return p.is_active; });
  }

  static void finish_if_active(PlaneWork& plane, StopReason reason) {
    if (!plane.is_active) return;
    plane.is_active = false;
    plane.field.stop = reason;
    if (plane.field.is_exact()) {  // stopped before its first look was complete
      plane.field.problem = reason == StopReason::time_limit ? "the time limit was reached before the first result"
                                                             : "the calculation was interrupted";
    }
  }

  // Why to stop now, or `accurate` for going on.
  StopReason check_stop(std::uint64_t paths) const {
    if (settings_.time_limit_s > 0.0 && now_s() - start_s_ > settings_.time_limit_s) {
      return StopReason::time_limit;
    }
    if (!progress_) return StopReason::accurate;
    SolveProgress state;
    state.planes = planes_.size();
    state.planes_done = static_cast<std::size_t>(std::count_if(
        planes_.begin(), planes_.end(), [](const PlaneWork& p) { return !p.is_active; }));
    state.paths_per_replicate = paths;
    return progress_(state) ? StopReason::accurate : StopReason::interrupted;
  }

  // Paths done_paths..paths of every replicate for every active plane. A look that was stopped half-way leaves
  // the published fields as they were.
  StopReason look(std::uint64_t done_paths, std::uint64_t paths) {
    for (PlaneWork& plane : planes_) {
      if (plane.is_active && samples_direct_) sample_direct(plane);
    }
    if (!samples_indirect_) {
      for (PlaneWork& plane : planes_) plane.paths = plane.is_active ? paths : plane.paths;
      return check_stop(paths);
    }
    const GeometryBound bound(tracer_, emitter_, paths - done_paths);
    const std::vector<std::size_t> active = active_planes();
    for (std::size_t r = 0; r < replicates(); ++r) {
      const TracedPaths traced = trace(bound, r, done_paths, paths);
      if (traced.has_endless_path) {
        refuse_endless();
        return StopReason::accurate;
      }
      for (const std::size_t p : active) connect(planes_[p], bound, traced.vertices, r, paths - done_paths);
      const StopReason stop = check_stop(paths);
      if (stop != StopReason::accurate) return stop;
    }
    for (const std::size_t p : active) {
      PlaneWork& plane = planes_[p];
      plane.paths = paths;
      plane.near_rays += near_rays(paths - done_paths);
      plane.field.counters.paths = paths * replicates();
    }
    return StopReason::accurate;
  }

  std::vector<std::size_t> active_planes() const {
    std::vector<std::size_t> active;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      if (planes_[p].is_active) active.push_back(p);
    }
    return active;
  }

  TracedPaths trace(const GeometryBound& bound, std::size_t replicate, std::uint64_t first,
                    std::uint64_t last) {
    const PhaseTimer timer(solution_.times.pool_s);
    TracedPaths traced = trace_light_paths(tracer_, emitter_, bound,
                                           {settings_.seed, replicate, static_cast<std::uint32_t>(first),
                                            static_cast<std::uint32_t>(last)});
    absorbed_lm_.resize(replicates());
    escaped_lm_.resize(replicates());
    const double share = static_cast<double>(last - first) / static_cast<double>(last);
    absorbed_lm_[replicate] += share * (traced.absorbed_lm - absorbed_lm_[replicate]);
    escaped_lm_[replicate] += share * (traced.escaped_lm - escaped_lm_[replicate]);
    solution_.pool_rays += traced.rays;
    return traced;
  }

  void refuse_endless() {
    for (PlaneWork& plane : planes_) {
      if (!plane.is_active) continue;
      plane.is_active = false;
      plane.field.problem = fmt::format(
          "a light path did not end after {} reflections: a closed space whose surfaces absorb nothing has no "
          "steady state",
          kMostReflections);
    }
  }

  static std::uint32_t near_rays(std::uint64_t batch_paths) {
    return static_cast<std::uint32_t>(std::max(kFewestNearRays, batch_paths / kPathsPerNearRay));
  }

  void connect(PlaneWork& plane, const GeometryBound& bound, const LightVertices& vertices,
               std::size_t replicate, std::uint64_t batch_paths) {
    const std::size_t points = plane.points();
    std::vector<double> batch_lx(channels() * points, 0.0);
    {
      const PhaseTimer timer(solution_.times.connect_s);
      plane.field.counters.connection_rays +=
          gatherer_.gather(tracer_, {plane.position_m, plane.normal}, vertices, batch_lx);
    }
    {
      const PhaseTimer timer(solution_.times.near_s);
      std::atomic<std::uint64_t> rays{0};
      tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
        const FlushDenormals flush;
        const NearFieldRequest request{plane.position_m[i], plane.normal[i],
                                       plane.near_key.with(i).with(replicate), plane.near_rays,
                                       plane.near_rays + near_rays(batch_paths)};
        rays += add_near_field(tracer_, bound, vertices, request, &batch_lx[i], points);
      });
      plane.field.counters.near_rays += rays;
    }
    double* sum = &plane.indirect_sum_lx[replicate * channels() * points];
    for (std::size_t k = 0; k < batch_lx.size(); ++k) {
      sum[k] += static_cast<double>(batch_paths) * batch_lx[k];
    }
  }

  // Doubles the rounds of opening samples, but only while the openings' error matters beside the rest.
  void sample_direct(PlaneWork& plane) {
    const PhaseTimer timer(solution_.times.direct_s);
    if (plane.direct_rounds > 0 && !direct_error_matters(plane)) return;
    const std::uint32_t first = plane.direct_rounds;
    const std::uint32_t last = std::max<std::uint32_t>(1, 2 * first);
    const std::size_t points = plane.points();
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
      const FlushDenormals flush;
      for (std::size_t r = 0; r < replicates(); ++r) {
        rays += add_extended_sources(tracer_, plane.position_m[i], plane.normal[i],
                                     plane.opening_key.with(i).with(r), first, last,
                                     &plane.direct_sum_lx[r * channels() * points + i], points);
      }
    });
    plane.field.counters.direct_rays += rays;
    plane.direct_rounds = last;
  }

  // Whether the opening samples carry more than a tenth of the indirect part's variance, summed over points.
  bool direct_error_matters(const PlaneWork& plane) const {
    if (!samples_indirect_) return true;
    return variance(plane.field.direct_sampled_lx, plane.points()) >
           0.1 * variance(plane.field.indirect_lx, plane.points());
  }

  double variance(const std::vector<double>& values_lx, std::size_t points) const {
    double sum = 0.0;
    std::vector<double> at_point(replicates());
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t r = 0; r < replicates(); ++r) {
        at_point[r] = 0.0;
        for (std::size_t c = 0; c < channels(); ++c) at_point[r] += values_lx[(r * channels() + c) * points + i];
      }
      const double error = replicate_mean(at_point).standard_error;
      sum += error * error;
    }
    return sum;
  }

  // Sums so far to estimates.
  static void publish(PlaneWork& plane) {
    const auto scaled = [](const std::vector<double>& sums, double divisor, std::vector<double>& to) {
      to.resize(sums.size());
      std::transform(sums.begin(), sums.end(), to.begin(), [divisor](double s) { return s / divisor; });
    };
    scaled(plane.direct_sum_lx, plane.direct_rounds, plane.field.direct_sampled_lx);
    scaled(plane.indirect_sum_lx, static_cast<double>(plane.paths), plane.field.indirect_lx);
  }

  void finish_balance() {
    solution_.balance.absorbed_lm = t_interval(absorbed_lm_, confidence_);
    solution_.balance.escaped_lm = t_interval(escaped_lm_, confidence_);
  }

  const PreparedScene& scene_;
  const RadiositySettings& settings_;
  double confidence_;
  Gatherer& gatherer_;
  const AccuracyTest& is_accurate_;
  const ProgressSink& progress_;
  double start_s_;
  Tracer tracer_;
  Emitter emitter_;
  std::vector<PlaneWork> planes_;
  std::vector<double> absorbed_lm_, escaped_lm_;  // per replicate
  bool samples_direct_ = false, samples_indirect_ = false;
  SpaceSolution solution_;
};

}  // namespace

SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence, Gatherer& gatherer,
                                const AccuracyTest& is_accurate, const ProgressSink& progress) {
  tbb::task_arena arena(settings.jobs > 0 ? settings.jobs : tbb::task_arena::automatic);
  return arena.execute([&] {
    return Solver(scene, settings, confidence, gatherer, is_accurate, progress).run(tasks);
  });
}

}  // namespace calc
