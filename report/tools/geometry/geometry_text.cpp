#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/tools/geometry/geometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

constexpr std::size_t kMostParts = 20;

std::string parts_text(const char* heading, const std::vector<calc::SurfacePart>& parts) {
  std::string text = fmt::format("    {:<34} {:>10} {:>12}\n", heading, "triangles", "area / m2");
  std::size_t shown = 0, used = 0;
  for (const calc::SurfacePart& part : parts) {
    if (part.triangles == 0) continue;
    if (++used > kMostParts) continue;
    ++shown;
    const std::string name = part.name.empty() ? "(no name)" : report::printable(part.name);
    const std::size_t width = report::display_width(name);
    text += fmt::format("      {}{} {:>10} {:>12}\n", name,
                        std::string(width < 32 ? 32 - width : 0, ' '), part.triangles,
                        report::format_fixed(part.area_m2, 3));
  }
  if (used > shown) text += fmt::format("      ... and {} more (--json has all)\n", used - shown);
  return text;
}

std::string percent(double share) { return report::format_fixed(100.0 * share, 2); }

std::string light_text(const SurfaceReport& surface) {
  const Escape& escape = surface.escape;
  if (escape.points == 0) return "no interior: most directions lead outside from every point";
  return fmt::format(
      "{} % of the light from inside leaves (95 %: {} to {} %); inside: {} % of the box",
      percent(escape.share.value), percent(escape.share.low), percent(escape.share.high),
      report::format_fixed(100.0 * escape.inside_share, 0));
}

// The largest by volume, and how many there are.
std::string shells_text(const calc::SurfaceFindings& found) {
  const auto f = [](double number) { return report::format_fixed(number, 3); };
  std::string text;
  if (found.open.count > 0) {
    text +=
        fmt::format("    open       {} m in all; the longest edge, {} m, begins at ({}, {}, {})\n",
                    f(found.open.length), f(found.open.longest), f(found.open.at.x),
                    f(found.open.at.y), f(found.open.at.z));
  }
  if (found.closed.empty()) return text;
  const auto largest = std::max_element(
      found.closed.begin(), found.closed.end(),
      [](const calc::MeshShell& a, const calc::MeshShell& b) { return a.volume < b.volume; });
  const std::size_t inward = largest->triangle.size() - largest->outward;
  text += fmt::format("    shells     {} closed; the largest around {} m3, its faces point {}\n",
                      found.closed.size(), f(largest->volume),
                      inward == 0 ? std::string("outward")
                      : largest->outward == 0
                          ? std::string("inward")
                          : fmt::format("inward ({}) and outward ({})", inward, largest->outward));
  return text;
}

std::string surface_text(const SurfaceReport& surface) {
  const calc::SurfaceFindings& found = surface.findings;
  std::string text;
  if (!surface.id.empty()) {
    text += fmt::format("  {} {}{}\n", surface.is_room ? "room" : "space",
                        report::printable(surface.id),
                        surface.name.empty() ? "" : " " + report::printable(surface.name));
  }
  if (found.bounds_m.is_empty()) return text + "    no surfaces\n";
  const glm::dvec3 lower = found.bounds_m.lower, upper = found.bounds_m.upper;
  const glm::dvec3 size = upper - lower;
  const auto f = [](double metres) { return report::format_fixed(metres, 3); };
  text += fmt::format("    bounds     x {} to {}, y {} to {}, z {} to {} m\n", f(lower.x),
                      f(upper.x), f(lower.y), f(upper.y), f(lower.z), f(upper.z));
  text += fmt::format("    size       {} x {} x {} m\n", f(size.x), f(size.y), f(size.z));
  text += fmt::format(
      "    triangles  {}, area {} m2; {} duplicate, {} without area, {} not finite\n",
      found.triangles, f(found.area_m2), found.duplicates, found.degenerate, found.not_finite);
  if (found.polygons_mended + found.polygons_left_out > 0) {
    text += fmt::format("    polygons   {} mended, {} omitted: {} m2 are missing\n",
                        found.polygons_mended, found.polygons_left_out, f(found.area_left_out_m2));
  }
  text += fmt::format("    edges      {}: {} open, {} of more than two triangles\n", found.edges,
                      found.open_edges, found.crowded_edges);
  text += fmt::format("    watertight {}\n", found.is_watertight ? "yes" : "no");
  text += shells_text(found);
  text += fmt::format("    light      {}\n", light_text(surface));
  for (const std::string& note : surface.notes) {
    text += fmt::format("    note       {}\n", report::printable(note));
  }
  return text + parts_text("objects", found.objects) + parts_text("materials", found.materials);
}

std::string heading(const GeometryReport& report) {
  if (!report.is_readable()) return "not readable";
  if (report.units.empty()) return report.kind;
  return fmt::format("{}, in {}, {} up", report.kind, report.units, report.up);
}

}  // namespace

std::string render_geometry_text(const std::vector<GeometryReport>& reports) {
  std::string text;
  for (const GeometryReport& report : reports) {
    if (!text.empty()) text += "\n";
    text += fmt::format("{}: {}\n", report::printable(report.path), heading(report));
    for (const SurfaceReport& surface : report.surfaces) text += surface_text(surface);
  }
  return text;
}

}  // namespace cli
