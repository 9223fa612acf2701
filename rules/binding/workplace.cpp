#include "rules/binding/workplace.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/xml_reader.h"
#include "calc/glare/room_ugr.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/workplace_xml.h"
#include "calc/scene/sensor_grid.h"
#include "rules/binding/deviation_xml.h"
#include "rules/binding/requirement_attributes.h"
#include "rules/binding/rule_reference.h"
#include "rules/binding/shared_surfaces.h"
#include "rules/binding/waiver_xml.h"
#include "rules/pack/limit.h"
#include "rules/pack/pack_parts.h"
#include "rules/verdict/waiver.h"
#include "rules/zones/straight_walls.h"
#include "rules/zones/zone_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;
using calc::Workplace;
using calc::ZoneText;

// Line of every plane of the project.
using LineOfPlane = std::map<std::string, int, std::less<>>;

// More than any building needs, and what fits into memory.
constexpr std::size_t kMostPlanes = 4000;
constexpr double kMostPoints = 4.0e6;

double cells_of(const calc::PlanarArea& area) {
  glm::dvec2 lower = area.outline_m.at(0), upper = lower;
  for (const glm::dvec2& corner : area.outline_m) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const glm::dvec2 side_m = glm::max(upper - lower - 2.0 * area.margin_m, glm::dvec2(1.0e-6));
  if (const auto* count = std::get_if<calc::GridByCount>(&area.grid)) {
    return static_cast<double>(count->columns) * static_cast<double>(count->rows);
  }
  if (const auto* spacing = std::get_if<calc::GridBySpacing>(&area.grid)) {
    return std::ceil(side_m.x / spacing->along_u_m) * std::ceil(side_m.y / spacing->along_v_m);
  }
  const calc::GridCounts counts =
      calc::grid_counts(std::get<calc::GridByRule>(area.grid), side_m.x, side_m.y);
  return static_cast<double>(counts.columns) * static_cast<double>(counts.rows);
}

// Totals over all workplaces of a project so far.
struct Total {
  std::size_t planes = 0;
  double points = 0.0;
};

// The way to judge a check that has an alternative.
enum class Method {
  as_fits,   // of the space, if there is a value for it
  of_space,  // whether there is one or not
  on_planes  // also, if there is one
};

// Returns why a quantity of the space has no value; "" = it has.
using ProblemOfSpace = std::function<calc::Message(const Quantity&)>;

class WorkplaceMaker {
 public:
  WorkplaceMaker(const RulePack& pack, const RuleRow& row, LimitScope scope,
                 const Workplace& workplace, Method method, ProblemOfSpace problem_of_space,
                 calc::Space& space, calc::Diagnostics& diagnostics)
      : pack_(pack),
        row_(row),
        scope_(std::move(scope)),
        workplace_(workplace),
        method_(method),
        problem_of_space_(std::move(problem_of_space)),
        part_of_(join_straight_walls(pack, workplace_)),
        space_(space),
        diagnostics_(diagnostics) {}

  // Checks that the zones are in the pack and may be changed this way.
  void check_zones() {
    std::vector<std::string> allowed;
    for (const std::string& role : pack_.roles()) {
      const RulePlane* plane = pack_.find_plane(role);
      if (plane == nullptr || !has_area(*plane)) continue;
      if (!find_quantity(role)->kernel) continue;
      allowed.push_back(role);
      for (std::size_t i = 1; i <= parts_of(role, *plane); ++i) {
        allowed.push_back(fmt::format("{}.{}", role, i));
      }
    }
    for (const ZoneText& zone : workplace_.zones) {
      if (zone.role.empty()) continue;  // reported where it was read
      if (std::find(allowed.begin(), allowed.end(), zone.role) == allowed.end()) {
        report_unknown_name(diagnostics_, zone.role_where, "role",
                            zone.left_out ? "without" : "zone", "zone", zone.role,
                            calc::Names(allowed.begin(), allowed.end()));
      } else if (zone.left_out) {
        check_may_be_left_out(zone);
      } else {
        check_fit(zone);
      }
    }
  }

