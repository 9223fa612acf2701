#pragma once
// Colour rendering of a space's luminaires: it is not calculated, manufacturers state it.

#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/requirement.h"

#include <string>

namespace rules {

// Sets the value of Metric::colour_rendering: the least Ra that the photometry of the luminaires in
// use states. Otherwise sets the problem: a luminaire states none, or a range that contains the
// limit. scene: null = all luminaires are on.
void set_colour_rendering(const calc::Project& project, const calc::Space& space,
                          const calc::LightScene* scene, Requirement& requirement);

// Returns why the limit cannot be decided in this light scene, see RenderingProblem; "" = it can.
calc::Message rendering_problem(const calc::Project& project, const calc::Space& space,
                                const std::string& scene, Comparison comparison, double limit);

}  // namespace rules
