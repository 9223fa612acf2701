#include "report/tools/import/project_text.h"

#include "calc/base/elementary.h"
#include "calc/base/file_hash.h"
#include "calc/base/text.h"
#include "calc/base/text_lengths.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/polygon.h"
#include "report/text/ifc_guid.h"
#include "report/text/markup.h"
#include "report/tools/import/design_notes.h"
#include "report/tools/import/design_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

// Of luminaires in a ceiling: in the very plane of it their light would not reach the room.
constexpr double kBelowCeiling_m = 0.01;
constexpr std::size_t kLongestName = 200;
constexpr const char* kHoleFolder = "holes";
constexpr std::size_t kHashDigits = 16;
// Of an id: before it stands what the thing is, and the room when an assembly copies it.
constexpr std::size_t kLongestPart = calc::kLongestId - 50;

double rounded(double value, double steps_per_unit) {
  return std::round(value * steps_per_unit) / steps_per_unit;
}

// "2.8", "0.3048", "-1": without zeros that say nothing.
std::string short_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}
std::string length_text(double metres) { return short_number(metres, 4); }

// As a part of an id.
std::string id_part(std::string_view text) {
  std::string id;
  for (const char c : text) {
    if (calc::is_id_character(c) && c != report::kDollarInId) {
      id += c;
    } else if (c == '$') {  // of a GlobalId, which an id cannot have: so that the way back is clear
      id += report::kDollarInId;
    } else if (!calc::is_utf8_continuation(c) && c != '*' && c != '?') {
      id += '_';
    }
  }
  if (id.size() > kLongestPart) id.erase(0, id.size() - kLongestPart);
  return id;
}

class Attributes {
 public:
  explicit Attributes(std::string_view element) : text_("<" + std::string(element)) {}
  Attributes& add(std::string_view name, std::string_view value) {
    text_ += fmt::format(" {}=\"{}\"", name, report::escape_html(value));
    return *this;
  }
  std::string closed() const { return text_ + "/>\n"; }
  std::string open() const { return text_ + ">\n"; }

 private:
  std::string text_;
};

class Writer {
 public:
  Writer(Design& design, const ImportMap& map, const std::vector<std::string>& photometry)
      : design_(design), map_(map), photometry_(photometry), notes_(design) {}

  ProjectText write() {
    inside_.resize(design_.room.size());
    const auto rooms_that_stay = fine_rooms();
    add_luminaires();
    add_boxes();
    add_lines(design_.plane, true);
    add_lines(design_.route, false);
    std::string rooms;
    for (const std::size_t i : rooms_that_stay) rooms += room_text(i);
    result_.xml = head() + rooms + "</luxgate>\n";
    return std::move(result_);
  }

 private:
  std::string own_id(const std::string& wanted) {
    const int times = ++used_[wanted];
    return times == 1 ? wanted : own_id(fmt::format("{}-{}", wanted, times));
  }
  void left_out(const std::string& what, const std::string& why, const DesignSource& source) {
    notes_.left_out(what, why, source.place);
  }

  // Becomes counter-clockwise.
  static void round_hole(std::vector<glm::dvec2>& hole) {
    for (glm::dvec2& corner : hole) corner = {rounded(corner.x, 1.0e4), rounded(corner.y, 1.0e4)};
    hole.erase(std::unique(hole.begin(), hole.end()), hole.end());
    while (hole.size() > 1 && hole.front() == hole.back()) hole.pop_back();
    if (calc::signed_area(hole) < 0.0) std::reverse(hole.begin(), hole.end());
    if (!is_rectangle(hole)) return;
    // So that boxes along the axes are not turned.
    while (!(hole[1].x > hole[0].x && hole[1].y >= hole[0].y)) {
      std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    }
  }