  // Returns the zones that run() did not make.
  const std::vector<calc::UnmadeZone>& unmade() const { return unmade_; }
  // Returns "EN 12464-1:2021 34.2".
  std::string row() const { return rule_words(); }
  // Returns "left out: ceiling (open)"; "" = there is nothing to say.
  calc::Message note() const { return note_words(); }
  std::vector<std::string> asked() const {
    std::vector<std::string> checks;
    for (const std::string& role : roles_made_) {
      const std::vector<std::string> own = asked_checks(role, scope_);
      checks.insert(checks.end(), own.begin(), own.end());
    }
    return checks;
  }

  // Makes the planes; requires check_zones() without an error. Adds nothing after an error.
  void run(LineOfPlane& ids, Total& total) {
    const std::size_t errors = diagnostics_.error_count();
    const auto [requires_something, rest] = required_roles();
    if (!requires_something) {
      diagnostics_.report(DiagnosticId::rule_requires_nothing, workplace_.where, pack_.full_id(),
                          fmt::format(" row '{}'", row_.ref), pack_.role,
                          rest.empty() ? "; remove the workplace"
                                       : fmt::format("; remove the workplace, and require what it "
                                                     "does have with <require role=\"{}\" .../> "
                                                     "in a <plane>",
                                                     rest));
      return;
    }
    if (row_.task_orientation == kUpright && !workplace_.upright) {
      diagnostics_.report(DiagnosticId::workplace_task_is_upright, workplace_.where, workplace_.id,
                          row_.ref);
      return;
    }
    choose_methods();
    for (const std::string& role : pack_.roles()) add_role(role);
    if (std::none_of(pack_.planes.begin(), pack_.planes.end(), has_area)) {
      diagnostics_.report(DiagnosticId::workplace_makes_nothing, workplace_.where, pack_.full_id(),
                          fmt::format(", for row '{}' or any other", row_.ref));
    }
    std::vector<calc::CalcPlane> own;
    std::vector<std::pair<std::size_t, calc::CalcPlane>> shared;  // with that plane of the space
    for (calc::CalcPlane& plane : planes_) {
      if (const auto twin = same_surface(plane, pack_, space_)) {
        shared.emplace_back(*twin, std::move(plane));
      } else {
        own.push_back(std::move(plane));
      }
    }
    check_size(own, total);
    const auto take_id = [&](const calc::CalcPlane& plane) {
      const auto [first, is_new] = ids.try_emplace(plane.id, plane.where.line);
      if (is_new) return;
      diagnostics_.report(DiagnosticId::duplicate_id, workplace_.where, "plane", plane.id,
                          first->second);
    };
    for (const calc::CalcPlane& plane : own) take_id(plane);
    for (const calc::LeftOutPlane& left_out : left_out_planes_) take_id(left_out.plane);
    if (diagnostics_.error_count() > errors) return;
    for (const auto& [twin, plane] : shared) ask_also(space_.planes[twin], plane);
    const std::size_t first =
        own.empty() && !shared.empty() ? shared.front().first : space_.planes.size();
    for (calc::CalcPlane& plane : own) space_.planes.push_back(std::move(plane));
    for (const std::string& role : roles_of_space_) {
      ask_of_space({workplace_.element, role, {workplace_.id}}, space_, first);
    }
    for (calc::LeftOutPlane& plane : left_out_planes_) space_.left_out.push_back(std::move(plane));
  }

 private:
  static bool has_area(const RulePlane& plane) { return plane.area != ZoneArea::none; }

  void check_size(const std::vector<calc::CalcPlane>& planes, Total& total) {
    total.planes += planes.size();
    for (const calc::CalcPlane& plane : planes) {
      total.points += cells_of(std::get<calc::PlanarArea>(plane.area));
    }
    if (total.planes <= kMostPlanes && total.points <= kMostPoints) return;
    diagnostics_.report(
        DiagnosticId::number_out_of_range, workplace_.where, "count", "workplace",
        fmt::format("a total of {} planes with {:.3g} points, including earlier workplaces",
                    total.planes, total.points),
        fmt::format("at most {} planes and {:.3g} points for all workplaces together", kMostPlanes,
                    kMostPoints));
  }

  // Refuses to omit the task, because a row without its task would be met by any rest.
  void check_may_be_left_out(const ZoneText& zone) {
    const RulePlane& plane = *plane_of_zone(zone);
    if (zone.role != pack_.role && plane.area != ZoneArea::task) return;
    diagnostics_.report(DiagnosticId::workplace_without_task, zone.role_where, workplace_.id,
                        zone.role, zone.role,
                        fmt::format("{}", fmt::join(asked_checks(plane.role, scope_), " ")));
  }

