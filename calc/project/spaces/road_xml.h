#pragma once
// Reads <road>: a straight road with even rows of luminaires, which is a space of its own.

#include "calc/project/reading/project_context.h"

namespace calc {

// Appends to Project::spaces. ids: of rooms and roads. The carriageway is a plane with the id of
// the road, and with its `was`.
void read_road(ProjectContext& context, ElementReader& reader, IdTable& ids);

}  // namespace calc
