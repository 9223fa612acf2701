#include "calc/scene/sensor_grid.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/sentences.h"
#include "calc/scene/grid_coverage.h"
#include "calc/scene/polygon.h"
#include "calc/scene/walking_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace calc {
namespace {

constexpr double kTie = 1.0e-9;  // relative; sides like 5.999999999 m come out of CAD files
constexpr double kOnFloor_m = 1.0e-6;
constexpr double kMaxPoints = 4.0e6;
constexpr double kMinCellAspect = 0.5, kMaxCellAspect = 2.0;  // EN 12464-1

// As doubles until it is known that they are few enough.
struct Counts {
  double columns = 0.0, rows = 0.0;
};

// What a rule makes of two sides.
struct RuleSpacing {
  double d_m = 0.0;  // the side that counts
  bool is_shorter = false, is_capped = false;
  double spacing_m = 0.0;
};

RuleSpacing spacing_by_rule(const GridByRule& rule, double side_u_m, double side_v_m) {
  const double longer = std::max(side_u_m, side_v_m), shorter = std::min(side_u_m, side_v_m);
  RuleSpacing result;
  result.is_shorter = longer >= rule.shorter_from_ratio * shorter * (1.0 - kTie);
  result.d_m = result.is_shorter ? shorter : longer;
  result.spacing_m = rule.factor_m * calc::pow(rule.base, calc::log10(result.d_m));
  result.is_capped = result.spacing_m > rule.max_spacing_m;
  if (result.is_capped) result.spacing_m = rule.max_spacing_m;
  return result;
}

double rounded_cells(double cells, GridRounding rounding) {
  if (rounding == GridRounding::nearest) {
    return std::max(1.0, std::floor(cells * (1.0 + kTie) + 0.5));
  }
  const double up = std::max(1.0, std::ceil(cells * (1.0 - kTie)));
  return rounding == GridRounding::odd_up && std::fmod(up, 2.0) < 0.5 ? up + 1.0 : up;
}

Counts counts_by_rule(const GridByRule& rule, double side_u_m, double side_v_m) {
  const double spacing_m = spacing_by_rule(rule, side_u_m, side_v_m).spacing_m;
  return {rounded_cells(side_u_m / spacing_m, rule.rounding),
          rounded_cells(side_v_m / spacing_m, rule.rounding)};
}

// Rounded up, so that the spacing is never larger than asked for.
double cells_by_spacing(double side_m, double spacing_m) {
  return std::max(1.0, std::ceil(side_m / spacing_m * (1.0 - kTie)));
}

Counts cell_counts(const GridRule& rule, glm::dvec2 side_m) {
  if (const auto* count = std::get_if<GridByCount>(&rule)) {
    return {static_cast<double>(count->columns), static_cast<double>(count->rows)};
  }
  if (const auto* spacing = std::get_if<GridBySpacing>(&rule)) {
    return {cells_by_spacing(side_m.x, spacing->along_u_m),
            cells_by_spacing(side_m.y, spacing->along_v_m)};
  }
  return counts_by_rule(std::get<GridByRule>(rule), side_m.x, side_m.y);
}

Message rule_words(const GridRule& rule, glm::dvec2 side_m) {
  if (std::holds_alternative<GridByCount>(rule)) return say<Sentence::grid_by_count>();
  if (const auto* spacing = std::get_if<GridBySpacing>(&rule)) {
    if (spacing->name.empty()) return say<Sentence::grid_by_spacing>();
    return say<Sentence::grid_at_most>(spacing->name, spacing->along_u_m, spacing->along_v_m);
  }
  return grid_words(std::get<GridByRule>(rule), side_m.x, side_m.y);
}

struct Rectangle {
  glm::dvec2 lower{0.0}, upper{0.0};

