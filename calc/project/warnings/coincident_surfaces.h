#pragma once
// Settles surfaces that lie exactly in others: windows drawn in a wall, a mat on a table top, a
// stretch ceiling at ceiling height. Otherwise rounding would decide which of the two a ray meets.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <vector>

namespace calc {

// Gives a surface the material of a sheet (a body that encloses nothing) in it: a surface of the
// room, its first `shell_bodies` bodies, or of a closed body. Nothing is moved. Of two coincident
// sheets with unlike materials neither is on top: the darker one counts, with a warning; the same
// for faces of one body (doubled_faces.h), however many it has. "In": within a micrometre, or the
// rounding of a large model. Sheets of more than kMostSheetTriangles (meshes) in other objects are
// not changed.
inline constexpr std::size_t kMostSheetTriangles = 256;
void settle_coincident_surfaces(Space& space, std::size_t shell_bodies,
                                const std::vector<Material>& materials, Diagnostics& diagnostics);

}  // namespace calc
