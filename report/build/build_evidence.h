#pragma once
// The sources of a plane's light, and the course of its results: the grounds of a verdict.

#include "calc/base/field.h"
#include "calc/photometry/web.h"
#include "report/document/document.h"
#include "rules/verdict/judge.h"

#include <vector>

namespace report {

// Returns the maintained light of each dimming group at full output, with its reflections, in order
// of the field's channels. derived: quantity of the plane; empty for ratings and ratios. level: of
// the intervals. Averages add up to the plane's.
std::vector<GroupShare> build_groups(const calc::PlaneField& field, calc::DerivedQuantity derived,
                                     double level);

// Returns the plane after one sampling round. findings: judged on this field. Ratings and ratios
// have no average.
PlaneLook build_look(const calc::PlaneField& field, calc::DerivedQuantity derived,
                     const std::vector<rules::Finding>& findings, double confidence);

// Returns intensities in the half planes C and C + 180 degrees, every kPolarStep_deg of gamma from
// -180 (in C + 180) to 180 (in C), in cd. All emitters together.
std::vector<double> polar_curve(const calc::Project& project, const calc::LuminaireType& type,
                                double c_rad);

}  // namespace report
