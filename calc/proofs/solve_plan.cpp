#include "calc/proofs/solve_plan.h"

#include "calc/proofs/convex_space.h"
#include "calc/proofs/point_set.h"
#include "calc/proofs/predicates.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace calc {
namespace {

bool is_left_out(const std::vector<std::uint8_t>& left_out, std::size_t luminaire) {
  return !left_out.empty() && left_out[luminaire] != 0;
}

bool has_light_paths(const PreparedScene& scene, const std::vector<std::uint8_t>& is_unlit) {
  for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = scene.luminaires[l];
    if (!is_left_out(is_unlit, l) && luminaire.web->flux_lm() * luminaire.flux_scale > 0.0) {
      return true;
    }
  }
  return false;
}

bool has_extended_opening(const PreparedScene& scene, const std::vector<std::uint8_t>& is_dark) {
  for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
    if (!is_left_out(is_dark, l) && scene.luminaires[l].opening.shape != OpeningShape::point) {
      return true;
    }
  }
  return false;
}

PlaneDecision decide_plane(const PreparedScene& scene, const SensorGrid& grid,
                           const std::vector<Beam>& beams, const ConvexAnswer& convex,
                           bool samples_indirect, const SkipSet& allowed) {
  const std::vector<glm::dvec3> local_m = local_positions_m(scene, grid);
  const PointSet points{local_m, grid.normal, grid.kernel};
  PlaneDecision plane;
  plane.points = local_m.size();
  plane.receivers = plane.points * receivers_per_point(grid.derived);
  plane.measures_direct = grid.derived != DerivedQuantity::ugr;
  plane.may_see_reflection = find_reflection_view(scene, points).sees_reflection;
  plane.gathers_reflection = allowed.allows(Skip::behind_plane)
                                 ? plane.may_see_reflection
                                 : std::vector<std::uint8_t>(plane.points, 1);
  plane.samples_reflection = samples_indirect && plane.gathering_points() > 0;
  if (plane.points == 0) return plane;
  const PointBounds bounds = bounds_of(points);
  if (allowed.allows(Skip::dark_pairs)) plane.is_dark = find_dark_luminaires(scene, beams, bounds);
  plane.samples_openings = plane.measures_direct && has_extended_opening(scene, plane.is_dark);
  if (convex.space) {
    // Of several receivers of a point some are lifted across its axis, as half-cylinders are.
    const ReceiverKernel kernel =
        receivers_per_point(grid.derived) > 1 ? ReceiverKernel::semicylindrical : grid.kernel;
    const PointSet lifted{local_m, grid.normal, kernel};
    plane.is_unobstructed = convex.space->holds(lifted, bounds_of(lifted));
  }
  return plane;
}