  glm::dvec2 side_m() const { return upper - lower; }
};

Rectangle bounding_rectangle(const std::vector<glm::dvec2>& outline) {
  if (outline.empty()) return {};
  Rectangle box{outline[0], outline[0]};
  for (const glm::dvec2& corner : outline) {
    box.lower = glm::min(box.lower, corner);
    box.upper = glm::max(box.upper, corner);
  }
  return box;
}

// Rows are odd in number, so that one is on the line.
Counts route_counts(const EscapeRoute& route, const std::vector<double>& stations) {
  const double least = route.is_spacing_given ? 1.0 : kLeastRouteRows;
  const double rows =
      std::max(least, cells_by_spacing(route.line.width_m, route.spacing.along_v_m));
  double columns = 0.0;
  for (const double count : stations) columns += count;
  return {columns, std::fmod(rows, 2.0) < 0.5 ? rows + 1.0 : rows};
}

Message route_words(const EscapeRoute& route) {
  const double along_m = route.spacing.along_u_m, across_m = route.spacing.along_v_m;
  return route.is_spacing_given
             ? say<Sentence::grid_of_route>(along_m, across_m)
             : say<Sentence::grid_of_route_from>(along_m, across_m, kLeastRouteRows);
}

Rectangle inside_margin(const PlanarArea& area) {
  const Rectangle bounds = bounding_rectangle(area.outline_m);
  return {bounds.lower + area.margin_m, bounds.upper - area.margin_m};
}

bool has_inside(const Rectangle& inner) { return inner.side_m().x > 0.0 && inner.side_m().y > 0.0; }

// Cells of a rule reach every part of the area; those that are given by count or a plain spacing
// stay as they are.
bool must_reach_every_part(const GridRule& rule) {
  const auto* spacing = std::get_if<GridBySpacing>(&rule);
  return std::holds_alternative<GridByRule>(rule) || (spacing != nullptr && !spacing->name.empty());
}

std::optional<MissedPart> part_missed_by(const PlanarArea& area, const Rectangle& inner,
                                         const Counts& counts) {
  return missed_part(area, {inner.lower, inner.side_m() / glm::dvec2(counts.columns, counts.rows),
                            static_cast<int>(counts.columns), static_cast<int>(counts.rows)});
}

// Along both sides of a cell; odd, so that all points there are stay.
constexpr std::array kParts{1.0, 3.0, 5.0, 7.0};

// The cells of a rule go by the bounding rectangle, and an arm of the area may lie between their
// centres. What a rule gives is the largest spacing: odd parts of it keep all points there are.
// Into how many parts each cell is divided along both sides, so that every part of the area has a
// point; empty: none of these does.
std::optional<double> parts_that_reach(const PlanarArea& area, const Rectangle& inner,
                                       const Counts& counts) {
  for (const double parts : kParts) {
    const Counts finer{parts * counts.columns, parts * counts.rows};
    if (!(finer.columns * finer.rows <= kMaxPoints)) break;
    if (!part_missed_by(area, inner, finer)) return parts;
  }
  return std::nullopt;
}

// A point that counts as outside of an open mesh, though little of it is open.
struct NearlyInside {
  glm::dvec3 position_m;
  std::string body;
};

// Adds candidates one by one and keeps the account.
class GridBuilder {
 public:
  // region: of all candidates. nearly_inside: gets those that an open mesh encloses nearly.
  GridBuilder(const Space& space, const BoundingBox& region, SensorGrid& grid,
              std::vector<NearlyInside>& nearly_inside)
      : filter_(space, grid.kernel, region), grid_(grid), nearly_inside_(nearly_inside) {}

  // `reason`: already known to be dropped because of the plane's own outline.
  void add(const CandidatePoint& candidate, int column, int row,
           std::optional<DropReason> reason = std::nullopt) {
    const glm::dvec3& point = candidate.position_m;
    if (reason) return drop({point, column, row, *reason, {}});
    PointStand stand = filter_.stand(candidate);
    if (stand.dropped) return drop({point, column, row, *stand.dropped, std::move(stand.body)});
    if (!stand.open_body.empty()) nearly_inside_.push_back({point, std::move(stand.open_body)});
    if (!stand.body.empty()) {
      grid_.inner.push_back({grid_.position_m.size(), std::move(stand.body)});
    }
    grid_.position_m.push_back(point);
    grid_.shift_m.push_back(stand.shift_m);
    grid_.normal.push_back(candidate.axis);
    grid_.column.push_back(column);
    grid_.row.push_back(row);
  }

  void drop(DroppedPoint point) { grid_.dropped.push_back(std::move(point)); }

