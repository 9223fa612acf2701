#include "report/tools/import/dxf_design.h"

#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/project/reading/project_elements.h"
#include "calc/scene/polygon.h"
#include "calc/scene/polygon_mend.h"
#include "report/tools/import/design_heights.h"
#include "report/tools/import/design_notes.h"
#include "report/tools/import/design_rooms.h"
#include "report/tools/import/dxf_outlines.h"
#include "report/tools/import/dxf_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

namespace cli {
namespace {

constexpr double kLowestArea_m2 = 1.0, kHighestArea_m2 = 1.0e5;
constexpr double kOnePlace_m = 1.0e-4;  // parts of one luminaire
constexpr double kNameReach_m = 0.5;    // of a text beside an outline
constexpr double kFarAway_m = 1000.0;   // origins are multiples of it
// So that no file takes all memory or time.
constexpr std::size_t kMostPoints = 5'000'000;  // of lines that may be outlines
constexpr std::size_t kMostRooms = 5000;
constexpr std::size_t kMostThings = 100'000;        // luminaires, furniture, texts: of each
constexpr std::size_t kMostCurveWork = 50'000'000;  // as corner_work() counts
constexpr std::size_t kMostText = 100'000'000;      // bytes that copies of texts take
constexpr double kMostLooks = 2.0e10;               // at corners of rooms, for what stands in them
constexpr std::size_t kMostComparisons = 50'000'000;  // of corners of rooms with other rooms
constexpr double kFarthest = 1.0e12;                  // in the file's unit

using Kind = DxfEntity::Kind;

bool is_outline_kind(Kind kind) {
  return kind == Kind::line || kind == Kind::polyline || kind == Kind::arc ||
         kind == Kind::circle || kind == Kind::curve;
}
bool is_surface_kind(Kind kind) { return kind == Kind::outline || kind == Kind::face; }

// DLX_BLD1_FL0_CONT: "BLD1_FL0".
std::string storey_of(const std::string& layer) {
  constexpr std::string_view kStart = "DLX_", kStorey = "_FL";
  if (layer.compare(0, kStart.size(), kStart) != 0 || layer.find(kStorey) == layer.npos) return "";
  const std::size_t end = layer.find('_', layer.find(kStorey) + 1);
  return layer.substr(kStart.size(), end == layer.npos ? layer.npos : end - kStart.size());
}

// x axis in the plan, degrees from 0 up to 360.
double rotation_of(const glm::dmat4& matrix) {
  const double degrees = calc::degrees_from_radians(calc::atan2(matrix[0].y, matrix[0].x));
  const double turn = degrees < 0.0 ? degrees + 360.0 : degrees;
  return turn >= 360.0 ? 0.0 : turn;
}
bool is_mirrored(const glm::dmat4& matrix) {
  return matrix[0].x * matrix[1].y - matrix[0].y * matrix[1].x < 0.0;
}
bool is_upright(const glm::dmat4& matrix) {
  const glm::dvec3 x(matrix[0]), y(matrix[1]);
  const glm::dvec3 up = glm::cross(x, y);
  const double length = glm::length(up);
  return length > 0.0 && std::fabs(up.z) > (1.0 - 1.0e-6) * length;
}
bool is_near(const glm::dvec3& at) {
  return std::fabs(at.x) < kFarthest && std::fabs(at.y) < kFarthest && std::fabs(at.z) < kFarthest;
}

// With one digit, so that things alike are said once.
double one_digit_up(double value) {
  if (!std::isfinite(value)) return value;
  double step = 1.0e-9;
  while (step * 10.0 <= value) step *= 10.0;
  return std::ceil(value / step) * step;
}

class Builder {
 public:
  Builder(const DxfDrawing& drawing, const ImportMap& map) : drawing_(drawing), map_(map) {}

  std::optional<Design> build(const std::string& file, const std::string& unit_option,
                              std::string& problem) {
    design_.file = file;
    room_.resize(map_.room.size());
    plane_.resize(map_.plane.size());
    route_.resize(map_.route.size());
    problem = sort_entities();
    if (problem.empty()) {
      check_counts();
      problem = problem_;
    }
    if (!problem.empty()) return std::nullopt;
    const ImportUnit unit = choose_unit(unit_option.empty() ? map_.unit : unit_option,
                                        unit_option.empty() ? "the map" : "--unit", drawing_.unit,
                                        is_dialux_, rough_areas());
    if (!unit.problem.empty()) {
      problem = unit.problem;
      return std::nullopt;
    }
    design_.unit = unit.name;
    design_.unit_reason = unit.reason;
    metres_ = *metres_per_import_unit(unit.name);
    points_ = 0;
    work_ = 0;
    add_rooms();
    check_looks();
    if (!problem_.empty()) {
      problem = problem_;
      return std::nullopt;
    }
    move_origin();
    add_names();
    say_sizes();
    add_luminaires();
    add_furniture();
    add_lines(plane_, map_.plane, true, design_.plane);
    add_lines(route_, map_.route, false, design_.route);
    say_the_rest();
    if (!problem_.empty()) {
      problem = problem_;
      return std::nullopt;
    }
    return std::move(design_);
  }

