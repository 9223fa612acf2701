#include "rules/zones/zone_plane.h"

#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "calc/base/units.h"
#include "calc/project/spaces/plane_area.h"
#include "calc/project/spaces/upright_task.h"
#include "calc/scene/polygon.h"
#include "calc/scene/zone_shapes.h"
#include "rules/zones/zone_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace rules {
namespace {

calc::Message metres(double length_m) {
  return calc::Message::number(fmt::format("{:.4g} m", length_m));
}

class ZoneMaker {
 public:
  ZoneMaker(const ZoneSource& source, const RulePlane& rule, const calc::ZoneText* change)
      : source_(source), rule_(rule), change_(change) {}

  ZonePlane run(std::optional<std::size_t> wall) {
    if (wall) {
      zone_.area = source_.workplace.walls[*wall];
      make_surface(calc::say<calc::Sentence::zone_wall>(*wall + 1));
    } else if (rule_.area == ZoneArea::ceiling) {
      zone_.area = source_.workplace.ceiling;
      turn_area();
      make_surface(calc::say<calc::Sentence::zone_ceiling>());
    } else if (upright() && rule_.area == ZoneArea::task) {
      make_face();
    } else if (upright() && rule_.area == ZoneArea::band && !is_area_given()) {
      make_band_of_face();
    } else {
      make_horizontal();
    }
    if (zone_.problem.empty() && zone_.not_made.empty()) add_grid();
    if (change_ != nullptr && !zone_.changed.empty() && !change_->because.empty()) {
      zone_.changed += " (" + calc::Message::words(change_->because) + ")";
    }
    return std::move(zone_);
  }

 private:
  const Polygon& room() const { return source_.space.shell->footprint_m; }
  const Polygon& task() const { return source_.workplace.task_m; }
  bool is_whole_room() const { return task().empty(); }

  const std::optional<calc::UprightTask>& upright() const { return source_.workplace.upright; }

  void note_change(const calc::Message& words) { append(zone_.changed, words, ", "); }

  double margin_m() {
    const double by_rule = margin_in_room_m(rule_, calc::width_up_to(room(), rule_.narrow_m));
    if (change_ == nullptr || !change_->margin_m) {
      if (by_rule < rule_.margin_m) zone_.narrow_margin_m = by_rule;
      return by_rule;
    }
    if (*change_->margin_m != by_rule) {
      note_change(
          calc::say<calc::Sentence::changed_margin>(metres(*change_->margin_m), metres(by_rule)));
    }
    return *change_->margin_m;
  }

  void make_surface(const calc::Message& name) {
    zone_.area.margin_m = margin_m();
    const glm::dvec2 side_m = size_of(zone_.area.outline_m);
    const double shorter_m = std::min(side_m.x, side_m.y);
    if (shorter_m <= 2.0 * zone_.area.margin_m) {
      zone_.not_made =
          calc::say<calc::Sentence::all_is_edge>(metres(shorter_m), metres(zone_.area.margin_m));
      return;
    }
    zone_.words = name;
    if (zone_.area.margin_m > 0.0) {
      zone_.words += ", " + calc::say<calc::Sentence::zone_off_edges>(metres(zone_.area.margin_m));
    }
  }

  void make_face() {
    using enum calc::Sentence;
    zone_.area = upright()->area;
    const calc::Message low = metres(upright()->low_m), high = metres(upright()->high_m);
    zone_.words = upright()->wall ? calc::say<zone_on_wall>(*upright()->wall + 1, low, high)
                                  : calc::say<zone_face>(low, high);
    const double lean_deg =
        calc::degrees_from_radians(calc::acos(std::min(1.0, upright()->area.v.z)));
    if (lean_deg > 0.0) zone_.words += ", " + calc::say<zone_face_leans>(lean_deg);
  }

