#include "report/html/drawings/html_layout.h"

#include "calc/scene/polygon.h"
#include "report/html/drawings/technical_drawing.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

// All in millimetres on paper; y points down.
constexpr glm::dvec2 kBelowOfFew_mm{150, 140}, kBelowOfMany_mm{122, 78}, kBesideOfMany_mm{122, 52};
constexpr double kLeastWidth_mm = 34;  // of the plan, for words below it
constexpr double kWide = 1.15;         // bold words against plain ones
constexpr std::size_t kFewRooms = 8, kFewPlanesOfAll = 24;
constexpr double kLeft_mm = 15, kTop_mm = 6, kRight_mm = 22, kGap_mm = 4;
constexpr double kChain_mm = 4, kWhole_mm = 9.5;  // dimension lines, from the room
constexpr std::size_t kMostNumbers = 200, kMostPoints = 1200, kMostSteps = 9, kMostLevels = 16,
                      kMostLetters = 200;

std::vector<glm::dvec3> corners_of(const PlanePart& plane) {
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& corner : plane.outline_m) {
    corners.push_back(plane.grid.origin_m + corner.x * plane.grid.u + corner.y * plane.grid.v);
  }
  return corners;
}

std::vector<glm::dvec3> corners_of(const LuminaireMark& mark) {
  // The outline is seen from above; the opening is at right angles to the axis, if one is known.
  constexpr double kUpright = 0.02;  // an axis so level leaves no outline from above
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2& corner : mark.outline_m) {
    const glm::dvec2 aside = corner - glm::dvec2(mark.position_m);
    const double rise = std::abs(mark.axis.z) > kUpright
                            ? -glm::dot(aside, glm::dvec2(mark.axis)) / mark.axis.z
                            : 0.0;
    corners.emplace_back(corner, mark.position_m.z + rise);
  }
  return corners;
}

// From above, or level along y or x: the first two or the other coordinates of a point.
enum class Sight { plan, towards_plus_y, towards_minus_x };

glm::dvec2 seen(Sight sight, const glm::dvec3& p) {
  switch (sight) {
    case Sight::plan:
      return {p.x, p.y};
    case Sight::towards_plus_y:
      return {p.x, p.z};
    case Sight::towards_minus_x:
      return {p.y, p.z};
  }
  return {};
}

std::vector<glm::dvec2> seen(Sight sight, const std::vector<glm::dvec3>& corners) {
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& corner : corners) flat.push_back(seen(sight, corner));
  return flat;
}

// Planes that look the same from above have one letter.
struct PlaneGroup {
  std::vector<glm::dvec2> outline_m;  // empty: points alone
  std::vector<const PlanePart*> planes;
};

std::string letter_of(std::size_t index) {
  constexpr std::size_t kLetters = 26;
  std::string letters(1, static_cast<char>('A' + index % kLetters));
  return index < kLetters ? letters : letter_of(index / kLetters - 1) + letters;
}

std::vector<PlaneGroup> groups_of(const SpacePart& space) {
  std::vector<PlaneGroup> groups;
  std::map<std::vector<std::pair<long long, long long>>, std::size_t> known;
  for (const PlanePart& plane : space.planes) {
    std::vector<glm::dvec2> outline = seen(Sight::plan, corners_of(plane));
    std::vector<std::pair<long long, long long>> key;  // in millimetres
    for (const glm::dvec2& corner : outline)
      key.emplace_back(std::llround(corner.x * 1000.0), std::llround(corner.y * 1000.0));
    if (key.empty() && plane.points.empty()) continue;
    const auto found = key.empty() ? known.end() : known.find(key);
    if (found != known.end()) {
      groups[found->second].planes.push_back(&plane);
      continue;
    }
    if (!key.empty()) known[key] = groups.size();
    groups.push_back({std::move(outline), {&plane}});
  }
  return groups;
}

