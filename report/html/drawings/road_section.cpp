#include "report/html/drawings/road_section.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/document/road_facts.h"
#include "report/html/drawings/technical_drawing.h"
#include "report/html/page/html_markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace report {
namespace {

// All in millimetres on paper; y points down.
constexpr glm::dvec2 kSectionRoom_mm{152, 80};
constexpr double kAside_mm = 14, kAbove_mm = 5;        // beside and above the section
constexpr double kRoadbed_mm = 1.6;                    // how thick surfaces are drawn
constexpr double kLanes_mm = 6, kCarriageway_mm = 11;  // dimension lines, below the surface
constexpr double kToPlan_mm = 15, kPlan_mm = 34;
constexpr double kPlanEnds = 0.28;  // of a spacing, before the first and behind the last luminaire
constexpr double kLine_mm = 3.2;    // from a line of words to the next

// Seen along the road: y to the left, z up.
glm::dvec2 across(double y_m, double z_m = 0.0) { return {-y_m, z_m}; }

// Where nobody says it: behind the edge, or below luminaires that are farther from it.
double pole_y_m(const RoadPart& road, const RoadRowPart& row) {
  constexpr double kBehindEdge_m = 0.7;
  const double inward = std::min(overhang_m(road, row), -kBehindEdge_m);
  return is_on_the_left(road, row) ? road.width_m - inward : inward;
}

FlatBox extent_of_section(const RoadPart& road) {
  constexpr double kVerge_m = 0.5;
  FlatBox extent;
  const auto add = [&](double y_m, double z_m) { extent.add(across(y_m, z_m)); };
  add(-kVerge_m, 0.0);
  add(road.width_m + kVerge_m, 1.0);
  for (const RoadAreaPart& area : road.areas) {
    add(area.from_y_m, 0.0);
    add(area.to_y_m, 0.0);
  }
  for (const RoadRowPart& row : road.rows) {
    add(row.y_m, row.height_m);
    const double pole_m = pole_y_m(road, row);
    add(pole_m + (is_on_the_left(road, row) ? kVerge_m : -kVerge_m), 0.0);
  }
  return extent;
}

std::string rectangle_path(const glm::dvec2& corner, const glm::dvec2& size) {
  return fmt::format("M{} {}h{}v{}h{}z", svg_number(corner.x), svg_number(corner.y),
                     svg_number(size.x), svg_number(size.y), svg_number(-size.x));
}

// Of each area from its left end, which is the one on the left of the drawing.
std::string surfaces(const DrawingView& view, const RoadPart& road, double top_mm,
                     double height_mm) {
  std::string carriageway, strips;
  for (std::size_t i = 0; i < road.areas.size(); ++i) {
    const RoadAreaPart& area = road.areas[i];
    const double left_mm = view.at(across(area.to_y_m)).x;
    const double right_mm = view.at(across(area.from_y_m)).x;
    (i == 0 ? carriageway : strips) +=
        rectangle_path({left_mm, top_mm}, {right_mm - left_mm, height_mm});
  }
  return drawing_path("strip", strips) + drawing_path("carriageway", carriageway);
}

std::string poles(const DrawingView& view, const RoadPart& road) {
  constexpr double kHousing_m = 0.7;
  std::string sketch, edges, luminaires;
  for (const RoadRowPart& row : road.rows) {
    const double pole_m = pole_y_m(road, row);
    sketch += view.path(
        {across(pole_m), across(pole_m, row.height_m), across(row.y_m, row.height_m)}, false);
    const double edge_m = is_on_the_left(road, row) ? road.width_m : 0.0;
    edges += view.path({across(edge_m), across(edge_m, row.height_m)}, false);
    const double tilt = calc::radians_from_degrees(row.tilt_deg);
    const glm::dvec2 half =
        0.5 * kHousing_m * glm::dvec2(-calc::cos(tilt), calc::sin(tilt));  // to the left, +y
    const glm::dvec2 at = across(row.y_m, row.height_m);
    luminaires += view.path({at - half, at + half}, false);
  }
  return drawing_path("edge", edges) + drawing_path("pole", sketch) +
         drawing_path("head", luminaires);
}

// Height, overhang and tilt beside each luminaire, towards the street; rows that differ in nothing
// of it have one label.
std::string luminaire_labels(const Texts& t, const DrawingView& view, const RoadPart& road) {
  constexpr double kAway_mm = 3;
  std::map<bool, double> free_mm;  // by side: from where on
  std::set<std::array<double, 4>> known;
  std::string svg;
  for (const RoadRowPart& row : road.rows) {
    const bool is_left = is_on_the_left(road, row);
    const double tilt_deg = street_tilt_deg(road, row);
    if (!known.insert({is_left ? 1.0 : 0.0, row.y_m, row.height_m, tilt_deg}).second) continue;
    const glm::dvec2 at = view.at(across(row.y_m, row.height_m));
    double y = std::max(at.y + kLine_mm + 0.8, free_mm[is_left]);
    const auto add = [&](const std::string& words) {
      svg += drawing_words({at.x + (is_left ? kAway_mm : -kAway_mm), y}, with_minus(words),
                           is_left ? "start" : "end");
      y += kLine_mm;
    };
    add(t.say<Text::road_height>(format_metres(t, row.height_m)));
    add(t.say<Text::road_overhang>(format_metres(t, overhang_m(road, row))));
    add(t.say<Text::road_tilt>(
        format_fixed(t, tilt_deg, std::round(tilt_deg) == tilt_deg ? 0 : 1)));
    free_mm[is_left] = y;
  }
  return svg;
}

// On each side that of the highest luminaire.
std::string height_dimensions(const Texts& t, const DrawingView& view, const RoadPart& road) {
  std::map<bool, double> highest_m;
  for (const RoadRowPart& row : road.rows) {
    double& height_m = highest_m[is_on_the_left(road, row)];
    height_m = std::max(height_m, row.height_m);
  }
  std::string svg;
  for (const auto& [is_left, height_m] : highest_m) {
    const double x = is_left ? view.corner_mm.x - 4 : view.right_mm() + 6;
    svg += upright_dimension(view.bottom_mm(), view.at({0.0, height_m}).y, x,
                             format_metres(t, height_m));
  }
  return svg;
}

// Ends of everything across the road, lanes included, and the carriageway as a whole.
std::string width_dimensions(const Texts& t, const DrawingView& view, const RoadPart& road) {
  std::vector<double> ends_m;
  const std::size_t lanes = road.light.observers.size();
  for (std::size_t lane = 0; lane <= lanes; ++lane)
    ends_m.push_back(road.width_m * static_cast<double>(lane) / static_cast<double>(lanes));
  for (const RoadAreaPart& area : road.areas) {
    ends_m.push_back(area.from_y_m);
    ends_m.push_back(area.to_y_m);
  }
  std::sort(ends_m.begin(), ends_m.end());
  constexpr double kSame_m = 0.001;
  const auto level = [&](double from_m, double to_m, double below_mm) {
    return level_dimension(view.at(across(to_m)).x, view.at(across(from_m)).x,
                           view.bottom_mm() + below_mm, format_metres(t, to_m - from_m));
  };
  std::string svg;
  for (std::size_t i = 0; i + 1 < ends_m.size(); ++i) {
    if (ends_m[i + 1] - ends_m[i] > kSame_m) svg += level(ends_m[i], ends_m[i + 1], kLanes_mm);
  }
  return svg + (lanes > 1 ? level(0.0, road.width_m, kCarriageway_mm) : "");
}

// x upwards, from top_mm to the bottom of the plan.
class RoadPlan {
 public:
  RoadPlan(const DrawingView& section, const RoadPart& road, double top_mm)
      : section_(section), road_(road), top_mm_(top_mm) {}

