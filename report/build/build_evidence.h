#pragma once
// Where a plane's light comes from, and how its results grew: what a verdict rests on.

#include "calc/base/field.h"
#include "calc/photometry/web.h"
#include "report/document/document.h"
#include "rules/verdict/judge.h"

#include <vector>

namespace report {

// Maintained light of each dimming group at full output, reflections of its light included, in
// order of the field's channels. derived: what the plane measures; empty for ratings and ratios.
// level: of the intervals. Averages add up to the plane's.
std::vector<GroupShare> build_groups(const calc::PlaneField& field, calc::DerivedQuantity derived,
                                     double level);

// The plane after one look. findings: judged on this field. Ratings and ratios have no average.
PlaneLook build_look(const calc::PlaneField& field, calc::DerivedQuantity derived,
                     const std::vector<rules::Finding>& findings, double confidence);

// Intensities in the half planes C and C + 180 degrees, every kPolarStep_deg of gamma from -180
// (in C + 180) to 180 (in C), in cd.
// All emitters together.
std::vector<double> polar_curve(const calc::Project& project, const calc::LuminaireType& type,
                                double c_rad);

}  // namespace report
