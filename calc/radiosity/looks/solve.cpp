#include "calc/radiosity/looks/solve.h"

#include "calc/base/sentences.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/direct/point_problem.h"
#include "calc/radiosity/gather/shared_gather.h"
#include "calc/radiosity/looks/look_key.h"
#include "calc/radiosity/looks/stored_look.h"
#include "calc/radiosity/looks/vertex_cache.h"
#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/threads.h"
#include "calc/scene/surface_summary.h"
#include "calc/store/entry_store.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

// Surfaces that reflect more than this may hold light for ever; probes find out first.
constexpr double kSuspectReflectance = 0.9995;
// Paths of a space with a longer mean are not begun; 0.9999 in a closed one is 10000.
constexpr std::uint64_t kMostMeanReflections = kMostReflections / 25;

// A look of a plane that takes more is not stored: half a million points with one channel.
constexpr std::size_t kMostLookBytes = std::size_t{1} << 28;

// Groups of light vertices that continue short rays, and the share of the scene's extent below
// which they do not tell distances apart.
constexpr std::size_t kGlobalCut = 128;
constexpr double kGlobalSoftening = 0.1;

// What rays need: not made for a space whose looks all come from the store.
struct RayContext {
  RayContext(const PreparedScene& scene, const std::vector<PlaneTask>& tasks, const SkipSet& skips)
      : plan(decide(scene, tasks, skips)),
        tracer(scene),
        emitter(scene, plan.is_unlit),
        luminaire_choice(scene),
        mean_reflectance(summarise_surfaces(scene).mean_reflectance) {
    if (plan.is_convex) tracer.leave_out_shadows();  // between surfaces and luminaires
    double largest_reflectance = 0.0;
    for (const double rho : scene.reflectance) {
      largest_reflectance = std::max(largest_reflectance, rho);
    }
    for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
      largest_path_lm = std::max(largest_path_lm, largest_reflectance * emitter.path_flux_lm(l));
    }
    may_be_endless = largest_reflectance > kSuspectReflectance;
  }

  SolvePlan plan;
  Tracer tracer;
  Emitter emitter;
  LuminaireChoice luminaire_choice;
  double mean_reflectance;
  double largest_path_lm = 0.0;  // reflected flux of one path's vertex, times the number of paths
  bool may_be_endless = false;
};

// A plane on its way through the looks.
struct SolvedPlane {
  SolvedPlane(const PlaneTask& task, const PreparedScene& scene, std::size_t replicates)
      : state(task.plane_id, *task.grid, scene.channels, replicates) {}

  PlaneState state;
  std::unique_ptr<PlaneWork> work;   // once a look of it has to be computed
  std::optional<LookKey> key;        // with a store
  std::string look_key;              // of the look at hand
  std::optional<StoredLook> stored;  // the look at hand, from the store

  bool is_missing() const { return state.is_active() && !stored; }
};

class Solver {
 public:
  Solver(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
         const RadiositySettings& settings, double confidence, const Stages& stages,
         const LookTest& test, const ProgressSink& progress, const VertexCache* cache,
         const LookStore* store)
      : scene_(scene),
        tasks_(tasks),
        settings_(settings),
        confidence_(confidence),
        stages_(stages),
        test_(test),
        progress_(progress),
        cache_(cache),
        store_(cache == nullptr ? store : nullptr),
        start_s_(now_s()) {
    if (settings.time_limit_s > 0.0) deadline_s_ = start_s_ + settings.time_limit_s;
  }

  SpaceSolution run() {
    for (auto* v : {&absorbed_lm_, &escaped_lm_, &look_absorbed_lm_, &look_escaped_lm_}) {
      v->resize(replicates());
    }
    open_planes();
    if (find_stored() > 0 || tasks_.empty()) make_ray_context();
    begin_missing();
    finish_exact();
    if (any_active() && is_endless()) {
      refuse_active(endless_words());
    } else {
      take_looks();
    }
    for (SolvedPlane& plane : planes_) {
      PlaneField& field = plane.state.field();
      field.is_cut_off = settings_.clamp_per_m2 > 0.0 && !field.indirect_lx.empty();
      solution_.fields.push_back(std::move(field));
    }
    solution_.looks.has_rays = ray_context_ != nullptr;
    solution_.pool_rays = pool_rays_;
    if (balanced_paths_ > 0) {
      solution_.balance.absorbed_lm = t_interval(absorbed_lm_, confidence_);
      solution_.balance.escaped_lm = t_interval(escaped_lm_, confidence_);
    }
    return std::move(solution_);
  }

