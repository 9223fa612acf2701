#include "calc/project/warnings/plane_warnings.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/warnings/surface_overlap.h"
#include "calc/project/warnings/warning_words.h"
#include "calc/scene/plane_place.h"

#include <variant>
#include <vector>

namespace calc {
namespace {

void warn_planes_in_surfaces(const Space& space, const std::set<std::string>& on_purpose,
                             Diagnostics& diagnostics) {
  for (const CalcPlane& plane : space.planes) {
    const auto* area = std::get_if<PlanarArea>(&plane.area);
    if (area == nullptr || on_purpose.contains(plane.id)) continue;
    const SurfaceOverlap overlap(*area);
    for (const Body& body : space.bodies) {
      if (!overlap.with(body)) continue;
      diagnostics.report(DiagnosticId::plane_in_surface, plane.where, plane.id, body.id);
      break;
    }
  }
}

void warn_planes_facing_away(const Project& project, const Space& space,
                             const std::set<std::string>& on_purpose, Diagnostics& diagnostics) {
  if (space.luminaires.empty()) return;
  std::vector<const CalcPlane*> away;
  for (const CalcPlane& plane : space.planes) {
    const bool is_planar =
        plane.kernel == ReceiverKernel::planar && plane.derived == DerivedQuantity::none;
    if (!is_planar || on_purpose.contains(plane.id)) continue;
    if (faces_away(project, space, plane)) away.push_back(&plane);
  }
  warn_of_first_few<const CalcPlane*>(
      away, "planes of this space", [&](const CalcPlane* plane, const std::string& more) {
        diagnostics.report(DiagnosticId::plane_faces_away, plane->where, plane->id, more);
      });
}

}  // namespace

void warn_planes(const Project& project, const Space& space,
                 const std::set<std::string>& on_purpose, Diagnostics& diagnostics) {
  warn_planes_in_surfaces(space, on_purpose, diagnostics);
  warn_planes_facing_away(project, space, on_purpose, diagnostics);
}

}  // namespace calc