  // Returns the pack's plane for a role or a part of it.
  const RulePlane* plane_of_zone(const ZoneText& zone) const {
    const RulePlane* plane = pack_.find_plane(zone.role);
    return plane != nullptr ? plane : pack_.find_plane(zone.role.substr(0, zone.role.rfind('.')));
  }

  // Refuses changes that surfaces of the room cannot have.
  void check_fit(const ZoneText& zone) {
    const RulePlane* plane = plane_of_zone(zone);
    const bool is_surface =
        plane != nullptr && (plane->area == ZoneArea::walls || plane->area == ZoneArea::ceiling);
    const auto refuse = [&](const char* what, std::string_view beside) {
      diagnostics_.report(DiagnosticId::attribute_without_meaning, zone.where, "zone", what,
                          fmt::format("role=\"{}\"{}", zone.role, beside));
    };
    if (is_surface && zone.height_m) refuse("height", "");
    if (is_surface && !zone.area_m.empty()) refuse("footprint' or 'size", "");
    if (plane != nullptr && workplace_.upright && is_in_its_plane(*plane)) {
      const std::string_view form = workplace_.upright->wall ? "wall" : "face";
      const std::string beside = fmt::format(" and '{}' of <workplace>", form);
      if (zone.height_m) refuse("height", beside);
      if (!zone.area_m.empty()) refuse("footprint' or 'size", beside);
      if (zone.margin_m) refuse("margin", beside);
      return;
    }
    if (plane == nullptr || plane->area != ZoneArea::task) return;
    if (zone.height_m && workplace_.height_m) refuse("height", " and 'height' of <workplace>");
    if (zone.margin_m && workplace_.is_task_place_unknown) {
      refuse("margin", " and 'task-place' of <workplace>");  // all of the room, or it is known
    }
    if (!zone.area_m.empty()) refuse("footprint' or 'size", ": give the area to <workplace>");
  }

  // Returns whether the plane is an upright task or the band around it.
  bool is_in_its_plane(const RulePlane& plane) const {
    const RulePlane* inside = pack_.find_plane(plane.around);
    return plane.area == ZoneArea::task ||
           (plane.area == ZoneArea::band && inside != nullptr && inside->area == ZoneArea::task);
  }

  const Quantity* find_quantity(const std::string& role) const {
    const auto is_of_role = [&](const RuleCheck& check) { return check.role == role; };
    return std::find_if(pack_.checks.begin(), pack_.checks.end(), is_of_role)->quantity;
  }

  const ZoneText* find_zone(std::string_view role) const {
    const auto found = std::find_if(workplace_.zones.begin(), workplace_.zones.end(),
                                    [&](const ZoneText& zone) { return zone.role == role; });
    return found == workplace_.zones.end() ? nullptr : &*found;
  }

  void leave_unmade(const std::string& role, const calc::Message& why,
                    bool is_place_unknown = false) {
    not_made_.push_back(calc::Message::words(role) + " (" + why + ")");
    unmade_.push_back({role, why, std::nullopt, is_place_unknown});
  }

  // Omits a plane. After the last day it is required again and cannot be judged: it has no area.
  void leave_out(const std::string& name, const RulePlane& rule, const ZoneText& zone,
                 std::optional<std::size_t> part) {
    calc::CalcPlane plane = plane_of(name, rule, part, calc::say<calc::Sentence::zone_left_out>());
    plane.where = zone.where;
    left_out_planes_.push_back({std::move(plane), *zone.left_out});
    left_out_names_.push_back(name);
  }

  // Reports the planes of a role omitted since `first`: under one name, if the whole role is
  // omitted and nothing of it is left.
  void tell_left_out(const std::string& role, std::size_t first, bool is_something_left) {
    const ZoneText* whole = find_zone(role);
    const bool is_whole = whole != nullptr && whole->left_out && !is_something_left;
    for (std::size_t i = first; i < left_out_planes_.size(); ++i) {
      const calc::Waiver& by = left_out_planes_[i].by;
      const bool is_own = !is_whole || by.where.line != whole->left_out->where.line ||
                          by.where.column != whole->left_out->where.column;
      const std::string& name = is_own ? left_out_names_[i] : role;
      if (!unmade_.empty() && unmade_.back().left_out && unmade_.back().role == name) continue;
      left_out_.push_back(calc::Message::words(name) + " (" + waiver_words(by) + ")");
      unmade_.push_back({name, calc::Message::words(by.reason), by, false});
    }
  }

