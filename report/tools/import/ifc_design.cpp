#include "report/tools/import/ifc_design.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/scene/polygon.h"
#include "report/tools/import/ifc_placement.h"
#include "report/tools/import/ifc_profile.h"
#include "report/tools/import/ifc_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace cli {
namespace {

constexpr int kDeepestStructure = 32;         // steps from a thing up to its storey
constexpr std::size_t kMostAttributes = 200;  // of one luminaire
constexpr std::size_t kMostNotes = 1000;      // that differ
constexpr std::size_t kLongestExample = 60;   // of a text in a note
constexpr double kFarOrigin_m = 1000.0;       // where an origin is taken away
constexpr double kVertical = 1.0e-5;          // sine of the angle to the vertical
// What a room of a building has: beyond it the unit may be wrong.
constexpr double kLeastArea_m2 = 1.0, kMostArea_m2 = 1.0e5;
constexpr double kLeastHeight_m = 1.8, kMostHeight_m = 60.0;

constexpr std::string_view kFurniture[] = {"IFCFURNISHINGELEMENT", "IFCFURNITURE",
                                           "IFCSYSTEMFURNITUREELEMENT"};

// Things of a building that light meets, and that are not taken.
struct PassedOver {
  std::string_view name, why;
};
constexpr std::string_view kWalls =
    "the outline of a room is that of its space; other objects in it are not taken";
constexpr PassedOver kPassedOver[] = {
    {"IFCWALL", kWalls},
    {"IFCWALLSTANDARDCASE", kWalls},
    {"IFCCOLUMN", kWalls},
    {"IFCCOLUMNSTANDARDCASE", kWalls},
    {"IFCBEAM", kWalls},
    {"IFCBEAMSTANDARDCASE", kWalls},
    {"IFCSLAB", kWalls},
    {"IFCSLABSTANDARDCASE", kWalls},
    {"IFCROOF", kWalls},
    {"IFCSTAIR", kWalls},
    {"IFCSTAIRFLIGHT", kWalls},
    {"IFCRAMP", kWalls},
    {"IFCRAILING", kWalls},
    {"IFCPLATE", kWalls},
    {"IFCMEMBER", kWalls},
    {"IFCCOVERING", kWalls},
    {"IFCCURTAINWALL", kWalls},
    {"IFCBUILDINGELEMENTPROXY", "its kind is not stated"},
    {"IFCDOOR", "doors are not taken"},
    {"IFCWINDOW", "windows are not taken: there is no daylight"},
    {"IFCLIGHTSOURCEGONIOMETRIC",
     "light distributions within the file are not read; the map gives "
     "each type its photometry file"},
};

// Words in names of what is no luminaire but is often filed as one.
constexpr std::string_view kSwitchWords[] = {"switch", "schalter", "sensor", "interrupteur"};

double degrees_from_above(const glm::dvec3& x) {
  double deg = calc::degrees_from_radians(calc::atan2(x.y, x.x));
  if (deg < 0.0) deg += 360.0;
  return deg < 360.0 ? deg : 0.0;
}

bool is_vertical(const glm::dvec3& v) {
  return std::fabs(v.x) + std::fabs(v.y) <= kVertical * std::fabs(v.z);
}

class DesignReader {
 public:
  DesignReader(const StepText& text, IfcUnits units)
      : text_(text), file_(text, std::move(units)), placements_(file_) {}

  Design read() {
    design_.unit = file_.units().name;
    design_.unit_reason = file_.units().reason;
    design_.metres_per_unit = file_.units().metres;
    for (const std::string& doubt : file_.units().doubt) {
      note(DesignNote::Kind::doubt, "unit of length", doubt, "");
    }
    if (!text_.is_utf8()) {
      note(DesignNote::Kind::doubt, "text",
           "some of it is not UTF-8; it is read as Windows-1252, and letters may be wrong", "");
    }
    relations();
    context();
    rooms();
    luminaires();
    furniture();
    passed_over();
    take_origin_away();
    design_.note = std::move(notes_);
    return std::move(design_);
  }

