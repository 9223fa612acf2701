#include "calc/scene/route_shape.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace calc {
namespace {

constexpr double kSame_m = 1.0e-6;     // corners this near are one
constexpr double kRelative = 1.0e-9;   // of lengths that come out of CAD files
constexpr double kTouching_m2 = 1e-6;  // parts that share no more than an edge

double cross_of(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Tangent of half the turn from one direction to the next, > 0 to the left.
double half_turn(const glm::dvec2& from, const glm::dvec2& to) {
  return cross_of(from, to) / (1.0 + glm::dot(from, to));
}

double turn_deg(const glm::dvec2& from, const glm::dvec2& to) {
  return degrees_from_radians(calc::acos(std::clamp(glm::dot(from, to), -1.0, 1.0)));
}

// Legs of any line whose corners are apart; turns by half a circle have no mitre.
std::vector<RouteLeg> legs_of(const RouteLine& line) {
  std::vector<RouteLeg> legs;
  double start_m = 0.0;
  for (std::size_t i = 0; i + 1 < line.corner_m.size(); ++i) {
    const glm::dvec3 &from = line.corner_m[i], &to = line.corner_m[i + 1];
    RouteLeg leg;
    leg.from_m = glm::dvec2(from);
    const glm::dvec2 step_m = glm::dvec2(to) - leg.from_m;
    leg.length_m = glm::length(step_m);
    leg.along = step_m / leg.length_m;
    leg.left = {-leg.along.y, leg.along.x};
    leg.start_m = start_m;
    leg.from_z_m = from.z;
    leg.to_z_m = to.z;
    start_m += leg.length_m;
    if (!legs.empty()) {
      const double slope = half_turn(legs.back().along, leg.along);
      legs.back().end_slope = -slope;
      leg.begin_slope = slope;
    }
    legs.push_back(leg);
  }
  return legs;
}

std::string corner_fault(const RouteLine& line) {
  for (std::size_t i = 0; i + 1 < line.corner_m.size(); ++i) {
    const glm::dvec3 step_m = line.corner_m[i + 1] - line.corner_m[i];
    if (glm::length(step_m) <= kSame_m) {
      return fmt::format("corners {} and {} are the same point; give each corner once", i + 1,
                         i + 2);
    }
    if (glm::length(glm::dvec2(step_m)) <= kSame_m) {
      return fmt::format(
          "corner {} is straight above or below corner {}; a leg must have a horizontal length",
          i + 2, i + 1);
    }
  }
  return {};
}

std::string turn_fault(const std::vector<RouteLeg>& legs) {
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    const double turn = turn_deg(legs[i].along, legs[i + 1].along);
    if (turn <= kSharpestTurn_deg * (1.0 + kRelative)) continue;
    return fmt::format(
        "the line turns by {:.4g} degrees at corner {}; at most {:g} degrees are allowed. "
        "Replace it by two corners",
        turn, i + 2, kSharpestTurn_deg);
  }
  return {};
}

// Between two mitres the inner edge of a leg is the shorter one, and may turn over.
std::string fold_fault(const std::vector<RouteLeg>& legs, double width_m) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double taken_m = 0.5 * width_m * std::abs(legs[i].end_slope - legs[i].begin_slope);
    if (legs[i].length_m >= taken_m * (1.0 - kRelative)) continue;
    return fmt::format(
        "the leg from corner {} to corner {} is {:.4g} m long, too short for its "
        "turns: with a width of {:.4g} m at least {:.4g} m are needed",
        i + 1, i + 2, legs[i].length_m, width_m, taken_m);
  }
  return {};
}

std::vector<glm::dvec2> outline_of(const RouteLeg& leg, double width_m) {
  const double right = -0.5 * width_m, left = 0.5 * width_m;
  return {leg.place_m(leg.begin_m(right), right), leg.place_m(leg.end_m(right), right),
          leg.place_m(leg.end_m(left), left), leg.place_m(leg.begin_m(left), left)};
}