// Everything in it, so that nothing is cut off.
FlatBox extent_of(const SpacePart& space, Sight sight) {
  FlatBox extent;
  const auto add_all = [&](const std::vector<glm::dvec3>& corners) {
    for (const glm::dvec3& corner : corners) extent.add(seen(sight, corner));
  };
  for (const glm::dvec2& corner : space.footprint_m) {
    extent.add(seen(sight, {corner, space.floor_z_m}));
    extent.add(seen(sight, {corner, space.floor_z_m + space.height_m}));
  }
  for (const LuminaireMark& mark : space.luminaires) {
    extent.add(seen(sight, mark.position_m));
    add_all(corners_of(mark));
  }
  for (const PlanePart& plane : space.planes) {
    add_all(corners_of(plane));
    if (!plane.outline_m.empty()) continue;
    for (const PointRow& point : plane.points) extent.add(seen(sight, point.position_m));
  }
  add_all(space.surface_lines_m);
  if (!space.footprint_m.empty()) return extent;
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) {
      for (const glm::dvec2& end : line) {
        extent.add(seen(sight, {end, body.low_z_m}));
        extent.add(seen(sight, {end, body.high_z_m}));
      }
    }
  }
  return extent;
}

// Where the outline has corners along an axis; the two ends alone where there are too many.
std::vector<double> steps_of(const std::vector<glm::dvec2>& outline_m, int axis) {
  std::set<long long> places_mm;
  for (const glm::dvec2& corner : outline_m) places_mm.insert(std::llround(corner[axis] * 1000.0));
  std::vector<double> steps;
  for (const long long place : places_mm) steps.push_back(static_cast<double>(place) / 1000.0);
  if (steps.size() > kMostSteps) return {steps.front(), steps.back()};
  return steps;
}

// Below the plan and on its left.
struct Dimensions {
  std::string svg;
  double below_mm = 0.0;  // room that they take
};

Dimensions dimensions(const Texts& t, const DrawingView& view, const SpacePart& space) {
  if (space.footprint_m.empty()) return {};
  const std::vector<double> x = steps_of(space.footprint_m, 0), y = steps_of(space.footprint_m, 1);
  Dimensions drawn;
  const auto level = [&](double from_m, double to_m, double below_mm) {
    drawn.svg += level_dimension(view.at({from_m, 0}).x, view.at({to_m, 0}).x,
                                 view.bottom_mm() + below_mm, format_metres(t, to_m - from_m));
    drawn.below_mm = below_mm + 1;
  };
  const auto upright = [&](double from_m, double to_m, double aside_mm) {
    drawn.svg += upright_dimension(view.at({0, from_m}).y, view.at({0, to_m}).y,
                                   view.corner_mm.x - aside_mm, format_metres(t, to_m - from_m));
  };
  for (std::size_t i = 0; i + 1 < x.size(); ++i) level(x[i], x[i + 1], kChain_mm);
  for (std::size_t i = 0; i + 1 < y.size(); ++i) upright(y[i], y[i + 1], kChain_mm);
  if (x.size() > 2) level(x.front(), x.back(), kWhole_mm);
  if (y.size() > 2) upright(y.front(), y.back(), kWhole_mm);
  return drawn;
}

// Of the lower left corner, for those who set out from the table of positions.
std::string corner_words(const Texts& t, const DrawingView& view, double below_mm) {
  const glm::dvec2& low = view.extent_m.low;
  return drawing_words({view.corner_mm.x, view.bottom_mm() + below_mm + 3},
                       "↖ x = " + with_minus(format_metres(t, low.x)) +
                           ", y = " + with_minus(format_metres(t, low.y)),
                       "start", "minor");
}