 private:
  // --- notes -----------------------------------------------------------------------------------
  std::string place(std::uint32_t instance) const {
    return fmt::format("#{}, line {}", text_.number(instance), text_.line(instance));
  }

  void note(DesignNote::Kind kind, std::string what, std::string why, std::string where,
            std::size_t count = 1) {
    if (note_at_.size() >= kMostNotes && !note_at_.contains({kind, what, why})) {
      what = "other things";
      why = "there are too many different reasons to list them";
    }
    const auto [found, is_new] =
        note_at_.try_emplace({kind, std::move(what), std::move(why)}, notes_.size());
    if (is_new) {
      notes_.push_back(
          {kind, std::get<1>(found->first), std::get<2>(found->first), std::move(where), count});
    } else {
      notes_[found->second].count += count;
    }
  }

  void left_out(std::uint32_t instance, const std::string& why) {
    note(DesignNote::Kind::left_out, text_.name(instance), why, place(instance));
  }

  void doubts(std::uint32_t instance, std::vector<std::string> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::string& doubt : all) {
      note(DesignNote::Kind::doubt, text_.name(instance), std::move(doubt), place(instance));
    }
  }

  // --- arguments -------------------------------------------------------------------------------
  std::string text_of(const std::vector<StepValue>& arguments, std::size_t i) {
    if (i >= arguments.size()) return {};
    return std::string(calc::trim(letters_of(arguments[i].untyped())));
  }

  std::string letters_of(const StepValue& value) {
    bool is_sure = true;
    const std::string text = value.text(&is_sure).value_or("");
    // Bytes that are no UTF-8 were said of the whole file.
    if (!is_sure && text_.is_utf8() && unsure_.insert(value.slice().data()).second) {
      note(DesignNote::Kind::doubt, "text",
           "an escape in it is not a letter, or is not from ISO 8859-1 to -9; letters may be "
           "missing (U+FFFD) or wrong",
           fmt::format("'{}'", calc::shorten_utf8(calc::printable(text), kLongestExample)));
    }
    return calc::printable(text);
  }

  DesignSource source(std::uint32_t instance, const std::vector<StepValue>& arguments) {
    DesignSource source{text_of(arguments, 0), place(instance)};
    if (source.key.empty() || !keys_.insert(source.key).second) {
      note(DesignNote::Kind::doubt, text_.name(instance),
           source.key.empty()
               ? "it has no GlobalId; the number of its instance is used"
               : "its GlobalId is given twice in the file; the number of its instance is added",
           source.place);
      source.key += fmt::format("#{}", text_.number(instance));
      keys_.insert(source.key);
    }
    return source;
  }

  // --- what belongs to what --------------------------------------------------------------------
  // Calls with each related thing and what it is related to.
  template <class Call>
  void relation(std::string_view name, std::size_t related, std::size_t relating, Call call) {
    for (const std::uint32_t instance : text_.of_name(name)) {
      const std::vector<StepValue> a = text_.arguments(instance);
      if (a.size() <= std::max(related, relating)) continue;
      std::vector<std::uint32_t> to;
      const StepValue& end = a[relating];
      for (const StepValue& one : end.kind() == StepValue::Kind::reference
                                      ? std::vector<StepValue>{end}
                                      : end.untyped().items()) {
        if (const auto found = text_.find(one)) to.push_back(*found);
      }
      for (const StepValue& one : a[related].items()) {
        const auto found = text_.find(one);
        if (!found) continue;
        for (const std::uint32_t other : to) call(*found, other);
      }
    }
  }