 private:
  struct Pieces {
    std::vector<DxfPlaced> outline, surface;
  };
  struct Block {
    DxfPlaced placed;
    std::size_t rule;
  };

  void check_counts() {
    const std::pair<std::size_t, const char*> counts[] = {
        {luminaire_.size(), "luminaires"},
        {furniture_.size(), "pieces of furniture"},
        {text_.size(), "names of rooms"}};
    for (const auto& [count, what] : counts) {
      if (count > kMostThings) {
        problem_ = fmt::format("this drawing has more than {} {}", kMostThings, what);
      }
    }
  }

  // Everything looks for its room among all of them.
  void check_looks() {
    double corners = 0.0;
    for (const DesignRoom& room : design_.room) {
      corners += static_cast<double>(room.outline_m.size());
      for (const auto& hole : room.hole_m) corners += static_cast<double>(hole.size());
    }
    const std::size_t things = luminaire_.size() + furniture_.size() + text_.size();
    if (problem_.empty() && corners * static_cast<double>(things) > kMostLooks) {
      problem_ = fmt::format(
          "finding the room of {} luminaires, pieces of furniture and texts among rooms of {:.0f} "
          "corners takes too long",
          things, corners);
    }
  }

  // False, with the problem: copies of texts take too much memory.
  bool has_memory_for(std::size_t bytes) {
    text_bytes_ += bytes;
    if (text_bytes_ > kMostText && problem_.empty()) {
      problem_ = fmt::format("names and attributes, with all blocks, are more than {} bytes long",
                             kMostText);
    }
    return text_bytes_ <= kMostText;
  }

  std::string place_of(const DxfPlaced& placed) const {
    return fmt::format("layer {}, {}", placed.layer, drawing_.place_words(placed.entity->place));
  }

  // Of a thing at this place, in metres: stays the same where the file has no handles.
  std::string key_of(const DxfPlaced& placed, const glm::dvec3& at, bool has_z) {
    std::string key = placed.key;
    if (key.empty()) {
      key = fmt::format("at_{:.0f}_{:.0f}", at.x * 100.0, at.y * 100.0);
      if (has_z) key += fmt::format("_{:.0f}", at.z * 100.0);
    }
    return own_key(key);
  }
  std::string own_key(const std::string& wanted) {
    const int times = ++used_[wanted];
    return times == 1 ? wanted : own_key(fmt::format("{}-{}", wanted, times));
  }

  bool is_ignored(const std::string& layer) const {
    return std::any_of(map_.ignore.begin(), map_.ignore.end(), [&](const std::string& pattern) {
      return matches_bound_name(pattern, layer);
    });
  }
  // Whether the map asks for something on this layer by its name.
  bool is_asked(const std::string& layer) const {
    const auto is_of = [&](const std::string& pattern) {
      return !pattern.empty() && matches_bound_name(pattern, layer);
    };
    const auto any = [&](const auto& rules) {
      return std::any_of(rules.begin(), rules.end(),
                         [&](const auto& rule) { return is_of(rule.layer); });
    };
    return any(map_.room) || any(map_.luminaire) || any(map_.furniture) || any(map_.plane) ||
           any(map_.route);
  }

  std::string sort_entities() {
    return visit_dxf(
        drawing_, [&](const DxfPlaced& placed) { return sort(placed); }, skipped_);
  }

  // Whether to go into a block.
  bool sort(const DxfPlaced& placed) {
    const DxfEntity& entity = *placed.entity;
    if (is_ignored(placed.layer)) return false;
    is_dialux_ = is_dialux_ || placed.layer.compare(0, 4, "DLX_") == 0;
    if (entity.kind == Kind::insert) return sort_block(placed);
    bool is_taken = false;
    if (entity.kind == Kind::text) {
      for (const MapRoom& room : map_.room) {
        if (!matches_bound_name(room.names, placed.layer)) continue;
        text_.push_back(placed);
        is_taken = true;
        break;
      }
    }
    const auto take = [&](const auto& rules, std::vector<Pieces>& pieces) {
      for (std::size_t i = 0; i < rules.size(); ++i) {
        if (!matches_bound_name(rules[i].layer, placed.layer)) continue;
        if (is_outline_kind(entity.kind)) {
          pieces[i].outline.push_back(placed);
        } else if (is_surface_kind(entity.kind)) {
          pieces[i].surface.push_back(placed);
        } else {
          continue;
        }
        is_taken = true;
        return;
      }
    };
    take(map_.room, room_);
    take(map_.plane, plane_);
    take(map_.route, route_);
    if (entity.kind == Kind::polyline || entity.kind == Kind::mesh) {
      for (std::size_t i = 0; i < map_.furniture.size(); ++i) {
        const MapFurniture& rule = map_.furniture[i];
        if (!rule.type.empty() || !matches_bound_name(rule.layer, placed.layer)) continue;
        furniture_.push_back({placed, i});
        is_taken = true;
        break;
      }
    }
    if (is_taken) return true;
    if (entity.kind == Kind::face && is_furniture_layer(placed.layer)) {
      ++skipped_[{"3DFACE, SOLID or TRACE", placed.layer,
                  "loose faces are not furniture; make a block of them"}];
      return true;
    }
    if (entity.kind == Kind::polyline && matches_name("DLX_*LUM*", placed.layer)) ++loose_;
    ++not_asked_[{"lines, texts and surfaces", placed.layer}];
    return true;
  }

