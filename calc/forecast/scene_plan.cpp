#include "calc/forecast/scene_plan.h"

#include "calc/proofs/point_set.h"
#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/glare.h"
#include "calc/radiosity/direct/opening_light.h"
#include "calc/radiosity/paths/near_field.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>
#include <set>

namespace calc {
namespace {

// Of a receiver, on average.
struct OpeningEffort {
  double samples = 0.0;     // of one round and one replicate, where nothing is proved
  double known = 0.0;       // openings that are seen in full
  double obstructed = 0.0;  // openings that are not, or of which nothing is proved
  double channels = 0.0;    // with openings that are seen in full
};

// Rays of one round and one replicate towards an opening of which nothing is proved.
double rays_towards(const PlacedLuminaire& luminaire, const Receiver& receiver, bool is_eye) {
  if (is_eye) return static_cast<double>(kSightLines * kSightLines);
  double rays = 0.0;
  for (const OpeningCell& cell : opening_cells(luminaire, receiver.position_m)) {
    rays += cell.samples;
  }
  return rays;
}

// From points spread over the plane.
OpeningEffort opening_effort(const Tracer& tracer, const PointSet& points,
                             const PlaneDecision& decided) {
  constexpr std::size_t kProbes = 16;
  const std::size_t count = points.position_m.size(), probes = std::min(kProbes, count);
  const auto& luminaires = tracer.scene().luminaires;
  OpeningEffort effort;
  if (count == 0) return effort;
  for (std::size_t k = 0; k < probes; ++k) {
    const std::size_t i = (2 * k + 1) * count / (2 * probes);
    const Receiver receiver{points.position_m[i], points.normal[i], points.kernel};
    std::set<std::size_t> known_channels;
    for (std::size_t l = 0; l < luminaires.size(); ++l) {
      if (luminaires[l].opening.shape == OpeningShape::point) continue;
      if (!decided.is_dark.empty() && decided.is_dark[l] != 0) continue;
      const bool is_eye = !decided.measures_direct;
      if (is_eye && is_behind(luminaires[l], receiver)) continue;
      const Sight sight = opening_sight(tracer, l, receiver, !decided.is_unobstructed);
      if (sight == Sight::free) {
        ++effort.known;
        known_channels.insert(luminaires[l].channel);
      } else {
        ++effort.obstructed;
      }
      if (sight == Sight::unknown) effort.samples += rays_towards(luminaires[l], receiver, is_eye);
    }
    effort.channels += static_cast<double>(known_channels.size());
  }
  effort.channels /= static_cast<double>(probes);
  effort.samples /= static_cast<double>(probes);
  effort.obstructed /= static_cast<double>(probes);
  effort.known /= static_cast<double>(probes);
  return effort;
}

// Distance from a point to a box.
double distance_m(const glm::dvec3& point_m, const glm::dvec3& low, const glm::dvec3& high) {
  return glm::length(glm::max(glm::max(low - point_m, point_m - high), glm::dvec3(0.0)));
}

// Share of the points with a surface in front of them within the reach of the near field. Triangles
// count as their boxes; a few points stand for all.
double near_share(const PreparedScene& scene, const PointSet& points, double reach_m) {
  constexpr std::size_t kProbes = 64, kMostTests = 200'000;
  const std::size_t count = points.position_m.size(), probes = std::min(kProbes, count);
  if (probes * scene.triangle.size() > kMostTests) return 1.0;
  std::vector<glm::dvec3> low, high;
  for (const glm::uvec3& t : scene.triangle) {
    const glm::dvec3 a(scene.vertex_m[t.x]), b(scene.vertex_m[t.y]), c(scene.vertex_m[t.z]);
    low.push_back(glm::min(a, glm::min(b, c)));
    high.push_back(glm::max(a, glm::max(b, c)));
  }
  const auto is_near = [&](std::size_t i) {
    const glm::dvec3& p = points.position_m[i];
    for (std::size_t t = 0; t < low.size(); ++t) {
      if (distance_m(p, low[t], high[t]) >= reach_m) continue;
      if (!points.has_back()) return true;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 corner(scene.vertex_m[scene.triangle[t][k]]);
        if (glm::dot(points.normal[i], corner - p) > scene.ray_offset_m()) return true;
      }
    }
    return false;
  };
  std::size_t near = 0;
  for (std::size_t k = 0; k < probes; ++k) near += is_near((2 * k + 1) * count / (2 * probes));
  return static_cast<double>(near) / static_cast<double>(probes);
}

class Planner {
 public:
  Planner(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
          const RadiositySettings& settings)
      : scene_(scene),
        tasks_(tasks),
        settings_(settings),
        surfaces_(summarise_surfaces(scene)),
        solve_(decide(scene, tasks, settings.skips)) {
    plan_.luminaires = scene.luminaires.size();
    plan_.threads = thread_count(settings);
    plan_.skips =
        explain_skips(solve_, scene, tasks, settings.skips, settings.method == Method::light_pool);
  }