  void relations() {
    relation("IFCRELDEFINESBYTYPE", 4, 5,
             [&](std::uint32_t thing, std::uint32_t type) { type_.emplace(thing, type); });
    const auto up = [&](std::uint32_t thing, std::uint32_t parent) {
      parent_.emplace(thing, parent);
    };
    relation("IFCRELCONTAINEDINSPATIALSTRUCTURE", 4, 5, up);
    relation("IFCRELAGGREGATES", 5, 4, up);
    for (const std::uint32_t space : text_.of_name("IFCSPACE")) has_sets_.insert(space);
    for (const std::uint32_t fixture : text_.of_name("IFCLIGHTFIXTURE")) lights_.insert(fixture);
    for (const auto& [thing, type] : type_) {
      if (text_.name(type) == "IFCLIGHTFIXTURETYPE") lights_.insert(thing);
    }
    has_sets_.insert(lights_.begin(), lights_.end());
    relation("IFCRELDEFINESBYPROPERTIES", 4, 5, [&](std::uint32_t thing, std::uint32_t set) {
      if (has_sets_.contains(thing)) sets_[thing].push_back(set);
    });
  }

  std::string storey_of(std::uint32_t thing) {
    for (int step = 0; step < kDeepestStructure; ++step) {
      const auto found = parent_.find(thing);
      if (found == parent_.end()) return {};
      thing = found->second;
      if (text_.name(thing) != "IFCBUILDINGSTOREY") continue;
      const std::vector<StepValue> a = text_.arguments(thing);
      const std::string name = text_of(a, 2);
      return name.empty() ? text_of(a, 7) : name;
    }
    return {};
  }

  // Coordinates may be meant in another system than that of the world.
  void context() {
    for (const std::uint32_t instance : text_.of_name("IFCGEOMETRICREPRESENTATIONCONTEXT")) {
      const std::vector<StepValue> a = text_.arguments(instance);
      if (a.size() < 5 || a[4].is_null()) continue;
      try {
        file_.begin_product();
        if (ifc_axis_placement(file_, a[4]) == glm::dmat4(1.0)) continue;
        note(DesignNote::Kind::doubt, text_.name(instance),
             "its coordinate system is not that of the world; this is not applied",
             place(instance));
      } catch (const IfcLeftOut& problem) {
        left_out(instance, problem.why);
      }
    }
  }

  // --- properties ------------------------------------------------------------------------------
  // Calls with "Set.Property" and the value, of the single values of a set.
  template <class Call>
  void single_values(std::uint32_t set, Call call) {
    if (text_.name(set) != "IFCPROPERTYSET") return;
    const std::vector<StepValue> a = text_.arguments(set);
    if (a.size() < 5) return;
    const std::string name = text_of(a, 2);
    for (const StepValue& property : a[4].items()) {
      const auto found = text_.find(property);
      if (!found || text_.name(*found) != "IFCPROPERTYSINGLEVALUE") continue;
      const std::vector<StepValue> b = text_.arguments(*found);
      if (b.size() < 3 || b[2].is_null()) continue;
      call(name, text_of(b, 0), value_text(b[2]));
    }
  }

  std::string value_text(const StepValue& value) {
    const StepValue plain = value.untyped();
    if (plain.kind() == StepValue::Kind::text) return letters_of(plain);
    if (plain.kind() == StepValue::Kind::enumeration) {
      const std::string word = plain.enumeration();
      return word == "T" ? "true" : word == "F" ? "false" : word == "U" ? "unknown" : word;
    }
    return calc::printable(plain.slice());
  }

  std::vector<std::uint32_t> sets_of(std::uint32_t thing) const {
    std::vector<std::uint32_t> all;
    if (const auto found = sets_.find(thing); found != sets_.end()) all = found->second;
    if (const auto type = type_.find(thing); type != type_.end()) {
      const std::vector<StepValue> a = text_.arguments(type->second);
      if (a.size() > 5) {
        for (const StepValue& set : a[5].items()) {
          if (const auto found = text_.find(set)) all.push_back(*found);
        }
      }
    }
    return all;
  }