  bool is_furniture_layer(const std::string& layer) const {
    return std::any_of(map_.furniture.begin(), map_.furniture.end(), [&](const MapFurniture& rule) {
      return rule.type.empty() && matches_bound_name(rule.layer, layer);
    });
  }

  bool sort_block(const DxfPlaced& placed) {
    const std::string& name = placed.entity->block;
    const auto matches = [&](const auto& rule) {
      return (rule.type.empty() || matches_bound_name(rule.type, name)) &&
             (rule.layer.empty() || matches_bound_name(rule.layer, placed.layer));
    };
    const auto found = std::find_if(map_.luminaire.begin(), map_.luminaire.end(), matches);
    if (found != map_.luminaire.end()) {
      luminaire_.push_back({placed, static_cast<std::size_t>(found - map_.luminaire.begin())});
      return false;
    }
    const auto box = std::find_if(map_.furniture.begin(), map_.furniture.end(), matches);
    if (box != map_.furniture.end()) {
      furniture_.push_back({placed, static_cast<std::size_t>(box - map_.furniture.begin())});
      return false;
    }
    if (placed.entity->is_clipped) ++clipped_;
    ++not_asked_[{fmt::format("block {}", name), placed.layer}];
    return true;
  }

  // In the file's unit.
  std::vector<double> rough_areas() {
    std::vector<double> areas;
    for (std::size_t i = 0; i < room_.size(); ++i) {
      const bool has_outlines = !room_[i].outline.empty();
      std::vector<PlanPiece> pieces;
      glm::dvec2 low(kFarthest), high(-kFarthest);
      for (const DxfPlaced& placed : has_outlines ? room_[i].outline : room_[i].surface) {
        for (std::size_t k = 0; k < placed.entity->vertex.size(); ++k) {
          const double around = placed.entity->radius * glm::length(glm::dvec3(placed.to_world[0]));
          low = glm::min(low, glm::dvec2(placed.at(k)) - around);
          high = glm::max(high, glm::dvec2(placed.at(k)) + around);
        }
      }
      const double size = glm::length(high - low);
      if (!std::isfinite(size) || size > kFarthest) continue;
      for (const DxfPlaced& placed : has_outlines ? room_[i].outline : room_[i].surface) {
        add_piece(placed, 1.0e-4 * size, 1.0, pieces);
      }
      for (const PlanOutline& outline :
           find_outlines(pieces, std::max(1.0e-6 * size, 1.0e-12), map_.room[i].closes).outline) {
        areas.push_back(calc::signed_area(outline.corner));
      }
    }
    return areas;
  }

  // error: in the file's unit, as is what its chords have reached. False: it is too far away.
  bool add_piece(const DxfPlaced& placed, double error, double scale,
                 std::vector<PlanPiece>& pieces, double* reached = nullptr) {
    PlanPiece piece;
    if (placed.entity->vertex.empty() || !problem_.empty()) return true;
    work_ += corner_work(*placed.entity);
    if (work_ > kMostCurveWork) {
      problem_ = "following the lines and curves that may be outlines takes too long";
      return true;
    }
    const std::vector<glm::dvec3> points = placed.corners(error, reached);
    points_ += points.size();
    if (points_ > kMostPoints) {
      problem_ =
          fmt::format("the lines that may be outlines have more than {} corners", kMostPoints);
      return true;
    }
    for (const glm::dvec3& point : points) {
      if (!is_near(point)) return false;
      piece.point.push_back(point * scale);
    }
    piece.is_closed = placed.entity->is_closed;
    piece.key = placed.key;
    piece.place = place_of(placed);
    if (placed.entity->kind == Kind::outline) piece.shape = placed.entity->place;
    pieces.push_back(std::move(piece));
    return true;
  }

  std::vector<PlanPiece> pieces_of(const std::vector<DxfPlaced>& list, const std::string& what) {
    std::vector<PlanPiece> pieces;
    for (const DxfPlaced& placed : list) {
      const double error = kChordError_m / metres_;
      double reached = error;
      if (!add_piece(placed, error, metres_, pieces, &reached)) {
        notes_.left_out(what, "it is too far away", place_of(placed));
      } else if (reached > error) {
        notes_.doubt(what,
                     fmt::format("one of its arcs or curves is so large that its chords are up to "
                                 "{:g} m from it, not {:g} m",
                                 one_digit_up(reached * metres_), kChordError_m),
                     place_of(placed));
      }
    }
    return pieces;
  }

  void say_failures(const PlanOutlines& found, const std::string& what) {
    for (const PlanOutlines::Failure& failure : found.failure) {
      notes_.left_out(what, failure.why, failure.place, failure.count);
    }
  }

