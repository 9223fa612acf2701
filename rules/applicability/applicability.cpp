#include "rules/applicability/applicability.h"

#include "calc/base/elementary.h"
#include "calc/base/names.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/project/spaces/plane_area.h"
#include "calc/scene/plane_place.h"
#include "calc/scene/polygon.h"
#include "calc/scene/zone_shapes.h"
#include "rules/applicability/covered_surface.h"
#include "rules/applicability/lost_points.h"
#include "rules/applicability/masked_grid.h"
#include "rules/applicability/obstacles.h"
#include "rules/applicability/place_in_space.h"
#include "rules/applicability/room_border.h"
#include "rules/applicability/route_way.h"
#include "rules/applicability/zone_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rules {
namespace {

using calc::say;
using calc::Sentence;

constexpr double kSameLength_m = 1e-6;
// Greatest height of an upright plane that must be at one height above the floor: half a metre to
// either side.
constexpr double kTallest_m = 1.0 + kSameLength_m;
constexpr double kDegrees = 180.0 / calc::kPi;
// Greatest angle that counts as level or upright: far above the rounding of imports, and at most a
// hundredth of the light.
constexpr double kLevel_deg = 0.1, kLevelSine = 0.1 / kDegrees;

// A check of a pack with what it says about its plane.
struct Meant {
  const RulePack& pack;
  const RuleCheck& check;
  const RuleRow* row;      // may be null
  const RulePlane& plane;  // of the check's role
  const Mask& mask;        // the check's, as it is asked: strips may be narrower
  const Requirement& asked;
};

calc::Message role_words(const Meant& meant) {
  return say<Sentence::role_of>(meant.check.role, meant.pack.full_id());
}

// Returns the orientation as packs name it.
std::string orientation_words(const Meant& meant) {
  if (meant.plane.area == ZoneArea::ceiling) return "horizontal-down";
  if (meant.plane.area == ZoneArea::walls) return std::string(kUpright);
  return orientation_of(meant.plane, meant.row);
}

bool faces(const std::string& orientation, const glm::dvec3& normal) {
  if (orientation == "horizontal-up") return looks_up(normal);
  if (orientation == "horizontal-down") return looks_down(normal);
  if (orientation == kUpright) return looks_sideways(normal);
  return true;  // surface, free
}

class PlaneFit {
 public:
  explicit PlaneFit(const ApplicabilityContext& context) : context_(context) {}

  std::vector<Deviation> deviations(const Meant& meant) const {
    std::vector<Deviation> found;
    const auto add = [&](FitAspect aspect, calc::Message words) {
      if (!words.empty()) found.push_back({aspect, std::move(words), std::nullopt, false});
    };
    add(FitAspect::orientation, orientation(meant));
    if (found.empty()) add(FitAspect::place, place(meant));
    add(FitAspect::height, height(meant));
    add(FitAspect::grid, grid(meant));
    add(FitAspect::margin, margin(meant));
    add(FitAspect::points, points(meant));
    return found;
  }

  calc::Message lost_words() const { return lost().words; }

  // Returns doubts that cannot be settled here, and that readers of the verdict must see.
  calc::Message doubts(const Meant& meant) const {
    const bool is_surface = is_of_surface(meant.plane);
    calc::Message words;
    if (is_surface && !context_.space.shell) words = say<Sentence::surfaces_unknown>();
    if (is_surface || is_route() || !heights_of(meant.plane, meant.row)) return words;
    append(words, platform_words());
    return words;
  }

 private:
  const calc::CalcPlane& plane() const { return context_.plane; }

  static bool is_of_surface(const RulePlane& role) {
    return role.area == ZoneArea::walls || role.area == ZoneArea::ceiling;
  }

  bool is_route() const { return std::holds_alternative<calc::EscapeRoute>(plane().area); }

  const LostPoints& lost() const {
    if (!lost_) lost_ = lost_points(context_.grid);
    return *lost_;
  }

  // Returns whether points face the direction of the plane's normal: planar points and half-spheres
  // do, and points of modelling, which refers to such points.
  bool faces_somewhere() const {
    using enum calc::ReceiverKernel;
    const bool is_plain = (plane().kernel == planar || plane().kernel == hemispherical) &&
                          plane().derived == calc::DerivedQuantity::none;
    return is_plain || plane().derived == calc::DerivedQuantity::modelling;
  }