  ScenePlan run() {
    for (std::size_t p = 0; p < tasks_.size(); ++p) add_plane(p);
    finish();
    return std::move(plan_);
  }

 private:
  void add_plane(std::size_t p) {
    const PlaneDecision& decided = solve_.planes[p];
    PlanePlan plane;
    plane.plane_id = tasks_[p].plane_id;
    plane.points = decided.points;
    plane.luminaires = scene_.luminaires.size() - decided.dark_luminaires();
    if (decided.samples_reflection) plane.seeing_points = decided.gathering_points();
    plane.is_exact = decided.is_exact();
    plan_.planes.push_back(std::move(plane));
    add_workload(p);
  }

  void add_workload(std::size_t p) {
    const PlaneDecision& decided = solve_.planes[p];
    const std::vector<glm::dvec3> position_m = local_positions_m(scene_, *tasks_[p].grid);
    const PointSet points{position_m, tasks_[p].grid->normal, tasks_[p].grid->kernel};
    const std::size_t of_each = decided.points == 0 ? 1 : decided.receivers / decided.points;
    PlaneWorkload load;
    load.points = decided.receivers;
    load.seeing_points = plan_.planes[p].seeing_points * of_each;
    load.is_unobstructed = decided.is_unobstructed;
    if (load.seeing_points > 0) {
      load.near_points = static_cast<double>(load.seeing_points) *
                         (settings_.skips.allows(Skip::clear_distance)
                              ? near_share(scene_, points, near_reach_m(surfaces_))
                              : 1.0);
    }
    std::size_t point_openings = 0;
    for (std::size_t l = 0; l < scene_.luminaires.size(); ++l) {
      if (!decided.is_dark.empty() && decided.is_dark[l] != 0) continue;
      if (scene_.luminaires[l].opening.shape == OpeningShape::point) ++point_openings;
    }
    const auto receivers = static_cast<double>(decided.receivers);
    load.exact_direct_rays = receivers * static_cast<double>(point_openings);
    if (decided.samples_openings || !decided.measures_direct) {
      if (!tracer_) tracer_.emplace(scene_);
      const OpeningEffort effort = opening_effort(*tracer_, points, decided);
      const bool is_eye = !decided.measures_direct;  // looks once, and not at random
      if (is_eye) load.exact_direct_rays += receivers * effort.samples;
      if (!is_eye) load.sampled_direct_rays = receivers * settings_.replicates * effort.samples;
      load.known_openings = receivers * effort.known;
      load.obstructed_openings = receivers * effort.obstructed;
      if (!is_eye) load.known_points = receivers * effort.channels;
    }
    plan_.workload.planes.push_back(load);
  }

  void finish() {
    const bool is_sampled = std::any_of(plan_.planes.begin(), plan_.planes.end(),
                                        [](const PlanePlan& plane) { return !plane.is_exact; });
    if (is_sampled) {
      plan_.looks = std::countr_zero(settings_.max_paths / settings_.first_paths) + 1;
    }
    SpaceWorkload& load = plan_.workload;
    load.channels = std::max<std::size_t>(1, scene_.channels.size());
    load.triangles = scene_.triangle.size();
    // In a closed space: the first reflection is free, each further one has the chance rho.
    const double rho = std::min(surfaces_.mean_reflectance, 0.9999);
    load.rays_per_path = rho > 0.0 ? 1.0 + 1.0 / (1.0 - rho) : 1.0;
    load.vertices_per_path = rho > 0.0 ? load.rays_per_path : 0.0;
    const auto prediction = [&](std::uint64_t paths) {
      return predict(load, std::vector<std::uint64_t>(tasks_.size(), paths), settings_,
                     plan_.threads);
    };
    plan_.first_look = prediction(settings_.first_paths);
    plan_.last_look = prediction(settings_.max_paths);
  }

  const PreparedScene& scene_;
  const std::vector<PlaneTask>& tasks_;
  const RadiositySettings& settings_;
  SurfaceSummary surfaces_;
  SolvePlan solve_;
  std::optional<Tracer> tracer_;  // where openings are sampled
  ScenePlan plan_;
};

}  // namespace

ScenePlan make_scene_plan(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                          const RadiositySettings& settings) {
  return Planner(scene, tasks, settings).run();
}

}  // namespace calc
