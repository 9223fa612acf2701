#pragma once
// Separates the light of single luminaires, for reports that state what each of them gives.

#include "calc/scene/prepared_scene.h"

namespace calc {

// Gives each luminaire i its own channel i, with the group and maintenance factor that it had. Sums
// over channels mean the same as before; random samples differ, since they are divided among
// channels.
void separate_luminaires(PreparedScene& scene);

}  // namespace calc