  // Returns whether the normal is the axis of a cylinder, whose ends are alike. Half-cylinders and
  // eyes face a horizontal direction on any plane, and spheres have no axis.
  bool is_of_cylinders() const {
    return plane().kernel == calc::ReceiverKernel::cylindrical && !faces_somewhere();
  }

  calc::Message orientation(const Meant& meant) const {
    if (is_of_cylinders()) return axis(meant);
    if (!faces_somewhere()) return {};
    const std::vector<glm::dvec3> normals = calc::normals_of(plane());
    const std::string words = orientation_words(meant);
    const bool fits = std::all_of(normals.begin(), normals.end(),
                                  [&](const glm::dvec3& normal) { return faces(words, normal); });
    if (!fits) {
      return is_route() ? say<Sentence::wrong_way_route>(role_words(meant), words)
                        : say<Sentence::wrong_way>(role_words(meant), words);
    }
    if (const double leans_deg = leaning_deg(meant, words, normals); leans_deg > kLevel_deg) {
      return say<Sentence::leans>(role_words(meant), words, leans_deg);
    }
    // Luminaires are seen from behind a plane, too.
    if (is_lower_limit(meant.check.comparison) || meant.check.quantity->of_space) return {};
    if (const calc::Body* body = body_before(plane(), context_.space)) {
      return say<Sentence::behind_surface>(body->id);
    }
    const auto& scenes = context_.project.scenes;
    const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& one) { return one.id == meant.asked.scene; });
    if (!calc::faces_away(context_.project, context_.space, plane(),
                          scene == scenes.end() ? nullptr : &*scene)) {
      return {};
    }
    return is_route() ? say<Sentence::faces_away_route>() : say<Sentence::faces_away>();
  }

  // Returns the angle from level or upright, in degrees. 0 for planes along a ramp, a board or a
  // wall on which they lie, and for walls and the ceiling, which are checked by their place. A few
  // degrees matter: if luminaires are far to the side they are half of the light.
  double leaning_deg(const Meant& meant, const std::string& orientation,
                     const std::vector<glm::dvec3>& normals) const {
    const bool is_upright = orientation == kUpright;
    const bool is_level = orientation == "horizontal-up" || orientation == "horizontal-down";
    if (is_of_surface(meant.plane) || (!is_upright && !is_level)) return 0.0;
    double most_deg = 0.0;
    for (const glm::dvec3& normal : normals) {
      const double off =
          std::min(1.0, is_upright ? std::abs(normal.z) : glm::length(glm::dvec2(normal)));
      most_deg = std::max(most_deg, calc::asin(off) * kDegrees);
    }
    if (most_deg <= kLevel_deg) return 0.0;
    return lies_along(plane(), context_.space) ? 0.0 : most_deg;
  }

  calc::Message axis(const Meant& meant) const {
    const std::vector<glm::dvec3> axes = calc::normals_of(plane());
    const std::string asked = orientation_words(meant);
    const auto unfit = std::find_if(axes.begin(), axes.end(), [&](const glm::dvec3& end) {
      const double off = asked == kUpright ? std::abs(end.z) : glm::length(glm::dvec2(end));
      return asked != "free" && asked != "surface" && off > kLevelSine;
    });
    if (unfit == axes.end()) return {};
    const bool is_upright = asked != kUpright;
    const double leans_deg = calc::acos(std::min(1.0, std::abs(unfit->z))) * kDegrees;
    return is_upright ? say<Sentence::cylinders_lean>(role_words(meant), leans_deg)
                      : say<Sentence::cylinders_stand>(role_words(meant), leans_deg);
  }

  calc::Message place(const Meant& meant) const {
    if (meant.plane.area == ZoneArea::walls && !lies_on(plane(), context_.space, ".wall")) {
      return is_route() ? say<Sentence::on_no_wall_route>(role_words(meant))
                        : say<Sentence::on_no_wall>(role_words(meant));
    }
    if (meant.plane.area == ZoneArea::ceiling && !lies_on(plane(), context_.space, ".ceiling")) {
      return is_route() ? say<Sentence::not_on_ceiling_route>(role_words(meant))
                        : say<Sentence::not_on_ceiling>(role_words(meant));
    }
    const calc::Message words = extent(meant);
    return words.empty() ? around(meant) : words;
  }

  // Checks that a zone around another of the same row, or with another inside it, is drawn as a
  // whole: a part of it could be chosen where it is bright enough. Zones that a workplace makes by
  // the rule are whole.
  calc::Message around(const Meant& meant) const {
    const RulePlane& role = meant.plane;
    const std::string& inside = role_inside(meant);
    const bool is_by_rule = !plane().made_by.empty() && !plane().has_own_area;
    if (inside.empty() || is_by_rule || meant.row == nullptr) return {};
    double to_m = role.width_m;
    std::vector<const calc::CalcPlane*> inner = planes_of_role(meant, inside);
    // Of a background without a surround that is asked: around the task.
    for (const RulePlane* band = meant.pack.find_plane(inside);
         inner.empty() && band != nullptr && !band->around.empty();
         band = meant.pack.find_plane(band->around)) {
      to_m += band->width_m;
      inner = planes_of_role(meant, band->around);
    }
    if (inner.empty()) return {};  // who reads of the row sees that nothing of it was asked
    const bool is_band = !role.around.empty();
    if (is_band) {
      const calc::Message words = beside(meant, inner, to_m);
      if (!words.empty()) return words;
    }
    return all_around(meant, inner, to_m);
  }

  // Returns the role of the zone inside; "" = such a plane has none. Eyes are in the task's zone,
  // where people are.
  const std::string& role_inside(const Meant& meant) const {
    static const std::string none;
    const RulePlane& role = meant.plane;
    if (!role.around.empty()) return role.around;
    if (!role.holds.empty()) return role.holds;
    if (role.area != ZoneArea::task_and_band) return none;
    if (calc::has_look(plane().kernel, plane().derived)) return none;
    for (const RulePlane& other : meant.pack.planes) {
      if (other.area == ZoneArea::task) return other.role;
    }
    return none;
  }

  // Checks that the plane is outside of the zones inside it, and next to one of them.
  calc::Message beside(const Meant& meant, const std::vector<const calc::CalcPlane*>& inner,
                       double width_m) const {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const calc::CalcPlane* zone : inner) {
      const ZoneContact contact = contact_with(*zone, context_.grid);
      nearest_m = std::min(nearest_m, contact.nearest_m);
      const std::size_t points = context_.grid.position_m.size();
      const double share = static_cast<double>(contact.inside) / static_cast<double>(points);
      if (share <= meant.plane.missing_share) continue;
      return say<Sentence::in_inner_zone>(role_words(meant), meant.plane.around, contact.inside,
                                          points, zone->id);
    }
    const double widest_m = std::max(context_.grid.spacing_u_m, context_.grid.spacing_v_m);
    if (nearest_m <= width_m + widest_m) return {};
    return say<Sentence::no_inner_zone>(role_words(meant), meant.plane.around, width_m);
  }

  // Checks that the plane covers all surroundings of a zone inside it, with the zone itself if it
  // belongs to them.
  calc::Message all_around(const Meant& meant, const std::vector<const calc::CalcPlane*>& inner,
                           double to_m) const {
    const auto* area = std::get_if<calc::PlanarArea>(&plane().area);
    if (area == nullptr) return {};  // a list: its points are no grid
    const bool has_inner = meant.plane.around.empty();
    const double own_strip_m = std::max(area->margin_m, mask_strip_m(meant, MaskStep::inset));
    std::vector<const calc::PlanarArea*> zones;
    for (const calc::CalcPlane* one : inner) {
      if (const auto* zone = std::get_if<calc::PlanarArea>(&one->area)) zones.push_back(zone);
    }
    double best = 0.0;  // share
    for (const calc::PlanarArea* zone : zones) {
      const ZoneAround around{zone, to_m - meant.plane.width_m, to_m, has_inner};
      if (!comes_near(*area, around)) continue;
      std::vector<const calc::PlanarArea*> others;
      std::copy_if(zones.begin(), zones.end(), std::back_inserter(others),
                   [&](const auto* other) { return other != zone; });
      const double covered = covered_zone(*area, own_strip_m, around, others, context_.space,
                                          strip_along_walls_m(meant));
      best = std::max(best, covered);
    }
    if (zones.empty() || best >= 1.0 - meant.plane.missing_share) return {};
    const std::string& role = role_inside(meant);
    const double width_m = meant.plane.width_m;
    const calc::Message whole = !has_inner      ? say<Sentence::whole_band>(width_m, role)
                                : width_m > 0.0 ? say<Sentence::whole_zone_and_band>(role, width_m)
                                                : say<Sentence::whole_zone>(role);
    return say<Sentence::covers_part>(role_words(meant), whole,
                                      say<Sentence::part_of_zone>(std::floor(100.0 * best)));
  }

  // Returns the planes of the space of which the same row requires something in this role; for a
  // workplace only its own.
  std::vector<const calc::CalcPlane*> planes_of_role(const Meant& meant,
                                                     const std::string& role) const {
    std::map<std::string_view, const calc::CalcPlane*> by_id;
    for (const calc::CalcPlane& other : context_.space.planes) by_id[other.id] = &other;
    std::set<const calc::CalcPlane*> planes;
    for (const Requirement& one : context_.of_project) {
      const RuleOrigin& origin = one.origin;
      if (origin.row != meant.row->ref || origin.pack != meant.pack.full_id()) continue;
      const RuleCheck* check = meant.pack.find_check(origin.check);
      if (check == nullptr || check->role != role) continue;
      const std::vector<std::string>& own = meant.asked.origin.workplaces;
      const bool is_own =
          own.empty() || std::find_first_of(own.begin(), own.end(), origin.workplaces.begin(),
                                            origin.workplaces.end()) != own.end();
      if (!is_own) continue;
      if (const auto found = by_id.find(one.plane_id); found != by_id.end()) {
        planes.insert(found->second);
      }
    }
    std::vector<const calc::CalcPlane*> in_order;
    for (const calc::CalcPlane& other : context_.space.planes) {
      if (planes.contains(&other)) in_order.push_back(&other);
    }
    return in_order;
  }

  // Checks that a plane covers all of a wall or the ceiling that the role counts: a part of it
  // could be chosen where it is bright enough.
  calc::Message extent(const Meant& meant) const {
    const bool is_wall = meant.plane.area == ZoneArea::walls;
    if (!is_wall && meant.plane.area != ZoneArea::ceiling) return {};
    const auto* area = std::get_if<calc::PlanarArea>(&plane().area);
    if (area == nullptr) return {};  // a list: its points are no grid
    const double strip_m = allowed_margin_m(meant);
    const double own_strip_m =
        std::max(std::min(area->margin_m, strip_m), mask_strip_m(meant, MaskStep::inset));
    calc::Message words;
    for (const CoveredSurface& surface :
         covered_surfaces(*area, own_strip_m,
                          surfaces_of(context_.space, is_wall ? ".wall" : ".ceiling"), strip_m)) {
      if (surface.share >= 1.0 - meant.plane.missing_share) continue;
      append(words, say<Sentence::part_of_surface>(std::floor(100.0 * surface.share),
                                                   surface.area_m2, surface.id));
    }
    if (words.empty()) return words;
    if (strip_m > 0.0) words += " (" + say<Sentence::edges_count_not>(strip_m) + ")";
    return say<Sentence::covers_part>(
        role_words(meant), is_wall ? say<Sentence::whole_wall>() : say<Sentence::whole_ceiling>(),
        words);
  }

  calc::Message height(const Meant& meant) const {
    const RulePlane& role = meant.plane;
    const std::optional<RuleRow::Heights> asked = heights_of(role, meant.row);
    if (!asked) return {};
    const auto [from_m, to_m] = *asked;
    const auto [lowest_m, highest_m] = heights_above_floor_m(plane(), context_.space);
    // An upright plane has its own height: half of it must be at the required heights, or it must
    // have half of these.
    const bool is_upright = orientation_of(role, meant.row) == kUpright;
    const double from = from_m - kLift_m, to = to_m + kLift_m;
    const double shared_m = std::min(highest_m, to) - std::max(lowest_m, from);
    // If a single height is required, the middle of the plane is there, and no point is far from
    // it.
    const bool is_one = is_upright && to_m - from_m < kLift_m;
    const double middle_m = 0.5 * (lowest_m + highest_m);
    const bool fits = is_one
                          ? middle_m >= from && middle_m <= to && highest_m - lowest_m <= kTallest_m
                      : is_upright ? shared_m >= 0.5 * std::min(highest_m - lowest_m, to_m - from_m)
                                   : lowest_m >= from && highest_m <= to;
    if (fits) return {};
    const auto range = [](double low, double high) {
      return std::abs(high - low) < 5e-4 ? calc::Message::number(fmt::format("{:.3g} m", low))
                                         : say<Sentence::metres_from_to>(low, high);
    };
    const bool is_of_row = !role.has_heights || from_m != role.lowest_m || to_m != role.highest_m;
    const calc::Message role_is = role_words(meant);
    const calc::Message of = range(from_m, to_m), own = range(lowest_m, highest_m);
    if (is_of_row) {
      return is_route() ? say<Sentence::height_of_row_route>(role_is, of, meant.row->ref, own)
                        : say<Sentence::height_of_row>(role_is, of, meant.row->ref, own);
    }
    if (role.are_heights_usual) {
      return is_route() ? say<Sentence::height_usual_route>(role_is, of, own)
                        : say<Sentence::height_usual>(role_is, of, own);
    }
    return is_route() ? say<Sentence::height_fixed_route>(role_is, of, own)
                      : say<Sentence::height_fixed>(role_is, of, own);
  }

  // Checks the number of points: fewer points than the rule gives to the same area miss extremes,
  // so a minimum is higher and a uniformity better. More are fine.
  calc::Message grid(const Meant& meant) const {
    const RuleGrid* rule = meant.pack.find_grid(meant.plane.grid);
    if (rule == nullptr || !rule->rule) return {};
    const calc::SensorGrid& own = context_.grid;
    if (own.columns == 0) {
      return say<Sentence::no_grid>(role_words(meant));
    }
    if (own.route) {
      const calc::Message words = grid_of_route(meant, *rule);
      return words.empty() ? grid_behind_mask(meant, *rule) : words;
    }
    const double u_m = own.columns * own.spacing_u_m, v_m = own.rows * own.spacing_v_m;
    const calc::GridCounts asked = asked_counts(*rule, u_m, v_m);
    if (own.columns < asked.columns || own.rows < asked.rows) {
      return say<Sentence::grid_too_wide>(own.columns, own.rows, role_words(meant), asked.columns,
                                          asked.rows);
    }
    if (const calc::Message words = cells_along_sides(meant, *rule); !words.empty()) return words;
    if (const calc::Message words = cut_out(meant); !words.empty()) return words;
    if (own.missed_m2 > 0.0) {
      return say<Sentence::grid_misses>(own.missed_m2);
    }
    return grid_behind_mask(meant, *rule);
  }

  // Checks the holes of a drawn plane whose role is no band and whose extent is not checked
  // otherwise: holes larger than bodies may be would make it another area, with its dark parts
  // omitted by choice.
  calc::Message cut_out(const Meant& meant) const {
    const auto* area = std::get_if<calc::PlanarArea>(&plane().area);
    const bool is_held = is_of_surface(meant.plane) || !role_inside(meant).empty();
    if (area == nullptr || !plane().made_by.empty() || is_held) return {};
    const double whole_m2 = std::abs(calc::signed_area(area->outline_m));
    const double cut_m2 = whole_m2 - calc::area_left(area->outline_m, area->holes_m);
    if (cut_m2 <= meant.plane.missing_share * whole_m2) return {};
    return say<Sentence::holes_take>(cut_m2, whole_m2);
  }

  // Checks the cells along the sides of the area, to which a formula refers: a grid at an angle to
  // them may be that of a larger area.
  calc::Message cells_along_sides(const Meant& meant, const RuleGrid& rule) const {
    const auto* area = std::get_if<calc::PlanarArea>(&plane().area);
    if (area == nullptr || !std::holds_alternative<calc::GridByRule>(*rule.rule)) return {};
    const glm::dvec2 axis = calc::long_axis(area->outline_m);
    if (axis.x >= 1.0) return {};  // it stands along them
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec2& corner : area->outline_m) {
      const glm::dvec2 place(glm::dot(corner, axis), axis.x * corner.y - axis.y * corner.x);
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
    const glm::dvec2 side_m = high - low - 2.0 * area->margin_m;
    if (!(side_m.x > 0.0 && side_m.y > 0.0)) return {};
    const calc::GridCounts asked = asked_counts(rule, side_m.x, side_m.y);
    const double most_m = std::max(side_m.x / asked.columns, side_m.y / asked.rows);
    const calc::SensorGrid& own = context_.grid;
    if (std::max(own.spacing_u_m, own.spacing_v_m) <= most_m + kSameLength_m) return {};
    return say<Sentence::cells_too_wide>(own.spacing_u_m, own.spacing_v_m, role_words(meant),
                                         most_m);
  }

  // Checks the grid of the area that a mask leaves, which the number is about: a formula gives a
  // small area a closer grid than a large one. A spacing is the same everywhere, and a count is for
  // the whole area: for these the cells that the mask cuts must not omit more than allowed.
  calc::Message grid_behind_mask(const Meant& meant, const RuleGrid& rule) const {
    if (std::holds_alternative<calc::GridByRule>(*rule.rule)) {
      if (const std::optional<CellsLeft> left = cells_left(meant.mask, context_.grid)) {
        const calc::GridCounts asked = asked_counts(rule, left->u_m, left->v_m);
        if (left->columns < asked.columns || left->rows < asked.rows) {
          return say<Sentence::grid_behind_mask>(left->columns, left->rows, role_words(meant),
                                                 asked.columns, asked.rows, left->u_m, left->v_m);
        }
      }
      return {};
    }
    const std::optional<MaskGap> gap = mask_gap(meant.mask, context_.grid, rule);
    if (!gap) return {};
    return say<Sentence::grid_gap>(gap->to_point_m, role_words(meant), gap->most_m);
  }

  // Checks each leg of a route as an area of its own; a count of cells is for the whole route.
  calc::Message grid_of_route(const Meant& meant, const RuleGrid& rule) const {
    const calc::SensorGrid& own = context_.grid;
    const calc::RouteLine& line = own.route->line;
    const double width_m = line.width_m, whole_m = calc::route_length_m(line);
    const auto problem = [&](int columns, const calc::GridCounts& asked,
                             const calc::Message& where) {
      if (columns >= asked.columns && own.rows >= asked.rows) return calc::Message();
      return say<Sentence::grid_along>(columns, own.rows, where, role_words(meant), asked.columns,
                                       asked.rows);
    };
    if (std::holds_alternative<calc::GridByCount>(*rule.rule)) {
      return problem(own.columns, asked_counts(rule, whole_m, width_m), say<Sentence::the_route>());
    }
    const std::vector<calc::RouteLeg> legs = calc::route_legs(line);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const calc::GridCounts asked = asked_counts(rule, legs[i].longer_edge_m(width_m), width_m);
      calc::Message words =
          problem(own.route->stations[i], asked, say<Sentence::leg_of_route>(i + 1));
      if (!words.empty()) return words;
    }
    return {};
  }

  // Returns the widest strip that the role omits: its own margin, or that of its mask.
  double allowed_margin_m(const Meant& meant) const {
    return std::max(strip_along_walls_m(meant), strip_along_outline_m(meant));
  }

  // Returns the strip omitted along walls: the margin, or that of its mask.
  double strip_along_walls_m(const Meant& meant) const {
    const double width_m = room_width_m(context_.space, meant.plane.narrow_m);
    return std::max(margin_in_room_m(meant.plane, width_m), mask_strip_m(meant, MaskStep::walls));
  }

  // Returns the strip omitted along any outline: that of its mask; for walls and the ceiling also
  // their margin.
  double strip_along_outline_m(const Meant& meant) const {
    const double strip_m = mask_strip_m(meant, MaskStep::inset);
    return is_of_surface(meant.plane) ? std::max(strip_m, meant.plane.margin_m) : strip_m;
  }

  double mask_strip_m(const Meant& meant, MaskStep step) const {
    double strip_m = 0.0;
    for (const MaskOperation& operation :
         mask_at(meant.mask, context_.grid.room_m.empty()).operations) {
      if (operation.step == step) strip_m = std::max(strip_m, operation.metres);
    }
    return strip_m;
  }

  // Checks the margin: the strip along walls is only omitted where walls are: a desk counts up to
  // its edge.
  calc::Message margin(const Meant& meant) const {
    const auto* area = std::get_if<calc::PlanarArea>(&plane().area);
    if (area == nullptr) return {};
    const double along_walls_m = strip_along_walls_m(meant);
    const double along_outline_m = strip_along_outline_m(meant);
    const double most_m = std::max(along_walls_m, along_outline_m);
    if (area->margin_m > most_m + kSameLength_m) {
      return say<Sentence::margin_too_wide>(area->margin_m, role_words(meant), most_m);
    }
    if (area->margin_m <= along_outline_m + kSameLength_m) return {};
    const bool is_level = looks_up(area->normal()) || looks_down(area->normal());
    const double off_m = is_level ? distance_from_walls_m(*area, context_.space)
                                  : std::numeric_limits<double>::infinity();
    const double beside_m = off_m <= kLift_m ? along_walls_m : along_walls_m - off_m;
    if (area->margin_m <= beside_m + kSameLength_m) return {};
    return say<Sentence::margin_off_walls>(area->margin_m, role_words(meant), along_walls_m);
  }

  calc::Message points(const Meant& meant) const {
    if (!barred().empty()) {
      calc::Message words = barred();
      append(words, lost().words);
      return words;
    }
    const bool is_of_each = meant.asked.metric != Metric::average;
    if (is_of_each && points_in_posts(context_.grid, context_.space) > 0) return lost().words;
    if (lost().share() <= meant.plane.missing_share) return {};
    if (is_beside_the_task(meant.plane) && share_lost_otherwise() <= meant.plane.missing_share) {
      return {};
    }
    return lost().words;
  }

  // Returns whether it is a band made by a workplace, which may end early at a wall or a rack.
  // Whoever draws a band can see the rack.
  bool is_beside_the_task(const RulePlane& role) const {
    if (plane().made_by.empty()) return false;
    return role.area == ZoneArea::band || role.area == ZoneArea::task_and_band;
  }

  // Returns the share of omitted points, without those in obstacles.
  double share_lost_otherwise() const {
    const std::size_t in_obstacles = points_in_obstacles(context_.grid, context_.space);
    return LostPoints{lost().lost - in_obstacles, lost().all - in_obstacles, {}}.share();
  }

  const ApplicabilityContext& context_;
  // Once, not for each requirement of the plane.
  const calc::Message& barred() const {
    if (!barred_) barred_ = barred_words(context_.grid, context_.space);
    return *barred_;
  }

  const calc::Message& platform_words() const {
    if (platform_) return *platform_;
    const std::optional<Platform> found = platform_below(plane(), context_.grid, context_.space);
    platform_ = found ? say<Sentence::above_platform>(found->id, found->height_m) : calc::Message();
    return *platform_;
  }

  mutable std::optional<calc::Message> platform_;
  mutable std::optional<LostPoints> lost_;
  mutable std::optional<calc::Message> barred_;
};

