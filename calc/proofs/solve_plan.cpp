#include "calc/proofs/solve_plan.h"

#include "calc/proofs/convex_space.h"
#include "calc/proofs/point_set.h"
#include "calc/proofs/predicates.h"

#include <algorithm>

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

}  // namespace

std::size_t PlaneDecision::gathering_points() const {
  return static_cast<std::size_t>(
      std::count(gathers_reflection.begin(), gathers_reflection.end(), 1));
}

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

}  // namespace calc