  // Those that can be written; corners are rounded.
  std::vector<std::size_t> fine_rooms() {
    std::vector<std::size_t> fine;
    is_fine_.assign(design_.room.size(), false);
    for (std::size_t i = 0; i < design_.room.size(); ++i) {
      DesignRoom& room = design_.room[i];
      for (glm::dvec2& corner : room.outline_m) {
        corner = {rounded(corner.x, 1.0e4), rounded(corner.y, 1.0e4)};
      }
      room.outline_m.erase(std::unique(room.outline_m.begin(), room.outline_m.end()),
                           room.outline_m.end());
      for (std::vector<glm::dvec2>& hole : room.hole_m) round_hole(hole);
      room.floor_z_m = rounded(room.floor_z_m, 1.0e4);
      if (!room.height_m && room.rule < map_.room.size()) {
        room.height_m = map_.room[room.rule].height_m;
      }
      if (room.rule >= map_.room.size()) {
        left_out("room", "the map has no [[room]] with its reflectances", room.source);
      } else if (!room.height_m) {
        left_out("room", "its height is not known", room.source);
      } else if (!calc::is_simple_polygon(room.outline_m)) {
        left_out("room", "its outline, rounded to 0.1 mm, is not valid", room.source);
      } else {
        is_fine_[i] = true;
        fine.push_back(i);
        ++result_.rooms;
      }
    }
    return fine;
  }

  // Of the room that a thing stands in, or why it is not written.
  std::optional<std::size_t> room_of(const glm::dvec3& at, const std::string& storey,
                                     const std::string& what, const DesignSource& source) {
    const std::optional<std::size_t> room = room_at(design_, at, at.z, storey);
    if (!room) {
      left_out(what, "it is not in a room", source);
    } else if (!is_fine_[*room]) {
      left_out(what, "its room is omitted", source);
      return std::nullopt;
    }
    return room;
  }

  std::string place_text(const glm::dvec3& at, const DesignRoom& room) const {
    return fmt::format("{} {} {}", length_text(at.x), length_text(at.y),
                       length_text(at.z - room.floor_z_m));
  }

  void add_luminaires() {
    const std::vector<std::string> types = type_ids();
    for (const DesignLuminaire& luminaire : design_.luminaire) {
      const std::string what = "luminaire " + luminaire.type;
      std::optional<std::size_t> rule = luminaire.rule;
      for (std::size_t i = 0; !rule && i < map_.luminaire.size(); ++i) {
        if (matches_bound_name(map_.luminaire[i].type, luminaire.type)) rule = i;
      }
      if (!rule) {
        left_out(what, "the map gives it no photometry", luminaire.source);
        continue;
      }
      if (photometry_[*rule].empty()) {
        left_out(what,
                 fmt::format("its photometry '{}' could not be read",
                             calc::printable(map_.luminaire[*rule].photometry)),
                 luminaire.source);
        continue;
      }
      glm::dvec3 at = luminaire.position_m;
      const std::optional<std::size_t> in =
          room_of(luminaire.has_height ? at : glm::dvec3(at.x, at.y, 0.0), luminaire.storey, what,
                  luminaire.source);
      if (!in) continue;
      if (!luminaire.has_height) {
        left_out(what, "its height is not known", luminaire.source);
        continue;
      }
      const DesignRoom& room = design_.room[*in];
      const double ceiling = room.floor_z_m + *room.height_m;
      if (at.z < room.floor_z_m || at.z > ceiling + 1.0e-3) {
        left_out(what,
                 at.z > ceiling ? "it is above the ceiling of its room"
                                : "it is below the floor of its room",
                 luminaire.source);
        continue;
      }
      if (at.z > ceiling - kBelowCeiling_m) {
        at.z = ceiling - kBelowCeiling_m;
        notes_.doubt("luminaire at the height of the ceiling",
                     "it is written 1 cm lower: in the plane of the ceiling its light would not "
                     "reach the room",
                     luminaire.source.place);
      }
      Attributes element("luminaire");
      element
          .add("id",
               own_id(std::string(report::kLuminaireIdPrefix) + id_part(luminaire.source.key)))
          .add("type", types[*rule])
          .add("position", place_text(at, room));
      const MapLuminaire& map = map_.luminaire[*rule];
      const double turn = std::fmod(luminaire.rotation_deg + map.turn_deg + 720.0, 360.0);
      const std::string rotation = short_number(turn, 3);
      if (rotation != "0" && rotation != "360") element.add("rotation", rotation);
      if (!map.group.empty()) {
        for (const auto& [name, value] : luminaire.attribute) {
          if (!matches_name(map.group, name) || calc::trim(value).empty()) continue;
          element.add("group", calc::trim(value));
          break;
        }
      }
      inside_[*in] += "    " + element.closed();
      used_types_.insert(*rule);
      ++result_.luminaires;
    }
    for (const std::size_t rule : used_types_) {
      const MapLuminaire& map = map_.luminaire[rule];
      Attributes element("luminaire-type");
      element.add("id", types[rule]).add("photometry", photometry_[rule]);
      if (map.flux_lm) element.add("flux-lm", short_number(*map.flux_lm, 3));
      if (map.power_w) element.add("power-w", short_number(*map.power_w, 3));
      if (map.maintenance_factor) {
        element.add("maintenance-factor", short_number(*map.maintenance_factor, 4));
      }
      types_text_ += "  " + element.closed();
    }
  }