// Returns types of the space's luminaires that state no maintenance factor, in their order.
std::vector<calc::Message> types_without_factor(const ApplicabilityContext& context) {
  std::vector<calc::Message> ids;
  for (const calc::Luminaire& luminaire : context.space.luminaires) {
    const calc::LuminaireType& type = context.project.luminaire_types[luminaire.type];
    if (type.maintenance.is_stated || !type.counts_as_luminaire()) continue;
    calc::Message id = say<Sentence::quoted>(type.id);
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(std::move(id));
  }
  return ids;
}

calc::Message maintenance_problem(const ApplicabilityContext& context,
                                  const Requirement& requirement) {
  const bool has_no_light = is_of_space(requirement.metric) && !is_of_road(requirement.metric);
  if (requirement.state == LightState::initial || has_no_light) return {};
  const std::vector<calc::Message> ids = types_without_factor(context);
  if (ids.empty()) return {};
  constexpr std::size_t kMostNamed = 3;
  const calc::Message names = calc::listed(ids, kMostNamed);
  return ids.size() == 1 ? say<Sentence::no_factor>(names) : say<Sentence::no_factors>(names);
}

// Returns deviations of checks that are only about level ways.
std::vector<Deviation> slope_deviations(const calc::CalcPlane& plane, const RulePack& pack,
                                        const RuleCheck& check) {
  if (!check.is_level_only) return {};
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -lowest_m;
  for (const glm::dvec3& place : calc::places_of(plane)) {
    lowest_m = std::min(lowest_m, place.z);
    highest_m = std::max(highest_m, place.z);
  }
  constexpr double kThreshold_m = 0.1;  // a door sill is no stair
  const double rise_m = highest_m - lowest_m;
  if (!(rise_m > kThreshold_m)) return {};
  calc::Message words =
      say<Sentence::not_level>(say<Sentence::role_of>(check.role, pack.full_id()), rise_m);
  return {{FitAspect::height, std::move(words), std::nullopt, false}};
}

