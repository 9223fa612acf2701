#include "calc/scene/polygon.h"
#include "report/revision/point_places.h"
#include "report/revision/question_list.h"
#include "report/revision/questions.h"
#include "report/text/number_format.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {
namespace {

using Loop = std::vector<glm::dvec3>;

struct PlaneShape {
  std::vector<Loop> loop_m;  // outline and holes; of a route its line alone
  double area_m2 = 0.0;
  double width_m = 0.0;  // of routes, else 0
};

// Of a list of points there is none.
PlaneShape shape_of(const PlanePart& plane) {
  PlaneShape shape;
  const calc::SensorGrid& grid = plane.grid;
  if (grid.route) {
    const Loop& line_m = grid.route->line.corner_m;
    shape.loop_m = {line_m};
    shape.width_m = grid.route->line.width_m;
    for (std::size_t k = 1; k < line_m.size(); ++k) {
      shape.area_m2 += shape.width_m * glm::length(line_m[k] - line_m[k - 1]);
    }
    return shape;
  }
  if (plane.outline_m.empty()) return shape;
  const auto add = [&](const std::vector<glm::dvec2>& outline) {
    Loop loop_m;
    for (const glm::dvec2& corner : outline) {
      loop_m.push_back(grid.origin_m + corner.x * grid.u + corner.y * grid.v);
    }
    shape.loop_m.push_back(std::move(loop_m));
  };
  add(plane.outline_m);
  shape.area_m2 = std::abs(calc::signed_area(plane.outline_m));
  for (const std::vector<glm::dvec2>& hole : plane.holes_m) {
    add(hole);
    shape.area_m2 -= std::abs(calc::signed_area(hole));
  }
  return shape;
}

// The same corners, whichever is the first and whichever way they go round.
bool is_same_loop(const Loop& a, const Loop& b) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  for (std::size_t first = 0; first < n; ++first) {
    bool faces_same_way = true, is_other_way = true;
    for (std::size_t k = 0; k < n && (faces_same_way || is_other_way); ++k) {
      faces_same_way = faces_same_way && is_same_place(a[k], b[(first + k) % n]);
      is_other_way = is_other_way && is_same_place(a[k], b[(first + n - k) % n]);
    }
    if (faces_same_way || is_other_way) return true;
  }
  return n == 0;
}

bool is_same_line(const Loop& a, const Loop& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same_place<glm::dvec3>);
}

bool is_same(const PlaneShape& a, const PlaneShape& b) {
  if (a.loop_m.size() != b.loop_m.size() || !is_same_number(a.width_m, b.width_m)) return false;
  const bool is_line = a.width_m > 0.0;
  return std::equal(a.loop_m.begin(), a.loop_m.end(), b.loop_m.begin(),
                    is_line ? is_same_line : is_same_loop);
}

std::string shape_words(const PlaneShape& shape) {
  std::string words;
  if (shape.area_m2 > 0.0) words = fmt::format("{:.4g} m2 ", shape.area_m2);
  if (!shape.loop_m.empty() && !shape.loop_m.front().empty()) {
    words += "from " + format_position(shape.loop_m.front().front());
  }
  return words.empty() ? "list of points" : words;
}

// Whether the area is the same, so that its points can be compared.
bool compare_areas(QuestionList& questions, const PlanePart& before, const PlanePart& after) {
  const PlaneShape was = shape_of(before), is = shape_of(after);
  if (is_same(was, is)) return true;
  constexpr double kSmaller = 1.0 - 1e-6;
  questions.add(
      is.area_m2 < kSmaller * was.area_m2 ? QuestionChange::weaker : QuestionChange::exchanged,
      QuestionPart::area, shape_words(was), shape_words(is));
  return false;
}

std::string facing_words(const glm::dvec3& normal) {
  return fmt::format("facing ({:.3g} {:.3g} {:.3g})", normal.x, normal.y, normal.z);
}

bool faces_same_way(const glm::dvec3& a, const glm::dvec3& b) {
  constexpr double kSameWay = 1e-6;
  return glm::length(a - b) <= kSameWay;
}

using Facings = std::optional<std::vector<glm::dvec3>>;