  // Returns whether it is advice for something that a project draws if it has it, such as shelves.
  bool is_advice_without_place(const std::string& role, const RulePlane* plane) const {
    return plane != nullptr && !has_area(*plane) &&
           std::none_of(pack_.checks.begin(), pack_.checks.end(), [&](const RuleCheck& check) {
             return check.role == role && check.severity != Severity::advice;
           });
  }

  // Returns whether the row has a number that a workplace can judge, and a role for which it has
  // numbers that none can; "" = none. Colour rendering is judged along with the task.
  std::pair<bool, std::string> required_roles() const {
    const auto counts = [](const RuleCheck& check) { return check.severity != Severity::advice; };
    std::pair<bool, std::string> required{false, ""};
    for (const std::string& role : pack_.roles()) {
      if (required_check(role, scope_, counts) == nullptr) continue;
      if (find_quantity(role)->of_space == Metric::colour_rendering) {
        required.second = role;
      } else {
        required.first = true;
      }
    }
    return required;
  }

  // Returns why there is no plane of a role, whatever the room; "" = there is one.
  calc::Message reason_against(const std::string& role, const RulePlane* plane) const {
    const Quantity& quantity = *find_quantity(role);
    if (!quantity.kernel) return calc::say<calc::Sentence::not_on_planes>(quantity.name);
    if (plane == nullptr || !has_area(*plane)) return calc::say<calc::Sentence::no_place>();
    const bool is_wanted =
        required_check(role, scope_, [](const RuleCheck&) { return true; }) != nullptr;
    if (!is_wanted) return calc::say<calc::Sentence::row_asks_nothing>(row_.ref);
    return {};
  }

  calc::ReceiverKernel kernel_of(const std::string& role) const {
    return *find_quantity(role)->kernel;
  }

  // Returns whether its points face the directions along the room's longest wall and across it,
  // both ways.
  bool looks_around(const std::string& role) const {
    return calc::has_look(kernel_of(role), find_quantity(role)->derived);
  }

  glm::dvec3 direction(std::size_t index) const {
    constexpr double kTie = 1.0e-9;
    const calc::PlanarArea* longest = &workplace_.walls.at(0);
    for (const calc::PlanarArea& wall : workplace_.walls) {
      if (wall.outline_m[1].x > longest->outline_m[1].x * (1.0 + kTie)) longest = &wall;
    }
    const glm::dvec3 along = longest->u;
    const glm::dvec3 across(-along.y, along.x, 0.0);
    const glm::dvec3 look = index % 2 == 0 ? along : across;
    return index < 2 ? look : -look;
  }

  // Returns the number of planes "role.1" ... for walls or directions; 0: one plane, "role".
  std::size_t parts_of(const std::string& role, const RulePlane& plane) const {
    if (plane.area == ZoneArea::walls) return workplace_.walls.size();
    return looks_around(role) ? 4 : 0;
  }

  // Chooses between alternative checks, one of the space and one of planes. If the space has a
  // value, no statement of the project removes it: requiring planes, or changing them, adds them to
  // it. Omitting planes omits only these.
  void choose_methods() {
    for (const RuleCheck& check : pack_.checks) {
      if (check.instead_of.empty() || !check.quantity->of_space) continue;
      const RuleCheck& other = *pack_.find_check(check.instead_of);
      if (evaluate_limit(check, scope_).status == LimitStatus::not_applicable) continue;
      const bool is_told =
          std::any_of(workplace_.zones.begin(), workplace_.zones.end(), [&](const ZoneText& zone) {
            return !zone.left_out &&
                   (zone.role == other.role || zone.role.starts_with(other.role + "."));
          });
      const bool is_on_planes =
          method_ == Method::on_planes || (method_ == Method::as_fits && is_told);
      if (method_ == Method::of_space) refuse_zones_of(other.role);
      // Somebody leaves glare out as a whole, with a reason and a last day.
      const ZoneText* planes = find_zone(other.role);
      if (method_ == Method::on_planes && planes != nullptr && planes->left_out) {
        instead_[check.role] = calc::say<calc::Sentence::judged_instead>(other.id);
        continue;
      }
      const calc::Message problem = problem_of_space_(*check.quantity);
      if (problem.empty() || method_ == Method::of_space) {
        roles_of_space_.push_back(check.role);
        roles_made_.push_back(check.role);
        if (is_on_planes) continue;
        instead_[other.role] = calc::say<calc::Sentence::judged_instead>(check.id);
      } else {
        instead_[check.role] = calc::say<calc::Sentence::judged_by_observers>(problem);
      }
    }
  }

