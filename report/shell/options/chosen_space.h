#pragma once
// The option --space ID.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <string>

namespace cli {

// Returns the space of that id, or the only space if the id is ""; null after an error.
const calc::Space* find_chosen_space(const calc::Project& project, const std::string& id,
                                     calc::Diagnostics& diagnostics);

}  // namespace cli
