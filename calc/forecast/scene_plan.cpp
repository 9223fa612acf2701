#include "calc/forecast/scene_plan.h"

#include "calc/proofs/point_set.h"
#include "calc/proofs/solve_plan.h"
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
      if (luminaire.opening.shape == OpeningShape::point) continue;
      if (!dark.empty() && dark[l] != 0) continue;
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
        solve_(decide(scene, tasks, settings.skips)) {
    plan_.luminaires = scene.luminaires.size();
    plan_.threads = thread_count(settings);
    for (std::size_t s = 0; s < kSkips; ++s) {
      const Skip skip = static_cast<Skip>(s);
      plan_.skips.push_back({skip, SkipState::not_proved, "", {}, 0, std::nullopt});
      if (settings.skips.allows(skip)) continue;
      decision(skip).state = SkipState::forbidden;
      decision(skip).why = "forbidden by --no-skip " + std::string(name_of(skip));
    }
  }

  ScenePlan run() {
    for (std::size_t p = 0; p < tasks_.size(); ++p) add_plane(p);
    say_no_reflection();
    say_unlit_surfaces();
    say_behind_plane();
    say_dark_pairs();
    say_convex();
    say_running();
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

  void add_plane(std::size_t p) {
    const PlaneDecision& decided = solve_.planes[p];
    PlanePlan plane;
    plane.plane_id = tasks_[p].plane_id;
    plane.points = decided.points;
    plane.luminaires = scene_.luminaires.size() - count_ones(decided.is_dark);
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
      load.near_points =
          static_cast<double>(load.seeing_points) *
          (allows(Skip::clear_distance) ? near_share(scene_, points, near_reach_m(surfaces_))
                                        : 1.0);
    }
    std::size_t exact_openings = 0;
    for (std::size_t l = 0; l < scene_.luminaires.size(); ++l) {
      if (!decided.is_dark.empty() && decided.is_dark[l] != 0) continue;
      // Eyes look at every opening once, whatever its shape.
      if (!decided.measures_direct || scene_.luminaires[l].opening.shape == OpeningShape::point) {
        ++exact_openings;
      }
    }
    const auto receivers = static_cast<double>(decided.receivers);
    load.exact_direct_rays = receivers * static_cast<double>(exact_openings);
    if (decided.samples_openings) {
      load.sampled_direct_rays = receivers * settings_.replicates *
                                 opening_samples_per_point(scene_, points, decided.is_dark);
    }
    plan_.workload.planes.push_back(load);
  }

  void say_no_reflection() {
    if (!allows(Skip::no_reflection)) return;
    const auto reflecting =
        static_cast<std::size_t>(std::count_if(scene_.reflectance.begin(), scene_.reflectance.end(),
                                               [](double rho) { return rho > 0.0; }));
    if (!solve_.has_reflection) {
      set(Skip::no_reflection, SkipState::applies,
          scene_.triangle.empty() ? "there is no surface" : "every surface is black");
    } else {
      set(Skip::no_reflection, SkipState::not_proved,
          of_all(reflecting, scene_.triangle.size(), "triangles") + " reflect");
    }
  }

  // Whether there would be light paths if no luminaire were left out for lighting no surface.
  bool may_reflect() const {
    return !scene_.luminaires.empty() && (solve_.has_reflection || !allows(Skip::no_reflection));
  }

  void say_unlit_surfaces() {
    if (!allows(Skip::unlit_surfaces)) return;
    if (!may_reflect()) return set(Skip::unlit_surfaces, SkipState::not_needed, kNoIndirect);
    const std::size_t unlit = count_ones(solve_.is_unlit);
    decision(Skip::unlit_surfaces).luminaires = unlit;
    if (unlit == 0) {
      return set(Skip::unlit_surfaces, SkipState::not_proved,
                 "every luminaire may light a reflecting surface");
    }
    set(Skip::unlit_surfaces, SkipState::applies,
        of_all(unlit, scene_.luminaires.size(), "luminaires") +
            " cannot light any reflecting surface");
  }

  void say_behind_plane() {
    if (!allows(Skip::behind_plane)) return;
    if (!solve_.samples_indirect) {
      return set(Skip::behind_plane, SkipState::not_needed, kNoIndirect);
    }
    std::size_t hidden = 0, all = 0;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      const PlaneDecision& decided = solve_.planes[p];
      all += decided.points;
      hidden += decided.points - decided.gathering_points();
      if (!decided.samples_reflection) {
        decision(Skip::behind_plane).planes.push_back(tasks_[p].plane_id);
      }
    }
    if (hidden == 0) {
      return set(Skip::behind_plane, SkipState::not_proved,
                 "reflecting surfaces reach in front of every point");
    }
    set(Skip::behind_plane, SkipState::applies,
        "every reflecting surface lies behind " + of_all(hidden, all, "points"));
  }

  void say_dark_pairs() {
    if (!allows(Skip::dark_pairs)) return;
    const std::size_t luminaires = scene_.luminaires.size();
    std::size_t dark_pairs = 0;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      const std::size_t dark_here = count_ones(solve_.planes[p].is_dark);
      dark_pairs += dark_here;
      if (dark_here == luminaires && luminaires > 0) {
        decision(Skip::dark_pairs).planes.push_back(tasks_[p].plane_id);
      }
    }
    decision(Skip::dark_pairs).luminaires = dark_pairs;
    if (dark_pairs == 0) {
      return set(Skip::dark_pairs, SkipState::not_proved,
                 "every luminaire may light a point of every plane");
    }
    set(Skip::dark_pairs, SkipState::applies,
        of_all(dark_pairs, luminaires * tasks_.size(), "pairs of luminaire and plane") +
            " are dark: the beam misses the plane or comes from behind");
  }

  void say_convex() {
    if (!allows(Skip::convex)) return;
    if (!solve_.is_convex) {
      decision(Skip::convex).body = solve_.obstacle_body;
      return set(Skip::convex, SkipState::not_proved, solve_.why_not_convex);
    }
    std::vector<std::string>& proved = decision(Skip::convex).planes;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      if (solve_.planes[p].is_unobstructed) proved.push_back(tasks_[p].plane_id);
    }
    if (proved.empty()) {
      return set(Skip::convex, SkipState::not_proved,
                 "points, or where their rays begin, lie outside the surfaces' walls");
    }
    set(Skip::convex, SkipState::applies, "nothing stands between two points of the space");
  }

  // Sought by the calculation itself, at each point or look.
  void say_running() {
    const bool is_sampled = std::any_of(plan_.planes.begin(), plan_.planes.end(),
                                        [](const PlanePlan& p) { return p.seeing_points > 0; });
    const bool has_pool = is_sampled && settings_.method == Method::light_pool;
    say_running(Skip::hidden_nodes, has_pool,
                "groups of light vertices behind a point or facing away");
    say_running(Skip::clear_distance, is_sampled, "points with no surface near them");
    const bool has_looks = std::any_of(plan_.planes.begin(), plan_.planes.end(),
                                       [](const PlanePlan& p) { return !p.is_exact; });
    say_running(Skip::decided_points, has_looks, "points that no open verdict needs");
  }

  void say_running(Skip skip, bool is_needed, const char* what) {
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
  SolvePlan solve_;
  ScenePlan plan_;
};

}  // namespace

ScenePlan make_scene_plan(const PreparedScene& scene, const std::vector<PlaneTask>& tasks,
                          const RadiositySettings& settings) {
  return Planner(scene, tasks, settings).run();
}

}  // namespace calc
