#pragma once
// L3D models of luminaires (.l3d): where their light emitting objects are.

#include "calc/photometry/luminaire_light.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

// bytes: the archive, of which structure.xml is read: positions in metres, rotations in degrees
// about the local axes in the order Z, X, Y (README of the format), joints as they are preset. By
// the name of the emitting object. Empty, with a reason in words in `problem`, if that is not what
// the archive holds or a name is there twice.
std::optional<std::map<std::string, EmitterPlace>> read_l3d_places(std::string_view bytes,
                                                                   std::string& problem);

}  // namespace calc