  // By the names of the photometry files: they stay where others come and go.
  std::vector<std::string> type_ids() {
    std::vector<std::string> ids;
    for (const MapLuminaire& rule : map_.luminaire) {
      std::string stem = id_part(std::filesystem::path(rule.photometry).stem().string());
      if (stem.empty()) stem = "type";
      std::string id = stem;
      for (int times = 2; std::find(ids.begin(), ids.end(), id) != ids.end(); ++times) {
        id = fmt::format("{}-{}", stem, times);
      }
      ids.push_back(id);
    }
    return ids;
  }

  // The same name and reflectance are one material.
  std::string material(const std::string& of, double reflectance) {
    std::string& id = materials_[{of, reflectance}];
    if (id.empty()) {
      id = own_id(id_part(of));
      materials_text_ += "  " + Attributes("material")
                                    .add("id", id)
                                    .add("reflectance", short_number(reflectance, 4))
                                    .closed();
    }
    return id;
  }

  void add_boxes() {
    for (const DesignBox& box : design_.box) {
      const std::string what = "furniture " + box.name;
      if (box.rule >= map_.furniture.size()) {
        left_out(what, "the map has no [[furniture]] with its reflectance", box.source);
        continue;
      }
      const std::optional<std::size_t> in = room_of(box.centre_m, "", what, box.source);
      if (!in) continue;
      const DesignRoom& room = design_.room[*in];
      const double angle = calc::radians_from_degrees(box.rotation_deg);
      const glm::dvec2 x(calc::cos(angle), calc::sin(angle)), y(-x.y, x.x);
      const glm::dvec2 low =
          glm::dvec2(box.centre_m) - 0.5 * box.size_m.x * x - 0.5 * box.size_m.y * y;
      if (box.size_m.z >= *room.height_m) {
        left_out(what, "it is as high as its room", box.source);
        continue;
      }
      Attributes element("box");
      element.add("id", own_id("F-" + id_part(box.source.key)))
          .add("size", fmt::format("{} {} {}", length_text(box.size_m.x), length_text(box.size_m.y),
                                   length_text(box.size_m.z)))
          .add("position", place_text({low, box.centre_m.z}, room));
      const std::string rotation = short_number(box.rotation_deg, 3);
      if (rotation != "0" && rotation != "360") element.add("rotation", rotation);
      const MapFurniture& rule = map_.furniture[box.rule];
      element.add("material", material("furniture-" + (rule.type.empty() ? rule.layer : rule.type),
                                       rule.reflectance));
      inside_[*in] += "    " + element.closed();
      ++result_.boxes;
    }
  }

