#pragma once
// Requirement against result: the verdict.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/finding.h"
#include "rules/catalogue/requirement.h"
#include "rules/measure/measure.h"

#include <string>
#include <vector>

namespace rules {

// One finding per requirement, in order. All arguments belong to one plane: `requirements` are its
// own, see requirements_of_plane(); field.points = number of points of the grid. confidence in (0,
// 1): of the run; every interval has the level of one look of the plane, see look_confidence().
std::vector<Finding> judge_plane(const std::vector<Requirement>& requirements,
                                 const calc::SensorGrid& grid, const calc::PlaneField& field,
                                 const std::vector<calc::LightScene>& scenes, double confidence);

// Glare ratings may have ends, or a value, that are infinite: what no observer sees is rated less
// than any number, and for some sources the formula is not stated. Else the upper end alone may be
// open, of what fails an upper limit already by its lower end (despite_doubt.h).
bool has_open_ends(const Requirement& requirement, const calc::Estimate& measured);

// What a value says about its requirement's limit; doubts of sampling are not in it. measured: in
// unit_of(requirement), finite or as has_open_ends() has it.
Decision decide(const Requirement& requirement, const calc::Estimate& measured);

// margin() of what was judged so; not a number where there is none. What fails has none that reads
// as good: where a limit that is left out is met exactly, or a policy rounds.
double margin_of(const Requirement& requirement, const calc::Estimate& measured, Verdict verdict);

// What a measurement says about its requirement, and about how much more work would decide it.
Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid, const calc::PlaneField& field);

// The same without that.
Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid);

// For a plane that could not be computed: every requirement is not judged, for this reason.
std::vector<Finding> not_judged_plane(const std::vector<Requirement>& requirements,
                                      const calc::Message& reason);

}  // namespace rules