std::string luminaire_signs(const DrawingView& view, const SpacePart& space, Sight sight,
                            DrawingLabels& labels) {
  const bool has_numbers = sight == Sight::plan && space.luminaires.size() <= kMostNumbers;
  std::string signs, numbers;
  std::vector<FlatBox> signs_mm;
  for (const LuminaireMark& mark : space.luminaires) {
    const glm::dvec2 p = view.at(seen(sight, mark.position_m));
    const std::vector<glm::dvec2> outline = seen(sight, corners_of(mark));
    FlatBox sign;
    for (const glm::dvec2& corner : outline) sign.add(view.at(corner));
    if (outline.empty()) {
      signs += point_sign(p);
      sign.add(p - glm::dvec2(kPointSign_mm));
      sign.add(p + glm::dvec2(kPointSign_mm));
    } else {
      signs += view.path(outline);
    }
    if (has_numbers) labels.take(0.5 * (sign.low + sign.high), sign.size());
    signs_mm.push_back(sign);
  }
  for (std::size_t i = 0; has_numbers && i < space.luminaires.size(); ++i) {
    const FlatBox& sign = signs_mm[i];
    const std::string& label = space.luminaires[i].label;
    const glm::dvec2 middle = 0.5 * (sign.low + sign.high);
    const glm::dvec2 half = 0.5 * glm::dvec2(drawing_width_mm(label) + 1.0, kDrawingText_mm + 0.6);
    std::vector<glm::dvec2> places;
    for (const double further_mm : {0.0, 1.5, 3.0}) {
      const glm::dvec2 aside = 0.5 * sign.size() + half + glm::dvec2(further_mm);
      for (const glm::dvec2& way :
           {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, 0), glm::dvec2(0, -1),
            glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)}) {
        places.push_back(middle + aside * way);
      }
    }
    numbers += labels.put(places, label, "number");
  }
  return drawing_path("luminaire", signs) + numbers;
}

// Lines that are seen as a point are left out.
std::string surface_lines(const DrawingView& view, const SpacePart& space, Sight sight) {
  std::string data;
  for (std::size_t i = 0; i + 1 < space.surface_lines_m.size(); i += 2) {
    const glm::dvec2 from = seen(sight, space.surface_lines_m[i]),
                     to = seen(sight, space.surface_lines_m[i + 1]);
    if (from != to) data += view.path({from, to}, false);
  }
  return drawing_path("surface", data);
}

std::string furniture(const DrawingView& view, const SpacePart& space) {
  std::string data;
  for (const BodyMark& body : space.bodies) {
    for (const auto& line : body.lines_m) data += view.path({line[0], line[1]}, false);
  }
  return drawing_path("furniture", data);
}

std::string standing_furniture(const DrawingView& view, const SpacePart& space, Sight sight) {
  std::string data;
  for (const BodyMark& body : space.bodies) {
    FlatBox extent;
    for (const auto& line : body.lines_m) {
      for (const glm::dvec2& end : line) {
        extent.add(seen(sight, {end, body.low_z_m}));
        extent.add(seen(sight, {end, body.high_z_m}));
      }
    }
    if (extent.is_empty()) continue;
    data += view.path(
        {extent.low, {extent.high.x, extent.low.y}, extent.high, {extent.low.x, extent.high.y}});
  }
  return drawing_path("furniture", data);
}

std::size_t points_of(const SpacePart& space) {
  std::size_t points = 0;
  for (const PlanePart& plane : space.planes) points += plane.points.size();
  return points;
}

std::string point_signs(const DrawingView& view, const SpacePart& space) {
  std::string dots;
  for (const PlanePart& plane : space.planes) {
    for (const PointRow& point : plane.points) {
      const glm::dvec2 p = view.at({point.position_m.x, point.position_m.y});
      dots += fmt::format("M{} {}h0", svg_number(p.x), svg_number(p.y));
    }
  }
  return drawing_path("points", dots);
}