  std::string draw(const Texts& t) const {
    return surfaces(section_, road_, top_mm_, kPlan_mm) + lane_lines() + arrows() + lane_names(t) +
           luminaires() + spacing(t);
  }

 private:
  double x_mm(double y_m) const { return section_.at(across(y_m)).x; }
  double y_mm(double spacings) const {
    return top_mm_ + kPlan_mm * (1.0 - (spacings + kPlanEnds) / (1.0 + 2.0 * kPlanEnds));
  }
  std::size_t lanes() const { return road_.light.observers.size(); }
  double lane_end_m(double lane) const {
    return road_.width_m * lane / static_cast<double>(lanes());
  }

  std::string lane_lines() const {
    std::string data;
    for (std::size_t lane = 1; lane < lanes(); ++lane) {
      data += fmt::format("M{} {}v{}", svg_number(x_mm(lane_end_m(static_cast<double>(lane)))),
                          svg_number(top_mm_), svg_number(kPlan_mm));
    }
    return drawing_path("lane-line", data);
  }

  std::string arrows() const {
    constexpr double kLength_mm = 9, kHead_mm = 2.2;
    std::string data;
    for (std::size_t lane = 0; lane < lanes(); ++lane) {
      const double x = x_mm(lane_end_m(static_cast<double>(lane) + 0.5));
      const double up = road_.light.observers[lane].is_oncoming ? -1.0 : 1.0;
      const double foot = y_mm(0.5) + up * 0.5 * kLength_mm;
      data +=
          fmt::format("M{} {}v{}", svg_number(x), svg_number(foot), svg_number(-up * kLength_mm)) +
          fmt::format("M{} {}l{} {}l{} {}", svg_number(x - 0.5 * kHead_mm),
                      svg_number(foot - up * (kLength_mm - kHead_mm)), svg_number(0.5 * kHead_mm),
                      svg_number(-up * kHead_mm), svg_number(0.5 * kHead_mm),
                      svg_number(up * kHead_mm));
    }
    return drawing_path("traffic", data);
  }