  void add_lines(const std::vector<DesignLine>& lines, bool is_plane) {
    for (const DesignLine& line : lines) {
      const std::string what = is_plane ? "plane" : "route";
      const bool has_rule = line.rule < (is_plane ? map_.plane.size() : map_.route.size());
      if (!has_rule) {
        left_out(what, "the map does not name it", line.source);
        continue;
      }
      glm::dvec3 middle(0.0);
      for (const glm::dvec3& point : line.point_m) middle += point;
      middle /= static_cast<double>(line.point_m.size());
      // A route belongs to the room where it begins; what leaves that is said by validate.
      const std::optional<std::size_t> in =
          room_of(is_plane ? middle : line.point_m.front(), "", what, line.source);
      if (!in) continue;
      const DesignRoom& room = design_.room[*in];
      std::string points;
      for (const glm::dvec3& point : line.point_m) {
        // Of routes as drawn, stairs too; in a flat plan they are on the floor.
        const double drawn = point.z - room.floor_z_m;
        const bool is_above = drawn > 0.0 && drawn < *room.height_m;
        const double z = is_plane ? map_.plane[line.rule].height_m : (is_above ? drawn : 0.0);
        points += fmt::format("{}{} {} {}", points.empty() ? "" : "  ", length_text(point.x),
                              length_text(point.y), length_text(z));
      }
      Attributes element(what);
      element.add("id", own_id((is_plane ? "P-" : "R-") + id_part(line.source.key)));
      if (!line.name.empty()) element.add("name", line.name);
      element.add("points", points);
      if (!is_plane) element.add("width", length_text(map_.route[line.rule].width_m));
      inside_[*in] += "    " + element.closed();
      ++(is_plane ? result_.planes : result_.routes);
    }
  }

  // Of the holes of a room, with the material of its walls.
  std::string holes_text(const DesignRoom& room, const std::string& walls) {
    std::string text;
    for (const std::vector<glm::dvec2>& hole : room.hole_m) {
      if (hole.size() < 3 || !calc::is_simple_polygon(hole)) {
        notes_.doubt("room", "a hole in its outline is filled: rounded to 0.1 mm it has no area",
                     room.source.place);
        continue;
      }
      notes_.doubt("room",
                   "a hole in its outline is written as a solid as high as the room, with the "
                   "reflectance of the walls; areas of the floor (W/m2, LENI) still count it",
                   room.source.place);
      Attributes element(is_rectangle(hole) ? "box" : "mesh");
      element.add("id", own_id("H-" + id_part(room.source.key)));
      if (is_rectangle(hole)) {
        const glm::dvec2 side = hole[1] - hole[0];
        element
            .add("size", fmt::format("{} {} {}", length_text(glm::length(side)),
                                     length_text(glm::distance(hole[0], hole[3])),
                                     length_text(*room.height_m)))
            .add("position",
                 fmt::format("{} {} 0", length_text(hole[0].x), length_text(hole[0].y)));
        const double turn = calc::degrees_from_radians(calc::atan2(side.y, side.x));
        const std::string rotation = short_number(std::fmod(turn + 360.0, 360.0), 3);
        if (rotation != "0" && rotation != "360") element.add("rotation", rotation);
      } else {
        const std::string bytes = prism_obj(hole, length_text(*room.height_m));
        const std::string name =
            fmt::format("{}/{}.obj", kHoleFolder, calc::sha256_hex(bytes).substr(0, kHashDigits));
        if (std::none_of(result_.file.begin(), result_.file.end(),
                         [&](const ProjectText::File& file) { return file.name == name; })) {
          result_.file.push_back({name, bytes});
        }
        element.add("file", name).add("units", "m").add("up", "z");
      }
      text += "    " + element.add("material", walls).closed();
    }
    return text;
  }