  // --- rooms -----------------------------------------------------------------------------------
  void rooms() {
    for (const std::uint32_t space : text_.of_name("IFCSPACE")) {
      file_.begin_product();
      try {
        room(space);
      } catch (const IfcLeftOut& problem) {
        left_out(space, problem.why);
      }
    }
  }

  void room(std::uint32_t space) {
    const std::vector<StepValue> a = file_.arguments(space, 8);
    const std::string composition = a.size() > 8 ? a[8].enumeration() : "";
    const std::string predefined = a.size() > 9 ? a[9].enumeration() : "";
    if (composition == "COMPLEX") throw IfcLeftOut{"it is a group of spaces"};
    if (predefined == "GFA") throw IfcLeftOut{"it is a gross area, not a room"};
    if (predefined == "EXTERNAL" || predefined == "PARKING") {
      throw IfcLeftOut{"it is outside the building"};
    }
    if (a[6].is_null()) throw IfcLeftOut{"it has no shape"};
    IfcRoomShape shape = ifc_room_shape(file_, a[6], placements_.world_from(a[5]));
    if (composition == "PARTIAL") shape.doubt.push_back("it is part of another space");
    const double area_m2 = std::fabs(calc::signed_area(shape.outline));
    if (!(area_m2 >= kLeastArea_m2 && area_m2 <= kMostArea_m2 && shape.height_m >= kLeastHeight_m &&
          shape.height_m <= kMostHeight_m)) {
      shape.doubt.push_back(fmt::format(
          "its size is unusual (area not within {:g} to {:g} m2, or height not within {:g} to {:g} "
          "m); check the unit, {}",
          kLeastArea_m2, kMostArea_m2, kLeastHeight_m, kMostHeight_m, file_.units().name));
    }
    DesignRoom room;
    room.source = source(space, a);
    room.number = text_of(a, 2);
    room.name = text_of(a, 7);
    room.use = use_of(space, a);
    room.storey = storey_of(space);
    room.outline_m = std::move(shape.outline);
    room.hole_m = std::move(shape.hole);
    room.floor_z_m = shape.floor_z_m;
    room.height_m = shape.height_m;
    room.doubt = shape.doubt;
    doubts(space, std::move(shape.doubt));
    design_.room.push_back(std::move(room));
  }

  // By the property that is made for it, else by the words of the object's type.
  std::string use_of(std::uint32_t space, const std::vector<StepValue>& arguments) {
    std::string use;
    for (const std::uint32_t set : sets_of(space)) {
      single_values(set, [&](const std::string&, const std::string& name, std::string value) {
        if (name == "OccupancyType" && use.empty()) use = std::move(value);
      });
    }
    return use.empty() ? text_of(arguments, 4) : use;
  }

  // --- luminaires ------------------------------------------------------------------------------
  void luminaires() {
    name_types();
    for (const std::uint32_t fixture : lights_) {
      file_.begin_product();
      try {
        luminaire(fixture);
      } catch (const IfcLeftOut& problem) {
        left_out(fixture, problem.why);
      }
    }
    if (!design_.luminaire.empty()) {
      note(DesignNote::Kind::taken, "luminaires",
           "each is taken to be at the origin of its type's body; the file does not say where the "
           "light comes out",
           design_.luminaire.front().source.place, design_.luminaire.size());
    }
    for (const std::uint32_t terminal : text_.of_name("IFCFLOWTERMINAL")) {
      if (lights_.contains(terminal)) continue;
      const auto type = type_.find(terminal);
      if (type == type_.end()) {
        left_out(terminal, "it has no type: it is not known whether it gives light");
      } else {
        note(DesignNote::Kind::not_asked, text_.name(terminal),
             fmt::format("it is of an {}, not a luminaire", text_.name(type->second)),
             place(terminal));
      }
    }
  }

