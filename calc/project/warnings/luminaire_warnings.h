#pragma once
// Warns of unlikely luminaires: their places, and their light for their power.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

namespace calc {

// Warns of the luminaire types that are used.
void warn_efficacies(const Project& project, Diagnostics& diagnostics);

// Warns of luminaires wholly or partly outside their room, in solids, twice at one place, tilted
// beyond the range of their file, or with a luminous body that a surface cuts.
void warn_luminaires(const Project& project, const Space& space, Diagnostics& diagnostics);

// Returns the first luminaire lit in the scene (null: all) whose light, or some of it, is missing:
// it is outside its room, wholly or by more than a hundredth of its size, or in a solid, wholly or
// in part, or shines out of the room from its surface. Null: there is none.
const Luminaire* luminaire_of_lost_light(const Project& project, const Space& space,
                                         const LightScene* scene);

}  // namespace calc
