#pragma once
// 'luxgate geometry': the contents of a geometry file, and its mistakes.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/meshes/mesh_check.h"
#include "report/shell/command/command.h"
#include "report/tools/geometry/escape.h"

#include <string>
#include <vector>

namespace cli {

// A mesh file, or one room or the open space of a project or gbXML file.
struct SurfaceReport {
  std::string id;        // of the space; "" = the whole file
  std::string name;      // of the space
  bool is_room = false;  // must be closed
  calc::SurfaceFindings findings;
  Escape escape;
  std::vector<std::string> notes;  // of a project's room
};

struct GeometryReport {
  std::string path;
  std::string kind;       // "obj", "gltf", "stl", "ply", "project", "gbxml"; "" = not readable
  std::string units, up;  // that a mesh was read with; "" for other files
  std::vector<SurfaceReport> surfaces;
  std::vector<calc::Diagnostic> diagnostics;

  bool is_readable() const { return !kind.empty(); }
};

struct GeometryOptions {
  std::vector<std::string> files;
  std::string mesh_units, mesh_up;  // of mesh files that do not say; "" = not given
  bool as_json = false;
  bool strict = false;  // warnings count
};

Command geometry_syntax(GeometryOptions& options);
Command geometry_command();

// Examines a file. The report has everything that is found, warnings included.
GeometryReport examine_geometry(const std::string& path, const calc::FileReader& files,
                                const GeometryOptions& options);

std::string render_geometry_text(const std::vector<GeometryReport>& reports);
// Returns JSON with "format": "luxgate-geometry-1"; lengths in metres.
std::string render_geometry_json(const std::vector<GeometryReport>& reports);

}  // namespace cli