  // A point of a route, above what is walked on below `on_line`.
  void add_above(const WalkingSurface& surface, const glm::dvec3& on_line, double height_m,
                 int column, int row) {
    constexpr glm::dvec3 kUp(0.0, 0.0, 1.0);
    if (filter_.is_beside_room(on_line)) {
      return drop({on_line, column, row, DropReason::outside_room, {}});
    }
    const WalkingSurface::Found found = surface.below(on_line);
    if (found.obstacle != nullptr) {
      return drop({on_line, column, row, DropReason::in_the_way, *found.obstacle});
    }
    if (!found.z_m) return drop({on_line, column, row, DropReason::without_floor, {}});
    add({{on_line.x, on_line.y, *found.z_m + height_m}, kUp, kUp}, column, row);
  }

 private:
  PointFilter filter_;
  SensorGrid& grid_;
  std::vector<NearlyInside>& nearly_inside_;
};

class GridMaker {
 public:
  GridMaker(const CalcPlane& plane, const Space& space, Diagnostics& diagnostics, Message* why_not)
      : plane_(plane), space_(space), diagnostics_(diagnostics), why_not_(why_not) {}

  std::optional<SensorGrid> run() {
    grid_.kernel = plane_.kernel;
    grid_.derived = plane_.derived;
    grid_.travel = plane_.travel;
    grid_.room_m = space_.shell ? space_.shell->footprint_m : space_.outline_m;
    grid_.has_unknown_walls = grid_.room_m.empty() && !space_.surfaces_file.empty();
    const bool made = std::visit([this](const auto& area) { return fill(area); }, plane_.area);
    if (made) warn_about_open_meshes();
    if (!made || is_empty() || is_in_furniture()) return std::nullopt;
    warn_about_surfaces();
    if (grid_.route) {
      warn_about_missing_floor();
    } else {
      warn_about_lost_points(std::holds_alternative<PointList>(plane_.area));
    }
    return std::move(grid_);
  }

 private:
  bool fill(const PointList& list) {
    grid_.rule = say<Sentence::grid_of_points>();
    const std::size_t count = list.position_m.size();
    if (!is_small_enough({static_cast<double>(count), 1.0})) return false;
    GridBuilder builder(space_, bounding_box(list.position_m), grid_, nearly_inside_);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3& axis = list.normal[i];
      builder.add({list.position_m[i], axis, axis}, static_cast<int>(i), 0);
    }
    return true;
  }

  bool fill(const PlanarArea& area) {
    const Rectangle inner = inside_margin(area);
    const glm::dvec2 side_m = inner.side_m();
    const glm::dvec2 whole_m = bounding_rectangle(area.outline_m).side_m();
    if (!(side_m.x > kTie * whole_m.x && side_m.y > kTie * whole_m.y)) {
      refuse(DiagnosticId::grid_margin_too_large,
             say<Sentence::grid_margin_leaves_nothing>(area.margin_m, whole_m.x, whole_m.y));
      return false;
    }
    const Counts counts = cell_counts(area.grid, side_m);
    if (!is_small_enough(counts)) return false;
    describe(area, inner, counts);
    if (!reach_every_part(area, inner, counts)) return false;
    check_cell_shape(area);
    add_cells(area, inner);
    return true;
  }

