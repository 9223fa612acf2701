#include "calc/project/spaces/route_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/planes_xml.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

// World coordinates; empty on errors.
std::vector<glm::dvec3> read_line_m(const ProjectContext& context, ElementReader& reader,
                                    const glm::dvec3& origin_m) {
  const std::vector<double> numbers =
      reader.number_groups("points", 3, 2, kRouteCornerLimit,
                           fmt::format("2 to {} corners of 3 numbers (x y z)", kRouteCornerLimit));
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    const glm::dvec3 corner(numbers[i], numbers[i + 1], numbers[i + 2]);
    corners.push_back(corner * context.metres_per_unit + origin_m);
  }
  return corners;
}

void read_spacing(const ProjectContext& context, ElementReader& reader, EscapeRoute& route) {
  route.spacing.along_u_m = route.spacing.along_v_m = kRouteSpacing_m;
  route.is_spacing_given = reader.has("spacing");
  if (!route.is_spacing_given) return;
  const std::vector<double> spacing = reader.number_groups(
      "spacing", 1, 1, 2, "1 or 2 numbers (along and across the route)", kPositive);
  if (spacing.empty()) return;
  route.spacing.along_u_m = spacing.front() * context.metres_per_unit;
  route.spacing.along_v_m = spacing.back() * context.metres_per_unit;
}

}  // namespace

CalcPlane read_route(ProjectContext& context, ElementReader& reader, const glm::dvec3& origin_m) {
  reader.allow(kRouteElement);
  CalcPlane plane = read_named_plane(context, reader);
  EscapeRoute route;
  route.line.corner_m = read_line_m(context, reader, origin_m);
  route.line.width_m = reader.number("width", kPositive) * context.metres_per_unit;
  route.height_m = reader.number_or("height", kNonNegative, 0.0) * context.metres_per_unit;
  read_spacing(context, reader, route);
  if (!reader.ok()) return plane;
  const std::string fault = route_fault(route.line);
  if (!fault.empty()) {
    reader.report(DiagnosticId::route_shape, reader.where("points"), fault);
    return plane;
  }
  plane.area = std::move(route);
  return plane;
}

}  // namespace calc