  // Makes the band around an upright task. Zones beyond the first band are on the floor, at a place
  // that is not stated.
  void make_band_of_face() {
    const RulePlane* inside = source_.pack.find_plane(rule_.around);
    if (inside == nullptr || inside->area != ZoneArea::task) {
      zone_.not_made = calc::say<calc::Sentence::task_is_upright>();
      zone_.is_place_unknown = true;
      return;
    }
    const calc::RoomBeside room = calc::room_beside(*upright(), *source_.space.shell);
    zone_.area = upright()->area;
    const Polygon inner = zone_.area.outline_m;
    const glm::dvec2 from = glm::max(inner[0] - rule_.width_m, room.from_m);
    const glm::dvec2 to = glm::min(inner[2] + rule_.width_m, room.to_m);
    zone_.area.outline_m = {from, {to.x, from.y}, to, {from.x, to.y}};
    zone_.area.holes_m = {inner};
    zone_.words = calc::say<calc::Sentence::zone_face_band>(metres(rule_.width_m), rule_.around);
    constexpr double kNothing_m2 = 1.0e-6;
    if (calc::area_left(zone_.area.outline_m, zone_.area.holes_m) > kNothing_m2) return;
    zone_.not_made = calc::say<calc::Sentence::nothing_around>(rule_.around);
  }

  // Turns the area, because rules about sides and spacings refer to the area's own sides.
  void turn_area() {
    calc::PlanarArea& area = zone_.area;
    const glm::dvec2 axis = calc::long_axis(area.outline_m);
    const glm::dvec3 u = area.u, v = area.v;
    area.u = axis.x * u + axis.y * v;
    area.v = axis.x * v - axis.y * u;
    area.outline_m = along_axis(area.outline_m, axis);
  }

  // Returns the height that a rule gives to a plane, for this row.
  double rule_height_m(const RulePlane& rule) const {
    if (rule.area == ZoneArea::task && source_.row.task_heights_m) {
      return source_.row.task_heights_m->lowest_m;
    }
    if (rule.height_m) return *rule.height_m;
    return task_height_m();
  }

  double task_height_m() const {
    for (const calc::ZoneText& zone : source_.workplace.zones) {
      const RulePlane* plane = source_.pack.find_plane(zone.role);
      if (plane != nullptr && plane->area == ZoneArea::task && zone.height_m) return *zone.height_m;
    }
    if (source_.workplace.height_m) return *source_.workplace.height_m;
    for (const RulePlane& plane : source_.pack.planes) {
      if (plane.area == ZoneArea::task) return rule_height_m(plane);
    }
    return 0.0;
  }

  double height_m() {
    const double by_rule = rule_height_m(rule_);
    double height = rule_.area == ZoneArea::task ? task_height_m() : by_rule;
    if (change_ != nullptr && change_->height_m) height = *change_->height_m;
    if (height != by_rule) {
      note_change(calc::say<calc::Sentence::changed_height>(metres(height), metres(by_rule)));
    }
    return height;
  }

  void make_horizontal() {
    const double height = height_m();
    if (height >= source_.space.shell->height_m) {
      zone_.problem = calc::say<calc::Sentence::zone_no_room_above>(metres(height));
      return;
    }
    make_outline();
    if (!zone_.problem.empty() || !zone_.not_made.empty()) return;
    zone_.words +=
        ", " + (height > 0.0 ? calc::say<calc::Sentence::zone_above_floor>(metres(height))
                             : calc::say<calc::Sentence::zone_on_floor>());
    place(height);
  }

  // Places the outlines, which are in the world's x and y so far: planes are written from a corner
  // of their own, along the longest side.
  void place(double height) {
    calc::PlanarArea& area = zone_.area;
    area.u = glm::dvec3(axis_, 0.0);
    area.v = glm::dvec3(-axis_.y, axis_.x, 0.0);
    area.outline_m = along_axis(area.outline_m, axis_);
    for (Polygon& hole : area.holes_m) hole = along_axis(hole, axis_);
    glm::dvec2 corner = area.outline_m[0];
    for (const glm::dvec2& other : area.outline_m) corner = glm::min(corner, other);
    area.origin_m = corner.x * area.u + corner.y * area.v;
    area.origin_m.z = source_.space.shell->floor_z_m + height;
    for (glm::dvec2& point : area.outline_m) point -= corner;
    for (Polygon& hole : area.holes_m) {
      for (glm::dvec2& point : hole) point -= corner;
    }
  }

  bool is_area_given() const { return change_ != nullptr && !change_->area_m.empty(); }

  void make_outline() {
    if (is_area_given()) return make_given(change_->area_m);
    if (rule_.area != ZoneArea::band && is_whole_room()) return make_whole_room();
    if (rule_.area == ZoneArea::task) return make_given(task());
    if (is_whole_room()) {
      zone_.not_made = calc::say<calc::Sentence::task_is_room>();
      return;
    }
    make_band();
  }