  bool fill(const EscapeRoute& route) {
    const std::vector<double> stations = route_stations(route.line, route.spacing.along_u_m);
    const Counts counts = route_counts(route, stations);
    if (!is_small_enough(counts)) return false;
    grid_.rule = route_words(route);
    grid_.route = RouteGrid{route.line, {stations.begin(), stations.end()}, route.height_m};
    grid_.columns = static_cast<int>(counts.columns);
    grid_.rows = static_cast<int>(counts.rows);
    grid_.spacing_v_m = route.line.width_m / grid_.rows;
    const std::vector<RouteLeg> legs = route_legs(route.line);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      grid_.spacing_u_m =
          std::max(grid_.spacing_u_m, legs[i].longer_edge_m(route.line.width_m) / stations[i]);
    }
    grid_.outline_m = route_outline_m(route.line);
    const Rectangle bounds = bounding_rectangle(grid_.outline_m);
    grid_.origin_m = {bounds.lower, route.line.corner_m[0].z + route.height_m};
    for (glm::dvec2& corner : grid_.outline_m) corner -= bounds.lower;
    add_cells(route, bounds);
    return true;
  }

  void add_cells(const EscapeRoute& route, const Rectangle& bounds) {
    double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;
    for (const glm::dvec3& corner : route.line.corner_m) {
      low_m = std::min(low_m, corner.z);
      high_m = std::max(high_m, corner.z);
    }
    const WalkingSurface surface(space_, {bounds.lower, low_m}, {bounds.upper, high_m});
    const RouteCells cells = grid_.route->cells(grid_.rows);
    const BoundingBox region{{bounds.lower, low_m - kWalkingSearchDown_m + route.height_m},
                             {bounds.upper, high_m + kWalkingSearchUp_m + route.height_m}};
    GridBuilder builder(space_, region, grid_, nearly_inside_);
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) {
        builder.add_above(surface, cells.centre_m(column, row), route.height_m, column, row);
      }
    }
  }

  bool is_small_enough(const Counts& counts) {
    // Not "greater than": a product that is not a number must not pass.
    if (counts.columns * counts.rows <= kMaxPoints) return true;
    refuse(DiagnosticId::grid_too_many_points,
           say<Sentence::grid_points_too_many>(counts.columns, counts.rows, kMaxPoints));
    return false;
  }

  void set_counts(const Rectangle& inner, const Counts& counts) {
    grid_.columns = static_cast<int>(counts.columns);
    grid_.rows = static_cast<int>(counts.rows);
    grid_.spacing_u_m = inner.side_m().x / counts.columns;
    grid_.spacing_v_m = inner.side_m().y / counts.rows;
  }

  void describe(const PlanarArea& area, const Rectangle& inner, const Counts& counts) {
    grid_.rule = rule_words(area.grid, inner.side_m());
    set_counts(inner, counts);
    grid_.margin_m = area.margin_m;
    grid_.origin_m = area.origin_m + inner.lower.x * area.u + inner.lower.y * area.v;
    grid_.u = area.u;
    grid_.v = area.v;
    for (const glm::dvec2& corner : area.outline_m) {
      grid_.outline_m.push_back(corner - inner.lower);
    }
  }

  // Cells that are given stay as they are, and may miss an arm of the area. Worth saying is what
  // EN 12464-1 would put a point into, whatever the plane is for.
  void warn_about_missed_part(const PlanarArea& area, const Rectangle& inner,
                              const Counts& counts) {
    const std::optional<MissedPart> missed = part_missed_by(area, inner, counts);
    if (!missed) return;
    const glm::dvec2 side_m = inner.side_m();
    const double spacing_m = spacing_by_rule(GridByRule(), side_m.x, side_m.y).spacing_m;
    if (missed->area_m2 <= spacing_m * spacing_m) return;
    const glm::dvec3 at = area.origin_m + missed->at_m.x * area.u + missed->at_m.y * area.v;
    grid_.missed_m2 = missed->area_m2;
    diagnostics_.report(DiagnosticId::grid_misses_part, plane_.where, plane_.id, missed->area_m2,
                        at.x, at.y, at.z);
  }

  // See parts_that_reach(). False: the error is reported.
  bool reach_every_part(const PlanarArea& area, const Rectangle& inner, const Counts& counts) {
    if (!must_reach_every_part(area.grid)) {
      warn_about_missed_part(area, inner, counts);
      return true;
    }
    if (const std::optional<double> parts = parts_that_reach(area, inner, counts)) {
      if (*parts == 1.0) return true;
      set_counts(inner, {*parts * counts.columns, *parts * counts.rows});
      grid_.rule = say<Sentence::grid_every_part>(grid_.rule, *parts, *parts);
      return true;
    }
    const std::optional<MissedPart> missed = part_missed_by(area, inner, counts);
    const glm::dvec3 at = area.origin_m + missed->at_m.x * area.u + missed->at_m.y * area.v;
    refuse(DiagnosticId::plane_not_computed,
           say<Sentence::grid_part_without_point>(missed->area_m2, at.x, at.y, at.z));
    return false;
  }

  void check_cell_shape(const PlanarArea& area) {
    if (!std::holds_alternative<GridByRule>(area.grid)) return;
    const double aspect = grid_.spacing_u_m / grid_.spacing_v_m;
    if (aspect >= kMinCellAspect * (1.0 - kTie) && aspect <= kMaxCellAspect * (1.0 + kTie)) return;
    diagnostics_.report(DiagnosticId::grid_cell_shape, plane_.where, plane_.id, grid_.spacing_u_m,
                        grid_.spacing_v_m);
  }

  void add_cells(const PlanarArea& area, const Rectangle& inner) {
    const auto place_m = [&](const glm::dvec2& at) {
      return area.origin_m + at.x * area.u + at.y * area.v;
    };
    const BoundingBox region = bounding_box({place_m(inner.lower), place_m(inner.upper),
                                             place_m({inner.lower.x, inner.upper.y}),
                                             place_m({inner.upper.x, inner.lower.y})});
    GridBuilder builder(space_, region, grid_, nearly_inside_);
    const glm::dvec2 cell_m(grid_.spacing_u_m, grid_.spacing_v_m);
    const glm::dvec3 normal = area.normal();
    const glm::dvec3 axis = has_look(plane_.kernel, plane_.derived) ? plane_.direction : normal;
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) {
        const glm::dvec2 at = inner.lower + glm::dvec2(column + 0.5, row + 0.5) * cell_m;
        builder.add({place_m(at), normal, axis}, column, row, reason_to_drop(area, at));
      }
    }
  }

  // Points outside the room, and points of a list that are not measured, were asked for by mistake.
  // Furniture that stands in a grid is not a mistake.
  void warn_about_lost_points(bool is_list) {
    std::size_t outside = 0, inside = 0;
    for (const DroppedPoint& point : grid_.dropped) {
      if (point.reason == DropReason::outside_room) ++outside;
      if (point.reason == DropReason::inside_solid) ++inside;
    }
    if (outside == 0 && (inside == 0 || !is_list)) return;
    diagnostics_.report(DiagnosticId::points_left_out, plane_.where, plane_.id, outside + inside,
                        grid_.position_m.size() + grid_.dropped.size(), outside, inside);
  }

  // A body may have been meant, and the mesh is what has to be mended.
  void warn_about_open_meshes() {
    struct Points {
      std::size_t count = 0;
      glm::dvec3 first_m{0.0};
    };
    std::map<std::string, Points> inside, nearly;
    const auto add = [](Points& points, const glm::dvec3& at) {
      if (++points.count == 1) points.first_m = at;
    };
    const auto is_open = [&](const std::string& id) {
      return std::any_of(space_.open_shells.begin(), space_.open_shells.end(),
                         [&](const Body& shell) { return shell.id == id; });
    };
    for (const DroppedPoint& point : grid_.dropped) {
      if (point.reason != DropReason::inside_solid) continue;
      if (inside.contains(point.body) || is_open(point.body)) {
        add(inside[point.body], point.position_m);
      }
    }
    for (const NearlyInside& point : nearly_inside_) add(nearly[point.body], point.position_m);
    const std::size_t all = grid_.position_m.size() + grid_.dropped.size();
    const auto warn = [&](DiagnosticId id, const std::map<std::string, Points>& by_body) {
      for (const auto& [body, points] : by_body) {
        const glm::dvec3& at = points.first_m;
        diagnostics_.report(id, plane_.where, plane_.id, points.count, all, body, at.x, at.y, at.z);
      }
    };
    warn(DiagnosticId::points_in_open_mesh, inside);
    warn(DiagnosticId::points_nearly_in_open_mesh, nearly);
  }

  // What a point in a surface means is our choice, and may not be the project's. Where furniture
  // meets the cells of a grid is chance, and said with the results.
  void warn_about_surfaces() {
    if (!grid_.inner.empty() && std::holds_alternative<PointList>(plane_.area)) {
      const InnerPoint& first = grid_.inner.front();
      const glm::dvec3& at = grid_.position_m[first.point];
      diagnostics_.report(DiagnosticId::points_beside_surface, plane_.where, plane_.id,
                          grid_.inner.size(), grid_.position_m.size(), at.x, at.y, at.z,
                          first.body);
    }
    const auto is_within = [](const DroppedPoint& p) { return p.reason == DropReason::in_surface; };
    const auto first = std::find_if(grid_.dropped.begin(), grid_.dropped.end(), is_within);
    if (first == grid_.dropped.end()) return;
    const glm::dvec3& at = first->position_m;
    diagnostics_.report(DiagnosticId::points_in_surface, plane_.where, plane_.id,
                        std::count_if(first, grid_.dropped.end(), is_within),
                        grid_.position_m.size() + grid_.dropped.size(), at.x, at.y, at.z,
                        first->body);
  }

  // Furniture on a route may be meant, a hole or a wall in it is not.
  void warn_about_missing_floor() {
    const DroppedPoint* first = nullptr;
    std::size_t outside = 0, floorless = 0;
    for (const DroppedPoint& point : grid_.dropped) {
      const bool is_outside = point.reason == DropReason::outside_room;
      if (!is_outside && point.reason != DropReason::without_floor) continue;
      if (first == nullptr) first = &point;
      ++(is_outside ? outside : floorless);
    }
    if (first == nullptr) return;
    const glm::dvec3& at = first->position_m;
    diagnostics_.report(DiagnosticId::route_points_left_out, plane_.where, plane_.id,
                        outside + floorless, grid_.position_m.size() + grid_.dropped.size(),
                        floorless, kWalkingSearchDown_m, kWalkingStepUp_m, outside, at.x, at.y,
                        at.z);
  }

  // Where people work there is air: a desk top that swallows the points on it must not leave only
  // those beside it. Of planes that a project has placed itself it is known what was meant; a floor
  // is taken up by furniture.
  bool is_work_plane() const {
    const auto* area = std::get_if<PlanarArea>(&plane_.area);
    return area != nullptr && !plane_.made_by.empty() && space_.shell &&
           plane_.kernel == ReceiverKernel::planar && plane_.derived == DerivedQuantity::none &&
           area->normal().z > 0.5 && area->origin_m.z > space_.shell->floor_z_m + kOnFloor_m;
  }

  bool is_in_furniture() {
    constexpr double kMostInside = 0.1;  // of the points
    if (!is_work_plane()) return false;
    const DroppedPoint* first = nullptr;
    std::size_t inside = 0;
    for (const DroppedPoint& point : grid_.dropped) {
      if (point.reason != DropReason::inside_solid) continue;
      if (first == nullptr) first = &point;
      ++inside;
    }
    if (first == nullptr) return false;
    const std::size_t all = grid_.position_m.size() + inside;
    if (static_cast<double>(inside) <= kMostInside * static_cast<double>(all)) {
      diagnostics_.report(DiagnosticId::points_left_out, plane_.where, plane_.id, inside, all, 0,
                          fmt::format("{}, the first in '{}',", inside, first->body));
      return false;
    }
    refuse(DiagnosticId::plane_not_computed,
           say<Sentence::grid_points_in_solids>(inside, all, first->body));
    return true;
  }

  // A plane without points would pass every limit unnoticed.
  bool is_empty() {
    if (!grid_.position_m.empty()) return false;
    std::array<std::size_t, std::size(EnumNames<DropReason>::list)> dropped{};
    for (const DroppedPoint& point : grid_.dropped)
      ++dropped[static_cast<std::size_t>(point.reason)];
    if (grid_.route) {
      const glm::dvec3& at = grid_.dropped.front().position_m;
      refuse(DiagnosticId::route_without_points,
             say<Sentence::route_no_points_left>(grid_.dropped.size(), dropped[4],
                                                 kWalkingSearchDown_m, kWalkingStepUp_m, dropped[5],
                                                 dropped[3], dropped[2], at.x, at.y, at.z));
      return true;
    }
    refuse(DiagnosticId::grid_without_points,
           say<Sentence::grid_no_points_left>(grid_.dropped.size(), dropped[0], dropped[1],
                                              dropped[2], dropped[3], dropped[6]));
    return true;
  }

  // There is no grid.
  void refuse(DiagnosticId id, const Message& why) {
    diagnostics_.report(id, plane_.where, plane_.id, why);
    if (why_not_ != nullptr) *why_not_ = why;
  }

  const CalcPlane& plane_;
  const Space& space_;
  Diagnostics& diagnostics_;
  Message* why_not_;
  SensorGrid grid_;
  std::vector<NearlyInside> nearly_inside_;
};

}  // namespace

