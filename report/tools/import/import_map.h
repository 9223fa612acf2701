#pragma once
// The map of an import: a TOML file that says what the layers and names of a design file mean, and
// what no design file knows: heights of rooms, reflectances, photometry. One table of keys
// (import_map.cpp) is what reader, messages and help go by.

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cli {

// Where the height of a luminaire comes from; metres above the floor of its room if it is a number.
struct FromZ {};
struct FromAttribute {
  std::string name;
};
using HeightSource = std::variant<double, FromZ, FromAttribute>;

// Patterns: * and ? stand for any characters, case does not count. "" = not given.
struct MapRoom {
  std::string layer, names;
  double height_m = 0.0;
  double ceiling = 0.0, walls = 0.0, floor = 0.0;  // reflectances
  std::optional<double> floor_z_m;
  bool closes = false;  // outlines whose ends are apart are closed by a straight line
  int line = 0;
};
struct MapLuminaire {
  std::string type, layer;
  std::string photometry;            // path from the map's folder
  std::vector<HeightSource> height;  // the first that says something counts
  std::string group;                 // an attribute: its value is the dimming group
  double turn_deg = 0.0;
  std::optional<double> flux_lm, power_w, maintenance_factor;
  int line = 0;
};
struct MapFurniture {
  std::string type, layer;
  double height_m = 0.0, reflectance = 0.0;
  int line = 0;
};
struct MapPlane {
  std::string layer;
  double height_m = 0.0;
  int line = 0;
};
struct MapRoute {
  std::string layer;
  double width_m = 0.0;
  int line = 0;
};

struct ImportMap {
  std::string file;  // "" = no map
  std::string unit;  // "" = not stated
  std::string name;  // of the project
  std::vector<std::string> ignore;
  std::vector<MapRoom> room;
  std::vector<MapLuminaire> luminaire;
  std::vector<MapFurniture> furniture;
  std::vector<MapPlane> plane;
  std::vector<MapRoute> route;
};

// Empty if and only if an error was reported. file: its path, for messages.
std::optional<ImportMap> read_import_map(const std::string& bytes, const std::string& file,
                                         calc::Diagnostics& diagnostics);

// The keys as a table in Markdown, for the manual.
std::string import_map_reference();

// Whether all of the name matches the pattern.
bool matches_name(std::string_view pattern, std::string_view name);
// The same of a layer or block that may carry the name of the file that it was bound in from
// ("xref-house$0$A-WALL"): with or without it.
bool matches_bound_name(std::string_view pattern, std::string_view name);

// Metres; empty: no unit of that name. Names: m, cm, mm, in, ft.
std::optional<double> metres_per_import_unit(std::string_view unit);
extern const std::vector<std::string_view> kImportUnits;

}  // namespace cli