// Returns words for stated deviations that are not found: the plane was corrected, or another was
// meant. A workplace states them for all planes of a role, of which only some may need it.
calc::Message unfounded_words(const Requirement& requirement) {
  if (!requirement.origin.workplaces.empty()) return {};
  calc::Message text;
  for (const StatedDeviation& stated : requirement.stated_deviations) {
    const auto& found = requirement.deviations;
    const bool is_found = std::any_of(found.begin(), found.end(), [&](const Deviation& deviation) {
      return deviation.aspect == stated.aspect;
    });
    if (is_found) continue;
    append(text, say<Sentence::unfounded_deviation>(calc::name_of(stated.aspect)));
  }
  return text;
}

// Accepts deviations that the project states; returns the words of all others.
calc::Message take_statements(const Requirement& requirement, std::string_view today,
                              std::vector<Deviation>& found) {
  calc::Message open;
  for (Deviation& deviation : found) {
    const auto& all = requirement.stated_deviations;
    const auto stated = std::find_if(all.begin(), all.end(), [&](const StatedDeviation& one) {
      return one.aspect == deviation.aspect;
    });
    if (stated != all.end()) {
      deviation.stated = stated->by;
      deviation.is_accepted = stated->by.holds_on(today);
    }
    if (deviation.is_accepted) continue;
    append(open, deviation.words);
    if (deviation.stated) {
      open += " (" + say<Sentence::stated_until>(deviation.stated->owner, deviation.stated->until) +
              ")";
    } else {
      open += " (" + say<Sentence::would_state>(calc::name_of(deviation.aspect)) + ")";
    }
  }
  return open;
}

}  // namespace