std::vector<double> point_weights(const SensorGrid& grid) {
  if (!grid.route) return {};
  const RouteCells cells = grid.route->cells(grid.rows);
  std::vector<double> area_m2;
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    area_m2.push_back(cells.area_m2(grid.column[i], grid.row[i]));
  }
  const auto [least, most] = std::minmax_element(area_m2.begin(), area_m2.end());
  if (area_m2.empty() || *most <= *least * (1.0 + kTie)) return {};
  return area_m2;
}

Message grid_words(const GridByRule& rule, double side_u_m, double side_v_m) {
  const std::array rounded{say<Sentence::rounded_nearest>(), say<Sentence::rounded_up>(),
                           say<Sentence::rounded_odd>()};
  const RuleSpacing spacing = spacing_by_rule(rule, side_u_m, side_v_m);
  const Counts counts = counts_by_rule(rule, side_u_m, side_v_m);
  return say<Sentence::grid_formula>(
      rule.name, rule.factor_m, rule.base, spacing.d_m,
      spacing.is_shorter ? say<Sentence::shorter_side>(rule.shorter_from_ratio)
                         : say<Sentence::longer_side>(),
      spacing.is_capped ? say<Sentence::most_spacing>(spacing.spacing_m)
                        : Message::number(fmt::format("{:.3g} m", spacing.spacing_m)),
      side_u_m / spacing.spacing_m, side_v_m / spacing.spacing_m,
      rounded[static_cast<std::size_t>(rule.rounding)], counts.columns, counts.rows);
}