std::size_t count_ones(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

std::string of_all(std::size_t part, std::size_t all, std::string_view things) {
  return part == all ? fmt::format("all {} {}", all, things)
                     : fmt::format("{} of {} {}", part, all, things);
}

class Explainer {
 public:
  Explainer(const SolvePlan& plan, const PreparedScene& scene, std::span<const PlaneTask> tasks,
            const SkipSet& allowed, bool has_light_pool)
      : plan_(plan),
        scene_(scene),
        tasks_(tasks),
        allowed_(allowed),
        has_light_pool_(has_light_pool) {}

  SkipDecision explain(Skip skip) const {
    SkipDecision said{skip, SkipState::not_proved, "", {}, 0, std::nullopt};
    if (!allowed_.allows(skip)) {
      said.state = SkipState::forbidden;
      said.why = "forbidden by --no-skip " + std::string(name_of(skip));
      return said;
    }
    switch (skip) {
      case Skip::no_reflection:
        say_no_reflection(said);
        break;
      case Skip::behind_plane:
        say_behind_plane(said);
        break;
      case Skip::unlit_surfaces:
        say_unlit_surfaces(said);
        break;
      case Skip::dark_pairs:
        say_dark_pairs(said);
        break;
      case Skip::convex:
        say_convex(said);
        break;
      // Sought by the calculation itself, at each point or look.
      case Skip::hidden_nodes:
        say_running(said, samples_reflection() && has_light_pool_ ? nullptr : kNoIndirect,
                    "groups of light vertices behind a point or facing away");
        break;
      case Skip::clear_distance:
        say_running(said, samples_reflection() ? nullptr : kNoIndirect,
                    "points with no surface near them");
        break;
      case Skip::decided_points:
        say_running(said, samples() ? nullptr : "nothing is sampled",
                    "points that no open verdict needs");
        break;
    }
    return said;
  }

 private:
  static constexpr const char* kNoIndirect = "no reflected light is sampled";

  static void set(SkipDecision& said, SkipState state, std::string why) {
    said.state = state;
    said.why = std::move(why);
  }

  // why_not: null where there may be something to leave out.
  static void say_running(SkipDecision& said, const char* why_not, const char* what) {
    if (why_not != nullptr) return set(said, SkipState::not_needed, why_not);
    set(said, SkipState::while_calculating, what);
  }

  bool samples_reflection() const {
    return std::any_of(plan_.planes.begin(), plan_.planes.end(),
                       [](const PlaneDecision& plane) { return plane.samples_reflection; });
  }
  bool samples() const {
    return std::any_of(plan_.planes.begin(), plan_.planes.end(),
                       [](const PlaneDecision& plane) { return !plane.is_exact(); });
  }

  void say_no_reflection(SkipDecision& said) const {
    if (!plan_.has_reflection) {
      return set(said, SkipState::applies,
                 scene_.triangle.empty() ? "there is no surface" : "every surface is black");
    }
    const auto reflecting =
        static_cast<std::size_t>(std::count_if(scene_.reflectance.begin(), scene_.reflectance.end(),
                                               [](double rho) { return rho > 0.0; }));
    set(said, SkipState::not_proved,
        of_all(reflecting, scene_.triangle.size(), "triangles") + " reflect");
  }

  // Whether there would be light paths if no luminaire were left out for lighting no surface.
  bool may_reflect() const {
    return !scene_.luminaires.empty() &&
           (plan_.has_reflection || !allowed_.allows(Skip::no_reflection));
  }

  void say_unlit_surfaces(SkipDecision& said) const {
    if (!may_reflect()) return set(said, SkipState::not_needed, kNoIndirect);
    said.luminaires = count_ones(plan_.is_unlit);
    if (said.luminaires == 0) {
      return set(said, SkipState::not_proved, "every luminaire may light a reflecting surface");
    }
    set(said, SkipState::applies,
        of_all(said.luminaires, scene_.luminaires.size(), "luminaires") +
            " cannot light any reflecting surface");
  }

  void say_behind_plane(SkipDecision& said) const {
    if (!plan_.samples_indirect) return set(said, SkipState::not_needed, kNoIndirect);
    std::size_t hidden = 0, all = 0;
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      const PlaneDecision& decided = plan_.planes[p];
      all += decided.points;
      hidden += decided.points - decided.gathering_points();
      if (!decided.samples_reflection) said.planes.push_back(tasks_[p].plane_id);
    }
    if (hidden == 0) {
      return set(said, SkipState::not_proved, "reflecting surfaces reach in front of every point");
    }
    set(said, SkipState::applies,
        "every reflecting surface lies behind " + of_all(hidden, all, "points"));
  }

  void say_dark_pairs(SkipDecision& said) const {
    const std::size_t luminaires = scene_.luminaires.size();
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      const std::size_t dark_here = plan_.planes[p].dark_luminaires();
      said.luminaires += dark_here;
      if (dark_here == luminaires && luminaires > 0) said.planes.push_back(tasks_[p].plane_id);
    }
    if (said.luminaires == 0) {
      return set(said, SkipState::not_proved, "every luminaire may light a point of every plane");
    }
    set(said, SkipState::applies,
        of_all(said.luminaires, luminaires * tasks_.size(), "pairs of luminaire and plane") +
            " are dark: the beam misses the plane or comes from behind");
  }

  void say_convex(SkipDecision& said) const {
    if (!plan_.is_convex) {
      said.body = plan_.obstacle_body;
      return set(said, SkipState::not_proved, plan_.why_not_convex);
    }
    for (std::size_t p = 0; p < tasks_.size(); ++p) {
      if (plan_.planes[p].is_unobstructed) said.planes.push_back(tasks_[p].plane_id);
    }
    if (said.planes.empty()) {
      return set(said, SkipState::not_proved,
                 "points, or where their rays begin, lie outside the surfaces' walls");
    }
    set(said, SkipState::applies, "nothing stands between two points of the space");
  }

  const SolvePlan& plan_;
  const PreparedScene& scene_;
  std::span<const PlaneTask> tasks_;
  const SkipSet& allowed_;
  bool has_light_pool_;
};

}  // namespace

std::size_t PlaneDecision::gathering_points() const { return count_ones(gathers_reflection); }

std::size_t PlaneDecision::dark_luminaires() const { return count_ones(is_dark); }

std::vector<std::uint8_t> unlit_luminaires(const PreparedScene& scene,
                                           const std::vector<Beam>& beams, const SkipSet& allowed) {
  if (!allowed.allows(Skip::unlit_surfaces)) return {};
  return find_unlit_surfaces(scene, beams);
}

SolvePlan decide(const PreparedScene& scene, std::span<const PlaneTask> tasks,
                 const SkipSet& allowed) {
  const std::vector<Beam> beams = beams_of(scene);
  SolvePlan plan;
  plan.has_reflection = !no_reflection(scene);
  plan.is_unlit = unlit_luminaires(scene, beams, allowed);
  plan.samples_indirect = (plan.has_reflection || !allowed.allows(Skip::no_reflection)) &&
                          has_light_paths(scene, plan.is_unlit);
  // Per plane, so that a plane outside the walls changes nothing for the others.
  ConvexAnswer convex;
  if (allowed.allows(Skip::convex)) convex = find_convex_space(scene);
  plan.is_convex = convex.space.has_value();
  plan.why_not_convex = convex.why_not;
  plan.obstacle_body = convex.obstacle_body;
  plan.planes.reserve(tasks.size());
  for (const PlaneTask& task : tasks) {
    plan.planes.push_back(
        decide_plane(scene, *task.grid, beams, convex, plan.samples_indirect, allowed));
  }
  return plan;
}

std::vector<SkipDecision> explain_skips(const SolvePlan& plan, const PreparedScene& scene,
                                        std::span<const PlaneTask> tasks, const SkipSet& allowed,
                                        bool has_light_pool) {
  const Explainer explainer(plan, scene, tasks, allowed, has_light_pool);
  std::vector<SkipDecision> said;
  for (const auto& [skip, name] : EnumNames<Skip>::list) said.push_back(explainer.explain(skip));
  return said;
}

}  // namespace calc
