#pragma once
// Warns if a plane's points do not represent the plane.

#include "calc/base/field.h"
#include "calc/radiosity/direct/between_points.h"
#include "calc/scene/project.h"
#include "report/check/plane_jobs.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace check {

// Returns whether the requirement is about light on the plane's points, and is judged.
bool counts(const rules::Requirement& requirement);

// Returns whether a counted requirement is about the plane's points, so that it matters, and the
// plane has cells and illuminances, so that it can be checked.
bool is_asked_of_points(const PlaneJob& job);

// Returns, for each requirement that counts, a few of the points with the least light and with the
// most.
std::vector<std::size_t> telling_points(const PlaneJob& job, const calc::PlaneField& field,
                                        const std::vector<calc::LightScene>& scenes);

// Points that make the plane look better than it is; lx.
struct FlatteringPoints {
  double at_points_lx = 0.0, between_lx = 0.0;  // what luminaires give directly
  double all_lx = 0.0;                          // at the points, of all light
  std::string where;                            // " at (1, 2, 0.8) m in scene 'x'", or ""
};

// Finds a requirement that would not be met if points had the light between them: luminaires give
// more direct light at the points than in their cells (or less, for upper limits). Thresholds:
// averages more than a twentieth; minima, maxima and uniformities more than a fifth, by the cells
// of the darkest and the brightest place; other statistics a tenth of the average. It is also found
// if most cells cannot be checked, because surfaces lie around their points: then nothing is known
// between them. Only points in the requirement's mask count. Empty: no such requirement, or it
// cannot be checked (see light_between_points()). field: of the job's grid.
std::optional<FlatteringPoints> flattering_points(const PlaneJob& job,
                                                  const calc::PlaneField& field,
                                                  const calc::LightBetweenPoints& between,
                                                  const std::vector<calc::LightScene>& scenes);

}  // namespace check