GridCounts grid_counts(const GridByRule& rule, double side_u_m, double side_v_m) {
  const Counts counts = counts_by_rule(rule, side_u_m, side_v_m);
  constexpr double kLargest = std::numeric_limits<int>::max();
  return {static_cast<int>(std::min(counts.columns, kLargest)),
          static_cast<int>(std::min(counts.rows, kLargest))};
}

namespace {

bool is_rectangle(const PlanarArea& area) {
  const Rectangle bounds = bounding_rectangle(area.outline_m);
  const auto is_corner = [&](const glm::dvec2& point) {
    return (point.x == bounds.lower.x || point.x == bounds.upper.x) &&
           (point.y == bounds.lower.y || point.y == bounds.upper.y);
  };
  return area.outline_m.size() == 4 && area.holes_m.empty() &&
         std::all_of(area.outline_m.begin(), area.outline_m.end(), is_corner);
}

// parts: into how many each cell is divided along both sides.
double points_of(
    const CalcPlane& plane,
    const std::function<double(const PlanarArea&, const Rectangle&, const Counts&)>& parts_of) {
  if (const auto* list = std::get_if<PointList>(&plane.area)) {
    return static_cast<double>(list->position_m.size());
  }
  if (const auto* route = std::get_if<EscapeRoute>(&plane.area)) {
    const Counts counts =
        route_counts(*route, route_stations(route->line, route->spacing.along_u_m));
    return counts.columns * counts.rows;
  }
  const auto& area = std::get<PlanarArea>(plane.area);
  const Rectangle inner = inside_margin(area);
  if (!has_inside(inner)) return 0.0;
  const Counts counts = cell_counts(area.grid, inner.side_m());
  const double points = counts.columns * counts.rows;
  const bool is_whole = !must_reach_every_part(area.grid) || is_rectangle(area);
  if (!(points <= kMaxPoints) || is_whole) return points;
  const double parts = parts_of(area, inner, counts);
  return points * parts * parts;
}

}  // namespace

double planned_points(const CalcPlane& plane) {
  return points_of(plane, [](const PlanarArea& area, const Rectangle& inner, const Counts& counts) {
    return parts_that_reach(area, inner, counts).value_or(1.0);
  });
}

double most_planned_points(const CalcPlane& plane) {
  return points_of(
      plane, [](const PlanarArea&, const Rectangle&, const Counts&) { return kParts.back(); });
}

std::optional<SensorGrid> make_sensor_grid(const CalcPlane& plane, const Space& space,
                                           Diagnostics& diagnostics, Message* why_not) {
  return GridMaker(plane, space, diagnostics, why_not).run();
}

}  // namespace calc
