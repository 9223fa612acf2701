#pragma once
// What is hardly meant of luminaires: where they are, and what light they give for their power.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

namespace calc {

// Of the types that are used.
void warn_efficacies(const Project& project, Diagnostics& diagnostics);

// Outside their room or partly so, in solids, at one place twice, tilted beyond what their file
// knows, with a luminous body that a surface cuts.
void warn_luminaires(const Project& project, const Space& space, Diagnostics& diagnostics);

// Of those that are lit in the scene (null: all) the first one that is outside its room, wholly or
// by more than a hundredth of its size, or in a solid, wholly or in part, or that shines out of the
// room from its surface: its light, or some of it, is missing. Null: there is none.
const Luminaire* luminaire_of_lost_light(const Project& project, const Space& space,
                                         const LightScene* scene);

}  // namespace calc
