#pragma once
// A requirement that must hold with any one luminaire out.

#include "rules/measure/measure.h"

namespace rules {

// The worst of as many measurements as there are dimming groups that the requirement's scene
// lights, each with one of them out. The binder sees to it that a group is one luminaire. The
// interval holds for all of them together (Bonferroni). Arguments as of measure(); the requirement
// must name a scene. A measurement that does not exist makes the whole not exist.
Measurement measure_any_one_out(const Requirement& requirement, const calc::SensorGrid& grid,
                                const calc::PlaneField& field,
                                const std::vector<calc::LightScene>& scenes, double confidence,
                                Goal goal);

}  // namespace rules
