#pragma once
// Surfaces that lie exactly in others: windows drawn in a wall, a mat on a table top, a stretch
// ceiling at ceiling height. Which of the two a ray meets would hang on rounding.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <cstddef>
#include <vector>

namespace calc {

// Sheets (bodies that enclose nothing) cover what they lie in: where one lies in a surface of the
// room, its first `shell_bodies` bodies, or of a closed body, that surface gets the sheet's
// material. Nothing is moved. Of two sheets in one place with unlike materials none is the upper
// one: the darker one counts there, and a warning says so; the same of faces of one body
// (doubled_faces.h), however many it has. "In": within a micrometre, or what rounding may do in a
// large model. Left as they are: sheets of more than kMostSheetTriangles (meshes) in other objects.
inline constexpr std::size_t kMostSheetTriangles = 256;
void settle_coincident_surfaces(Space& space, std::size_t shell_bodies,
                                const std::vector<Material>& materials, Diagnostics& diagnostics);

}  // namespace calc