  // Refuses zones of planes that are not made, because another check replaces them.
  void refuse_zones_of(const std::string& role) {
    for (const ZoneText& zone : workplace_.zones) {
      if (zone.role != role && !zone.role.starts_with(role + ".")) continue;
      diagnostics_.report(DiagnosticId::attribute_without_meaning, zone.role_where,
                          zone.left_out ? "without" : "zone", "role", "glare=\"table\"");
    }
  }

  void add_role(const std::string& role) {
    if (std::find(roles_of_space_.begin(), roles_of_space_.end(), role) != roles_of_space_.end()) {
      return;
    }
    if (const auto other = instead_.find(role); other != instead_.end()) {
      return leave_unmade(role, other->second);
    }
    // It is asked along with the task, where the makers state it.
    if (find_quantity(role)->of_space == Metric::colour_rendering) return;
    const RulePlane* plane = pack_.find_plane(role);
    if (is_advice_without_place(role, plane)) return;
    if (const calc::Message reason = reason_against(role, plane); !reason.empty()) {
      return leave_unmade(role, reason);
    }
    const std::size_t parts = parts_of(role, *plane);
    const std::size_t before = planes_.size(), not_made = not_made_.size();
    const std::size_t left_out = left_out_planes_.size();
    std::vector<std::size_t> too_narrow;  // walls
    if (parts == 0) add_plane(role, *plane, find_zone(role), std::nullopt);
    for (std::size_t i = 0; i < parts; ++i) {
      const std::string name = fmt::format("{}.{}", role, i + 1);
      if (plane->area == ZoneArea::walls && part_of_[i]) continue;
      const ZoneText* one = find_zone(name);
      const std::size_t count = not_made_.size();
      add_plane(name, *plane, one != nullptr ? one : find_zone(role), i);
      if (not_made_.size() > count) too_narrow.push_back(i);
    }
    if (plane->area == ZoneArea::walls) check_front_wall(too_narrow);
    tell_left_out(role, left_out, planes_.size() > before || not_made_.size() > not_made);
    const std::string run = plane->area == ZoneArea::walls && planes_.size() > before
                                ? run_of_pieces(workplace_.walls, part_of_, too_narrow)
                                : "";
    if (!run.empty()) {
      diagnostics_.report(DiagnosticId::zone_vanishes, workplace_.where, workplace_.id, role, run,
                          role, role);
      return;
    }
    // A requirement of the row must not go away because a wall is drawn in pieces.
    const bool is_surface = plane->area == ZoneArea::walls || plane->area == ZoneArea::ceiling;
    if (!is_surface || not_made_.size() == not_made) return;
    if (planes_.size() > before) {
      if (!workplace_.is_further_copy) warn_of_unchecked(not_made);
      return;
    }
    diagnostics_.report(DiagnosticId::zone_vanishes, workplace_.where, workplace_.id, role,
                        not_made_[not_made], role, role);
  }

  // Reports a front wall that is too narrow: it would not be judged, and the other walls would have
  // easier limits.
  void check_front_wall(const std::vector<std::size_t>& too_narrow) {
    const std::optional<std::size_t> front = front_wall();
    if (!front || std::find(too_narrow.begin(), too_narrow.end(), *front) == too_narrow.end()) {
      return;
    }
    const calc::XmlAttribute* given = workplace_.element.find("front-wall");
    diagnostics_.report(DiagnosticId::number_out_of_range, given->where, "front-wall",
                        workplace_.element.name, given->value,
                        "a wall that is wide enough to be judged");
  }

  // Warns of surfaces with nothing left inside the standard's margin: they are not judged while the
  // others are, and readers must see that.
  void warn_of_unchecked(std::size_t first) {
    constexpr std::size_t kMostNamed = 4;
    const std::vector<calc::Message> all(not_made_.begin() + static_cast<std::ptrdiff_t>(first),
                                         not_made_.end());
    diagnostics_.report(DiagnosticId::zone_not_checked, workplace_.where, workplace_.id,
                        calc::listed(all, kMostNamed));
  }