  void make_whole_room() {
    zone_.area.outline_m = room();
    axis_ = calc::long_axis(room());
    zone_.area.margin_m = margin_m();
    zone_.words = calc::say<calc::Sentence::zone_room>();
    if (zone_.area.margin_m > 0.0)
      zone_.words = calc::say<calc::Sentence::zone_room_without>(metres(zone_.area.margin_m));
    constexpr double kWorthSaying_m2 = 1.0;
    if (const double lost_m2 = lost_to_margin_m2(room(), zone_.area.margin_m);
        zone_.area.margin_m > 0.0 && lost_m2 > kWorthSaying_m2) {
      zone_.words +=
          " (" +
          calc::say<calc::Sentence::zone_room_lost>(lost_m2, metres(2.0 * zone_.area.margin_m)) +
          ")";
    }
    const glm::dvec2 side_m = size_of(along_axis(room(), axis_));
    const double width_m = std::min(side_m.x, side_m.y);
    if (width_m <= 2.0 * zone_.area.margin_m) {
      zone_.problem =
          calc::say<calc::Sentence::zone_room_narrow>(metres(width_m), metres(zone_.area.margin_m));
    }
  }

  // Makes a given area: it needs no margin but the one written with it.
  void make_given(const Polygon& outline) {
    const bool is_task = rule_.area == ZoneArea::task;
    zone_.area.outline_m = outline;
    axis_ = calc::long_axis(outline);
    if (change_ != nullptr && change_->margin_m) {
      zone_.area.margin_m = *change_->margin_m;
      note_change(calc::say<calc::Sentence::changed_own_margin>(metres(zone_.area.margin_m)));
    }
    zone_.words = calc::say<calc::Sentence::zone_given>();
    if (!is_task) note_change(calc::say<calc::Sentence::changed_area>());
    if (rule_.area == ZoneArea::band && !is_whole_room()) {
      const Polygon inner = outer_edge(rule_.around);
      zone_.words += ", " + calc::say<calc::Sentence::zone_without_inner>();
      if (inner.empty()) {
        zone_.problem = zone_.words;
        zone_.is_simple = false;
        return;
      }
      zone_.area.holes_m.push_back(inner);
      check_area(calc::say<calc::Sentence::zone_covered>());
    }
  }

  // Returns the outer edge of the zone with this role, regardless of walls. Empty if it is not
  // simple.
  Polygon outer_edge(const std::string& role) const {
    const RulePlane* plane = source_.pack.find_plane(role);
    if (plane == nullptr || plane->area != ZoneArea::band) return task();
    for (const calc::ZoneText& zone : source_.workplace.zones) {
      if (zone.role == role && !zone.area_m.empty()) return zone.area_m;
    }
    const Polygon inner = outer_edge(plane->around);
    return inner.empty() ? inner : calc::moved_sides(inner, plane->width_m);
  }

  bool reaches_into_margin(double margin) const {
    constexpr double kTie = 1.0e-9;
    return least_distance(task(), room()) < margin * (1.0 - kTie);
  }

  void make_band() {
    const bool is_band = rule_.area == ZoneArea::band;
    const Polygon inner = is_band ? outer_edge(rule_.around) : task();
    const Polygon outer = inner.empty() ? inner : calc::moved_sides(inner, rule_.width_m);
    const calc::Message width = metres(rule_.width_m);
    zone_.words = is_band ? calc::say<calc::Sentence::zone_band>(width, rule_.around)
                          : calc::say<calc::Sentence::zone_task_band>(width);
    if (outer.empty()) {
      zone_.problem = zone_.words;
      zone_.is_simple = false;
      return;
    }
    double margin = margin_m();
    const bool is_first = is_band && source_.pack.find_plane(rule_.around)->area == ZoneArea::task;
    const bool is_changed = change_ != nullptr && change_->margin_m;
    if (is_first && margin > 0.0 && !is_changed && reaches_into_margin(margin)) {
      margin = 0.0;
      zone_.words += ", " + calc::say<calc::Sentence::zone_to_walls>();
    } else if (margin > 0.0) {
      zone_.words += ", " + calc::say<calc::Sentence::zone_off_walls>(metres(margin));
    }
    axis_ = calc::long_axis(inner);
    // A niche narrower than twice the margin has no sides to move: the strips are cut off instead.
    const Polygon moved = margin > 0.0 ? calc::moved_sides(room(), -margin) : room();
    const auto strips = moved.empty() ? wall_strips(room(), margin) : std::vector<Polygon>();
    cut_band(outer, inner, moved.empty() ? room() : moved, strips, is_band);
  }

