#pragma once
// A warning where a plane's points do not stand for the plane.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/radiosity/between_points.h"
#include "calc/scene/project.h"
#include "report/check/plane_jobs.h"

#include <vector>

namespace check {

// Whether anything that counts is asked of the plane's points, so that it matters.
bool is_asked_of_points(const PlaneJob& job);

// What luminaires give directly at points is better than what they give between them by more than a
// tenth of the average, in a scene that something is asked of: beams fall on the points, where more
// light is asked for, or shadows, where less is. Says so once, of the scene where it is most.
// Points that make a plane worse than it is are the safe side. Average and direct light are those
// of the cells that `between` has looked at. field: of the job's grid, not empty.
void warn_of_light_between_points(const PlaneJob& job, const calc::PlaneField& field,
                                  const calc::LightBetweenPoints& between,
                                  const std::vector<calc::LightScene>& scenes,
                                  calc::Diagnostics& diagnostics);

}  // namespace check