// Each way that points of a plane face, once; nothing where there are too many to tell.
Facings facings_of(const PlanePart& plane) {
  constexpr std::size_t kMost = 64;
  std::vector<glm::dvec3> facings;
  for (const PointRow& point : plane.points) {
    const bool is_known = std::any_of(facings.begin(), facings.end(), [&](const auto& facing) {
      return faces_same_way(facing, point.normal);
    });
    if (!is_known) facings.push_back(point.normal);
    if (facings.size() > kMost) return std::nullopt;
  }
  return facings;
}

// The first of the one that the other has not; null: there is none.
const glm::dvec3* missing_facing(const std::vector<glm::dvec3>& facings,
                                 const std::vector<glm::dvec3>& in) {
  const auto found = std::find_if(facings.begin(), facings.end(), [&](const glm::dvec3& facing) {
    return std::none_of(in.begin(), in.end(),
                        [&](const glm::dvec3& other) { return faces_same_way(facing, other); });
  });
  return found == facings.end() ? nullptr : &*found;
}

bool is_facing_alike(const PlanePart& before, const PlanePart& after) {
  const Facings was = facings_of(before), is = facings_of(after);
  return was && is && missing_facing(*was, *is) == nullptr && missing_facing(*is, *was) == nullptr;
}

// Of the first point that faces another way; of other points, of the first way that is another.
void compare_facing(QuestionList& questions, const PlanePart& before, const PlanePart& after,
                    const PointPairs& pairs) {
  const auto add = [&questions](const glm::dvec3& was, const glm::dvec3& is) {
    questions.add(QuestionChange::exchanged, QuestionPart::area, facing_words(was),
                  facing_words(is));
  };
  for (const auto& [was, is] : pairs.both) {
    if (was.measured == nullptr || is.measured == nullptr) continue;
    if (faces_same_way(was.measured->normal, is.measured->normal)) continue;
    return add(was.measured->normal, is.measured->normal);
  }
  if (pairs.gone.empty() && pairs.added.empty()) return;
  if (before.points.empty() || after.points.empty()) return;
  const glm::dvec3 &first_was = before.points.front().normal,
                   &first_is = after.points.front().normal;
  const Facings was = facings_of(before), is = facings_of(after);
  if (!was || !is) return add(first_was, first_is);  // nobody can tell
  if (const glm::dvec3* added = missing_facing(*is, *was)) return add(first_was, *added);
  if (const glm::dvec3* gone = missing_facing(*was, *is)) add(*gone, first_is);
}

bool has_cells(const PlanePart& plane) { return plane.grid.columns > 0; }

double count_cells(const PlanePart& plane) {
  return has_cells(plane)
             ? static_cast<double>(plane.grid.columns) * static_cast<double>(plane.grid.rows)
             : static_cast<double>(plane.points.size() + plane.grid.dropped.size());
}

std::string grid_words(const PlanePart& plane) {
  if (!has_cells(plane)) return fmt::format("{:.0f} points", count_cells(plane));
  return fmt::format("{} x {} points", plane.grid.columns, plane.grid.rows);
}

// Of two grids of one area: more cells along one of its sides, and not fewer along the other one.
bool has_finer_cells(const PlanePart& before, const PlanePart& after) {
  const calc::SensorGrid &was = before.grid, &is = after.grid;
  constexpr double kAlong = 1.0 - 1e-9;
  const auto is_finer = [&](int columns, int rows) {
    return is.columns >= columns && is.rows >= rows && is.columns + is.rows > columns + rows;
  };
  if (!has_cells(before) || !has_cells(after)) return false;
  if (std::abs(glm::dot(was.u, is.u)) > kAlong) return is_finer(was.columns, was.rows);
  return std::abs(glm::dot(was.u, is.v)) > kAlong && is_finer(was.rows, was.columns);
}