// The part of a polygon to the left of the line from a to b.
std::vector<glm::dvec2> left_part(const std::vector<glm::dvec2>& polygon, const glm::dvec2& a,
                                  const glm::dvec2& b) {
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double of_p = cross_of(b - a, p - a), of_q = cross_of(b - a, q - a);
    if (of_p >= 0.0) kept.push_back(p);
    if ((of_p > 0.0 && of_q < 0.0) || (of_p < 0.0 && of_q > 0.0)) {
      kept.push_back(p + of_p / (of_p - of_q) * (q - p));
    }
  }
  return kept;
}

double fan_area(const std::vector<glm::dvec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross_of(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

std::vector<glm::dvec2> common_part(const RouteLeg& one, const RouteLeg& other, double width_m) {
  std::vector<glm::dvec2> part = outline_of(one, width_m);
  const std::vector<glm::dvec2> around = outline_of(other, width_m);
  for (std::size_t i = 0; i < around.size() && !part.empty(); ++i) {
    part = left_part(part, around[i], around[(i + 1) % around.size()]);
  }
  return fan_area(part) > kTouching_m2 ? part : std::vector<glm::dvec2>{};
}

double height_on(const RouteLeg& leg, const glm::dvec2& place_m) {
  return leg.point_m(glm::dot(place_m - leg.from_m, leg.along), 0.0).z;
}

// Stairs may lead over themselves, with people upright below.
bool has_headroom(const std::vector<glm::dvec2>& part, const RouteLeg& one, const RouteLeg& other) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const glm::dvec2& place_m : part) {
    const double apart_m = height_on(other, place_m) - height_on(one, place_m);
    lowest = std::min(lowest, apart_m);
    highest = std::max(highest, apart_m);
  }
  const double least_m = kLeastHeadroom_m * (1.0 - kRelative);
  return lowest >= least_m || highest <= -least_m;
}

std::string overlap_fault(const std::vector<RouteLeg>& legs, double width_m) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    for (std::size_t k = i + 2; k < legs.size(); ++k) {
      const std::vector<glm::dvec2> part = common_part(legs[i], legs[k], width_m);
      if (part.empty() || has_headroom(part, legs[i], legs[k])) continue;
      return fmt::format(
          "the legs from corner {} to {} and from corner {} to {} overlap at ({:.4g}, {:.4g}) m; "
          "with its width the route must not overlap itself, unless one part is {:g} m above the "
          "other",
          i + 1, i + 2, k + 1, k + 2, part[0].x, part[0].y, kLeastHeadroom_m);
    }
  }
  return {};
}

}  // namespace

double RouteLeg::longer_edge_m(double width_m) const {
  return length_m + 0.5 * width_m * std::abs(end_slope - begin_slope);
}

glm::dvec3 RouteLeg::point_m(double along_m, double offset_m) const {
  const double part = std::clamp(along_m / length_m, 0.0, 1.0);
  return {place_m(along_m, offset_m), from_z_m + part * (to_z_m - from_z_m)};
}

std::string route_fault(const RouteLine& line) {
  if (line.corner_m.size() < 2) return "the line has fewer than 2 corners";
  std::string fault = corner_fault(line);
  if (!fault.empty()) return fault;
  const std::vector<RouteLeg> legs = legs_of(line);
  fault = turn_fault(legs);
  if (fault.empty()) fault = fold_fault(legs, line.width_m);
  if (fault.empty()) fault = overlap_fault(legs, line.width_m);
  return fault;
}

std::vector<RouteLeg> route_legs(const RouteLine& line) { return legs_of(line); }

double route_length_m(const RouteLine& line) {
  const std::vector<RouteLeg> legs = legs_of(line);
  return legs.back().start_m + legs.back().length_m;
}

