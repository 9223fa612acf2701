#pragma once
// Marks of a room in plans, beside its planes: luminaires and furniture seen from above.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "report/document/document.h"

namespace report {

// Fills part.luminaires and part.bodies; scene is the prepared space. A body keeps the outline of
// its faces that look up, or all its edges if there are none (a screen), and the convex hull
// instead of more than kMostBodyLines lines. Surfaces of the room itself are omitted, and bodies
// beyond kMostBodies are only counted (part.bodies_left_out). For a room from a file, which has
// only surfaces, also fills part.surface_lines_m, see surface_lines.h: the longest
// kMostSurfaceLines.
void add_plan_marks(const calc::Project& project, const calc::Space& space,
                    const calc::PreparedScene& scene, SpacePart& part);

inline constexpr std::size_t kMostBodies = 500;
inline constexpr std::size_t kMostBodyLines = 64;
inline constexpr std::size_t kMostSurfaceLines = 2000;

}  // namespace report
