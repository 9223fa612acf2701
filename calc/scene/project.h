#pragma once
// A project as read: plain data, world coordinates, metres, radians. Made by load_project().

#include "calc/diagnostics.h"
#include "calc/photometry/web.h"
#include "calc/scene/receiver_kernel.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace calc {

struct Material {
  std::string id;
  double reflectance;  // diffuse, [0, 1]
  SourceLocation where;
};

// One object as triangles. Two-sided: both faces reflect, nothing passes through.
struct Body {
  std::string id;
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> material_of;  // per triangle, index into Project::materials
  bool is_closed = false;                  // watertight: it has an inside, whose points are dropped
  SourceLocation where;
};

// The walls of a <room>: a vertical prism over a simple polygon (counter-clockwise, may be
// concave).
struct RoomShell {
  std::vector<glm::dvec2> footprint_m;
  double floor_z_m = 0.0;
  double height_m = 0.0;
};

// ISO/CIE TS 22012: MF = LLMF x LSF x LMF x RSMF. A single number is kept in `product` alone.
struct MaintenanceFactor {
  double product = 1.0;  // (0, 1]
  std::optional<double> llmf, lsf, lmf, rsmf;
};

struct LuminaireType {
  std::string id;
  std::string photometry_file;  // as written in the project
  std::size_t web = 0;          // index into Project::webs
  double flux_scale = 1.0;      // flux override / flux of the web
  double power_w = 0.0;         // override, else the file's; 0 = not stated
  MaintenanceFactor maintenance;
  SourceLocation where;
};

struct Luminaire {
  std::string id;
  std::size_t type = 0;        // index into Project::luminaire_types
  glm::dvec3 position_m{0.0};  // centre of the luminous opening
  glm::dmat3
      world_from_luminaire;  // columns: C0, C90 and -axis (gamma = pi) directions, orthonormal
  std::string group;         // dimming group; "" = none
  SourceLocation where;
};

// Dimming levels per group; groups not named are at 1.
struct LightScene {
  std::string id;
  std::vector<std::pair<std::string, double>> level_of_group;  // level in [0, 1]
  SourceLocation where;
};

struct GridByRule {};  // EN 12464-1: p = 0.2 * 5^log10(d)
struct GridByCount {
  int columns = 0, rows = 0;
};
struct GridBySpacing {
  double along_u_m = 0.0, along_v_m = 0.0;
};
using GridRule = std::variant<GridByRule, GridByCount, GridBySpacing>;

// A flat area: p = origin + x * u + y * v for (x, y) in the outline and in no hole.
struct PlanarArea {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 u{1, 0, 0},
      v{0, 1, 0};  // orthonormal; planar illuminance is measured on the side of normal()
  std::vector<glm::dvec2> outline_m;  // simple polygon, in (u, v)
  std::vector<std::vector<glm::dvec2>> holes_m;
  double margin_m = 0.0;  // strip along the outline without points
  GridRule grid;

  glm::dvec3 normal() const { return glm::cross(u, v); }
};

// Points and unit normals as given, e.g. of a site measurement.
struct PointList {
  std::string file;
  std::vector<glm::dvec3> position_m, normal;
  std::vector<int> line;  // of the file, as many
};

// A requirement as written; rules/ gives it a meaning. Attributes in file order.
struct RequirementText {
  struct Attribute {
    std::string name, value;
    SourceLocation where;
  };
  std::vector<Attribute> attributes;
  SourceLocation where;
};

struct CalcPlane {
  std::string id;  // unique in the project
  std::string name;
  std::variant<PlanarArea, PointList> area;
  ReceiverKernel kernel = ReceiverKernel::planar;
  DerivedQuantity derived = DerivedQuantity::none;
  // Of an area's points that look somewhere (has_look()): where, unit and horizontal; else 0.
  // Points of a list look along their normals, and all others of an area have its normal for an
  // axis.
  glm::dvec3 direction{0.0};
  std::vector<RequirementText> requirements;
  SourceLocation where;
};

// A unit of calculation: a room, or the open space with everything outside all rooms. Rooms are
// closed and opaque, so that nothing in one space changes the light in another.
struct Space {
  std::string id;
  std::string name;
  std::optional<RoomShell> shell;  // empty for the open space and rooms of a building file
  std::string surfaces_file;       // of such a room, as the project names it; else ""
  std::vector<Body>
      bodies;  // the shell's own surfaces first, ids "<room>.floor", ".ceiling", ".wall1"...
  std::vector<Luminaire> luminaires;
  std::vector<CalcPlane> planes;
  SourceLocation where;
};

// A file that was read, for provenance.
struct InputFile {
  std::string path;    // as the user or the project names it
  std::string sha256;  // lower-case hexadecimal
};

struct Project {
  std::string path;
  std::string name;
  std::vector<Material> materials;
  std::vector<PhotometricWeb> webs;  // one per light of a file, with or without opening
  std::vector<LuminaireType> luminaire_types;
  std::vector<LightScene> scenes;
  std::vector<Space> spaces;  // rooms in file order; the open space last, if it has anything in it
  std::vector<InputFile> inputs;
};

}  // namespace calc
