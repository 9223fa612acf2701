#pragma once
// Housings: luminaires as bodies that shade and absorb the light of others and of the room. A
// luminaire's own light is as its photometry states, which was measured with the housing.

#include "calc/scene/project.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace calc {

// A luminous opening and its place in the luminaire.
struct HousedOpening {
  LuminousOpening opening;
  double backward_share = 0.0;  // backward_share() of its light
  EmitterPlace place;
};

// A housing from a file: surfaces in the luminaire's axes (x = C0, y = C90, z backwards), m, about
// the centre of its opening, or, with several emitters, about its place.
struct HousingMesh {
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  bool is_closed = false;  // is_watertight()
};

// Returns whether the body is part of the luminaire's housing, of all its emitters together.
bool is_housing_of(const Body& body, const Luminaire& luminaire);

// Returns the share of its light that goes backwards, beyond the plane of a flat opening: [0, 1].
double backward_share(const PhotometricWeb& web);
inline constexpr double kNoBackwardLight = 1.0e-6;  // a share up to this counts as none

// Returns the bodies of a luminaire's housing, "<id>.face" and "<id>.housing", at the luminaire:
//
//  - flat opening: the face, a sheet in the opening's plane. A surface that contains it (a ceiling)
//    gets its material, see coincident_surfaces.h. Light starts before it, on either side. With a
//    depth, a closed prism backwards from it, too. Round ones: 32 corners and the disk's area.
//  - opening that is a body: that body, 1 mm (at most a tenth of its smallest half side) within the
//    surface that light leaves, so that it hides none of its own light. Round ones are inscribed.
//  - several emitters, all flat: each has its face, and the first one, with a depth, the box around
//    all openings (housing_box_m).
//  - with a mesh (not null): it replaces prism, body or box. Flat openings keep their faces.
//
// Empty where the type has no housing. The reader checks that the opening has a size, that the
// housing is not smaller, and that none hides light of its own luminaire.
std::vector<Body> housing_bodies(const Project& project, const Luminaire& luminaire,
                                 const HousingMesh* mesh = nullptr);

// A box in the luminaire's axes, m: lower and upper corner of the extent of the openings.
struct HousingBox {
  glm::dvec3 lower_m{0.0}, upper_m{0.0};
};
HousingBox reach_of(const std::vector<HousedOpening>& openings);
// Returns the box of a housing around several openings: over their outline (or of the housing's
// size, with the same middle), from the frontmost opening backwards by the depth.
HousingBox housing_box_m(const std::vector<HousedOpening>& openings, const Housing& housing);

// An opening whose light a part of the housing in front of it would hide.
struct HiddenOpening {
  std::size_t emitter = 0;               // whose light
  std::optional<std::size_t> face = {};  // by the face of this emitter; empty: by box or mesh
  double before_m = 0.0;                 // how far before it, > 0
};
// Returns the worst one; empty if there is none. openings: flat, of several emitters or with a mesh
// (null: a box, if the housing has a depth).
std::optional<HiddenOpening> hidden_opening(const std::vector<HousedOpening>& openings,
                                            const Housing& housing, const HousingMesh* mesh);
// Returns a corner of the mesh that is less far within an opening that is a body than
// housing_bodies() requires; empty if there is none.
std::optional<glm::dvec3> corner_outside(const LuminousOpening& opening, const HousingMesh& mesh);

// Replaces housings of luminaires whose luminous body is cut (opening_fit.h) and counts as flat by
// the face of the flat opening, because a body about its centre would hide the light. Requires that
// all bodies and luminaires of the space are there.
void fit_housings(const Project& project, Space& space);

// Returns the number of triangles of these bodies.
std::size_t housing_triangles(const Project& project, const LuminaireType& type,
                              const HousingMesh* mesh = nullptr);

}  // namespace calc
