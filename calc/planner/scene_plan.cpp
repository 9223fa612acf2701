#include "calc/planner/scene_plan.h"

#include "calc/planner/beam.h"
#include "calc/planner/convex_space.h"
#include "calc/planner/point_set.h"
#include "calc/planner/predicates.h"
#include "calc/radiosity/direct.h"
#include "calc/radiosity/near_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>

namespace calc {
namespace {

std::size_t count_ones(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

std::string of_all(std::size_t part, std::size_t all, std::string_view things) {
  return part == all ? fmt::format("all {} {}", all, things)
                     : fmt::format("{} of {} {}", part, all, things);
}

// One round of samples on extended openings for one replicate, from points spread over the plane.
double opening_samples_per_point(const PreparedScene& scene, const PointSet& points,
                                 const std::vector<std::uint8_t>& dark) {
  constexpr std::size_t kProbes = 8;
  const std::size_t count = points.position_m.size(), probes = std::min(kProbes, count);
  double samples = 0.0;
  for (std::size_t k = 0; k < probes; ++k) {
    const glm::dvec3& position_m = points.position_m[(2 * k + 1) * count / (2 * probes)];
    for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
      const PlacedLuminaire& luminaire = scene.luminaires[l];
      if (luminaire.opening.shape == OpeningShape::point || dark[l] != 0) continue;
      for (const OpeningCell& cell : opening_cells(luminaire, position_m)) samples += cell.samples;
    }
  }
  return samples / static_cast<double>(probes);
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
        beams_(beams_of(scene)) {
    plan_.luminaires = scene.luminaires.size();
    plan_.threads = thread_count(settings);
    for (std::size_t s = 0; s < kSkips; ++s) {
      const Skip skip = static_cast<Skip>(s);
      plan_.skips.push_back({skip, SkipState::not_proved, "", {}, 0, std::nullopt});
      if (settings.skips.allows(skip)) continue;
      decision(skip).state = SkipState::forbidden;
      decision(skip).why = "forbidden by --no-skip " + std::string(skip_name(skip));
    }
  }

  ScenePlan run() {
    for (const PlaneTask& task : tasks_) {
      position_m_.push_back(local_positions_m(scene_, *task.grid));
      points_.push_back({position_m_.back(), task.grid->normal, task.grid->kernel});
      bounds_.push_back(bounds_of(points_.back()));
      plan_.planes.push_back({task.plane_id, points_.back().position_m.size(), 0, 0, false});
    }
    decide_no_reflection();
    decide_unlit_surfaces();
    decide_behind_plane();
    decide_dark_pairs();
    decide_convex();
    decide_running();
    finish();
    return std::move(plan_);
  }

 private:
  SkipDecision& decision(Skip skip) { return plan_.skips[static_cast<std::size_t>(skip)]; }
  bool allows(Skip skip) const { return settings_.skips.allows(skip); }

  void set(Skip skip, SkipState state, std::string why) {
    decision(skip).state = state;
    decision(skip).why = std::move(why);
  }

  void decide_no_reflection() {
    const bool is_black = no_reflection(scene_);
    has_indirect_ = !scene_.luminaires.empty() && !(is_black && allows(Skip::no_reflection));
    if (!allows(Skip::no_reflection)) return;
    const auto reflecting =
        static_cast<std::size_t>(std::count_if(scene_.reflectance.begin(), scene_.reflectance.end(),
                                               [](double rho) { return rho > 0.0; }));
    if (is_black) {
      set(Skip::no_reflection, SkipState::applies,
          scene_.triangle.empty() ? "there is no surface" : "every surface is black");
    } else {
      set(Skip::no_reflection, SkipState::not_proved,
          of_all(reflecting, scene_.triangle.size(), "triangles") + " reflect");
    }
  }

  void decide_unlit_surfaces() {
    if (!allows(Skip::unlit_surfaces)) return;
    if (!has_indirect_) return set(Skip::unlit_surfaces, SkipState::not_needed, kNoIndirect);
    const std::size_t all = scene_.luminaires.size();
    const std::size_t unlit = count_ones(find_unlit_surfaces(scene_, beams_));
    decision(Skip::unlit_surfaces).luminaires = unlit;
    if (unlit == 0) {
      return set(Skip::unlit_surfaces, SkipState::not_proved,
                 "every luminaire may light a reflecting surface");
    }
    has_indirect_ = unlit < all;
    set(Skip::unlit_surfaces, SkipState::applies,
        of_all(unlit, all, "luminaires") + " cannot light any reflecting surface");
  }

  void decide_behind_plane() {
    std::vector<std::string>& proved = decision(Skip::behind_plane).planes;
    std::size_t hidden = 0, all = 0;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      const std::size_t count = plan_.planes[p].points;
      all += count;
      if (!has_indirect_) continue;
      plan_.planes[p].seeing_points = count;
      if (!allows(Skip::behind_plane)) continue;
      const ReflectionView view = find_reflection_view(scene_, points_[p]);
      plan_.planes[p].seeing_points = view.seeing;
      hidden += count - view.seeing;
      if (view.is_behind_plane()) proved.push_back(tasks_[p].plane_id);
    }
    if (!allows(Skip::behind_plane)) return;
    if (!has_indirect_) return set(Skip::behind_plane, SkipState::not_needed, kNoIndirect);
    if (hidden == 0) {
      return set(Skip::behind_plane, SkipState::not_proved,
                 "reflecting surfaces reach in front of every point");
    }
    set(Skip::behind_plane, SkipState::applies,
        "every reflecting surface lies behind " + of_all(hidden, all, "points"));
  }