std::vector<glm::dvec2> route_outline_m(const RouteLine& line) {
  const std::vector<RouteLeg> legs = legs_of(line);
  std::vector<glm::dvec2> outline, back;
  const double right = -0.5 * line.width_m, left = 0.5 * line.width_m;
  for (const RouteLeg& leg : legs) {
    outline.push_back(leg.place_m(leg.begin_m(right), right));
    back.push_back(leg.place_m(leg.begin_m(left), left));
  }
  const RouteLeg& last = legs.back();
  outline.push_back(last.place_m(last.end_m(right), right));
  back.push_back(last.place_m(last.end_m(left), left));
  outline.insert(outline.end(), back.rbegin(), back.rend());
  return outline;
}

RouteCells::RouteCells(const RouteLine& line, std::vector<int> stations, int rows)
    : legs_(legs_of(line)), stations_(std::move(stations)), width_m_(line.width_m), rows_(rows) {
  for (const int count : stations_) {
    first_column_.push_back(columns_);
    columns_ += count;
  }
}

RouteCells::Place RouteCells::place_of(int column) const {
  const auto next = std::upper_bound(first_column_.begin(), first_column_.end(), column);
  const auto leg = static_cast<std::size_t>(next - first_column_.begin()) - 1;
  const double count = stations_[leg];
  const int station = column - first_column_[leg];
  return {leg, station / count, (station + 1) / count};
}

double RouteCells::along_m(const RouteLeg& leg, double part, double offset_m) const {
  const double begin_m = leg.begin_m(offset_m);
  return begin_m + part * (leg.end_m(offset_m) - begin_m);
}

double RouteCells::offset_m(int row) const {
  return (2 * row + 1 - rows_) * width_m_ / (2.0 * rows_);
}

double RouteCells::station_m(int column) const {
  const Place place = place_of(column);
  const RouteLeg& leg = legs_[place.leg];
  return leg.start_m + 0.5 * (place.begin + place.end) * leg.length_m;
}

glm::dvec3 RouteCells::centre_m(int column, int row) const {
  const Place place = place_of(column);
  const RouteLeg& leg = legs_[place.leg];
  const double offset = offset_m(row);
  return leg.point_m(along_m(leg, 0.5 * (place.begin + place.end), offset), offset);
}

double RouteCells::from_begin_m(int column, int row) const {
  const Place place = place_of(column);
  if (place.leg != 0) return std::numeric_limits<double>::infinity();
  return along_m(legs_[0], 0.5 * (place.begin + place.end), offset_m(row));
}

double RouteCells::from_end_m(int column, int row) const {
  const Place place = place_of(column);
  if (place.leg + 1 != legs_.size()) return std::numeric_limits<double>::infinity();
  const RouteLeg& leg = legs_.back();
  return leg.length_m - along_m(leg, 0.5 * (place.begin + place.end), offset_m(row));
}

std::vector<glm::dvec2> RouteCells::corners_m(int column, int row) const {
  const Place place = place_of(column);
  const RouteLeg& leg = legs_[place.leg];
  const double right = (2 * row - rows_) * width_m_ / (2.0 * rows_);
  const double left = (2 * row + 2 - rows_) * width_m_ / (2.0 * rows_);
  const auto corner = [&](double part, double offset) {
    return leg.place_m(along_m(leg, part, offset), offset);
  };
  return {corner(place.begin, right), corner(place.end, right), corner(place.end, left),
          corner(place.begin, left)};
}

double RouteCells::area_m2(int column, int row) const { return fan_area(corners_m(column, row)); }

std::vector<double> route_stations(const RouteLine& line, double spacing_m) {
  std::vector<double> stations;
  for (const RouteLeg& leg : legs_of(line)) {
    const double cells = leg.longer_edge_m(line.width_m) / spacing_m;
    stations.push_back(std::max(1.0, std::ceil(cells * (1.0 - kRelative))));
  }
  return stations;
}

}  // namespace calc
