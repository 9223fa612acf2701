#pragma once
// Finds the parts of open meshes that may have an inside all the same.

#include "calc/scene/project.h"

#include <cstddef>

namespace calc {

// Fills Space::open_shells from its bodies from `first` on: connected parts of bodies that are not
// closed, without flat things and housings of luminaires.
void find_open_shells(Space& space, std::size_t first);

}  // namespace calc