// Of one area and margin. Whether there is nothing to be said of them.
bool compare_grids(QuestionList& questions, const PlanePart& before, const PlanePart& after,
                   const PointPairs& pairs) {
  if (pairs.gone.empty() && pairs.added.empty()) return true;
  const std::string was = grid_words(before);
  std::string is = grid_words(after);
  const double cells_before = count_cells(before), cells_after = count_cells(after);
  if (!is_same_number(cells_before, cells_after)) {
    const bool is_list = !has_cells(before) || !has_cells(after);
    const bool is_finer = is_list ? pairs.gone.empty() : has_finer_cells(before, after);
    const bool is_coarser = cells_after < cells_before && (!is_list || pairs.added.empty());
    questions.add(is_coarser ? QuestionChange::weaker
                  : is_finer ? QuestionChange::stricter
                             : QuestionChange::exchanged,
                  QuestionPart::grid, was, is);
    return false;
  }
  const double farthest_m = farthest_move_m(pairs);
  if (was == is && farthest_m > 0.0) {
    is +=
        fmt::format(", up to {} m elsewhere", format_shortest(std::round(farthest_m * 1e6) / 1e6));
  } else if (was == is) {
    is += fmt::format(", {} of them elsewhere", pairs.added.size());
  }
  questions.add(QuestionChange::exchanged, QuestionPart::grid, was, is);
  return false;
}

// Of one grid.
void compare_lost(QuestionList& questions, const PlanePart& before, const PlanePart& after,
                  const PointPairs& pairs) {
  std::size_t lost = 0, found = 0;
  for (const auto& [was, is] : pairs.both) {
    if (was.measured != nullptr && is.measured == nullptr) ++lost;
    if (was.measured == nullptr && is.measured != nullptr) ++found;
  }
  if (lost == 0 && found == 0) return;
  std::string words = fmt::format("{}", after.grid.dropped.size());
  if (lost > 0 && found > 0) words += fmt::format(", {} of them others", lost);
  questions.add(lost == 0    ? QuestionChange::stricter
                : found == 0 ? QuestionChange::weaker
                             : QuestionChange::exchanged,
                QuestionPart::lost_points, fmt::format("{}", before.grid.dropped.size()), words);
}

}  // namespace

bool is_same_area(const PlanePart& before, const PlanePart& after) {
  const PlaneShape was = shape_of(before), is = shape_of(after);
  if (!is_same(was, is)) return false;
  if (!was.loop_m.empty()) return true;
  const PointPairs pairs = match_points(before, after);
  return pairs.gone.empty() && pairs.added.empty() && !pairs.both.empty();
}

bool is_finer_grid(const PlanePart& before, const PlanePart& after) {
  return before.is_computed && after.is_computed && is_same(shape_of(before), shape_of(after)) &&
         is_same_number(before.grid.margin_m, after.grid.margin_m) &&
         has_finer_cells(before, after) && is_facing_alike(before, after) &&
         has_points_in_all_cells(before, after);
}

std::vector<ChangedQuestion> compare_plane_question(const PlanePart& before, const PlanePart& after,
                                                    bool is_only_finer,
                                                    const RevisionPlace& place) {
  QuestionList questions(place);
  questions.exchange(QuestionPart::quantity, plane_words(before), plane_words(after));
  if (!before.is_computed || !after.is_computed) return questions.take();  // no grid to compare
  const bool is_same_area = compare_areas(questions, before, after);
  const bool is_same_margin = is_same_number(before.grid.margin_m, after.grid.margin_m);
  questions.compare(QuestionPart::margin, before.grid.margin_m, after.grid.margin_m, false,
                    format_shortest(before.grid.margin_m) + " m",
                    format_shortest(after.grid.margin_m) + " m");
  const PointPairs pairs = match_points(before, after);
  if (is_same_area) compare_facing(questions, before, after, pairs);
  if (is_same_area && is_same_margin && compare_grids(questions, before, after, pairs)) {
    compare_lost(questions, before, after, pairs);
    return questions.take();
  }
  if (is_only_finer) return questions.take();
  // On another grid no point is the one that was left out.
  questions.compare(QuestionPart::lost_points, static_cast<double>(before.grid.dropped.size()),
                    static_cast<double>(after.grid.dropped.size()), false,
                    fmt::format("{}", before.grid.dropped.size()),
                    fmt::format("{}", after.grid.dropped.size()));
  return questions.take();
}

}  // namespace report
