#pragma once
// Luminaires in the layout of shaders/paths/emission.glsl.

#include "calc/radiosity/direct/emission.h"

#include <vector>

namespace gpu {

// One array of double:
//   offset of rays, m
//   cumulative probabilities, luminaires + 1
//   per luminaire, kLuminaireSize: position, three axes, half sizes, calc::OpeningShape, flux of a
//     batch of one path, channel, where its web begins
//   per distinct web: planes, gammas, 1 if lateral; C of the planes, their sums over C (at least
//     two); gammas, their sines and cosines; intensities and their sums [plane][gamma]
std::vector<double> path_tables(const calc::Emitter& emitter, double offset_m);

}  // namespace gpu
