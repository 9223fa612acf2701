#include "report/tools/import/ifc_import.h"

#include "report/tools/import/design_heights.h"
#include "report/tools/import/design_notes.h"
#include "report/tools/import/design_rooms.h"
#include "report/tools/import/ifc_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace cli {
namespace {

constexpr std::string_view kAnyOutline = "DLX_*CONT";  // `layer` of a [[room]] that has none

bool fits_room(const MapRoom& rule, const DesignRoom& room) {
  if (rule.layer.empty() || rule.layer == kAnyOutline) return true;
  return matches_name(rule.layer, room.number) || matches_name(rule.layer, room.name) ||
         matches_name(rule.layer, room.use) || matches_name(rule.layer, room.storey);
}

class RuleFinder {
 public:
  RuleFinder(Design& design, const ImportMap& map, double metres_per_unit)
      : design_(design), map_(map), notes_(design), metres_per_unit_(metres_per_unit) {}

  void find() {
    for (DesignRoom& room : design_.room) {
      room.rule = map_.room.size();
      for (std::size_t i = map_.room.size(); i-- > 0;) {
        if (fits_room(map_.room[i], room)) room.rule = i;
      }
      if (room.rule < map_.room.size() && map_.room[room.rule].floor_z_m) {
        notes_.doubt("room", "its floor has the height of the IFC file, not that of the map",
                     room.source.place);
      }
    }
    std::vector<DesignLuminaire> luminaires;
    for (DesignLuminaire& one : design_.luminaire) {
      if (is_ignored(one.type)) {
        notes_.add(DesignNote::Kind::not_asked, "luminaire " + one.type, "the map ignores it",
                   one.source.place);
        continue;
      }
      for (std::size_t i = map_.luminaire.size(); i-- > 0;) {
        if (matches_name(map_.luminaire[i].type, one.type)) one.rule = i;
      }
      if (one.rule) set_height(one, map_.luminaire[*one.rule]);
      luminaires.push_back(std::move(one));
    }
    design_.luminaire = std::move(luminaires);
    std::vector<DesignBox> boxes;
    for (DesignBox& box : design_.box) {
      std::optional<std::size_t> rule;
      for (std::size_t i = map_.furniture.size(); i-- > 0;) {
        const std::string& type = map_.furniture[i].type;
        if (!type.empty() && matches_name(type, box.name)) rule = i;
      }
      if (!rule) {
        notes_.add(DesignNote::Kind::not_asked, "furniture",
                   "the map has no [[furniture]] whose type fits its name", box.source.place);
        continue;
      }
      box.rule = *rule;
      boxes.push_back(std::move(box));
    }
    design_.box = std::move(boxes);
  }

 private:
  bool is_ignored(const std::string& type) const {
    return std::any_of(map_.ignore.begin(), map_.ignore.end(),
                       [&](const std::string& pattern) { return matches_name(pattern, type); });
  }

  // By the first source that says something; by none the height is not known.
  void set_height(DesignLuminaire& one, const MapLuminaire& rule) {
    const auto room = room_at(design_, one.position_m, one.position_m.z, one.storey);
    for (const HeightSource& source : rule.height) {
      if (std::holds_alternative<FromZ>(source)) return;
      std::optional<double> above_m;
      if (const auto* given = std::get_if<double>(&source)) {
        above_m = *given;
      } else {
        above_m = height_of_attribute(one, std::get<FromAttribute>(source).name, metres_per_unit_,
                                      notes_);
      }
      if (!above_m) continue;
      if (room) one.position_m.z = design_.room[*room].floor_z_m + *above_m;
      return;  // outside of all rooms it is left out for that
    }
    one.has_height = false;
  }

  Design& design_;
  const ImportMap& map_;
  DesignNotes notes_;
  double metres_per_unit_;
};

}  // namespace

std::optional<Design> ifc_without_map(std::string_view bytes, const std::string& file,
                                      const std::string& unit, std::string& problem) {
  IfcOptions options;
  if (!unit.empty()) options.metres_per_unit = metres_per_import_unit(unit);
  StepProblem step;
  std::optional<Design> design = read_ifc(bytes, file, options, step);
  if (!design) {
    problem = step.line == 0 ? step.what : fmt::format("line {}: {}", step.line, step.what);
  }
  return design;
}

std::optional<Design> design_of_ifc(std::string_view bytes, const std::string& file,
                                    const ImportMap& map, const std::string& unit,
                                    std::string& problem) {
  std::optional<Design> design =
      ifc_without_map(bytes, file, unit.empty() ? map.unit : unit, problem);
  if (design) RuleFinder(*design, map, design->metres_per_unit).find();
  return design;
}

}  // namespace cli
