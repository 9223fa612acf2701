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

// What luminaires give directly at points and between them differs by more than a tenth of the
// average, in a scene that something is asked of: beams, or the shadows of something, fall on the
// points or beside them. Says so once, of the scene where it is most. Average and direct light are
// those of the cells that `between` has looked at. field: of the job's grid, not empty.
void warn_of_light_between_points(const PlaneJob& job, const calc::PlaneField& field,
                                  const calc::LightBetweenPoints& between,
                                  const std::vector<calc::LightScene>& scenes,
                                  calc::Diagnostics& diagnostics);

}  // namespace check