  // Types of one name are told apart by their tags.
  void name_types() {
    std::map<std::string, std::vector<std::uint32_t>> of_name;
    std::set<std::uint32_t> used;
    for (const std::uint32_t fixture : lights_) {
      if (const auto type = type_.find(fixture); type != type_.end()) used.insert(type->second);
    }
    for (const std::uint32_t type : used) {
      const std::vector<StepValue> a = text_.arguments(type);
      std::string name = text_of(a, 2);
      if (name.empty()) name = text_of(a, 8);
      of_name[name].push_back(type);
      type_name_[type] = name;
    }
    for (const auto& [name, types] : of_name) {
      if (types.size() < 2 || name.empty()) continue;
      note(DesignNote::Kind::doubt, text_.name(types[0]),
           fmt::format("several types have the name '{}'; their tags are added", name),
           place(types[0]), types.size());
      for (const std::uint32_t type : types) {
        const std::string tag = text_of(text_.arguments(type), 7);
        type_name_[type] = fmt::format("{} ({})", name,
                                       tag.empty() ? fmt::format("#{}", text_.number(type)) : tag);
      }
    }
  }

  void luminaire(std::uint32_t fixture) {
    const std::vector<StepValue> a = file_.arguments(fixture, 7);
    const IfcTypeFrame type_frame = a[6].is_null() ? IfcTypeFrame() : ifc_type_frame(file_, a[6]);
    const glm::dmat4 world = placements_.world_from(a[5]) * type_frame.product_from_type;
    DesignLuminaire result;
    const auto type = type_.find(fixture);
    if (type != type_.end()) result.type = type_name_[type->second];
    if (result.type.empty()) result.type = text_of(a, 4);
    if (result.type.empty()) result.type = text_of(a, 2);
    if (result.type.empty()) throw IfcLeftOut{"neither it nor its type has a name"};
    result.position_m = glm::dvec3(world[3]);
    for (const double x : {result.position_m.x, result.position_m.y, result.position_m.z}) {
      if (!(std::fabs(x) <= kFarthestIfc)) throw IfcLeftOut{"it is too far away"};
    }
    result.has_height = true;
    const glm::dvec3 x(world[0]), y(world[1]), z(world[2]);
    result.rotation_deg = degrees_from_above(x);
    const bool is_left_handed = glm::dot(glm::cross(x, y), z) < 0.0;
    result.is_mirrored = is_left_handed != (z.z < 0.0);
    std::vector<std::string> doubt;
    if (!is_vertical(z)) {
      doubt.push_back(
          "its upright axis is tilted; only the turn of its x axis, seen from above, "
          "is taken");
    } else if (z.z < 0.0) {
      doubt.push_back("it is upside down; it is taken as mirrored, seen from above");
    }
    const std::string lower = calc::ascii_lowered(result.type + " " + text_of(a, 2));
    for (const std::string_view word : kSwitchWords) {
      if (lower.find(word) == std::string::npos) continue;
      doubt.push_back(
          fmt::format("its name or type says '{}', but the file calls it a light "
                      "fixture; leave the type '{}' out in the map if it gives no light",
                      word, result.type));
      break;
    }
    result.source = source(fixture, a);
    result.storey = storey_of(fixture);
    attributes(fixture, a, result);
    doubts(fixture, std::move(doubt));
    design_.luminaire.push_back(std::move(result));
  }

  void attributes(std::uint32_t fixture, const std::vector<StepValue>& a, DesignLuminaire& result) {
    std::set<std::string> known;
    std::size_t more = 0;
    const auto add = [&](std::string name, std::string value) {
      if (value.empty() || !known.insert(name).second) return;
      if (result.attribute.size() >= kMostAttributes) {
        ++more;
      } else {
        result.attribute.emplace_back(std::move(name), std::move(value));
      }
    };
    add("Tag", text_of(a, 7));
    if (a.size() > 8) add("PredefinedType", a[8].enumeration());
    if (const auto type = type_.find(fixture); type != type_.end()) {
      const std::vector<StepValue> b = text_.arguments(type->second);
      if (b.size() > 9) add("PredefinedType", b[9].enumeration());
    }
    for (const std::uint32_t set : sets_of(fixture)) {
      single_values(set, [&](const std::string& of, const std::string& name, std::string value) {
        add(of.empty() ? name : of + "." + name, std::move(value));
      });
    }
    if (more > 0) {
      note(DesignNote::Kind::left_out, "properties of a luminaire",
           fmt::format("more than {} of one luminaire", kMostAttributes), place(fixture), more);
    }
  }

