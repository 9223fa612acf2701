#include "calc/radiosity/paths/importance.h"

#include "calc/base/sentences.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/threads.h"
#include "calc/radiosity/terms/path_terms.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace calc {
namespace {

constexpr double kAnyDistance = std::numeric_limits<double>::infinity();
constexpr double kLeastSurvival = 0.25;

// Sobol' dimensions of a path.
enum : int { kPointDimension = 0, kFirstDirection = 1, kFirstBounce = 3 };
constexpr int kBounceDimensions = 3;  // roulette, direction

// Not one of RandomStage's, so that the streams of the solver stay apart from it.
RandomKey importance_key(const ImportanceSettings& settings) {
  return RandomKey(settings.seed).with("importance");
}

// Chooses points of a target by their weights.
class PointChoice {
 public:
  explicit PointChoice(const ImportanceTarget& target) : cumulative_{0.0} {
    for (std::size_t i = 0; i < target.receiver.size(); ++i) {
      cumulative_.push_back(cumulative_.back() + (target.weight.empty() ? 1.0 : target.weight[i]));
    }
  }
  // u in [0, 1).
  std::size_t choose(double u) const {
    const auto above =
        std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u * cumulative_.back());
    return static_cast<std::size_t>(above - cumulative_.begin() - 1);
  }
  double share(std::size_t i) const {
    return (cumulative_[i + 1] - cumulative_[i]) / cumulative_.back();
  }

 private:
  std::vector<double> cumulative_;
};

// What was found by one batch of one target.
struct PathVertices {
  std::vector<ImportanceVertex> vertices;
  std::vector<double> slope, step;
  std::uint64_t rays = 0;
};

class PathFollower {
 public:
  PathFollower(const Tracer& tracer, const SurfaceClasses& classes, PathVertices& found)
      : tracer_(tracer),
        classes_(classes),
        found_(found),
        slope_(classes.count),
        step_(classes.count) {}

  // False: it did not end. share: what the path counts for.
  bool follow(const Receiver& receiver, const ScrambledSobol& sobol, std::uint32_t index,
              double share) {
    weight_ = share;
    std::fill(slope_.begin(), slope_.end(), 0.0);
    std::fill(step_.begin(), step_.end(), share);
    glm::dvec3 origin_m = tracer_.lift(receiver), axis = receiver.axis;
    int dimension = kFirstDirection;
    for (int reflection = 0; reflection < kMostReflections; ++reflection) {
      const auto u = sobol.sample_pair(index, dimension);
      SurfaceHit hit;
      ++found_.rays;
      if (!tracer_.closest_hit(origin_m, cosine_direction(axis, u[0], u[1]), kAnyDistance, hit)) {
        return true;
      }
      const int bounce = kFirstBounce + kBounceDimensions * reflection;
      if (!reflect(hit.triangle, reflection, sobol.sample(index, bounce))) return true;
      store(hit);
      origin_m = tracer_.lift(hit.position_m, hit.normal);
      axis = hit.normal;
      dimension = bounce + 1;
    }
    return false;
  }

 private:
  // False: the path ends.
  bool reflect(std::uint32_t triangle, int reflection, double u) {
    const double rho = tracer_.scene().reflectance[triangle];
    const double survival = reflection == 0 ? 1.0 : std::max(rho, kLeastSurvival);
    if (u >= survival) return false;
    const std::uint32_t own = classes_.count > 0 ? classes_.of_triangle[triangle] : kNoClass;
    bool is_known = false;
    for (std::size_t c = 0; c < classes_.count; ++c) {
      const bool changes = c == own;
      // The product rule: one factor more.
      slope_[c] = (slope_[c] * rho + (changes ? weight_ : 0.0)) / survival;
      step_[c] *= (changes ? rho + classes_.step : rho) / survival;
      is_known = is_known || slope_[c] > 0.0 || step_[c] > 0.0;
    }
    weight_ *= rho / survival;
    return is_known || weight_ > 0.0;
  }

  void store(const SurfaceHit& hit) {
    found_.vertices.push_back({hit.position_m, hit.normal, weight_});
    for (std::size_t c = 0; c < classes_.count; ++c) {
      found_.slope.push_back(slope_[c]);
      found_.step.push_back(step_[c] - weight_);
    }
  }