// Inside the outline, at its corners and in its middle; beside it where it is only a line or a
// point.
std::vector<glm::dvec2> letter_places(const DrawingView& view, const PlaneGroup& group,
                                      const FlatBox& extent_mm, const glm::dvec2& in_mm) {
  constexpr std::size_t kMostCorners = 40;
  constexpr std::array<glm::dvec2, 4> kWays{glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(1, -1),
                                            glm::dvec2(-1, -1)};
  std::vector<glm::dvec2> outline_mm;
  for (const glm::dvec2& corner : group.outline_m) outline_mm.push_back(view.at(corner));
  std::vector<glm::dvec2> places;
  const auto add_if_inside = [&](const glm::dvec2& place) {
    if (calc::contains_point(outline_mm, place)) places.push_back(place);
  };
  const glm::dvec2 size = extent_mm.size(), middle = 0.5 * (extent_mm.low + extent_mm.high);
  if (size.x > 2 * in_mm.x && size.y > 2 * in_mm.y) {
    for (std::size_t i = 0; i < std::min(outline_mm.size(), kMostCorners); ++i) {
      for (const glm::dvec2& way : kWays) add_if_inside(outline_mm[i] + way * in_mm);
    }
    add_if_inside(middle);
  }
  for (const double part : {0.5, 0.25, 0.75}) {
    const glm::dvec2 along = extent_mm.low + part * size;
    for (const glm::dvec2& way : kWays) places.push_back(along + way * in_mm);
  }
  return places;
}

std::string plane_signs(const DrawingView& view, const std::vector<PlaneGroup>& groups,
                        DrawingLabels& labels) {
  std::string outlines, letters;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const PlaneGroup& group = groups[i];
    FlatBox extent;
    for (const glm::dvec2& corner : group.outline_m) extent.add(view.at(corner));
    if (group.outline_m.empty()) {
      const glm::dvec3& point = group.planes.front()->points.front().position_m;
      extent.add(view.at({point.x, point.y}));
    }
    outlines += view.path(group.outline_m);
    if (groups.size() > kMostLetters) continue;
    const std::string letter = letter_of(i);
    const glm::dvec2 in(0.5 * drawing_width_mm(letter) + 1.1, 0.5 * kDrawingText_mm + 0.9);
    letters += labels.put(letter_places(view, group, extent, in), letter, "letter");
  }
  return drawing_path("area", outlines) + letters;
}

// By centimetres over the floor: of the room, of luminaires, of level planes.
std::map<long long, double> heights_of(const SpacePart& space) {
  std::map<long long, double> heights;
  const auto add = [&](double z_m) {
    heights.emplace(std::llround((z_m - space.floor_z_m) * 100.0), z_m);
  };
  if (!space.footprint_m.empty()) {
    add(space.floor_z_m);
    add(space.floor_z_m + space.height_m);
  }
  for (const LuminaireMark& mark : space.luminaires) add(mark.position_m.z);
  for (const PlanePart& plane : space.planes) {
    if (plane.outline_m.empty() || plane.grid.route) continue;
    if (is_horizontal(glm::cross(plane.grid.u, plane.grid.v))) add(plane.grid.origin_m.z);
  }
  return heights;
}

// Heights over the floor beside the elevation.
std::string levels(const Texts& t, const DrawingView& view, const SpacePart& space) {
  std::map<long long, double> heights = heights_of(space);
  if (heights.size() > kMostLevels) {
    const std::pair low = *heights.begin(), high = *heights.rbegin();
    heights = {low, high};
  }
  std::string svg;
  double free_mm = std::numeric_limits<double>::max();  // the lowest place that is left
  for (const auto& [height_cm, z_m] : heights) {
    const double y = view.at({0, z_m}).y, x = view.right_mm();
    const double place = std::min(y, free_mm);
    free_mm = place - kDrawingText_mm - 0.4;
    svg += drawing_path("dimension",
                        fmt::format("M{} {}h2L{} {}h1", svg_number(x + 0.8), svg_number(y),
                                    svg_number(x + 5), svg_number(place))) +
           drawing_words({x + 6.6, place + 0.36 * kDrawingText_mm},
                         with_minus(format_metres(t, z_m - space.floor_z_m)), "start");
  }
  return svg;
}