  static bool is_rectangle(const std::vector<glm::dvec2>& corner) {
    if (corner.size() != 4) return false;
    constexpr double kSame_m = 1.5e-4;  // corners are rounded to 0.1 mm
    const glm::dvec2 u = corner[1] - corner[0], v = corner[3] - corner[0];
    return glm::distance(corner[2] - corner[1], v) <= kSame_m &&
           std::fabs(glm::dot(u, v)) <= kSame_m * std::min(glm::length(u), glm::length(v));
  }

  // Closed, its faces looking outwards.
  static std::string prism_obj(const std::vector<glm::dvec2>& base, const std::string& height) {
    std::string text;
    const std::size_t count = base.size();
    for (const std::string& z : {std::string("0"), height}) {
      for (const glm::dvec2& corner : base) {
        text += fmt::format("v {} {} {}\n", length_text(corner.x), length_text(corner.y), z);
      }
    }
    for (const glm::uvec3& t :
         calc::triangulate_polygon(base).value_or(std::vector<glm::uvec3>())) {
      text += fmt::format("f {} {} {}\n", t.z + 1, t.y + 1, t.x + 1);
      text += fmt::format("f {} {} {}\n", count + t.x + 1, count + t.y + 1, count + t.z + 1);
    }
    for (std::size_t i = 1; i <= count; ++i) {
      const std::size_t next = i % count + 1;
      text += fmt::format("f {} {} {} {}\n", i, next, count + next, count + i);
    }
    return text;
  }

  std::string room_text(std::size_t index) {
    const DesignRoom& room = design_.room[index];
    const MapRoom& rule = map_.room[room.rule];
    Attributes element("room");
    element.add("id", own_id(std::string(report::kRoomIdPrefix) + id_part(room.source.key)));
    const std::string name =
        room.number + (room.number.empty() || room.name.empty() ? "" : " ") + room.name;
    if (!name.empty()) element.add("name", calc::shorten_utf8(name, kLongestName));
    if (room.floor_z_m != 0.0) {
      element.add("origin", fmt::format("0 0 {}", length_text(room.floor_z_m)));
    }
    std::string corners;
    for (const glm::dvec2& corner : room.outline_m) {
      corners += fmt::format("{}{} {}", corners.empty() ? "" : "  ", length_text(corner.x),
                             length_text(corner.y));
    }
    element.add("footprint", corners).add("height", length_text(*room.height_m));
    const std::string& of = rule.layer;
    element.add("ceiling", material(of + "-ceiling", rule.ceiling));
    const std::string walls = material(of + "-walls", rule.walls);
    element.add("walls", walls).add("floor", material(of + "-floor", rule.floor));
    const std::string inside = inside_[index] + holes_text(room, walls);
    if (inside.empty()) return "  " + element.closed();
    return "  " + element.open() + inside + "  </room>\n";
  }

  std::string head() const {
    std::string file(calc::printable(std::filesystem::path(design_.file).filename().string()));
    // Two dashes would end a comment.
    for (std::size_t at = file.find("--"); at != file.npos; at = file.find("--")) {
      file.replace(at, 2, "-_");
    }
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<!-- Begun by 'luxgate import' from " +
        file +
        ". Change whatever you want: the next import keeps that.\n     Ids connect objects with "
        "the drawing: keep them. -->\n";
    Attributes root("luxgate");
    root.add("version", "1");
    if (!map_.name.empty()) root.add("name", map_.name);
    return text + root.open() + materials_text_ + types_text_;
  }

  Design& design_;
  const ImportMap& map_;
  const std::vector<std::string>& photometry_;
  DesignNotes notes_;
  ProjectText result_;
  std::vector<bool> is_fine_;
  std::vector<std::string> inside_;  // elements of each room
  std::string materials_text_, types_text_;
  std::map<std::pair<std::string, double>, std::string> materials_;  // ids
  std::set<std::size_t> used_types_;
  std::map<std::string, int> used_;
};

}  // namespace

ProjectText project_text(Design& design, const ImportMap& map,
                         const std::vector<std::string>& photometry) {
  return Writer(design, map, photometry).write();
}

}  // namespace cli