calc::Message small_task_words(const calc::CalcPlane& plane, const calc::SensorGrid& grid) {
  constexpr double kSpeck_m2 = 0.1;  // about 0.3 x 0.3 m
  if (const auto* route = std::get_if<calc::EscapeRoute>(&plane.area)) {
    const double route_m2 = calc::route_length_m(route->line) * route->line.width_m;
    return route_m2 < kSpeck_m2 ? say<Sentence::speck_route>(route_m2) : calc::Message();
  }
  const auto* area = std::get_if<calc::PlanarArea>(&plane.area);
  if (area == nullptr) return {};
  double area_m2 = calc::area_left(area->outline_m, area->holes_m);  // holes may overlap
  if (area->margin_m > 0.0 && grid.columns > 0) {
    const double cell_m2 = grid.spacing_u_m * grid.spacing_v_m;
    area_m2 = std::min(area_m2, static_cast<double>(lost_points(grid).all) * cell_m2);
  }
  if (!(area_m2 < kSpeck_m2)) return {};
  return say<Sentence::speck>(std::max(area_m2, 0.0));
}

void check_applicability(const ApplicabilityContext& context,
                         std::vector<Requirement>& requirements) {
  const PlaneFit fit(context);
  for (Requirement& requirement : requirements) {
    const auto is_it = [&](const RulePack& p) { return p.full_id() == requirement.origin.pack; };
    const auto pack = std::find_if(context.packs.begin(), context.packs.end(), is_it);
    const RuleCheck* check =
        pack == context.packs.end() ? nullptr : pack->find_check(requirement.origin.check);
    // Of luminaires as seen from points, these are of the plane.
    if (is_of_space(requirement.metric) && !is_of_points(requirement.metric)) {
      const bool is_free = requirement.origin.pack.empty() || !requirement.problem.empty();
      if (!is_free) requirement.problem = maintenance_problem(context, requirement);
      if (check == nullptr) continue;
      requirement.deviations = slope_deviations(context.plane, *pack, *check);
      const calc::Message open =
          take_statements(requirement, context.today, requirement.deviations);
      append(requirement.note, unfounded_words(requirement));
      if (requirement.problem.empty()) requirement.problem = open;
      continue;
    }
    const Mask* mask = &requirement.mask;
    // Glare outdoors is rated on the area that the row is about, which must be fit for the row.
    if (check != nullptr && requirement.metric == Metric::glare_rating) {
      const Requirement* area = area_of(requirement, requirements);
      check = area == nullptr ? nullptr : pack->find_check(area->origin.check);
      if (area != nullptr) mask = &area->mask;
    }
    const RulePlane* role = check == nullptr ? nullptr : pack->find_plane(check->role);
    if (role != nullptr) {
      const Meant meant{*pack, *check, pack->find_row(requirement.origin.row),
                        *role, *mask,  requirement};
      append(requirement.note, small_task_words(context.plane, context.grid));
      append(requirement.note, fit.doubts(meant));
      requirement.deviations = fit.deviations(meant);
    }
    const calc::Message open = take_statements(requirement, context.today, requirement.deviations);
    append(requirement.note, unfounded_words(requirement));
    const bool is_told = std::any_of(
        requirement.deviations.begin(), requirement.deviations.end(),
        [](const Deviation& deviation) { return deviation.aspect == FitAspect::points; });
    if (!is_told) append(requirement.note, fit.lost_words());
    append(requirement.note, inner_words(context.grid));
    const bool counts_points =
        requirement.metric == Metric::percentile || requirement.metric == Metric::share;
    if (counts_points && !calc::point_weights(context.grid).empty()) {
      append(requirement.note, say<Sentence::points_alike>());
    }
    if (check == nullptr || !requirement.problem.empty()) continue;
    requirement.problem = maintenance_problem(context, requirement);
    if (requirement.problem.empty()) requirement.problem = open;
  }
}

}  // namespace rules
