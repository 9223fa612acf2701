#pragma once
// Light of a whole luminaire, all its emitters together.

#include "calc/scene/project.h"

#include <array>
#include <cstddef>
#include <vector>

namespace calc {

// These require types with counts_as_luminaire() and include any override of the flux.
double luminaire_flux_lm(const Project& project, const LuminaireType& type);

// Returns the intensity towards a unit direction in the luminaire's frame, from far away.
double luminaire_intensity_cd(const Project& project, const LuminaireType& type,
                              const std::array<double, 3>& direction);

// Returns the highest intensity; with several emitters, among the directions of their tables.
double luminaire_peak_cd(const Project& project, const LuminaireType& type);

// Returns the number in all spaces. type: index into Project::luminaire_types.
int luminaires_of_type(const Project& project, std::size_t type);

// Returns a luminaire for each emitter at its place; a luminaire with a single emitter stays as it
// is. The further ones have the luminaire's id followed by their own.
std::vector<Luminaire> with_all_emitters(const Project& project, std::vector<Luminaire> luminaires);

}  // namespace calc