  const Tracer& tracer_;
  const SurfaceClasses& classes_;
  PathVertices& found_;
  double weight_ = 0.0;
  std::vector<double> slope_, step_;  // [class]; of step_ the whole weight
};

std::string importance_problem(std::span<const ImportanceTarget> targets,
                               const SurfaceClasses& classes, const PreparedScene& scene,
                               const ImportanceSettings& settings) {
  if (settings.batches < 2 || settings.paths < 1 || settings.most_points < 1) {
    return "importance needs two batches, one path and one point at least";
  }
  if (classes.count > 0 && classes.of_triangle.size() != scene.triangle.size()) {
    return "every triangle must have a class of surfaces, or none";
  }
  for (const ImportanceTarget& target : targets) {
    if (target.receiver.empty()) return "a target has no points";
    if (!target.weight.empty() && target.weight.size() != target.receiver.size()) {
      return "every point of a target must have a weight, or none";
    }
    for (const Receiver& receiver : target.receiver) {
      if (!has_back(receiver.kernel)) return "points must measure the illuminance of a plane";
    }
  }
  return "";
}

// Points that a batch takes of a target, each with what it counts for.
struct TakenPoint {
  std::size_t index;
  double share;
};
std::vector<TakenPoint> take_points(const ImportanceTarget& target, RandomKey key,
                                    std::size_t most) {
  const PointChoice choice(target);
  std::vector<TakenPoint> taken;
  if (target.receiver.size() <= most) {
    for (std::size_t i = 0; i < target.receiver.size(); ++i) taken.push_back({i, choice.share(i)});
    return taken;
  }
  // Evenly spaced, from a random place on: one of each stretch of neighbours.
  for (std::size_t k = 0; k < most; ++k) {
    const double u = (static_cast<double>(k) + key.uniform()) / static_cast<double>(most);
    taken.push_back({choice.choose(u), 1.0 / static_cast<double>(most)});
  }
  return taken;
}

// One place of all of the opening would be far off there: near parts are to be drawn more often.
bool is_beside_opening(const PlacedLuminaire& luminaire, const glm::dvec3& position_m) {
  return luminaire.opening.shape != OpeningShape::point &&
         glm::length(luminaire.position_m - position_m) < glm::length(luminaire.opening.size_m());
}

void add_direct(const Tracer& tracer, const ImportanceTarget& target, RandomKey key,
                std::size_t most_points, std::span<double> lx) {
  std::vector<double> of_point(lx.size());
  for (const TakenPoint& point : take_points(target, key.with("points"), most_points)) {
    std::fill(of_point.begin(), of_point.end(), 0.0);
    const Receiver& receiver = target.receiver[point.index];
    add_point_sources(tracer, receiver, {}, of_point.data(), 1);
    add_extended_sources(tracer, receiver, {}, key.with("openings").with(point.index), 0, 1,
                         of_point.data(), 1);
    for (std::size_t l = 0; l < lx.size(); ++l) lx[l] += point.share * of_point[l];
  }
}

}  // namespace

ImportancePool trace_importance(const Tracer& tracer, std::span<const ImportanceTarget> targets,
                                const SurfaceClasses& classes, const ImportanceSettings& settings) {
  ImportancePool pool{targets.size(), classes.count, settings.batches, {}, {}, {}, {}, 0, {}};
  pool.problem = Message::words(importance_problem(targets, classes, tracer.scene(), settings));
  if (!pool.problem.empty()) return pool;
  std::vector<PathVertices> parts(settings.batches * targets.size());
  std::atomic<bool> is_endless{false}, is_stopped{false};
  on_threads(settings.jobs, [&] {
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
      const FlushDenormals flush;
      if (settings.goes_on && !settings.goes_on()) is_stopped = true;
      if (is_stopped || is_endless) return;
      const std::size_t batch = k / targets.size(), t = k % targets.size();
      const PointChoice choice(targets[t]);
      const ScrambledSobol sobol(importance_key(settings).with("paths").with(batch).with(t),
                                 kSobolDimensions);
      PathFollower follower(tracer, classes, parts[k]);
      for (std::uint32_t p = 0; p < settings.paths; ++p) {
        const std::size_t point = choice.choose(sobol.sample(p, kPointDimension));
        if (!follower.follow(targets[t].receiver[point], sobol, p, 1.0 / settings.paths)) {
          is_endless = true;
          return;
        }
      }
    });
  });
  if (is_stopped) pool.problem = say<Sentence::interrupted>();
  if (is_endless) {
    pool.problem = say<Sentence::endless_path>(kMostReflections);
  }
  if (!pool.problem.empty()) return pool;
  pool.first.push_back(0);
  for (const PathVertices& part : parts) {
    pool.vertices.insert(pool.vertices.end(), part.vertices.begin(), part.vertices.end());
    pool.slope.insert(pool.slope.end(), part.slope.begin(), part.slope.end());
    pool.step.insert(pool.step.end(), part.step.begin(), part.step.end());
    pool.first.push_back(pool.vertices.size());
    pool.rays += part.rays;
  }
  return pool;
}