  void add_plane(const std::string& name, const RulePlane& rule, const ZoneText* zone,
                 std::optional<std::size_t> part) {
    if (zone != nullptr && zone->left_out) return leave_out(name, rule, *zone, part);
    const auto wall = rule.area == ZoneArea::walls ? part : std::nullopt;
    ZonePlane made = make_zone_plane({pack_, row_, workplace_, space_}, rule, zone, wall);
    if (!made.not_made.empty()) {
      // A surface goes away within the standard's margin alone, never within the project's own.
      if (zone != nullptr && zone->margin_m) {
        ZoneText usual = *zone;
        usual.margin_m.reset();
        if (make_zone_plane({pack_, row_, workplace_, space_}, rule, &usual, wall)
                .not_made.empty()) {
          diagnostics_.report(DiagnosticId::zone_vanishes, zone->where, workplace_.id, name,
                              made.not_made, name, name);
          return;
        }
      }
      return leave_unmade(name, made.not_made, made.is_place_unknown);
    }
    if (!made.problem.empty()) {
      const calc::SourceLocation& where = zone != nullptr ? zone->where : workplace_.where;
      diagnostics_.report(
          made.is_simple ? DiagnosticId::zone_vanishes : DiagnosticId::zone_not_simple, where,
          workplace_.id, name, made.problem, name, name);
      return;
    }
    calc::CalcPlane plane = plane_of(name, rule, part, made.words);
    plane.area = std::move(made.area);
    plane.changed = std::move(made.changed);
    plane.has_own_area = zone != nullptr && !zone->area_m.empty();
    plane.own_margin_m = zone != nullptr && zone->margin_m ? zone->margin_m : made.narrow_margin_m;
    planes_.push_back(std::move(plane));
    if (std::find(roles_made_.begin(), roles_made_.end(), rule.role) == roles_made_.end()) {
      roles_made_.push_back(rule.role);
    }
  }

  // Returns the plane without its area.
  calc::CalcPlane plane_of(const std::string& name, const RulePlane& rule,
                           std::optional<std::size_t> part, calc::Message words) const {
    calc::CalcPlane plane;
    plane.id = fmt::format("{}.{}", workplace_.id, name);
    if (!workplace_.was.empty()) plane.was = fmt::format("{}.{}", workplace_.was, name);
    const std::string& title = workplace_.name.empty() ? workplace_.id : workplace_.name;
    plane.name =
        fmt::format("{}: {}", title, part ? fmt::format("{} {}", rule.role, *part + 1) : rule.role);
    plane.tags = workplace_.tags;
    plane.where = workplace_.where;
    plane.kernel = kernel_of(rule.role);
    plane.derived = find_quantity(rule.role)->derived;
    if (looks_around(rule.role)) {
      plane.direction = direction(*part);
      words += ", " + calc::say<calc::Sentence::zone_looking>(plane.direction.x + 0.0,
                                                              plane.direction.y + 0.0);
    }
    plane.made_by = calc::say<calc::Sentence::made_by>(workplace_.id, rule_words(), name, words);
    plane.requirements.push_back(
        {workplace_.element, rule.role, {workplace_.id}, special_place(rule, part)});
    return plane;
  }

  // Returns the number of the front wall; for joined walls that of the first.
  std::optional<std::size_t> front_wall() const {
    if (!workplace_.front_wall) return std::nullopt;
    return part_of_.at(*workplace_.front_wall).value_or(*workplace_.front_wall);
  }

  calc::SpecialPlace special_place(const RulePlane& rule, std::optional<std::size_t> part) const {
    if (rule.area == ZoneArea::task && workplace_.is_task_place_unknown) {
      return calc::SpecialPlace::unknown_task;
    }
    const std::optional<std::size_t> front = front_wall();
    const bool is_other = rule.area == ZoneArea::walls && front && part != front;
    return is_other ? calc::SpecialPlace::other_wall : calc::SpecialPlace::none;
  }

  std::string rule_words() const {
    return fmt::format("{}:{} {}", pack_.title, pack_.edition, row_.ref);
  }