 private:
  static Message why_no_result(StopReason stopped) {
    switch (stopped) {
      case StopReason::memory_limit:
        return say<Sentence::too_many_vertices>(kMostVertices);
      case StopReason::time_limit:
        return say<Sentence::time_was_up>();
      case StopReason::endless_path:
        return say<Sentence::no_steady_state>(kMostReflections);
      default:
        return say<Sentence::interrupted_at_first>();
    }
  }

  std::size_t replicates() const { return static_cast<std::size_t>(settings_.replicates); }

  void open_planes() {
    planes_.reserve(tasks_.size());
    for (const PlaneTask& task : tasks_) planes_.emplace_back(task, scene_, replicates());
    if (store_ == nullptr) return;
    const std::string space = space_key(scene_, settings_, store_->backend);
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      if (most_look_bytes(planes_[p].state) <= kMostLookBytes) {
        planes_[p].key.emplace(space, tasks_[p]);
      } else {
        ++solution_.looks.too_large;
      }
    }
  }

  // Looks for the next look of every active plane in the store; how many are not there.
  std::size_t find_stored() {
    std::size_t missing = 0;
    for (SolvedPlane& plane : planes_) {
      plane.stored.reset();
      if (!plane.state.is_active()) continue;
      if (plane.key) read_look(plane);
      if (plane.stored) {
        ++solution_.looks.read;
        solution_.balance.emitted_lm = plane.stored->light.emitted_lm;
        solution_.balance.untraced_lm = plane.stored->light.untraced_lm;
      } else {
        ++missing;
      }
    }
    if (!is_store_all()) solution_.looks.computed += missing;  // else they stay missing
    return missing;
  }

  void read_look(SolvedPlane& plane) {
    plane.look_key = plane.key->next(plane.state.active());
    const auto bytes = store_->entries.read(plane.look_key, most_look_bytes(plane.state));
    if (!bytes) return;
    plane.stored = parse_look(*bytes, plane.state);
    if (!plane.stored) {
      store_->entries.refuse(plane.look_key, "it does not hold what a look of its plane needs");
    }
  }

  // Of a plane whose look is complete.
  void write_look(const SolvedPlane& plane, bool is_exact, bool has_paths) {
    if (!plane.key) return;
    LookLight light;
    light.emitted_lm = solution_.balance.emitted_lm;
    light.untraced_lm = solution_.balance.untraced_lm;
    light.has_paths = has_paths;
    if (has_paths) {
      light.absorbed_lm = look_absorbed_lm_;
      light.escaped_lm = look_escaped_lm_;
      light.pool_rays = look_rays_;
    }
    const std::string bytes = render_look(plane.state, is_exact, light);
    // What would be refused when it is read (a number that is none) is not worth its room.
    if (parse_look(bytes, plane.state)) store_->entries.write(plane.look_key, bytes);
  }

  void make_ray_context() {
    if (ray_context_) return;
    const double begin_s = now_s();
    ray_context_ = std::make_unique<RayContext>(scene_, tasks_, settings_.skips);
    const Emitter& emitter = ray_context_->emitter;
    solution_.balance.emitted_lm = emitter.flux_lm();
    solution_.balance.untraced_lm = emitter.flux_lm() - emitter.traced_flux_lm();
    solution_.times.build_s += now_s() - begin_s;
  }

  void make_work(std::size_t p) {
    if (planes_[p].work) return;
    planes_[p].work =
        std::make_unique<PlaneWork>(ray_context_->tracer, *tasks_[p].grid,
                                    ray_context_->plan.planes[p], settings_, planes_[p].state);
  }

  // Exact light of planes that are not in the store.
  void begin_missing() {
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      if (planes_[p].stored) continue;
      make_work(p);
      planes_[p].work->begin(*tasks_[p].grid);
    }
    if (any_missing() && settings_.refuses_close_points) {
      const Message covered = source_problem(ray_context_->tracer);
      if (!covered.empty()) refuse_missing(covered);
    }
    refuse_missing_of_store();
    for (SolvedPlane& plane : planes_) {
      if (!plane.is_missing()) continue;
      plane.work->add_exact(stages_.direct_tracer, deadline_s_, solution_.times);
      if (is_past(deadline_s_)) plane.state.refuse(why_no_result(StopReason::time_limit));
    }
  }

  // What needs no samples is done, whatever becomes of the other planes.
  void finish_exact() {
    for (SolvedPlane& plane : planes_) {
      if (!plane.state.is_active()) continue;
      if (plane.stored) {
        if (!plane.stored->is_exact) continue;
        restore(*std::move(plane.stored), plane.state);
      } else {
        if (!plane.work->decision().is_exact()) continue;
        write_look(plane, true, false);
      }
      plane.state.finish(StopReason::exact);
    }
  }

  // Whether light is reflected too often before it is absorbed. The scene alone decides, by paths
  // of its own: neither the seed nor the number of paths matters. Where this lets a space pass, a
  // path reaches kMostReflections with a probability of e^-25. Few and long: nothing for a device.
  bool is_endless() {
    constexpr std::uint64_t kProbeSeed = 1;
    constexpr std::uint32_t kProbes = 32;
    // A look that was stored was taken in this space.
    if (std::any_of(planes_.begin(), planes_.end(), [](const SolvedPlane& plane) {
          return plane.state.is_active() && plane.stored;
        })) {
      return false;
    }
    if (!ray_context_->plan.samples_indirect || !ray_context_->may_be_endless) return false;
    PathBatch probes{kProbeSeed, 0, 0, kProbes, deadline_s_};
    probes.most_vertices = kProbes * kMostMeanReflections;
    const TracedPaths traced =
        trace_light_paths(ray_context_->tracer, ray_context_->emitter, probes);
    return traced.has_endless_path || traced.has_too_many_vertices;
  }

  bool is_store_all() const { return store_ != nullptr && store_->is_all_there_is; }

  // Where nothing but the store counts. What it can never hold is told as it would be otherwise:
  // points that cannot be computed, and spaces without an end.
  void refuse_missing_of_store() {
    if (!is_store_all() || !any_missing()) return;
    const bool is_unlimited = ray_context_ != nullptr && is_endless();
    for (SolvedPlane& plane : planes_) {
      if (!plane.is_missing()) continue;
      plane.state.refuse(is_unlimited ? endless_words()
                         : plane.key  ? say<Sentence::not_in_store>()
                                      : say<Sentence::too_large_for_store>());
    }
  }

  bool any_missing() const {
    return std::any_of(planes_.begin(), planes_.end(),
                       [](const SolvedPlane& plane) { return plane.is_missing(); });
  }

  static Message endless_words() {
    return say<Sentence::no_steady_state_on_average>(kMostMeanReflections);
  }

  bool any_active() const {
    return std::any_of(planes_.begin(), planes_.end(),
                       [](const SolvedPlane& plane) { return plane.state.is_active(); });
  }

  void finish_active(StopReason reason) {
    for (SolvedPlane& plane : planes_) {
      if (plane.state.is_active()) plane.state.finish(reason);
    }
  }

  void refuse_missing(const Message& problem) {
    for (SolvedPlane& plane : planes_) {
      if (plane.is_missing()) plane.state.refuse(problem);
    }
  }

  void refuse_active(const Message& problem) {
    for (SolvedPlane& plane : planes_) {
      if (plane.state.is_active()) plane.state.refuse(problem);
    }
  }

  // Looks with doubling numbers of paths until every plane is accurate, or a limit ends the work.
  void take_looks() {
    std::uint64_t done_paths = 0;
    Look look_number{0, std::countr_zero(settings_.max_paths / settings_.first_paths) + 1};
    for (std::uint64_t paths = settings_.first_paths; any_active();
         paths *= 2, ++look_number.index) {
      if (look_number.index > 0 && find_stored() > 0) {
        if (!is_store_all()) make_ray_context();
        refuse_missing_of_store();
        if (!any_active()) return;
      }
      const auto stopped = look(done_paths, paths);
      pool_rays_ += look_rays_;
      if (stopped) {
        take_direct_light();
        if (done_paths == 0) refuse_active(why_no_result(*stopped));
        return finish_active(*stopped);
      }
      exchange_with_store(done_paths, paths);
      done_paths = paths;
      for (std::size_t p = 0; p < planes_.size(); ++p) {
        PlaneState& plane = planes_[p].state;
        if (!plane.is_active()) continue;
        plane.publish(look_number.planned);
        LookAnswer answer = test_(p, plane.field(), look_number);
        if (answer.finished) {
          plane.finish(*answer.finished);
        } else if (paths * 2 > settings_.max_paths) {
          plane.finish(StopReason::path_limit);
        } else if (settings_.skips.allows(Skip::decided_points)) {
          plane.narrow(answer.active);
        }
      }
    }
  }

  // Where a look ends half-way its direct light is there, and in the fields: as if it had been
  // computed.
  void take_direct_light() {
    for (SolvedPlane& plane : planes_) {
      if (!plane.state.is_active() || !plane.stored) continue;
      PlaneField& field = plane.state.field();
      field.direct_exact_lx = plane.stored->direct_exact_lx;
      field.glare = plane.stored->glare;
      field.counters.direct_rays = plane.stored->counters.direct_rays;
    }
  }

  // The look is complete: what was computed is stored, and what was stored becomes the planes'
  // state.
  void exchange_with_store(std::uint64_t done_paths, std::uint64_t paths) {
    for (const SolvedPlane& plane : planes_) {
      if (plane.is_missing()) write_look(plane, false, is_lit(plane));
    }
    bool has_paths = !lit_planes_.empty();
    for (SolvedPlane& plane : planes_) {
      if (!plane.state.is_active() || !plane.stored) continue;
      if (plane.stored->light.has_paths && !has_paths) {
        look_absorbed_lm_ = plane.stored->light.absorbed_lm;
        look_escaped_lm_ = plane.stored->light.escaped_lm;
        pool_rays_ += plane.stored->light.pool_rays;
        has_paths = true;
      }
      restore(*std::move(plane.stored), plane.state);
      plane.stored.reset();
    }
    if (has_paths) add_balance(done_paths, paths);
  }

  bool is_lit(const SolvedPlane& plane) const {
    return std::find(lit_planes_.begin(), lit_planes_.end(), plane.work.get()) != lit_planes_.end();
  }

  // Adds paths done_paths..paths of every replicate to every active plane that is not in the store.
  // Gives a reason if it was stopped half-way; what was published before then stands.
  std::optional<StopReason> look(std::uint64_t done_paths, std::uint64_t paths) {
    look_rays_ = 0;
    lit_planes_.clear();
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      if (!planes_[p].is_missing()) continue;
      make_work(p);
      planes_[p].work->sample_openings(stages_.direct_tracer, deadline_s_, solution_.times);
    }
    if (const auto stopped = reason_to_stop(paths)) return stopped;
    if (!any_missing() || !ray_context_->plan.samples_indirect) return std::nullopt;

    const std::uint64_t batch_paths = paths - done_paths;
    const bool is_pool = settings_.method == Method::light_pool;
    const GeometryBound bound(ray_context_->tracer, ray_context_->emitter, batch_paths);
    for (SolvedPlane& plane : planes_) {
      if (!plane.is_missing() || !plane.work->decision().samples_reflection) continue;
      plane.work->start_look(is_pool ? bound.reach_m() : 0.0,
                             is_pool
                                 ? PossibleVertex{ray_context_->largest_path_lm,
                                                  ray_context_->mean_reflectance, bound.smallest()}
                                 : PossibleVertex{});
      lit_planes_.push_back(plane.work.get());
    }
    if (!lit_planes_.empty()) {
      if (const auto stopped = run_replicates(is_pool ? &bound : nullptr, done_paths, paths)) {
        return stopped;
      }
    }
    for (SolvedPlane& plane : planes_) {
      if (plane.is_missing()) plane.work->finish_look(batch_paths);
    }
    return std::nullopt;
  }

  // Replicates run at the same time, each with a pool of its own.
  std::optional<StopReason> run_replicates(const GeometryBound* bound, std::uint64_t first,
                                           std::uint64_t last) {
    const double begin_s = now_s();
    std::vector<SolveTimes> times(replicates());
    std::vector<std::optional<StopReason>> stopped(replicates());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, replicates(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t r = range.begin(); r < range.end(); ++r) {
            if (is_stopped_) return;
            stopped[r] = run_replicate(bound, r, first, last, times[r]);
            if (stopped[r]) is_stopped_ = true;
          }
        },
        tbb::simple_partitioner());
    add_elapsed(times, now_s() - begin_s);
    is_stopped_ = false;
    for (const std::optional<StopReason>& reason : stopped) {
      if (reason) return reason;
    }
    return std::nullopt;
  }

  // Gives a reason if it was stopped half-way.
  std::optional<StopReason> run_replicate(const GeometryBound* bound, std::size_t replicate,
                                          std::uint64_t first, std::uint64_t last,
                                          SolveTimes& times) {
    const FlushDenormals flush;
    TracedPaths traced;
    {
      const PhaseTimer timer(times.pool_s);
      tbb::this_task_arena::isolate([&] { traced = trace(replicate, first, last); });
    }
    if (traced.has_endless_path) return StopReason::endless_path;
    if (traced.has_too_many_vertices) return StopReason::memory_limit;
    if (const auto stopped = reason_to_stop(last)) return stopped;
    const double sort_begin_s = now_s();
    const std::size_t channels = ray_context_->tracer.scene().channels.size();
    const VertexTree tree(std::move(traced.vertices), channels);
    const VertexBounds bounds =
        bound != nullptr
            ? VertexBounds(*bound, tree.vertices())
            : VertexBounds(settings_.clamp_per_m2 > 0.0 ? settings_.clamp_per_m2
                                                        : std::numeric_limits<double>::infinity());
    Cut global_cut;
    if (bound != nullptr) {
      ReceiverTile everywhere;
      everywhere.softening_m =
          static_cast<float>(kGlobalSoftening * ray_context_->tracer.scene().extent_m);
      global_cut.build(tree, everywhere,
                       {kGlobalCut, static_cast<float>(bound->smallest()), false});
    }
    times.pool_s += now_s() - sort_begin_s;
    if (stages_.gatherer.connects_all() && bound == nullptr) {
      gather_all_planes(ray_context_->tracer, lit_planes_,
                        {tree, bounds, bound, ray_context_->luminaire_choice, global_cut, replicate,
                         first, last - first, deadline_s_},
                        stages_.gatherer, times);
      return reason_to_stop(last);
    }
    for (PlaneWork* plane : lit_planes_) {
      plane->connect({tree, bounds, bound, ray_context_->luminaire_choice, global_cut, replicate,
                      first, last - first, deadline_s_, stages_.short_rays, &has_endless_chain_},
                     stages_.gatherer, times);
      if (has_endless_chain_) return StopReason::endless_path;
      if (const auto stopped = reason_to_stop(last)) return stopped;
    }
    return std::nullopt;
  }

  // Running means over all complete looks, weighted by paths.
  void add_balance(std::uint64_t first, std::uint64_t last) {
    const double share = static_cast<double>(last - first) / static_cast<double>(last);
    for (std::size_t r = 0; r < replicates(); ++r) {
      absorbed_lm_[r] += share * (look_absorbed_lm_[r] - absorbed_lm_[r]);
      escaped_lm_[r] += share * (look_escaped_lm_[r] - escaped_lm_[r]);
    }
    balanced_paths_ = last;
  }

  // Replicates share the elapsed time in proportion to their work.
  void add_elapsed(const std::vector<SolveTimes>& times, double elapsed_s) {
    SolveTimes sum;
    for (const SolveTimes& t : times) {
      sum.pool_s += t.pool_s;
      sum.maps_s += t.maps_s;
      sum.connect_s += t.connect_s;
      sum.near_s += t.near_s;
    }
    const double busy_s = sum.pool_s + sum.maps_s + sum.connect_s + sum.near_s;
    if (!(busy_s > 0.0)) return;
    const double share = elapsed_s / busy_s;
    solution_.times.pool_s += share * sum.pool_s;
    solution_.times.maps_s += share * sum.maps_s;
    solution_.times.connect_s += share * sum.connect_s;
    solution_.times.near_s += share * sum.near_s;
  }

  TracedPaths trace_batch(const PathBatch& batch) const {
    if (stages_.path_tracer == nullptr)
      return trace_light_paths(ray_context_->tracer, ray_context_->emitter, batch);
    return stages_.path_tracer->trace(ray_context_->tracer, ray_context_->emitter, batch);
  }

  TracedPaths trace(std::size_t replicate, std::uint64_t first, std::uint64_t last) {
    const PathBatch batch{settings_.seed, replicate, static_cast<std::uint32_t>(first),
                          static_cast<std::uint32_t>(last), deadline_s_};
    TracedPaths traced = cache_ != nullptr ? cache_->take(batch) : trace_batch(batch);
    look_absorbed_lm_[replicate] = traced.absorbed_lm;
    look_escaped_lm_[replicate] = traced.escaped_lm;
    look_rays_ += traced.rays;
    return traced;
  }

  std::optional<StopReason> reason_to_stop(std::uint64_t paths) {
    if (is_past(deadline_s_)) return StopReason::time_limit;
    if (!progress_) return std::nullopt;
    const std::scoped_lock lock(progress_mutex_);
    SolveProgress state;
    state.planes = planes_.size();
    state.planes_done = static_cast<std::size_t>(std::count_if(
        planes_.begin(), planes_.end(), [](const SolvedPlane& p) { return !p.state.is_active(); }));
    state.paths_per_replicate = paths;
    if (!progress_(state)) return StopReason::interrupted;
    return std::nullopt;
  }

  const PreparedScene& scene_;
  const std::vector<PlaneTask>& tasks_;
  const RadiositySettings& settings_;
  double confidence_;
  const Stages& stages_;
  const LookTest& test_;
  const ProgressSink& progress_;
  const VertexCache* cache_;
  const LookStore* store_;
  double start_s_;
  std::unique_ptr<RayContext> ray_context_;  // once a look has to be computed
  std::vector<SolvedPlane> planes_;
  std::vector<PlaneWork*> lit_planes_;            // active ones with indirect light, of this look
  std::vector<double> absorbed_lm_, escaped_lm_;  // per replicate
  std::vector<double> look_absorbed_lm_, look_escaped_lm_;  // the same, of one look
  std::uint64_t balanced_paths_ = 0;
  std::atomic<std::uint64_t> look_rays_{0};  // of light paths, in this look
  std::uint64_t pool_rays_ = 0;              // the same of all looks
  std::atomic<bool> is_stopped_{false}, has_endless_chain_{false};
  std::mutex progress_mutex_;
  double deadline_s_ = 0.0;  // 0 = none
  SpaceSolution solution_;
};

}  // namespace

SpaceSolution solve_illuminance(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                                const RadiositySettings& settings, double confidence,
                                const Stages& stages, const LookTest& test,
                                const ProgressSink& progress, const VertexCache* cache,
                                const LookStore* store) {
  SpaceSolution solution;
  on_threads(settings.jobs, [&] {
    solution =
        Solver(scene, tasks, settings, confidence, stages, test, progress, cache, store).run();
  });
  return solution;
}

}  // namespace calc
