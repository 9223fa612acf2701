#pragma once
// Colour rendering of a space's luminaires: no calculation has it, their makers state it.

#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/requirement.h"

#include <string>

namespace rules {

// Of Metric::colour_rendering: the least Ra that the photometry of the luminaires states which are
// on, or why nobody can say whether the limit is met: one of them states none or a range with the
// limit in it. scene: null, and all are on.
void set_colour_rendering(const calc::Project& project, const calc::Space& space,
                          const calc::LightScene* scene, Requirement& requirement);

// Why it does not decide such a limit in a light scene by name, see RenderingProblem; "" = it does.
calc::Message rendering_problem(const calc::Project& project, const calc::Space& space,
                                const std::string& scene, Comparison comparison, double limit);

}  // namespace rules
