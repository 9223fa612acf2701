#pragma once
// Turns results into the document: fields and findings become report contents only here.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "report/document/document.h"
#include "rules/verdict/judge.h"

#include <string>
#include <vector>

namespace report {

// Returns a plane with its field, computed on `grid` (>= 1 point). confidence in (0, 1): of the
// run; all intervals have the level of one sampling round of the plane, see
// rules::look_confidence(). scenes: all scenes of the project that the findings name.
PlanePart build_plane(const calc::CalcPlane& plane, const calc::SensorGrid& grid,
                      const calc::PlaneField& field, std::vector<rules::Finding> findings,
                      double confidence, const std::vector<calc::LightScene>& scenes = {});

// Returns a plane without result; reason in words. findings: all not judged.
PlanePart build_uncomputed_plane(const calc::CalcPlane& plane, calc::Message reason,
                                 std::vector<rules::Finding> findings);

// Returns a space. planes: in the order of space.planes; their space_id is set here.
SpacePart build_space(const calc::Space& space, const calc::PreparedScene& scene,
                      const calc::FluxBalance& balance, std::vector<PlanePart> planes);

// Returns the part of a project that could be read; the caller adds spaces, times and diagnostics.
ProjectPart build_project(const calc::Project& project);

}  // namespace report