std::string elevation(const Texts& t, const DrawingView& view, const SpacePart& space,
                      Sight sight) {
  std::string svg;
  if (!space.footprint_m.empty()) {
    FlatBox room;
    for (const glm::dvec2& corner : space.footprint_m) {
      room.add(seen(sight, {corner, space.floor_z_m}));
      room.add(seen(sight, {corner, space.floor_z_m + space.height_m}));
    }
    svg += drawing_path(
        "wall",
        view.path({room.low, {room.high.x, room.low.y}, room.high, {room.low.x, room.high.y}}));
  }
  svg += surface_lines(view, space, sight) + standing_furniture(view, space, sight);
  std::string areas;
  for (const PlanePart& plane : space.planes) areas += view.path(seen(sight, corners_of(plane)));
  DrawingLabels none;
  return svg + drawing_path("area", areas) + luminaire_signs(view, space, sight, none) +
         levels(t, view, space);
}

std::string height_words(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  if (plane.outline_m.empty() || plane.grid.route) return {};
  const glm::dvec3 normal = glm::cross(plane.grid.u, plane.grid.v);
  if (!is_horizontal(normal)) return " (" + with_minus(orientation_words(t, normal)) + ")";
  return " (" + with_minus(format_metres(t, plane.grid.origin_m.z - space.floor_z_m)) + " m)";
}

// "A Task (0.75 m), Task: cylinder (1.20 m)".
std::string key_of(const Texts& t, const SpacePart& space, const std::vector<PlaneGroup>& groups) {
  if (groups.size() > kMostLetters) return {};
  std::string items;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::string names;
    for (const PlanePart* plane : groups[i].planes) {
      names += (names.empty() ? "" : ", ") + escape_html(plane_name(t, space, *plane)) +
               height_words(t, space, *plane);
    }
    items += fmt::format("<li><b>{}</b> {}</li>\n", letter_of(i), names);
  }
  return items.empty() ? "" : "<ul class=\"layout-key\">\n" + items + "</ul>\n";
}

// Its report is: it has room for large drawings.
bool is_short(const ProjectPart& project) {
  std::size_t planes = 0;
  for (const SpacePart& space : project.spaces) planes += space.planes.size();
  return project.spaces.size() <= kFewRooms && planes <= kFewPlanesOfAll;
}

std::string scale_words(const Texts& t, double scale) { return "1:" + format_shortest(t, scale); }

}  // namespace