  // In full where there is room in a lane, else their numbers.
  std::string lane_names(const Texts& t) const {
    const double room_mm = section_.mm_by_m * lane_end_m(1.0);
    std::string svg;
    for (std::size_t lane = 0; lane < lanes(); ++lane) {
      const std::string number = fmt::format("{}", lane + 1);
      const std::string words = t.say<Text::road_lane>(number);
      const double x = x_mm(lane_end_m(static_cast<double>(lane) + 0.5));
      svg += drawing_words({x, top_mm_ + kPlan_mm - 2.0},
                           drawing_width_mm(words) < room_mm ? words : number);
    }
    return svg;
  }

  std::string luminaires() const {
    constexpr double kRadius_mm = 1.1;
    std::string data;
    for (const RoadRowPart& row : road_.rows) {
      const double shift_m = first_shift_m(row.shift_m, road_.spacing_m);
      for (double at = shift_m / road_.spacing_m - 1.0; at < 1.0 + kPlanEnds; at += 1.0) {
        if (at > -kPlanEnds) data += circle_path({x_mm(row.y_m), y_mm(at)}, kRadius_mm);
      }
    }
    return drawing_path("lamp", data);
  }

  std::string spacing(const Texts& t) const {
    if (road_.rows.empty()) return {};
    return upright_dimension(y_mm(0.0), y_mm(1.0), section_.corner_mm.x - 4,
                             format_metres(t, road_.spacing_m));
  }

  const DrawingView& section_;
  const RoadPart& road_;
  double top_mm_;
};

}  // namespace

std::string road_section(const Texts& t, const RoadPart& road, const std::string& name) {
  DrawingView view;
  view.extent_m = extent_of_section(road);
  const glm::dvec2 size = view.extent_m.size();
  constexpr double kLargest_m = 1e4;
  const auto is_drawable = [](double m) { return m > 0.0 && m <= kLargest_m; };
  if (road.light.observers.empty() || !is_drawable(size.x) || !is_drawable(size.y))
    return std::string("<p class=\"quiet\">") + t[Text::road_no_section] + "</p>\n";
  const double scale = drawing_scale(size, kSectionRoom_mm);
  view.mm_by_m = 1000.0 / scale;
  view.corner_mm = {kAside_mm, kAbove_mm};
  const double plan_top = view.bottom_mm() + kToPlan_mm;
  const double width = view.right_mm() + kAside_mm, height = plan_top + kPlan_mm + 2.0;
  const std::string scale_words = "1:" + format_shortest(t, scale);
  const std::string words = t.say<Text::road_section>(name, scale_words);
  std::string svg = fmt::format(
      "<svg class=\"layout road\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-size=\"{2}\" role=\"img\" aria-label=\"{3}\">\n",
      svg_number(width), svg_number(height), kDrawingText_mm, words);
  svg += surfaces(view, road, view.bottom_mm(), kRoadbed_mm) +
         drawing_path("ground",
                      fmt::format("M{} {}H{}", svg_number(view.corner_mm.x),
                                  svg_number(view.bottom_mm()), svg_number(view.right_mm()))) +
         poles(view, road) + luminaire_labels(t, view, road) + height_dimensions(t, view, road) +
         width_dimensions(t, view, road) + RoadPlan(view, road, plan_top).draw(t) + "</svg>\n";
  return "<figure class=\"layout-figure\">\n" + scroll_box(words, svg) + "<figcaption>" +
         t.say<Text::road_section_caption>(scale_words) + "</figcaption></figure>\n";
}

}  // namespace report
