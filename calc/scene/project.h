#pragma once
// A project as read: plain data, world coordinates, metres, radians. Made by load_project().

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/base/xml_document.h"
#include "calc/photometry/luminaire_light.h"
#include "calc/photometry/web.h"
#include "calc/scene/about_project.h"
#include "calc/scene/maintenance_plan.h"
#include "calc/scene/receiver_kernel.h"
#include "calc/scene/road.h"
#include "calc/scene/route_shape.h"
#include "calc/scene/waiver.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace calc {

struct Material {
  std::string id;
  double reflectance;  // diffuse, [0, 1]
  SourceLocation where;
};

// An object as triangles. Two-sided: both faces reflect, nothing passes through.
struct Body {
  std::string id;
  std::vector<glm::dvec3> vertex_m;
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> material_of;  // per triangle, index into Project::materials
  bool is_closed = false;                  // watertight: it has an inside, whose points are dropped
  bool encloses_room = false;              // watertight, and the room is its inside; not is_closed
  SourceLocation where;
  std::string housing_of = {};  // id of the luminaire that has it (housing.h); of all others empty
};

// The walls of a <room>: a vertical prism over a simple polygon (counter-clockwise, may be
// concave).
struct RoomShell {
  std::vector<glm::dvec2> footprint_m;
  double floor_z_m = 0.0;
  double height_m = 0.0;
};

// MF = LLMF x LSF x LMF x RSMF (ISO/CIE TS 22012). A single number is only in `product`.
struct MaintenanceFactor {
  double product = 1.0;   // (0, 1]
  bool is_stated = true;  // by the type or for the whole project; else 1 is an assumption
  std::optional<double> llmf, lsf, lmf, rsmf;
};

// An emitter of a luminaire that has several.
struct TypeEmitter {
  std::size_t type = 0;  // index into Project::luminaire_types: the light of this emitter alone
  EmitterPlace place;
};

// The luminaire as an obstacle to light, without its own light, because photometry includes that.
// It extends from its opening backwards; for an opening that is a body, it is that body.
struct Housing {
  std::uint32_t material = 0;             // index into Project::materials
  double depth_m = 0.0;                   // 0: the face alone, as of a luminaire in a ceiling
  std::optional<glm::dvec2> size_m = {};  // along C0 and C90; else that of the opening
  bool is_round = false;                  // size_m is of an ellipse
};

// A lamp, driver or current with which a luminaire is sold: the light of its photometry file with
// another flux.
struct LampPackage {
  std::string article;                  // its name, unique in its type
  double flux_lm = 0.0, power_w = 0.0;  // of the luminaire, > 0
  std::optional<double> price = {};     // of one luminaire, as LuminaireType has it
};

// Whether a flux is another than that of the photometry file, > 0, and not only rounded otherwise:
// what the file says of power and colour is of another light then.
inline bool is_other_flux(double flux_lm, double file_flux_lm) {
  constexpr double kSame = 1e-3;
  const double apart_lm = flux_lm > file_flux_lm ? flux_lm - file_flux_lm : file_flux_lm - flux_lm;
  return apart_lm > kSame * file_flux_lm;
}

// A luminaire with several emitters is a type for each of them: the first one has its id and power,
// the others come behind it. So everything that asks for light finds each emitter where it is; what
// counts luminaires or watts asks counts_as_luminaire().
struct LuminaireType {
  std::string id;
  std::string photometry_file;  // as written in the project
  std::size_t web = 0;          // index into Project::webs
  double flux_scale = 1.0;      // flux override / flux of the web
  double power_w = 0.0;         // override, else the file's; 0 = not stated; of all emitters
  double file_power_w = 0.0;    // without the override
  MaintenanceFactor maintenance;
  SourceLocation where;
  std::vector<TypeEmitter> emitters = {};  // all of a luminaire that has several, else none
  bool is_further_emitter = false;         // of the type before it
  // Price of a luminaire in the project's own currency; empty = not stated. No effect on light.
  std::optional<double> price = {};
  std::optional<Housing> housing = {};
  // Its lamp packages; `package`: the index of the package whose flux and power it has. Empty:
  // those of the file or the project's own.
  std::vector<LampPackage> packages = {};
  std::optional<std::size_t> package = {};

