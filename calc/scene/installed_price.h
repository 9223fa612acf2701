#pragma once
// The cost of a space's luminaires.

#include "calc/scene/project.h"

namespace calc {

// A price in the project's own currency.
struct InstalledPrice {
  double price = 0.0;     // of the luminaires that state it
  int luminaires = 0;     // all
  int without_price = 0;  // of them: the project states no price
};

// Requires the types of the space's luminaires in project.luminaire_types.
InstalledPrice installed_price(const Project& project, const Space& space);

}  // namespace calc
