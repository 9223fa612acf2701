#pragma once
// Luminaires as things: bodies that shade and take up the light that others, and the room, send to
// them. A luminaire's own light is as its photometry says, which was measured with the housing.

#include "calc/scene/project.h"

#include <cstddef>
#include <vector>

namespace calc {

bool is_housing_of(const Body& body, const Luminaire& luminaire);

// How much of its light goes backwards, beyond the plane of a flat opening: [0, 1].
double backward_share(const PhotometricWeb& web);

// The bodies of a luminaire's housing, "<id>.face" and "<id>.housing", where the luminaire is:
//
//  - flat opening: the face, a sheet in the opening's plane. What it lies in (a ceiling) gets its
//    material, see coincident_surfaces.h. Light starts before it, on either side. With a depth, a
//    closed prism from there backwards, too. Round ones have 32 corners and the disk's area.
//  - opening that is a body: that body, 1 mm (at most a tenth of its smallest half side) within the
//    surface that light leaves, so that it hides nothing of its own. Round ones are inscribed.
//
// None where the type has no housing. The reader sees to it that the opening has a size, that the
// housing is not smaller, and that none with a depth hides light that goes backwards.
std::vector<Body> housing_bodies(const Project& project, const Luminaire& luminaire);

// Of luminaires whose luminous body is cut (opening_fit.h) and counts as flat, a body about its
// centre would hide the light: these get the face of the flat opening instead. Once all bodies and
// luminaires of the space are there.
void fit_housings(const Project& project, Space& space);

// Of these bodies.
std::size_t housing_triangles(const Project& project, const LuminaireType& type);

}  // namespace calc
