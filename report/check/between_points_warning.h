#pragma once
// A warning where a plane's points do not stand for the plane.

#include "calc/base/field.h"
#include "calc/radiosity/direct/between_points.h"
#include "calc/scene/project.h"
#include "report/check/plane_jobs.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace check {

// Of the light on the plane's points, and judged.
bool counts(const rules::Requirement& requirement);

// Whether anything that counts is asked of the plane's points, so that it matters, and the plane
// has cells and illuminances, so that it can be told.
bool is_asked_of_points(const PlaneJob& job);

// Of each requirement that counts a few of the points with the least light, and with the most.
std::vector<std::size_t> telling_points(const PlaneJob& job, const calc::PlaneField& field,
                                        const std::vector<calc::LightScene>& scenes);

// What flatters the plane; lx.
struct FlatteringPoints {
  double at_points_lx = 0.0, between_lx = 0.0;  // what luminaires give directly
  double all_lx = 0.0;                          // at the points, of all light
  std::string where;                            // " at (1, 2, 0.8) m in scene 'x'", or ""
};

// Where a requirement would not be met if points had what their cells have between them: luminaires
// give more directly at the points than between them (or less, where light is limited). Of averages
// by more than a twentieth; of the darkest and the brightest place, whose cells are looked at one
// by one, by more than a fifth: of minima, maxima and uniformities. Also where most cells cannot be
// looked at, since surfaces lie around their points: then nothing is known between them. Others
// than these statistics by a tenth of the average. Of the points that the requirement's mask
// leaves. Empty: nothing flatters it, or it cannot be told (see light_between_points()). field: of
// the job's grid.
std::optional<FlatteringPoints> flattering_points(const PlaneJob& job,
                                                  const calc::PlaneField& field,
                                                  const calc::LightBetweenPoints& between,
                                                  const std::vector<calc::LightScene>& scenes);

}  // namespace check
