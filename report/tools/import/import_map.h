#pragma once
// The map of an import: a TOML file with the meaning of the layers and names of a design file, and
// with facts that no design file has: heights of rooms, reflectances, photometry. Reader, messages
// and help share one table of keys (import_map.cpp).

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cli {

// The source of a luminaire's height; a number is in metres above the floor of its room.
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

// Returns the map; empty exactly if an error was reported. file: its path, for messages.
std::optional<ImportMap> read_import_map(const std::string& bytes, const std::string& file,
                                         calc::Diagnostics& diagnostics);

// Returns the keys as a table in Markdown, for the manual.
std::string import_map_reference();

// Returns whether all of the name matches the pattern.
bool matches_name(std::string_view pattern, std::string_view name);
// Returns whether a layer or block matches, with or without the name of the file that it was bound
// in from ("xref-house$0$A-WALL").
bool matches_bound_name(std::string_view pattern, std::string_view name);

// Returns metres per unit; empty: unknown unit. Names: m, cm, mm, in, ft.
std::optional<double> metres_per_import_unit(std::string_view unit);
extern const std::vector<std::string_view> kImportUnits;

}  // namespace cli