std::string html_layout(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  DrawingView plan, side;
  plan.extent_m = extent_of(space, Sight::plan);
  if (plan.extent_m.is_empty()) return {};
  const glm::dvec2 ground = plan.extent_m.size();
  const Sight sight = ground.x >= ground.y ? Sight::towards_plus_y : Sight::towards_minus_x;
  side.extent_m = extent_of(space, sight);
  const glm::dvec2 standing = side.extent_m.size();
  // Both views in one scale: below each other, or beside each other where pages are to be saved and
  // the drawing does not get smaller by it.
  const glm::dvec2 below(std::max(ground.x, standing.x), ground.y + standing.y);
  const glm::dvec2 beside(ground.x + standing.x, std::max(ground.y, standing.y));
  if (!(below.x > 0.0) || !(below.y > 0.0) || !std::isfinite(below.x + below.y)) return {};
  const double beside_scale = drawing_scale(beside, kBesideOfMany_mm);
  double scale = drawing_scale(below, is_short(project) ? kBelowOfFew_mm : kBelowOfMany_mm);
  const bool is_below = is_short(project) || scale < beside_scale;
  if (!is_below) scale = beside_scale;
  plan.mm_by_m = side.mm_by_m = 1000.0 / scale;
  plan.corner_mm = {kLeft_mm, kTop_mm};
  const Dimensions lengths = dimensions(t, plan, space);
  const double plan_end_mm = plan.bottom_mm() + lengths.below_mm + kGap_mm;
  const double plan_right_mm = std::max(plan.right_mm(), kLeft_mm + kLeastWidth_mm);
  side.corner_mm = is_below ? glm::dvec2(kLeft_mm, plan_end_mm + kTop_mm)
                            : glm::dvec2(plan_right_mm + kRight_mm, kTop_mm);
  const std::string side_title =
      t.say<Text::layout_elevation>(sight == Sight::towards_plus_y ? "+y" : "−x");
  const double width = std::max({plan_right_mm + kRight_mm, side.right_mm() + kRight_mm,
                                 side.corner_mm.x + kWide * drawing_width_mm(side_title)});
  const double height = std::max(plan_end_mm, side.bottom_mm() + 2);

  const std::vector<PlaneGroup> groups = groups_of(space);
  const bool has_points = points_of(space) <= kMostPoints;
  DrawingLabels labels;
  // Numbers keep away from the heading and the dimensions.
  labels.take({kLeft_mm + 0.5 * kLeastWidth_mm, 0.5 * kTop_mm}, {kLeastWidth_mm, kTop_mm - 1});
  labels.take(
      {0.5 * (plan.corner_mm.x + plan_right_mm), 0.5 * (plan.bottom_mm() + 1 + plan_end_mm)},
      {plan_right_mm - plan.corner_mm.x, plan_end_mm - plan.bottom_mm() - 1});
  const std::string title = escape_html(title_of(space.name, space.id));
  const std::string words = t.say<Text::layout_of>(title, scale_words(t, scale));
  std::string svg = fmt::format(
      "<svg class=\"layout\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-size=\"{2}\" role=\"img\" aria-label=\"{3}\">\n",
      svg_number(width), svg_number(height), kDrawingText_mm, words);
  svg += drawing_words({kLeft_mm, kTop_mm - 2.2}, t[Text::layout_plan], "start", "view");
  svg += drawing_path("wall", plan.path(space.footprint_m)) +
         surface_lines(plan, space, Sight::plan) + furniture(plan, space);
  if (has_points) svg += point_signs(plan, space);
  const std::string luminaires = luminaire_signs(plan, space, Sight::plan, labels);
  svg += plane_signs(plan, groups, labels) + luminaires + lengths.svg +
         corner_words(t, plan, lengths.below_mm);
  if (project.north_deg)
    svg += north_arrow({plan_right_mm + 0.55 * kRight_mm, kTop_mm + 8}, *project.north_deg);
  svg += drawing_words({side.corner_mm.x, side.corner_mm.y - 2.2}, side_title, "start", "view") +
         elevation(t, side, space, sight) + "</svg>\n";

  std::string notes;
  if (space.luminaires.size() > kMostNumbers)
    notes += std::string(" ") + t[Text::layout_no_numbers];
  if (groups.size() > kMostLetters) notes += std::string(" ") + t[Text::layout_no_letters];
  notes += std::string(" ") + t[has_points ? Text::layout_points : Text::layout_no_points];
  if (heights_of(space).size() > kMostLevels)
    notes += std::string(" ") + t[Text::layout_no_heights];
  // The floor of the open space and of rooms from files is not known.
  if (space.footprint_m.empty()) notes += std::string(" ") + t[Text::heights_over_zero];
  if (space.bodies_left_out > 0)
    notes += " " + t.say<Text::furniture_left_out>(space.bodies_left_out);
  if (!space.surface_lines_m.empty()) notes += std::string(" ") + t[Text::layout_surface_lines];
  if (space.surface_lines_left_out > 0)
    notes += " " + t.say<Text::layout_lines_left_out>(space.surface_lines_left_out);
  return std::string("<figure class=\"layout-figure") + (is_short(project) ? "" : " of-many") +
         "\">\n" + scroll_box(words, svg) + key_of(t, space, groups) + "<figcaption>" +
         t.say<Text::layout_caption>(scale_words(t, scale)) + notes + "</figcaption></figure>\n";
}

}  // namespace report