  // --- furniture -------------------------------------------------------------------------------
  void furniture() {
    for (const std::string_view name : kFurniture) {
      for (const std::uint32_t thing : text_.of_name(name)) {
        file_.begin_product();
        try {
          box(thing);
        } catch (const IfcLeftOut& problem) {
          left_out(thing, problem.why);
        }
      }
    }
  }

  // Of a map once for all that use it.
  const IfcExtent& extent_of(const StepValue& representation, const IfcTypeFrame& type) {
    if (!type.map) return extent_ = ifc_extent(file_, representation, type);
    const auto found = extents_.find(*type.map);
    if (found != extents_.end()) return found->second;
    return extents_.emplace(*type.map, ifc_extent(file_, representation, type)).first->second;
  }

  void box(std::uint32_t thing) {
    const std::vector<StepValue> a = file_.arguments(thing, 7);
    const glm::dmat4 placed = placements_.world_from(a[5]);
    const IfcTypeFrame type = ifc_type_frame(file_, a[6]);
    const glm::dmat4 world = placed * type.product_from_type;
    const IfcExtent& extent = extent_of(a[6], type);
    std::vector<std::string> doubt = extent.doubt;
    doubt.push_back("it is taken as the upright box around its body");
    DesignBox result;
    const glm::dvec3 x(world[0]), z(world[2]);
    if (is_vertical(z) && z.z > 0.0) {
      const glm::dvec3 middle = 0.5 * (extent.low + extent.high);
      const glm::dvec3 y(world[1]);
      result.size_m = (extent.high - extent.low) *
                      glm::sqrt(glm::dvec3(glm::dot(x, x), glm::dot(y, y), glm::dot(z, z)));
      result.centre_m = glm::dvec3(world * glm::dvec4(middle.x, middle.y, extent.low.z, 1.0));
      result.rotation_deg = degrees_from_above(x);
    } else {
      doubt.push_back("it is tilted; its box has its sides along x and y");
      glm::dvec3 low(kFarthestIfc), high(-kFarthestIfc);
      for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec3 local((corner & 1u) != 0 ? extent.low.x : extent.high.x,
                               (corner & 2u) != 0 ? extent.low.y : extent.high.y,
                               (corner & 4u) != 0 ? extent.low.z : extent.high.z);
        const glm::dvec3 p(world * glm::dvec4(local, 1.0));
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
      result.size_m = high - low;
      result.centre_m = glm::dvec3(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z);
    }
    for (const glm::dvec3& v : {result.size_m, result.centre_m}) {
      if (!(std::fabs(v.x) <= kFarthestIfc && std::fabs(v.y) <= kFarthestIfc &&
            std::fabs(v.z) <= kFarthestIfc)) {
        throw IfcLeftOut{"it is too far away"};
      }
    }
    if (!(std::min({result.size_m.x, result.size_m.y, result.size_m.z}) > kSamePoint_m)) {
      throw IfcLeftOut{"its body is flat"};
    }
    result.source = source(thing, a);
    result.name = text_of(a, 2);
    doubts(thing, std::move(doubt));
    design_.box.push_back(std::move(result));
  }

  // --- the rest --------------------------------------------------------------------------------
  void passed_over() {
    for (const PassedOver& one : kPassedOver) {
      const auto all = text_.of_name(one.name);
      std::size_t count = 0;
      for (const std::uint32_t thing : all) count += lights_.contains(thing) ? 0u : 1u;
      if (count == 0) continue;
      note(DesignNote::Kind::not_asked, std::string(one.name), std::string(one.why),
           place(all.front()), count);
    }
    if (text_.of_name("IFCSPACE").empty()) {
      note(DesignNote::Kind::left_out, "rooms", "this file has no IFCSPACE", "");
    }
  }

