#pragma once
// Measures requirements that must hold with any single luminaire out.

#include "rules/measure/measure.h"

namespace rules {

// Returns the worst of several measurements, one for each dimming group that is lit in the
// requirement's scene, with that group out. The binder ensures that a group is one luminaire. The
// interval holds for all of them together (Bonferroni). Arguments as in measure(); the requirement
// must name a scene. If one measurement does not exist, neither does the result.
Measurement measure_any_one_out(const Requirement& requirement, const calc::SensorGrid& grid,
                                const calc::PlaneField& field,
                                const std::vector<calc::LightScene>& scenes, double confidence,
                                Goal goal);

}  // namespace rules
