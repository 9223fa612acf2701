#pragma once
// Compares results with requirements: the verdicts.

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

// Returns one finding per requirement, in order. All arguments belong to one plane: `requirements`
// are those of requirements_of_plane(); field.points = number of points of the grid. confidence in
// (0, 1): of the run; every interval has the level of one sampling round, see look_confidence().
std::vector<Finding> judge_plane(const std::vector<Requirement>& requirements,
                                 const calc::SensorGrid& grid, const calc::PlaneField& field,
                                 const std::vector<calc::LightScene>& scenes, double confidence);

// Returns whether `measured` may have infinite ends. Glare ratings may, and their value too:
// without a visible source it is below any number, and some sources are outside the formula.
// Otherwise only the upper end may be open, if the lower end already fails an upper limit
// (despite_doubt.h).
bool has_open_ends(const Requirement& requirement, const calc::Estimate& measured);

// Decides the requirement by the value alone, without doubts about the sampling. measured: in
// unit_of(requirement), finite or as in has_open_ends().
Decision decide(const Requirement& requirement, const calc::Estimate& measured);

// Returns margin() for this verdict; NaN where there is none. A failure has no margin that reads as
// good: for a strict limit that is met exactly, or a policy that rounds.
double margin_of(const Requirement& requirement, const calc::Estimate& measured, Verdict verdict);

// Returns the finding for a measurement, with an estimate of the work that would decide it.
Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid, const calc::PlaneField& field);

// Returns the finding without that estimate.
Finding judge_measurement(const Requirement& requirement, const Measurement& measurement,
                          const calc::SensorGrid& grid);

// Returns the findings of a plane that could not be computed: not judged, for this reason.
std::vector<Finding> not_judged_plane(const std::vector<Requirement>& requirements,
                                      const calc::Message& reason);

}  // namespace rules