  calc::Message note_words() const {
    std::vector<calc::Message> parts;
    if (workplace_.is_task_place_unknown)
      parts.push_back(calc::say<calc::Sentence::task_anywhere>());
    if (workplace_.front_wall)
      parts.push_back(calc::say<calc::Sentence::front_wall>(*workplace_.front_wall + 1));
    if (!left_out_.empty())
      parts.push_back(calc::say<calc::Sentence::left_out>(joined(left_out_, ", ")));
    if (!not_made_.empty())
      parts.push_back(calc::say<calc::Sentence::not_made>(joined(not_made_, ", ")));
    return joined(parts, "; ");
  }

  const RulePack& pack_;
  const RuleRow& row_;
  LimitScope scope_;
  Workplace workplace_;  // with joined walls
  Method method_;
  ProblemOfSpace problem_of_space_;
  std::vector<std::optional<std::size_t>> part_of_;
  calc::Space& space_;
  calc::Diagnostics& diagnostics_;
  std::vector<calc::CalcPlane> planes_;
  std::vector<calc::LeftOutPlane> left_out_planes_;
  std::vector<std::string> left_out_names_;  // of each of these: "wall.2"
  std::vector<std::string> roles_made_;
  std::vector<std::string> roles_of_space_;         // asked of the room, on the first plane
  std::map<std::string, calc::Message> instead_;    // role: why another is asked in its place
  std::vector<calc::Message> left_out_, not_made_;  // "ceiling (because)"
  std::vector<calc::UnmadeZone> unmade_;            // the same
};

// Checks the scene once here, not once for every plane.
void check_scene(ElementReader& reader, const std::vector<calc::LightScene>& scenes) {
  if (!reader.has("scene")) return;
  const std::string scene = reader.text("scene");
  calc::Names names;
  for (const calc::LightScene& candidate : scenes) names.emplace_back(candidate.id);
  if (scene.empty() || std::find(names.begin(), names.end(), scene) != names.end()) return;
  report_unknown_name(reader.diagnostics(), reader.where("scene"), "scene", reader.element().name,
                      "scene", scene, names);
}

// Returns the scene; null: every luminaire at full output.
const calc::LightScene* scene_named(const ElementReader& reader,
                                    const std::vector<calc::LightScene>& scenes) {
  const calc::XmlAttribute* name = reader.element().find("scene");
  if (name == nullptr) return nullptr;
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const auto& scene) { return scene.id == name->value; });
  return found == scenes.end() ? nullptr : &*found;
}

// A workplace's row with a note on its missing planes; "" = nothing to say.
struct WorkplaceNote {
  std::string id, row;
  calc::Message words;
};

// Adds the notes; equal notes appear once: "workplaces a, b and 6 more, ...".
void add_notes(const std::vector<WorkplaceNote>& notes, calc::Space& space) {
  using enum calc::Sentence;
  std::map<std::pair<std::string, calc::Message>, std::vector<std::string>> ids;  // by what is said
  for (const WorkplaceNote& note : notes) ids[{note.row, note.words}].push_back(note.id);
  for (const WorkplaceNote& note : notes) {
    const auto same = ids.find({note.row, note.words});
    if (note.words.empty() || same == ids.end()) continue;
    const calc::Message names = calc::names_message(same->second, 3);
    space.notes.push_back(same->second.size() == 1
                              ? calc::say<of_workplace>(names, note.row, note.words)
                              : calc::say<of_workplaces>(names, note.row, note.words));
    ids.erase(same);
  }
}

Method read_method(ElementReader& reader) {
  if (!reader.has("glare")) return Method::as_fits;
  return reader.choice("glare", calc::kGlareMethodType.words) == 0 ? Method::of_space
                                                                   : Method::on_planes;
}

// Problems of the UGR of a space, shared by its workplaces.
class RoomUgrProblems {
 public:
  // is_good: false if luminaires may have no type, which are then not used.
  RoomUgrProblems(const calc::Project& project, const calc::Space& space, bool is_good)
      : project_(project), space_(space), is_good_(is_good) {}

  const std::vector<calc::LightScene>& scenes() const { return project_.scenes; }
  const calc::Message& of(const calc::LightScene* scene) {
    const auto known = of_scene_.find(scene);
    if (known != of_scene_.end()) return known->second;
    calc::Message problem;
    if (is_good_) problem = calc::why_no_room_ugr(project_, space_, scene);
    return of_scene_.emplace(scene, std::move(problem)).first->second;
  }