LightByLuminaire light_of_luminaires(const Tracer& tracer,
                                     std::span<const ImportanceTarget> targets,
                                     const ImportancePool& pool,
                                     const ImportanceSettings& settings) {
  const std::size_t luminaires = tracer.scene().luminaires.size();
  LightByLuminaire light{
      pool.batches, pool.targets, luminaires, pool.classes, {}, {}, {}, {}, 0, {}};
  light.problem = pool.problem;
  if (light.problem.empty() &&
      (targets.size() != pool.targets || pool.first.size() != pool.batches * pool.targets + 1 ||
       tracer.scene().channels.size() != luminaires)) {
    light.problem = Message::words("pool, targets and luminaires do not belong together");
  }
  if (!light.problem.empty()) return light;
  const std::size_t parts = pool.batches * pool.targets;
  light.direct_lx.assign(parts * luminaires, 0.0);
  light.reflected_lx = light.direct_lx;
  light.slope_lx.assign(parts * pool.classes * luminaires, 0.0);
  light.step_lx = light.slope_lx;
  std::atomic<bool> is_stopped{false};
  std::atomic<std::uint64_t> rays{0};
  on_threads(settings.jobs, [&] {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t k) {
      const FlushDenormals flush;
      const std::size_t batch = k / pool.targets, t = k % pool.targets;
      const RandomKey key = importance_key(settings).with("light").with(batch).with(t);
      add_direct(tracer, targets[t], key, settings.most_points,
                 std::span(light.direct_lx).subspan(k * luminaires, luminaires));
      std::vector<double> sample(luminaires);
      double* reflected = luminaires > 0 ? &light.reflected_lx[k * luminaires] : nullptr;
      for (std::size_t v = pool.first[k]; v < pool.first[k + 1]; ++v) {
        if (v % 64 == 0 && settings.goes_on && !settings.goes_on()) is_stopped = true;
        if (is_stopped) return;
        const ImportanceVertex& vertex = pool.vertices[v];
        std::fill(sample.begin(), sample.end(), 0.0);
        rays +=
            add_direct_sample(tracer, {vertex.position_m, vertex.normal},
                              key.with("places").with(v - pool.first[k]), 1.0, sample.data(), 1);
        for (std::size_t l = 0; l < luminaires; ++l) {
          if (!is_beside_opening(tracer.scene().luminaires[l], vertex.position_m)) continue;
          sample[l] = 0.0;
          rays += add_direct_sample_of(tracer, l, {vertex.position_m, vertex.normal},
                                       key.with("near").with(v - pool.first[k]).with(l), 1.0,
                                       sample.data(), 1);
        }
        for (std::size_t l = 0; l < luminaires; ++l) reflected[l] += vertex.weight * sample[l];
        for (std::size_t c = 0; c < pool.classes; ++c) {
          const double slope = pool.slope[v * pool.classes + c];
          const double step = pool.step[v * pool.classes + c];
          const std::size_t row = (k * pool.classes + c) * luminaires;
          for (std::size_t l = 0; l < luminaires; ++l) {
            light.slope_lx[row + l] += slope * sample[l];
            light.step_lx[row + l] += step * sample[l];
          }
        }
      }
    });
  });
  light.rays = rays;
  if (is_stopped) light.problem = say<Sentence::interrupted>();
  return light;
}

}  // namespace calc
