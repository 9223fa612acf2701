#pragma once
// What a luminaire gives as a whole, all its emitters together.

#include "calc/scene/project.h"

#include <array>
#include <cstddef>
#include <vector>

namespace calc {

// All for the types that counts_as_luminaire(), after any override of the flux.
double luminaire_flux_lm(const Project& project, const LuminaireType& type);

// Towards a unit direction in the luminaire's frame, from far away.
double luminaire_intensity_cd(const Project& project, const LuminaireType& type,
                              const std::array<double, 3>& direction);

// The highest one. Of several emitters among the directions of their tables.
double luminaire_peak_cd(const Project& project, const LuminaireType& type);

// In all spaces. type: index into Project::luminaire_types.
int luminaires_of_type(const Project& project, std::size_t type);

// One for each emitter, where it is: a luminaire of one is its own emitter. The further ones have
// the luminaire's id and their own behind it.
std::vector<Luminaire> with_all_emitters(const Project& project, std::vector<Luminaire> luminaires);

}  // namespace calc
