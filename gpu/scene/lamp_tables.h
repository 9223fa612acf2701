#pragma once
// Luminaires in the layout of shaders/direct/lamps.glsl.

#include "calc/radiosity/sampling/rays.h"

#include <cstdint>
#include <vector>

namespace gpu {

inline constexpr std::uint32_t kLampsAt = 3, kLampSize = 30;

// One array of double:
//   offset of rays, margin and clearance of proofs of sight (calc::SightQuery), m
//   per luminaire, kLampSize: position, three axes, half sizes, calc::OpeningShape, channel, where
//     its web begins, flux scale, largest intensity, error share of its sketch, 1 if its reach
//     ends, the direction of that and its distance, where its sketch begins, steps of C and of
//     gamma, the first and the last of these with light
//   per distinct web: planes, gammas, 1 if lateral, intensity at nadir and zenith; C of the planes;
//     gammas; intensities [plane][gamma]
// and one of float: the sketches, one after the other.
struct LampTables {
  std::vector<double> entries;
  std::vector<float> sketches;
};
LampTables lamp_tables(const calc::Tracer& tracer);

}  // namespace gpu