  // Coordinates of surveys are large; whole metres of them go into the origin.
  void take_origin_away() {
    std::optional<glm::dvec3> low;
    const auto add = [&](const glm::dvec3& p) { low = low ? glm::min(*low, p) : p; };
    for (const DesignRoom& room : design_.room) {
      for (const glm::dvec2& p : room.outline_m) add(glm::dvec3(p, room.floor_z_m));
    }
    if (!low) {
      for (const DesignLuminaire& one : design_.luminaire) add(one.position_m);
      for (const DesignBox& one : design_.box) add(one.centre_m);
    }
    if (!low) return;
    glm::dvec3 origin(0.0);
    for (const glm::length_t i : {0, 1, 2}) {
      if (std::fabs((*low)[i]) > kFarOrigin_m) origin[i] = std::floor((*low)[i]);
    }
    design_.origin_m = origin;
    if (origin == glm::dvec3(0.0)) return;
    for (DesignRoom& room : design_.room) {
      const auto move = [&](std::vector<glm::dvec2>& ring) {
        for (glm::dvec2& p : ring) p -= glm::dvec2(origin);
      };
      move(room.outline_m);
      for (auto& hole : room.hole_m) move(hole);
      room.floor_z_m -= origin.z;
    }
    for (DesignLuminaire& one : design_.luminaire) one.position_m -= origin;
    for (DesignBox& one : design_.box) one.centre_m -= origin;
    note(DesignNote::Kind::taken, "origin",
         fmt::format("coordinates are far from zero; ({:.0f}, {:.0f}, {:.0f}) m is subtracted",
                     origin.x, origin.y, origin.z),
         "");
  }

  const StepText& text_;
  IfcFile file_;
  IfcPlacements placements_;
  Design design_;
  std::vector<DesignNote> notes_;
  std::map<std::tuple<DesignNote::Kind, std::string, std::string>, std::size_t> note_at_;
  std::set<std::string> keys_;
  std::set<const char*> unsure_;  // texts whose letters were doubted, by their places
  // By instance, which is by number: nothing here depends on a hash.
  std::map<std::uint32_t, std::uint32_t> type_, parent_;
  std::set<std::uint32_t> lights_, has_sets_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> sets_;
  std::map<std::uint32_t, std::string> type_name_;
  std::map<std::uint32_t, IfcExtent> extents_;  // of maps
  IfcExtent extent_;                            // of what has none
};

}  // namespace

std::optional<Design> read_ifc(std::string_view bytes, const std::string& name,
                               const IfcOptions& options, StepProblem& problem) {
  const std::optional<StepText> text = StepText::open(bytes, problem);
  if (!text) return std::nullopt;
  const std::string schema = text->schema().empty() ? "" : text->schema().front();
  if (!schema.starts_with("IFC2X") && !schema.starts_with("IFC4")) {
    problem = {0, fmt::format("the schema is '{}'; IFC2X3 and IFC4 are read",
                              calc::shorten_utf8(calc::printable(schema), 40))};
    return std::nullopt;
  }
  std::optional<IfcUnits> units = read_ifc_units(*text, problem);
  if (!units && !options.metres_per_unit) return std::nullopt;
  if (options.metres_per_unit) {
    const std::string stated = units ? units->name : "nothing that import can read";
    if (!units) units.emplace();
    set_length_unit(*units, *options.metres_per_unit);
    units->name = fmt::format("{:g} m", *options.metres_per_unit);
    units->reason = fmt::format("stated by the user; the file says {}", stated);
  }
  Design design = DesignReader(*text, std::move(*units)).read();
  design.file = name;
  return design;
}

}  // namespace cli