  void cut_band(const Polygon& outer, const Polygon& inner, const Polygon& region,
                const std::vector<Polygon>& strips, bool is_band) {
    zone_.area.outline_m =
        back_from(calc::within_bounds(along_axis(outer, axis_), along_axis(region, axis_)), axis_);
    if (zone_.area.outline_m.empty()) {
      zone_.problem = zone_.words;
      return;
    }
    zone_.area.holes_m = calc::pieces_outside(zone_.area.outline_m, region);
    zone_.area.holes_m.insert(zone_.area.holes_m.end(), strips.begin(), strips.end());
    if (is_band) zone_.area.holes_m.push_back(inner);
    check_area(zone_.words);
  }

  // Checks the area: an outer band may end at the walls before it begins.
  void check_area(const calc::Message& why) {
    constexpr double kNothing = 1.0e-6;  // of the outline's area
    const double whole_m2 = std::abs(calc::signed_area(zone_.area.outline_m));
    if (calc::area_left(zone_.area.outline_m, zone_.area.holes_m) > kNothing * whole_m2) return;
    const RulePlane* inside = source_.pack.find_plane(rule_.around);
    const bool is_outer = inside != nullptr && inside->area == ZoneArea::band;
    if (is_outer && (change_ == nullptr || change_->area_m.empty())) {
      zone_.not_made = calc::say<calc::Sentence::nothing_around>(rule_.around);
    } else {
      zone_.problem = why;
    }
  }

  void add_grid() {
    const RuleGrid* grid = source_.pack.find_grid(rule_.grid);
    if (grid != nullptr && grid->rule) zone_.area.grid = *grid->rule;
    if (change_ != nullptr && change_->grid) return change_grid(*change_->grid);
    name_grid(grid);
  }

  void change_grid(const calc::GridRule& grid) {
    auto* by_rule = std::get_if<calc::GridByRule>(&zone_.area.grid);
    const auto* own = std::get_if<calc::GridByRule>(&grid);
    if (own == nullptr) {
      note_change(calc::say<calc::Sentence::changed_grid>());
      zone_.area.grid = grid;
      return;
    }
    if (by_rule == nullptr) {
      zone_.area.grid = grid;
    } else {
      by_rule->rounding = own->rounding;
    }
    note_change(calc::say<calc::Sentence::changed_rounding>());
    name_grid(source_.pack.find_grid(rule_.grid));
  }

  // Sets the grid with the pack's name, with cells at most as wide as a band.
  void name_grid(const RuleGrid* grid) {
    calc::Message name = calc::GridByRule().name;
    if (grid != nullptr) {
      name = with_trust(
          calc::Message::words(fmt::format("{}:{}", source_.pack.title, source_.pack.edition)),
          grid->trust);
    }
    const double widest_m = rule_.area == ZoneArea::band ? rule_.width_m : 1.0e9;
    const glm::dvec2 side_m = size_of(zone_.area.outline_m);
    const bool is_v_longer = side_m.y > side_m.x;
    if (auto* by_rule = std::get_if<calc::GridByRule>(&zone_.area.grid)) {
      by_rule->name = name;
      by_rule->max_spacing_m = std::min(by_rule->max_spacing_m, widest_m);
    } else if (auto* spacing = std::get_if<calc::GridBySpacing>(&zone_.area.grid)) {
      spacing->name = name;
      if (is_v_longer) std::swap(spacing->along_u_m, spacing->along_v_m);
      spacing->along_u_m = std::min(spacing->along_u_m, widest_m);
      spacing->along_v_m = std::min(spacing->along_v_m, widest_m);
    } else if (auto* count = std::get_if<calc::GridByCount>(&zone_.area.grid)) {
      if (is_v_longer) std::swap(count->columns, count->rows);
    }
  }

  const ZoneSource& source_;
  const RulePlane& rule_;
  const calc::ZoneText* change_;
  glm::dvec2 axis_{1.0, 0.0};  // of horizontal areas, in the world
  ZonePlane zone_;
};

}  // namespace

ZonePlane make_zone_plane(const ZoneSource& source, const RulePlane& rule,
                          const calc::ZoneText* change, std::optional<std::size_t> wall) {
  return ZoneMaker(source, rule, change).run(wall);
}

}  // namespace rules