  void add_rooms() {
    for (std::size_t i = 0; i < room_.size(); ++i) {
      const MapRoom& rule = map_.room[i];
      const std::string what = fmt::format("outline of a room on {}", rule.layer);
      const bool has_outlines = !room_[i].outline.empty();
      if (has_outlines && !room_[i].surface.empty()) {
        notes_.add(DesignNote::Kind::not_asked, fmt::format("surfaces on {}", rule.layer),
                   "layers with lines, which count", "", room_[i].surface.size());
      }
      const std::vector<DxfPlaced>& list = has_outlines ? room_[i].outline : room_[i].surface;
      const PlanOutlines found = find_outlines(pieces_of(list, what), kSamePlace_m, rule.closes);
      say_failures(found, what);
      add_rooms_of(found.outline, i);
      if (found.outline.empty()) {
        notes_.left_out(
            "rooms",
            fmt::format("no closed outline is on a layer {}{}", rule.layer,
                        rule.closes || list.empty() ? "" : "; if they are open, see 'close'"),
            fmt::format("map line {}", rule.line));
      }
    }
  }

  // Loops of a hatch that lie in another one of it are holes, those in holes rooms again.
  void add_rooms_of(const std::vector<PlanOutline>& outlines, std::size_t rule) {
    std::map<std::size_t, std::vector<std::size_t>> loops;  // by hatch
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (outlines[i].shape != 0) loops[outlines[i].shape].push_back(i);
    }
    // Around each outline: how many, and the smallest.
    std::vector<std::size_t> depth(outlines.size(), 0), around(outlines.size(), outlines.size());
    std::size_t comparisons = 0;
    for (const auto& [shape, list] : loops) {
      for (const std::size_t i : list) {
        for (const std::size_t k : list) {
          comparisons += outlines[k].corner.size();
          if (comparisons > kMostComparisons) {
            problem_ = "comparing the loops of hatches with each other takes too long";
            return;
          }
          if (i == k || !is_within(outlines[i].corner, outlines[k].corner, comparisons)) continue;
          ++depth[i];
          if (around[i] == outlines.size() || calc::signed_area(outlines[k].corner) <
                                                  calc::signed_area(outlines[around[i]].corner)) {
            around[i] = k;
          }
        }
      }
    }
    std::vector<std::size_t> room_of(outlines.size(), 0);
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (depth[i] % 2 != 0) continue;
      room_of[i] = design_.room.size();
      add_room(outlines[i], rule);
      if (!problem_.empty()) return;
    }
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (depth[i] % 2 == 0) continue;
      std::vector<glm::dvec2> hole = outlines[i].corner;
      std::reverse(hole.begin(), hole.end());
      design_.room[room_of[around[i]]].hole_m.push_back(std::move(hole));
    }
  }

  // Smaller, and no corner outside.
  static bool is_within(const std::vector<glm::dvec2>& inner, const std::vector<glm::dvec2>& outer,
                        std::size_t& comparisons) {
    if (!(calc::enclosed_area(inner) < calc::enclosed_area(outer))) return false;
    return std::all_of(inner.begin(), inner.end(), [&](const glm::dvec2& corner) {
      comparisons += outer.size();
      return calc::contains_point(outer, corner);
    });
  }

  void add_room(const PlanOutline& outline, std::size_t rule) {
    const MapRoom& map = map_.room[rule];
    if (design_.room.size() == kMostRooms) {
      problem_ = fmt::format("this drawing has more than {} rooms", kMostRooms);
      return;
    }
    DesignRoom room;
    room.rule = rule;
    room.outline_m = outline.corner;
    room.height_m = map.height_m;
    room.floor_z_m = map.floor_z_m.value_or(outline.z);
    room.source.place = outline.place;
    const std::string layer = outline.place.substr(6, outline.place.rfind(", ") - 6);
    room.storey = storey_of(layer);
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& corner : outline.corner) middle += corner;
    middle /= static_cast<double>(outline.corner.size());
    room.source.key = own_key(
        !outline.key.empty() ? outline.key
                             : fmt::format("at_{:.0f}_{:.0f}", middle.x * 100.0, middle.y * 100.0));
    if (!outline.mended.empty()) {
      notes_.doubt("outline of a room", "it was repaired: " + outline.mended, outline.place);
    }
    if (!outline.is_level && !map.floor_z_m) {
      notes_.doubt("outline of a room", "it is not level: its lowest corner counts as the floor",
                   outline.place);
    }
    design_.room.push_back(std::move(room));
  }

  void move_origin() {
    glm::dvec2 low(kFarthest);
    for (const DesignRoom& room : design_.room) {
      for (const glm::dvec2& corner : room.outline_m) low = glm::min(low, corner);
    }
    if (design_.room.empty()) return;
    for (const int axis : {0, 1}) {
      if (std::fabs(low[axis]) >= kFarAway_m) {
        design_.origin_m[axis] = std::floor(low[axis] / kFarAway_m) * kFarAway_m;
      }
    }
    for (DesignRoom& room : design_.room) {
      for (glm::dvec2& corner : room.outline_m) corner -= glm::dvec2(design_.origin_m);
      for (std::vector<glm::dvec2>& hole : room.hole_m) {
        for (glm::dvec2& corner : hole) corner -= glm::dvec2(design_.origin_m);
      }
    }
  }

  glm::dvec3 in_metres(const glm::dvec3& at) const { return at * metres_ - design_.origin_m; }

  // A text in an outline names the room; one close beside a single outline does so where nothing is
  // in it: DIALux writes there. Several are read from the top down.
  void add_names() {
    struct Found {
      double y, x;
      std::string text;
    };
    std::vector<std::vector<Found>> inside(design_.room.size()), beside(design_.room.size());
    for (const DxfPlaced& placed : text_) {
      const glm::dvec3 at = in_metres(placed.at(0));
      const std::string storey = storey_of(placed.layer);
      if (placed.entity->text.empty() || !is_near(at)) continue;
      if (!has_memory_for(placed.entity->text.size())) return;
      if (const std::optional<std::size_t> room = room_at(design_, at, std::nullopt, storey)) {
        inside[*room].push_back({at.y, at.x, placed.entity->text});
        continue;
      }
      std::vector<std::size_t> close;
      for (std::size_t i = 0; i < design_.room.size(); ++i) {
        const DesignRoom& room = design_.room[i];
        if ((storey.empty() || room.storey.empty() || room.storey == storey) &&
            calc::distance_to_boundary(room.outline_m, at) <= kNameReach_m) {
          close.push_back(i);
        }
      }
      if (close.size() == 1) {
        beside[close[0]].push_back({at.y, at.x, placed.entity->text});
      } else {
        notes_.add(DesignNote::Kind::not_asked, "text of a room's name", "it is not in a room",
                   place_of(placed));
      }
    }
    for (std::size_t i = 0; i < design_.room.size(); ++i) {
      std::vector<Found>& texts = inside[i].empty() ? beside[i] : inside[i];
      std::sort(texts.begin(), texts.end(), [](const Found& a, const Found& b) {
        return std::tie(b.y, a.x, a.text) < std::tie(a.y, b.x, b.text);
      });
      for (const Found& found : texts) {
        design_.room[i].name += (design_.room[i].name.empty() ? "" : " ") + found.text;
      }
    }
  }

  void say_sizes() {
    for (const DesignRoom& room : design_.room) {
      const double area = calc::signed_area(room.outline_m);
      if (area >= kLowestArea_m2 && area <= kHighestArea_m2) continue;
      notes_.doubt(
          "room",
          fmt::format("its area would be {:.3g} m2: check the unit, {}", area, design_.unit),
          room.source.place);
    }
    say_rooms_in_rooms();
  }

  void say_rooms_in_rooms() {
    struct Box {
      glm::dvec2 low, high;
    };
    std::vector<Box> boxes;
    for (const DesignRoom& room : design_.room) {
      Box box{room.outline_m[0], room.outline_m[0]};
      for (const glm::dvec2& corner : room.outline_m) {
        box = {glm::min(box.low, corner), glm::max(box.high, corner)};
      }
      boxes.push_back(box);
    }
    std::size_t comparisons = 0;
    for (std::size_t i = 0; i < design_.room.size(); ++i) {
      const DesignRoom& room = design_.room[i];
      for (std::size_t k = 0; k < design_.room.size(); ++k) {
        const DesignRoom& other = design_.room[k];
        if (k == i || other.storey != room.storey || other.floor_z_m != room.floor_z_m) continue;
        const double near = kSamePlace_m;
        if (boxes[k].low.x < boxes[i].low.x - near || boxes[k].low.y < boxes[i].low.y - near ||
            boxes[k].high.x > boxes[i].high.x + near || boxes[k].high.y > boxes[i].high.y + near) {
          continue;
        }
        const bool is_inside = std::all_of(other.outline_m.begin(), other.outline_m.end(),
                                           [&](const glm::dvec2& corner) {
                                             comparisons += room.outline_m.size();
                                             return calc::contains_point(room.outline_m, corner);
                                           });
        if (comparisons > kMostComparisons) {
          notes_.doubt("rooms",
                       "not all were compared, because their outlines have too many corners: one "
                       "may be inside another",
                       "");
          return;
        }
        const bool is_in_hole = std::any_of(room.hole_m.begin(), room.hole_m.end(),
                                            [&](const std::vector<glm::dvec2>& hole) {
                                              return is_within(other.outline_m, hole, comparisons);
                                            });
        if (!is_inside || is_in_hole ||
            (k < i && calc::signed_area(other.outline_m) == calc::signed_area(room.outline_m))) {
          continue;
        }
        notes_.doubt("room",
                     "its outline is inside that of another room: both are written, and objects in "
                     "it belong only to it",
                     other.source.place);
      }
    }
  }

  void add_luminaires() {
    std::vector<std::size_t> of_rule(map_.luminaire.size(), 0);
    // Luminaires by their places, to find parts of one.
    std::map<std::tuple<std::size_t, std::int64_t, std::int64_t, std::int64_t>,
             std::vector<std::size_t>>
        cells;
    for (const Block& block : luminaire_) {
      const DxfPlaced& placed = block.placed;
      const MapLuminaire& rule = map_.luminaire[block.rule];
      ++of_rule[block.rule];
      const std::string what = fmt::format("luminaire {}", placed.entity->block);
      const glm::dvec3 at = in_metres(placed.at(0));
      if (!is_near(at / metres_)) {
        notes_.left_out(what, "it is too far away", place_of(placed));
        continue;
      }
      if (!is_upright(placed.to_world)) {
        notes_.left_out(what, "it is tilted, and the block of a plan does not define the tilt",
                        place_of(placed));
        continue;
      }
      const std::optional<std::size_t> part = same_place(cells, block.rule, at);
      if (part) {
        ++parts_;
        if (std::fabs(design_.luminaire[*part].rotation_deg - rotation_of(placed.to_world)) >
            0.01) {
          notes_.doubt(what, "several are at the same place, turned differently: the first counts",
                       place_of(placed));
        }
        add_attributes(placed, design_.luminaire[*part]);
        continue;
      }
      std::size_t bytes = placed.entity->block.size();
      for (const auto& [name, value] : placed.entity->attribute)
        bytes += name.size() + value.size();
      if (!has_memory_for(bytes)) return;
      DesignLuminaire luminaire;
      luminaire.rule = block.rule;
      luminaire.source = {key_of(placed, at, true), place_of(placed)};
      luminaire.type = placed.entity->block;
      luminaire.storey = storey_of(placed.layer);
      luminaire.position_m = at;
      luminaire.rotation_deg = rotation_of(placed.to_world);
      luminaire.is_mirrored = is_mirrored(placed.to_world);
      add_attributes(placed, luminaire);
      set_height(rule, luminaire);
      if (luminaire.is_mirrored) {
        notes_.doubt(what, "it is mirrored in the drawing; its light is turned but not mirrored",
                     place_of(placed));
      }
      design_.luminaire.push_back(std::move(luminaire));
    }
    for (std::size_t i = 0; i < of_rule.size(); ++i) {
      if (of_rule[i] != 0) continue;
      notes_.left_out(
          "luminaires",
          fmt::format(
              "the drawing has no block {}{}", map_.luminaire[i].type,
              map_.luminaire[i].layer.empty() ? "" : " on a layer " + map_.luminaire[i].layer),
          fmt::format("map line {}", map_.luminaire[i].line));
    }
    if (parts_ > 0) {
      notes_.add(DesignNote::Kind::taken, "block at the place of another one",
                 "they are parts of a luminaire, or it was drawn twice", "", parts_);
    }
    if (loose_ > 0) {
      notes_.left_out("lines of luminaires",
                      "they are not blocks: export from DIALux while a 3-D view is active",
                      "layers DLX_*LUM*", loose_);
    }
  }

  template <class Cells>
  std::optional<std::size_t> same_place(Cells& cells, std::size_t rule, const glm::dvec3& at) {
    std::array<std::int64_t, 3> cell{};
    for (int i = 0; i < 3; ++i) {
      cell[static_cast<std::size_t>(i)] =
          static_cast<std::int64_t>(std::floor(at[i] / kOnePlace_m));
    }
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = cells.find({rule, cell[0] + x, cell[1] + y, cell[2] + z});
          if (found == cells.end()) continue;
          for (const std::size_t index : found->second) {
            if (glm::distance(place_[index], at) <= kOnePlace_m) return index;
          }
        }
      }
    }
    cells[{rule, cell[0], cell[1], cell[2]}].push_back(design_.luminaire.size());
    place_.push_back(at);
    return std::nullopt;
  }

  static void add_attributes(const DxfPlaced& placed, DesignLuminaire& luminaire) {
    const auto& list = placed.entity->attribute;
    luminaire.attribute.insert(luminaire.attribute.end(), list.begin(), list.end());
  }

  void set_height(const MapLuminaire& rule, DesignLuminaire& luminaire) {
    const double z = luminaire.position_m.z;
    const std::optional<std::size_t> room =
        room_at(design_, luminaire.position_m, std::nullopt, luminaire.storey);
    const std::optional<std::size_t> room_by_z =
        room_at(design_, luminaire.position_m, z, luminaire.storey);
    for (const HeightSource& source : rule.height) {
      if (std::holds_alternative<FromZ>(source)) {
        const double floor = room_by_z ? design_.room[*room_by_z].floor_z_m : 0.0;
        if (z - floor <= kSamePlace_m) continue;  // drawn on the floor, or in a flat plan
        luminaire.has_height = true;
        return;
      }
      if (!room) return;  // it will be left out
      std::optional<double> above;
      if (const double* number = std::get_if<double>(&source)) {
        above = *number;
      } else {
        above =
            height_of_attribute(luminaire, std::get<FromAttribute>(source).name, metres_, notes_);
      }
      if (!above) continue;
      luminaire.position_m.z = design_.room[*room].floor_z_m + *above;
      luminaire.has_height = true;
      return;
    }
  }

  void add_furniture() {
    std::vector<std::size_t> of_rule(map_.furniture.size(), 0);
    std::map<std::string, DxfExtent> extents;
    std::size_t work = kMostDxfWork;
    for (const Block& block : furniture_) {
      const DxfPlaced& placed = block.placed;
      if (!has_memory_for(placed.entity->block.size())) return;
      const DxfEntity& entity = *placed.entity;
      const MapFurniture& rule = map_.furniture[block.rule];
      ++of_rule[block.rule];
      DesignBox box;
      box.rule = block.rule;
      const bool is_block = entity.kind == Kind::insert;
      box.name = is_block ? entity.block : placed.layer;
      const std::string what = "furniture " + box.name;
      if (!is_upright(placed.to_world)) {
        notes_.left_out(what, "it is tilted", place_of(placed));
        continue;
      }
      glm::dvec3 centre;
      if (is_block) {
        const auto [found, is_new] = extents.try_emplace(dxf_key(entity.block_in_file));
        if (is_new) found->second = extent_of_block(drawing_, entity.block_in_file, work);
        if (!found->second.is_any) {
          notes_.left_out(
              what,
              found->second.problem.empty() ? "its block has no volume" : found->second.problem,
              place_of(placed));
          continue;
        }
        const auto base = drawing_.block.find(dxf_key(entity.block_in_file));
        const glm::dvec3 middle =
            0.5 * (found->second.low + found->second.high) - base->second.base;
        centre = glm::dvec3(placed.to_world * glm::dvec4(middle, 1.0));
        const glm::dvec3 size = found->second.high - found->second.low;
        box.size_m = metres_ * glm::dvec3(size.x * glm::length(glm::dvec3(placed.to_world[0])),
                                          size.y * glm::length(glm::dvec3(placed.to_world[1])), 0);
        box.rotation_deg = rotation_of(placed.to_world);
      } else if (!take_rectangle(placed, centre, box)) {
        notes_.left_out(what,
                        entity.kind == Kind::mesh
                            ? "a mesh outside a block is not taken; make a block of it"
                            : "its outline is not a rectangle; draw it as a block",
                        place_of(placed));
        continue;
      }
      box.size_m.z = rule.height_m;
      box.centre_m = in_metres(centre);
      if (!is_near(box.centre_m / metres_) || !(box.size_m.x > 0.0) || !(box.size_m.y > 0.0)) {
        notes_.left_out(what, "it is flat or too far away", place_of(placed));
        continue;
      }
      const std::optional<std::size_t> room =
          room_at(design_, box.centre_m, std::nullopt, storey_of(placed.layer));
      if (!room) {
        notes_.left_out(what, "it is not in a room", place_of(placed));
        continue;
      }
      box.centre_m.z = design_.room[*room].floor_z_m;
      if (is_block) {
        say_faces(extents.at(dxf_key(entity.block_in_file)), what, box, placed);
      }
      box.source = {key_of(placed, box.centre_m, false), place_of(placed)};
      design_.box.push_back(std::move(box));
    }
    for (std::size_t i = 0; i < of_rule.size(); ++i) {
      if (of_rule[i] != 0) continue;
      const MapFurniture& rule = map_.furniture[i];
      notes_.left_out("furniture",
                      fmt::format("the drawing has nothing for {}",
                                  rule.type.empty() ? "layer " + rule.layer : rule.type),
                      fmt::format("map line {}", rule.line));
    }
  }

  // What becomes simpler of a block that has a shape in space.
  void say_faces(const DxfExtent& extent, const std::string& what, const DesignBox& box,
                 const DxfPlaced& placed) {
    if (extent.faces + extent.meshes == 0) return;
    const double drawn_m =
        metres_ * (extent.high.z - extent.low.z) * glm::length(glm::dvec3(placed.to_world[2]));
    notes_.add(
        DesignNote::Kind::taken, what,
        fmt::format(
            "its block has {} 3DFACE, SOLID and TRACE and {} meshes; only the upright box around "
            "them is written. It is {:.4g} m high as the map says, and {:.4g} m in the drawing",
            extent.faces, extent.meshes, box.size_m.z, drawn_m),
        place_of(placed));
  }

  bool take_rectangle(const DxfPlaced& placed, glm::dvec3& centre, DesignBox& box) const {
    if (placed.entity->kind != Kind::polyline) return false;
    double reached = 0.0;
    std::vector<glm::dvec3> corner = placed.corners(kChordError_m / metres_, &reached);
    if (reached > kChordError_m / metres_) return false;
    if (corner.size() == 5 && corner[0] == corner[4]) corner.pop_back();
    if (corner.size() != 4) return false;
    const glm::dvec2 u(corner[1] - corner[0]), v(corner[3] - corner[0]), w(corner[2] - corner[1]);
    const double same = kSamePlace_m / metres_;
    if (glm::distance(v, w) > same || std::fabs(glm::dot(u, v)) > same * glm::length(u)) {
      return false;
    }
    centre = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
    box.size_m = metres_ * glm::dvec3(glm::length(u), glm::length(v), 0.0);
    const double degrees = calc::degrees_from_radians(calc::atan2(u.y, u.x));
    box.rotation_deg = degrees < 0.0 ? degrees + 360.0 : degrees;
    return true;
  }

  template <class Rules>
  void add_lines(const std::vector<Pieces>& pieces, const Rules& rules, bool is_plane,
                 std::vector<DesignLine>& lines) {
    const std::string what = is_plane ? "plane" : "route";
    for (std::size_t i = 0; i < rules.size(); ++i) {
      const std::vector<PlanPiece> list = pieces_of(pieces[i].outline, what);
      const std::size_t before = lines.size();
      const auto add = [&](DesignLine line, const std::string& key) {
        line.rule = i;
        const glm::dvec3 first = line.point_m.front();
        line.source.key = own_key(
            !key.empty() ? key : fmt::format("at_{:.0f}_{:.0f}", first.x * 100.0, first.y * 100.0));
        lines.push_back(std::move(line));
      };
      if (is_plane) {
        const PlanOutlines found = find_outlines(list, kSamePlace_m, false);
        say_failures(found, fmt::format("outline of a plane on {}", rules[i].layer));
        for (const PlanOutline& outline : found.outline) {
          DesignLine line;
          line.source.place = outline.place;
          for (const glm::dvec2& corner : outline.corner) {
            line.point_m.push_back(glm::dvec3(corner, outline.z) - design_.origin_m);
          }
          add(std::move(line), outline.key);
        }
      } else {
        for (const PlanPiece& piece : list) {
          const std::size_t corners = piece.point.size() + (piece.is_closed ? 1 : 0);
          if (corners < 2 || corners > calc::kRouteCornerLimit) {
            notes_.left_out("route",
                            fmt::format("2 to {} corners are needed", calc::kRouteCornerLimit),
                            piece.place);
            continue;
          }
          DesignLine line;
          line.source.place = piece.place;
          for (const glm::dvec3& point : piece.point) {
            line.point_m.push_back(point - design_.origin_m);
          }
          if (piece.is_closed) line.point_m.push_back(line.point_m.front());
          add(std::move(line), piece.key);
        }
      }
      if (lines.size() == before) {
        notes_.left_out(what + "s",
                        fmt::format("no layer {} has an object that can be one", rules[i].layer),
                        fmt::format("map line {}", rules[i].line));
      }
    }
  }

  void say_the_rest() {
    for (const DxfSkipped* list : {&drawing_.skipped, &std::as_const(skipped_)}) {
      for (const auto& [what, count] : *list) {
        const auto& [kind, layer, why] = what;
        if (is_ignored(layer)) continue;
        if (is_asked(layer)) {
          notes_.left_out(kind, why, "layer " + layer, count);
        } else {
          notes_.add(DesignNote::Kind::not_asked, kind, why, layer.empty() ? "" : "layer " + layer,
                     count);
        }
      }
    }
    for (const auto& [what, count] : not_asked_) {
      notes_.add(DesignNote::Kind::not_asked,
                 fmt::format("{} on layer {}", what.first, what.second),
                 "the map does not name them", "", count);
    }
    if (clipped_ > 0) {
      notes_.doubt("block reference", "part of it is hidden (XCLIP); all of it was read", "",
                   clipped_);
    }
    for (const std::string& doubt : {drawing_.text_doubt, drawing_.end_doubt}) {
      if (!doubt.empty()) notes_.doubt("file", doubt);
    }
    for (int i : {0, 1}) {
      if (design_.origin_m[i] == 0.0) continue;
      notes_.add(DesignNote::Kind::taken, "origin",
                 fmt::format("({:.0f}, {:.0f}) m of the drawing is (0, 0) of the project",
                             design_.origin_m.x, design_.origin_m.y),
                 "");
      break;
    }
  }

  const DxfDrawing& drawing_;
  const ImportMap& map_;
  Design design_;
  DesignNotes notes_{design_};
  double metres_ = 1.0;
  bool is_dialux_ = false;
  std::vector<Pieces> room_, plane_, route_;  // by rule
  std::vector<Block> luminaire_, furniture_;
  std::vector<DxfPlaced> text_;
  std::vector<glm::dvec3> place_;  // of luminaires, as drawn
  std::string problem_;
  std::size_t points_ = 0, work_ = 0, text_bytes_ = 0, parts_ = 0, loose_ = 0, clipped_ = 0;
  DxfSkipped skipped_;
  std::map<std::pair<std::string, std::string>, std::size_t> not_asked_;
  std::map<std::string, int> used_;
};

}  // namespace

std::optional<Design> design_of_dxf(const DxfDrawing& drawing, const std::string& file,
                                    const ImportMap& map, const std::string& unit_option,
                                    std::string& problem) {
  return Builder(drawing, map).build(file, unit_option, problem);
}

}  // namespace cli