 private:
  const calc::Project& project_;
  const calc::Space& space_;
  bool is_good_;
  std::map<const calc::LightScene*, calc::Message> of_scene_;
};

// Reports a special place for which the pack has no value.
void check_special(ElementReader& reader, const RulePack& pack, const RuleRow* row,
                   std::string_view name, calc::SpecialPlace place) {
  if (!reader.has(name) || row == nullptr) return;
  const bool is_known = std::any_of(
      pack.checks.begin(), pack.checks.end(),
      [&](const RuleCheck& check) { return check.find_special(place, row) != nullptr; });
  if (is_known) return;
  reader.report(DiagnosticId::attribute_without_meaning, reader.where(name), reader.element().name,
                name, fmt::format("row=\"{}\" of {}", row->ref, pack.full_id()));
}

void make_planes(Workplace& workplace, RoomUgrProblems& ugr_problems, calc::Space& space,
                 const std::vector<RulePack>& packs, LineOfPlane& ids, Total& total,
                 std::vector<WorkplaceNote>& notes, calc::Diagnostics& diagnostics) {
  ElementReader reader(workplace.element, diagnostics);
  const bool is_grid = workplace.element.name == "workplace-grid";
  reader.allow_attributes(is_grid ? workplace_grid_element() : workplace_element());
  check_scene(reader, ugr_problems.scenes());
  const Method method = read_method(reader);
  if (!reader.has("row")) reader.text("row");  // reports its absence
  const RulePack* pack = find_pack(reader, packs);
  if (pack == nullptr) return check_row_values(reader);
  const RuleRow* row = find_row(reader, *pack);
  const RowLevel level = read_level(reader, *pack, row).level;
  std::map<std::string, double> facts = read_facts(reader, *pack);
  check_deviation_roles(reader, *pack);
  const bool has_choice = std::any_of(pack->checks.begin(), pack->checks.end(),
                                      [](const auto& check) { return !check.instead_of.empty(); });
  if (method != Method::as_fits && !has_choice) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("glare"),
                  reader.element().name, "glare", "pack=\"" + pack->full_id() + "\"");
  }
  check_special(reader, *pack, row, calc::kTaskPlaceName, calc::SpecialPlace::unknown_task);
  check_special(reader, *pack, row, "front-wall", calc::SpecialPlace::other_wall);
  if (row == nullptr || workplace.walls.empty()) return;
  const auto problem_of_space = [&](const Quantity& quantity) {
    if (quantity.of_space != Metric::ugr_table) return calc::Message();
    return ugr_problems.of(scene_named(reader, ugr_problems.scenes()));
  };
  WorkplaceMaker maker(*pack, *row, {*pack, row, level, std::move(facts)}, workplace, method,
                       problem_of_space, space, diagnostics);
  maker.check_zones();
  const std::vector<WaivedCheck> waived = read_waived_checks(reader, pack);
  if (!workplace.is_good || !reader.ok()) return;
  maker.run(ids, total);
  if (reader.ok()) check_waived_are_asked(reader, waived, *pack, maker.asked());
  workplace.unmade = maker.unmade();
  if (reader.ok()) notes.push_back({workplace.id, maker.row(), maker.note()});
}

}  // namespace

void make_workplace_planes(calc::Project& project, const std::vector<RulePack>& packs,
                           calc::Diagnostics& diagnostics, bool is_good) {
  LineOfPlane ids;
  Total total;
  for (const calc::Space& space : project.spaces) {
    for (const calc::CalcPlane& plane : space.planes) ids.emplace(plane.id, plane.where.line);
  }
  for (calc::Space& space : project.spaces) {
    std::vector<WorkplaceNote> notes;
    RoomUgrProblems ugr_problems(project, space, is_good);
    std::size_t errors = 0;  // before the first copy
    for (Workplace& workplace : space.workplaces) {
      if (!workplace.is_further_copy) errors = diagnostics.error_count();
      if (workplace.is_further_copy && diagnostics.error_count() > errors) continue;
      make_planes(workplace, ugr_problems, space, packs, ids, total, notes, diagnostics);
    }
    add_notes(notes, space);
    name_shared_planes(space);
  }
}

}  // namespace rules
