#pragma once
// What a space's luminaires cost.

#include "calc/scene/project.h"

namespace calc {

// In the project's own currency.
struct InstalledPrice {
  double price = 0.0;     // of the luminaires that state it
  int luminaires = 0;     // all
  int without_price = 0;  // of them: the project states no price
};

// project.luminaire_types must hold the types of the space's luminaires.
InstalledPrice installed_price(const Project& project, const Space& space);

}  // namespace calc