  void decide_dark_pairs() {
    const std::size_t luminaires = scene_.luminaires.size();
    std::size_t dark_pairs = 0;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      std::vector<std::uint8_t> dark(luminaires, 0);
      if (allows(Skip::dark_pairs)) dark = find_dark_luminaires(scene_, beams_, bounds_[p]);
      const std::size_t dark_here = count_ones(dark);
      dark_pairs += dark_here;
      plan_.planes[p].luminaires = luminaires - dark_here;
      if (dark_here == luminaires && luminaires > 0) {
        decision(Skip::dark_pairs).planes.push_back(tasks_[p].plane_id);
      }
      plan_direct(p, dark);
    }
    if (!allows(Skip::dark_pairs)) return;
    decision(Skip::dark_pairs).luminaires = dark_pairs;
    if (dark_pairs == 0) {
      return set(Skip::dark_pairs, SkipState::not_proved,
                 "every luminaire may light a point of every plane");
    }
    set(Skip::dark_pairs, SkipState::applies,
        of_all(dark_pairs, luminaires * tasks_.size(), "pairs of luminaire and plane") +
            " are dark: the beam misses the plane or comes from behind");
  }

  void plan_direct(std::size_t p, const std::vector<std::uint8_t>& dark) {
    PlaneWorkload load;
    load.points = plan_.planes[p].points;
    load.seeing_points = plan_.planes[p].seeing_points;
    if (load.seeing_points > 0) {
      const bool is_skipped = allows(Skip::clear_distance);
      load.near_points =
          static_cast<double>(load.seeing_points) *
          (is_skipped ? near_share(scene_, points_[p], near_reach_m(surfaces_)) : 1.0);
    }
    std::size_t point_openings = 0;
    for (std::size_t l = 0; l < dark.size(); ++l) {
      if (dark[l] == 0 && scene_.luminaires[l].opening.shape == OpeningShape::point) {
        ++point_openings;
      }
    }
    const auto points = static_cast<double>(load.points);
    load.exact_direct_rays = points * static_cast<double>(point_openings);
    load.sampled_direct_rays =
        points * settings_.replicates * opening_samples_per_point(scene_, points_[p], dark);
    plan_.planes[p].is_exact = load.sampled_direct_rays == 0.0 && load.seeing_points == 0;
    plan_.workload.planes.push_back(load);
  }

  void decide_convex() {
    if (!allows(Skip::convex)) return;
    ConvexAnswer answer = find_convex_space(scene_);
    if (!answer.space) {
      decision(Skip::convex).body = answer.obstacle_body;
      return set(Skip::convex, SkipState::not_proved, std::move(answer.why_not));
    }
    std::vector<std::string>& proved = decision(Skip::convex).planes;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      if (!answer.space->holds(points_[p], bounds_[p])) continue;
      proved.push_back(tasks_[p].plane_id);
      plan_.workload.planes[p].is_unobstructed = true;
    }
    if (proved.empty()) {
      return set(Skip::convex, SkipState::not_proved, "points lie outside the surfaces' walls");
    }
    set(Skip::convex, SkipState::applies, "nothing stands between two points of the space");
  }

  // Sought by the calculation itself, at each point or look.
  void decide_running() {
    const bool is_sampled = std::any_of(plan_.planes.begin(), plan_.planes.end(),
                                        [](const PlanePlan& p) { return p.seeing_points > 0; });
    const bool has_pool = is_sampled && settings_.method == Method::light_pool;
    decide_running(Skip::hidden_nodes, has_pool,
                   "groups of light vertices behind a point or facing away");
    decide_running(Skip::clear_distance, is_sampled, "points with no surface near them");
    const bool has_looks = std::any_of(plan_.planes.begin(), plan_.planes.end(),
                                       [](const PlanePlan& p) { return !p.is_exact; });
    decide_running(Skip::decided_points, has_looks, "points that no open verdict needs");
  }

  void decide_running(Skip skip, bool is_needed, const char* what) {
    if (!allows(skip)) return;
    if (is_needed) return set(skip, SkipState::while_calculating, what);
    set(skip, SkipState::not_needed,
        skip == Skip::decided_points ? "nothing is sampled" : kNoIndirect);
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

  static constexpr const char* kNoIndirect = "no reflected light is sampled";

  const PreparedScene& scene_;
  const std::vector<PlaneTask>& tasks_;
  const RadiositySettings& settings_;
  SurfaceSummary surfaces_;
  std::vector<Beam> beams_;
  std::vector<std::vector<glm::dvec3>> position_m_;
  std::vector<PointSet> points_;
  std::vector<PointBounds> bounds_;
  bool has_indirect_ = true;
  ScenePlan plan_;
};

}  // namespace

std::string_view skip_state_name(SkipState state) {
  switch (state) {
    case SkipState::applies:
      return "applies";
    case SkipState::not_proved:
      return "not proved";
    case SkipState::while_calculating:
      return "while calculating";
    case SkipState::not_needed:
      return "not needed";
    case SkipState::forbidden:
      break;
  }
  return "forbidden";
}

ScenePlan make_scene_plan(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                          const RadiositySettings& settings) {
  return Planner(scene, tasks, settings).run();
}

}  // namespace calc