  bool counts_as_luminaire() const { return !is_further_emitter; }
  // The project states a flux that is not the file's.
  bool is_of_other_flux() const { return is_other_flux(flux_scale, 1.0); }
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

// Dimming levels per group; other groups are at 1.
struct LightScene {
  std::string id;
  std::vector<std::pair<std::string, double>> level_of_group;  // level in [0, 1]
  SourceLocation where;
};

// How side / spacing becomes a number of cells: the nearest number, the next one up, or the next
// odd one up. Never below 1.
enum class GridRounding { nearest, up, odd_up };

template <>
struct EnumNames<GridRounding> {
  static constexpr EnumName<GridRounding> list[] = {{GridRounding::nearest, "nearest"},
                                                    {GridRounding::up, "up"},
                                                    {GridRounding::odd_up, "odd-up"}};
};

// The largest spacing is p = factor * base^log10(d), at most `max_spacing_m`; d is the longer side,
// or the shorter one if longer / shorter >= shorter_from_ratio. Default: EN 12464-1.
struct GridByRule {
  Message name = Message::words("EN 12464-1");  // of the requirement's source, for reports
  double factor_m = 0.2, base = 5.0, max_spacing_m = 10.0;
  double shorter_from_ratio = 2.0;
  GridRounding rounding = GridRounding::nearest;
  bool operator==(const GridByRule&) const = default;
};
struct GridByCount {
  int columns = 0, rows = 0;
  bool operator==(const GridByCount&) const = default;
};
// Cell counts are rounded up, so that no cell is larger.
struct GridBySpacing {
  double along_u_m = 0.0, along_v_m = 0.0;
  Message name;  // of the requirement's source; "" = the project
  bool operator==(const GridBySpacing&) const = default;
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
  bool operator==(const PlanarArea&) const = default;
};

// Points and unit normals as given, e.g. for a site measurement.
struct PointList {
  std::string file;
  std::vector<glm::dvec3> position_m, normal;
  std::vector<int> line;        // of the file, as many
  bool names_its_unit = false;  // else its columns are 'x,y,z', which are metres
};

// An escape route: points at `height_m` above the surface that people walk on, facing up.
struct EscapeRoute {
  RouteLine line;  // without fault
  double height_m = 0.0;
  // Largest distances of points; the rows are an odd number, so that one is on the line.
  GridBySpacing spacing;
  bool is_spacing_given = false;  // else there are kLeastRouteRows rows at least
};
inline constexpr double kRouteSpacing_m = 0.5;
inline constexpr int kLeastRouteRows = 5;

using PlaneArea = std::variant<PlanarArea, PointList, EscapeRoute>;

// What a workplace states of a plane for which a standard may have a number of its own: the task
// may be anywhere on it; or it is on a wall other than the one in front of the person at work.
enum class SpecialPlace { none, unknown_task, other_wall };

template <>
struct EnumNames<SpecialPlace> {
  static constexpr EnumName<SpecialPlace> list[] = {{SpecialPlace::none, ""},
                                                    {SpecialPlace::unknown_task, "unknown-task"},
                                                    {SpecialPlace::other_wall, "other-wall"}};
};

// A requirement for a plane: a <require>, or the <workplace> that has made the plane, which then
// has this role in it. It is kept as written, and not even the names of its attributes are checked,
// because rules/ knows the grammar.
struct RequirementText {
  XmlElement element;
  std::string role{};                     // "" of a <require>
  std::vector<std::string> workplaces{};  // ids of all that ask for this; none: a <require>
  SpecialPlace special = SpecialPlace::none;
};

// Roles of planes that a <road> makes.
inline constexpr std::string_view kCarriagewayRole = "carriageway", kFootwayRole = "footway";

struct CalcPlane {
  std::string id;   // unique in the project
  std::string was;  // its id in earlier revisions of the project; "" = the same
  std::string name;
  std::vector<std::string> tags;  // words by which people choose; they change no result
  PlaneArea area;
  ReceiverKernel kernel = ReceiverKernel::planar;
  DerivedQuantity derived = DerivedQuantity::none;
  bool is_quantity_known = true;  // false after an error in it: the two above say nothing
  // The direction, unit and horizontal, of an area's points that look somewhere (has_look()); else
  // 0. Points of a list look along their normals, and all other points of an area have its normal
  // for an axis.
  glm::dvec3 direction{0.0};
  // The walking direction on it, unit and horizontal; 0: not stated.
  glm::dvec3 travel{0.0};
  std::vector<RequirementText> requirements;
  // For a plane made by a workplace, for reports: its origin, and what the project changed; else
  // "".
  Message made_by, changed;
  bool has_own_area = false;           // of such a plane: around the task, where the project says
  std::optional<double> own_margin_m;  // what the project, or the room's width, makes of the rule's
  std::string usual_role;  // that packs know what the road has made by; "" of any other plane
  SourceLocation where;
};

// A project's change to a zone of a workplace, or its omission.
struct ZoneText {
  std::string role;                // "cylinder", "wall" for all walls, "wall.2"
  std::optional<Waiver> left_out;  // who leaves it out; empty: it is changed
  std::string because;             // of a change; may be ""
  std::optional<double> height_m, margin_m;
  std::optional<GridRule> grid;
  std::vector<glm::dvec2> area_m;  // world x and y, counter-clockwise; empty: the rule's
  SourceLocation where, role_where;
};

// A zone of a workplace, or a part of it ("wall.2"), that has no plane.
struct UnmadeZone {
  std::string role;
  Message why;
  std::optional<Waiver> left_out;  // by the project; else there is no place for it
  bool is_place_unknown = false;   // it exists, but the project does not state where
};

// The task of a workplace that is not level: a board on a wall, the face of a rack.
struct UprightTask {
  PlanarArea area;  // a rectangle; u along its foot, v up, facing whoever looks at it
  double low_m = 0.0, high_m = 0.0;  // above the floor
  std::optional<std::size_t> wall;   // that it is on, from 0
};

// A plane of a workplace that the project omits for a time: without an area.
struct LeftOutPlane {
  CalcPlane plane;
  Waiver by;
};

// The zones of a room by a row of a standard, as facts only; rules/binding/workplace.h makes
// planes.
struct Workplace {
  std::string id, was, name;      // was: as of a plane
  std::vector<std::string> tags;  // of its planes
  XmlElement element;  // as written, for what only rules/ knows: pack, row, level, scene, facts
  std::vector<glm::dvec2> task_m;         // world x and y, counter-clockwise; empty: the whole room
  std::optional<UprightTask> upright;     // instead of task_m
  std::optional<double> height_m;         // of the task, above the floor
  bool is_task_place_unknown = false;     // it may be anywhere in the room
  std::optional<std::size_t> front_wall;  // that whoever works there looks at, from 0
  PlanarArea ceiling;
  std::vector<PlanarArea> walls;  // in the order of the project's numbers
  std::vector<ZoneText> zones;
  std::vector<UnmadeZone> unmade;  // known once its planes are made
  bool is_good = true;             // false after an error in it or in the shape of its room
  bool is_further_copy = false;    // of a grid: errors are reported for the first copy
  SourceLocation where;
};

// Factors of EN 15193 as a project states them, (0, 1]; others count as 1.
struct EnergyFactors {
  std::optional<double> occupancy, daylight, constant_illuminance;  // Fo, FD, Fc
};

// The use of a room's light in a year.
struct EnergyUse {
  double day_h = 0.0, night_h = 0.0;  // in use with and without daylight
  double parasitic_kwh_m2 = 0.0;      // controls on standby, charging of emergency luminaires
  EnergyFactors factors;
  std::vector<std::pair<std::string, EnergyFactors>> of_group;  // what differs in dimming groups
};

// A space for calculation: a room, a road, or the open space with everything else. Rooms are closed
// and opaque, so that nothing in one space changes the light in another.
struct Space {
  std::string id, was;  // was: as of a plane
  std::string name;
  std::vector<std::string> tags;   // of all of its planes
  std::optional<RoomShell> shell;  // empty for the open space and rooms of a building file
  // A road is a space of its own, with only its luminaires. Its rows continue; `luminaires` holds
  // those that light the field by EN 13201-3.
  std::optional<Road> road;
  std::string surfaces_file;  // of such a room, as the project names it; else ""
  bool is_from_mesh = false;  // surfaces_file is a mesh, and not gbXML
  std::vector<Body>
      bodies;  // the shell's own surfaces first, ids "<room>.floor", ".ceiling", ".wall1"...
  // Connected parts of those bodies that are objects and not closed, if they may have an inside
  // (hollow_shells.h): with their ids, and no materials.
  std::vector<Body> open_shells;
  std::vector<Luminaire> luminaires;
  std::vector<CalcPlane> planes;
  std::vector<LeftOutPlane> left_out;  // of its workplaces
  std::vector<Workplace> workplaces;
  std::optional<EnergyUse> energy;  // its own, or else the project's
  std::vector<Message> notes;       // for reports: zones that were not made, and why
  std::vector<glm::dvec2>
      outline_m;  // of the floor of a room of a building file, world x and y; empty: not known
  SourceLocation where;

  // Returns whether it is the space around all rooms.
  bool is_open_space() const { return !shell && !road && surfaces_file.empty(); }
};

// Rooms with common requirements: for their sum, not for each.
struct Building {
  std::string id, was;  // was: as of a plane
  std::string name;
  std::vector<std::size_t> rooms;  // in Project::spaces, ascending; at least one, none twice
  std::vector<RequirementText> requirements;
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
  AboutProject about;
  // Direction of north in plan, degrees from +x counter-clockwise, [-360, 360]; only for drawings.
  std::optional<double> north_deg;
  MaintenancePlan maintenance_plan;
  std::vector<Material> materials;
  std::vector<PhotometricWeb> webs;  // one per light of a file, with or without opening
  std::vector<LuminaireType> luminaire_types;
  std::vector<LightScene> scenes;
  std::vector<Space>
      spaces;  // rooms and roads in file order; the open space last, if it has anything in it
  std::vector<Building> buildings;
  std::vector<InputFile> inputs;
};

}  // namespace calc
