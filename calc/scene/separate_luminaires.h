#pragma once
// Light of single luminaires kept apart, for reports that say what each of them gives.

#include "calc/scene/prepared_scene.h"

namespace calc {

// Afterwards channel i is that of luminaire i alone, with the group and maintenance factor that it
// had. Sums over channels mean the same as before; random samples are others, since they are shared
// out among channels.
void separate_luminaires(PreparedScene& scene);

}  // namespace calc
