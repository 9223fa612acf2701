#pragma once
// Reads L3D models of luminaires (.l3d): the places of their light emitting objects.

#include "calc/photometry/luminaire_light.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns the places by the name of the emitting object. bytes: the archive, of which structure.xml
// is read: positions in metres, rotations in degrees about the local axes in the order Z, X, Y
// (README of the format), joints as preset. Empty, with a reason in words in `problem`, if the
// archive holds something else or a name appears twice.
std::optional<std::map<std::string, EmitterPlace>> read_l3d_places(std::string_view bytes,
                                                                   std::string& problem);

}  // namespace calc
