#include "report/text/json_layout.h"
#include "report/tools/geometry/geometry.h"

#include <nlohmann/json.hpp>

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Json parts_json(const std::vector<calc::SurfacePart>& parts) {
  Json list = Json::array();
  for (const calc::SurfacePart& part : parts) {
    if (part.triangles == 0) continue;
    list.push_back({{"name", part.name}, {"triangles", part.triangles}, {"area_m2", part.area_m2}});
  }
  return list;
}

Json escape_json(const Escape& escape) {
  Json json = {{"inside_share", escape.inside_share}, {"points", escape.points}};
  if (escape.points == 0) return json;
  json["share"] = escape.share.value;
  json["low_95"] = escape.share.low;
  json["high_95"] = escape.share.high;
  return json;
}

Json shells_json(const std::vector<calc::MeshShell>& shells) {
  Json list = Json::array();
  for (const calc::MeshShell& shell : shells) {
    list.push_back({{"triangles", shell.triangle.size()},
                    {"outward", shell.outward},
                    {"volume_m3", shell.volume},
                    {"lower_m", point_json(shell.bounds.lower)},
                    {"upper_m", point_json(shell.bounds.upper)}});
  }
  return list;
}

Json surface_json(const SurfaceReport& surface) {
  const calc::SurfaceFindings& found = surface.findings;
  Json json = {{"id", surface.id}, {"name", surface.name}, {"room", surface.is_room}};
  if (!found.bounds_m.is_empty()) {
    json["lower_m"] = point_json(found.bounds_m.lower);
    json["upper_m"] = point_json(found.bounds_m.upper);
  }
  json["triangles"] = found.triangles;
  json["area_m2"] = found.area_m2;
  json["duplicate_triangles"] = found.duplicates;
  json["triangles_without_area"] = found.degenerate;
  json["triangles_not_finite"] = found.not_finite;
  json["polygons_mended"] = found.polygons_mended;
  json["polygons_left_out"] = found.polygons_left_out;
  json["area_left_out_m2"] = found.area_left_out_m2;
  json["edges"] = found.edges;
  json["open_edges"] = found.open_edges;
  json["crowded_edges"] = found.crowded_edges;
  json["watertight"] = found.is_watertight;
  json["open_edges_m"] = found.open.length;
  json["closed_shells"] = shells_json(found.closed);
  json["float_step_m"] = found.float_step_m;
  json["escape"] = escape_json(surface.escape);
  if (!surface.notes.empty()) json["notes"] = surface.notes;
  json["objects"] = parts_json(found.objects);
  json["materials"] = parts_json(found.materials);
  return json;
}

Json diagnostic_json(const calc::Diagnostic& diagnostic) {
  const bool is_error = diagnostic.severity() == calc::Severity::error;
  return {{"severity", is_error ? "error" : "warning"},
          {"id", calc::diagnostic_name(diagnostic.id)},
          {"file", diagnostic.where.file},
          {"line", diagnostic.where.line},
          {"message", diagnostic.message}};
}

}  // namespace

std::string render_geometry_json(const std::vector<GeometryReport>& reports) {
  Json json = {{"format", "luxgate-geometry-1"}, {"files", Json::array()}};
  for (const GeometryReport& report : reports) {
    Json file = {{"path", report.path},
                 {"readable", report.is_readable()},
                 {"kind", report.kind},
                 {"units", report.units},
                 {"up", report.up},
                 {"surfaces", Json::array()},
                 {"diagnostics", Json::array()}};
    for (const SurfaceReport& surface : report.surfaces) {
      file["surfaces"].push_back(surface_json(surface));
    }
    for (const calc::Diagnostic& diagnostic : report.diagnostics) {
      file["diagnostics"].push_back(diagnostic_json(diagnostic));
    }
    json["files"].push_back(std::move(file));
  }
  return report::json_layout(json);
}

}  // namespace cli
