#pragma once
// Reads <luminaire> and the regular arrays of luminaires, in the coordinates around them.

#include "calc/project/reading/project_context.h"
#include "calc/scene/project.h"

#include <vector>

namespace calc {

// Ids are complete: "id", or "id[column,row]" and "id[index]" in arrays. Empty on errors.
std::vector<Luminaire> read_luminaire(ProjectContext& context, ElementReader& reader);
std::vector<Luminaire> read_luminaire_grid(ProjectContext& context, ElementReader& reader);
std::vector<Luminaire> read_luminaire_line(ProjectContext& context, ElementReader& reader);
std::vector<Luminaire> read_luminaire_ring(ProjectContext& context, ElementReader& reader);
// Reads <luminaires id="L" file="x.csv"/>: a luminaire "L.name" for each line.
std::vector<Luminaire> read_luminaire_list(ProjectContext& context, ElementReader& reader);

}  // namespace calc
