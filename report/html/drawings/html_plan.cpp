#include "report/html/drawings/html_plan.h"

#include "report/html/drawings/html_isolux.h"
#include "report/html/drawings/html_legend.h"
#include "report/html/drawings/isolux.h"
#include "report/html/drawings/plan_cells.h"
#include "report/html/drawings/plan_layout.h"
#include "report/html/page/html_markup.h"
#include "report/images/heatmap.h"
#include "report/images/png.h"
#include "report/text/base64.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/point_thresholds.h"
#include "report/text/svg.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostIsoluxPoints = 20000;
constexpr double kBelowPlan = 26;     // px: room for the scale bar
constexpr int kPicturePixels = 1000;  // on its longer side: sharp in print

// How the drawing gets onto paper: smaller than on a screen, with words of a size that is read
// there. Values that have no room stay away by rows and columns.
struct PaperForm {
  double px_by_css_px = 1.0;  // of the drawing, by one of the style sheet
  double width_mm = 0.0;
  int pieces = 1;
  double number_px = 0.0;     // size of values; 0: not even one has room
  int columns = 1, rows = 1;  // of so many cells one is printed
  bool has_value(int column, int row, const calc::SensorGrid& grid) const {
    return is_kept(column, grid.columns, columns) && is_kept(row, grid.rows, rows);
  }

 private:
  // In the middle: the first and the last one have as much room as those between.
  static bool is_kept(int cell, int cells, int every) {
    const int kept = cells / every;
    const int from_first = cell - (cells - 1 - every * (kept - 1)) / 2;
    return from_first >= 0 && from_first % every == 0 && from_first / every < kept;
  }
};

// A long plan in pieces of one size: a wide one in rows, a high one in columns.
class Pieces {
 public:
  Pieces(const PlanLayout& layout, int count)
      : count_(count),
        all_px_(layout.width_px(), layout.height_px()),
        axis_(all_px_.x < all_px_.y) {}

  int count() const { return count_; }
  glm::dvec2 piece_px() const {
    glm::dvec2 size = all_px_;
    size[axis_] /= count_;
    return size;
  }
  // Of the drawing: where the piece begins.
  glm::dvec2 from_px(int piece) const {
    glm::dvec2 from(0.0);
    from[axis_] = piece * piece_px()[axis_];
    return from;
  }
  // Of the picture: where the piece stands. The first one of a high plan is its upper end.
  glm::dvec2 at_px(int piece) const {
    glm::dvec2 at(0.0);
    at[1 - axis_] = piece * (all_px_[1 - axis_] + kGap);
    return at;
  }
  glm::dvec2 whole_px() const {
    return at_px(count_ - 1) + piece_px() + glm::dvec2(0.0, kBelowPlan);
  }

 private:
  static constexpr double kGap = 8;

  int count_;
  glm::dvec2 all_px_;
  int axis_;  // along which it is cut
};

struct Drawing : PlanCells {
  const Texts& t;
  std::string name;  // of the plane
  ColourScale scale;
  ScaleSharing sharing;
  std::vector<PlanLimit> limits;
  std::optional<Threshold> at_least, at_most;  // that single points must meet
  std::string anchor;
  std::vector<IsoluxLevel> isolux = {};
  std::optional<PaperForm> on_paper = {};  // pages alone

  Thresholds thresholds() const { return {at_least, at_most}; }
  bool misses_a_limit(double value) const {
    return misses(at_least, value) || misses(at_most, value);
  }
};

bool has_direction(const PlanLuminaire& sign) { return glm::length(sign.c0) > 0.1; }

const PointRow& lowest_point(const PlanePart& plane) {
  return *std::min_element(
      plane.points.begin(), plane.points.end(),
      [](const PointRow& a, const PointRow& b) { return a.measured.value < b.measured.value; });
}

std::string svg_cells(const Drawing& drawing) {
  std::string svg;
  for (const auto& [band, points] : points_by_band(drawing.plane, drawing.scale)) {
    const std::string colour = hex_colour(band_colour(drawing.scale, band));
    svg += fmt::format("<g class=\"cells\" fill=\"{0}\" stroke=\"{0}\">\n", colour);
    for (const PointRow* point : points) {
      svg += fmt::format("<path d=\"{}\"><title>{}</title></path>\n",
                         drawing.cell_path(point->column, point->row),
                         drawing.t.say<Text::cell_title>(
                             escape_html(value_words(drawing.t, drawing.plane, point->measured,
                                                     drawing.thresholds())),
                             format_cell(drawing.t, point->direct_lx),
                             format_cell(drawing.t, point->indirect_lx)));
    }
    svg += "</g>\n";
  }
  return svg;
}

// One path for each colour: cells that are too many for titles, and in no raster.
std::string plain_cells(const Drawing& drawing) {
  std::string svg;
  for (const auto& [band, points] : points_by_band(drawing.plane, drawing.scale)) {
    const std::string colour = hex_colour(band_colour(drawing.scale, band));
    svg += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"", colour);
    for (const PointRow* point : points) svg += drawing.cell_path(point->column, point->row);
    svg += "\"/>\n";
  }
  return svg;
}

std::string png_cells(const Drawing& drawing) {
  const glm::dvec2 corner = drawing.cell_corner_px(0, drawing.plane.grid.rows - 1);
  const glm::dvec2 cell = drawing.cell_px();
  return fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>\n",
      svg_number(corner.x), svg_number(corner.y), svg_number(cell.x * drawing.plane.grid.columns),
      svg_number(cell.y * drawing.plane.grid.rows),
      base64(encode_png(plane_raster(drawing.plane, drawing.scale,
                                     pixels_per_cell(drawing.plane, kPicturePixels)))));
}

// One path for all hatched cells; neighbours in a row are joined.
std::string svg_hatch(const Drawing& drawing) {
  std::map<std::pair<int, int>, bool> cells;  // by row, then column
  for (const PointRow& point : drawing.plane.points) {
    if (drawing.misses_a_limit(point.measured.value)) cells[{point.row, point.column}] = true;
  }
  if (cells.empty()) return {};
  std::string path;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto [row, column] = first->first;
    int count = 0;
    while (first != cells.end() && first->first == std::pair(row, column + count)) {
      ++count;
      ++first;
    }
    if (drawing.route) {
      for (int k = 0; k < count; ++k) path += drawing.cell_path(column + k, row);
      continue;
    }
    const glm::dvec2 size = drawing.cell_px();
    path += svg_rectangle(drawing.cell_corner_px(column, row), {size.x * count, size.y});
  }
  return fmt::format("<path class=\"missed\" fill=\"url(#hatch-{})\" d=\"{}\"/>\n", drawing.anchor,
                     path);
}

std::string cell_text(const Drawing& drawing, const calc::Estimate& value) {
  return cell_words(drawing.t, drawing.plane, value, drawing.thresholds());
}

constexpr double kDigitWidth = 0.6;  // of the font's size

std::size_t longest_number(const Drawing& drawing) {
  std::size_t longest = 1;
  for (const PointRow& point : drawing.plane.points) {
    longest = std::max(longest, cell_text(drawing, point.measured).size());
  }
  return longest;
}

// Font size at which every number fits into its cell; 0: they do not fit.
double number_size_px(const Drawing& drawing) {
  constexpr double kSmallest = 7.5, kLargest = 12.5;
  const auto longest = static_cast<double>(longest_number(drawing));
  const glm::dvec2 cell = drawing.cell_px();
  const double fitting = std::min(0.86 * cell.x / (kDigitWidth * longest), 0.62 * cell.y);
  return fitting < kSmallest ? 0.0 : std::min(fitting, kLargest);
}

// What is read on paper.
PaperForm paper_form(const Drawing& drawing, const PlanPlace& place) {
  constexpr double kWorthAPiece = 1.15;  // so much larger all becomes
  constexpr double kPoint_mm = 25.4 / 72, kCssPixel_mm = 25.4 / 96;
  constexpr double kSmallest_mm = 6.5 * kPoint_mm, kLargest_mm = 8 * kPoint_mm;
  constexpr double kGap = 0.5, kLine = 1.15;  // beside and below a number, of its size
  PaperForm form;
  double mm_by_px = 0.0;
  for (int pieces = 1; pieces <= place.most_pieces; ++pieces) {
    const glm::dvec2 plan_px = Pieces(drawing.layout, pieces).whole_px();
    const double fitting = std::min(place.most_mm.x / plan_px.x, place.most_mm.y / plan_px.y);
    if (fitting <= kWorthAPiece * mm_by_px) continue;
    mm_by_px = fitting;
    form.pieces = pieces;
    form.width_mm = mm_by_px * plan_px.x;
  }
  form.px_by_css_px = kCssPixel_mm / mm_by_px;
  const calc::SensorGrid& grid = drawing.plane.grid;
  const glm::dvec2 cell = drawing.cell_px(), cells(grid.columns, grid.rows);
  // By the size of the font. Cells of a route may lie in any direction.
  glm::dvec2 number(kDigitWidth * static_cast<double>(longest_number(drawing)) + kGap, kLine);
  if (drawing.route) number = glm::dvec2(std::max(number.x, number.y));
  const double smallest_px = kSmallest_mm / mm_by_px;
  const glm::dvec2 steps = glm::ceil(smallest_px * number / cell);
  if (steps.x > cells.x && steps.y > cells.y) return form;
  form.columns = static_cast<int>(std::clamp(steps.x, 1.0, cells.x));
  form.rows = static_cast<int>(std::clamp(steps.y, 1.0, cells.y));
  const glm::dvec2 fitting = glm::dvec2(form.columns, form.rows) * cell / number;
  form.number_px = std::clamp(std::min(fitting.x, fitting.y), smallest_px, kLargest_mm / mm_by_px);
  return form;
}

bool is_on_paper(const Drawing& drawing, const PointRow& point) {
  return drawing.on_paper && drawing.on_paper->number_px > 0.0 &&
         drawing.on_paper->has_value(point.column, point.row, drawing.plane.grid);
}

// Those of a screen, or of paper alone.
std::string svg_numbers(const Drawing& drawing) {
  const bool is_of_paper = number_size_px(drawing) == 0.0;
  if (is_of_paper && !drawing.on_paper) return {};
  const double size = is_of_paper ? drawing.on_paper->number_px : number_size_px(drawing);
  if (size == 0.0) return {};
  std::string svg;
  for (const auto& [band, points] : points_by_band(drawing.plane, drawing.scale)) {
    const Rgb colour = band_colour(drawing.scale, band);
    svg += fmt::format("<g class=\"{}\" fill=\"{}\" stroke=\"{}\" font-size=\"{}\">\n",
                       is_of_paper ? "paper-numbers" : "numbers",
                       needs_dark_text(colour) ? "#000" : "#fff", hex_colour(colour),
                       svg_number(size));
    for (const PointRow* point : points) {
      const bool is_printed = is_on_paper(drawing, *point);
      if (is_of_paper && !is_printed) continue;
      const glm::dvec2 middle = drawing.cell_middle_px(point->column, point->row);
      svg += fmt::format("<text{} x=\"{}\" y=\"{}\">{}</text>\n",
                         drawing.on_paper && !is_printed ? " class=\"unprinted\"" : "",
                         svg_number(middle.x), svg_number(middle.y + 0.36 * size),
                         escape_html(cell_text(drawing, point->measured)));
    }
    svg += "</g>\n";
  }
  return svg;
}

// A circle with a cross for a point, else the opening; a short arrow towards C0.
std::string svg_luminaires(const Drawing& drawing) {
  std::string circles, path, arrows;
  constexpr double kRadius = 5, kArrow = 15, kHead = 3.4;
  for (const PlanLuminaire& sign : drawing.layout.luminaires_m) {
    const glm::dvec2 p = drawing.layout.pixel(sign.place_m);
    const std::string outline = svg_path(drawing.layout, sign.outline_m);
    if (outline.empty()) {
      circles += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", svg_number(p.x),
                             svg_number(p.y), kRadius);
      path += fmt::format("M{} {}l7 7m0-7l-7 7", svg_number(p.x - 3.5), svg_number(p.y - 3.5));
    }
    path += outline;
    if (!has_direction(sign)) continue;
    const glm::dvec2 ahead = glm::normalize(glm::dvec2(sign.c0.x, -sign.c0.y));
    const glm::dvec2 beside(-ahead.y, ahead.x);
    const glm::dvec2 tip = p + kArrow * ahead, foot = tip - 1.6 * kHead * ahead;
    const glm::dvec2 left = foot + 0.7 * kHead * beside, right = foot - 0.7 * kHead * beside;
    arrows += fmt::format("M{} {}L{} {}M{} {}L{} {}L{} {}z", svg_number(p.x), svg_number(p.y),
                          svg_number(foot.x), svg_number(foot.y), svg_number(tip.x),
                          svg_number(tip.y), svg_number(left.x), svg_number(left.y),
                          svg_number(right.x), svg_number(right.y));
  }
  if (circles.empty() && path.empty()) return {};
  std::string picture = circles + "<path d=\"" + path + "\"/>";
  if (!arrows.empty()) picture += "<path class=\"c0\" d=\"" + arrows + "\"/>";
  return "<g class=\"luminaire halo\">" + picture + "</g><g class=\"luminaire\">" + picture +
         "</g>\n";
}

constexpr double kNumberSize = 10;     // px
constexpr double kLetterWidth = 0.66;  // of marks, about, in sizes: capitals are wider than digits

// Marks of luminaires, to the lower right of their signs. There are none where they are too many to
// be read apart, and none among the values of cells: the room's layout has them, too.
glm::dvec2 sign_label_px(const Drawing& drawing, const PlanLuminaire& sign) {
  constexpr double kAside = 8;
  return drawing.layout.pixel(sign.place_m) + glm::dvec2(kAside, kAside + 0.36 * kNumberSize);
}

bool has_sign_labels(const Drawing& drawing) {
  constexpr std::size_t kMost = 80;
  return drawing.layout.luminaires_m.size() <= kMost && number_size_px(drawing) == 0.0;
}

std::string svg_sign_labels(const Drawing& drawing) {
  if (drawing.layout.luminaires_m.empty() || !has_sign_labels(drawing)) return {};
  std::string svg = "<g class=\"sign-numbers\">";
  for (const PlanLuminaire& sign : drawing.layout.luminaires_m) {
    const glm::dvec2 at = sign_label_px(drawing, sign);
    svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", svg_number(at.x), svg_number(at.y),
                       escape_html(sign.label));
  }
  return svg + "</g>\n";
}

std::string svg_furniture(const Drawing& drawing) {
  std::string below, above;
  for (const PlanLine& line : drawing.layout.furniture_m) {
    const glm::dvec2 from = drawing.layout.pixel(line.from_m), to = drawing.layout.pixel(line.to_m);
    (line.is_above ? above : below) += fmt::format(
        "M{} {}L{} {}", svg_number(from.x), svg_number(from.y), svg_number(to.x), svg_number(to.y));
  }
  std::string svg;
  if (!below.empty()) svg += "<path class=\"furniture\" d=\"" + below + "\"/>\n";
  if (!above.empty()) svg += "<path class=\"furniture above\" d=\"" + above + "\"/>\n";
  return svg;
}

// By values of that size, of all points or of those that are printed, and luminaires.
std::vector<LabelBox> taken_by_numbers(const Drawing& drawing, double size, bool on_paper) {
  constexpr double kSign = 12;
  std::vector<LabelBox> taken;
  for (const PointRow& point : drawing.plane.points) {
    if (size == 0.0 || (on_paper && !is_on_paper(drawing, point))) continue;
    const glm::dvec2 middle = drawing.cell_middle_px(point.column, point.row);
    const auto digits = static_cast<double>(cell_text(drawing, point.measured).size());
    taken.push_back(box_around(middle, {kDigitWidth * size * digits, size}));
  }
  for (const PlanLuminaire& sign : drawing.layout.luminaires_m)
    taken.push_back(box_around(drawing.layout.pixel(sign.place_m), glm::dvec2(kSign)));
  return taken;
}

std::vector<LabelBox> taken_places(const Drawing& drawing) {
  std::vector<LabelBox> taken = taken_by_numbers(drawing, number_size_px(drawing), false);
  if (!has_sign_labels(drawing)) return taken;
  for (const PlanLuminaire& sign : drawing.layout.luminaires_m) {
    const auto letters = static_cast<double>(sign.label.size());
    const glm::dvec2 size(kLetterWidth * kNumberSize * letters, kNumberSize);
    taken.push_back(box_around(sign_label_px(drawing, sign) + glm::dvec2(0.5, -0.36) * size, size));
  }
  return taken;
}

// A frame around the cell, never smaller than can be seen.
std::string svg_minimum(const Drawing& drawing) {
  constexpr double kSmallest = 11;
  const PointRow& point = lowest_point(drawing.plane);
  const glm::dvec2 cell = drawing.cell_px();
  const glm::dvec2 size = glm::max(cell, glm::dvec2(kSmallest));
  const glm::dvec2 corner =
      drawing.route ? drawing.cell_middle_px(point.column, point.row) - 0.5 * size
                    : drawing.cell_corner_px(point.column, point.row) + 0.5 * (cell - size);
  const std::string path = svg_rectangle(corner, size);
  return fmt::format("<path class=\"min-halo\" d=\"{0}\"/><path class=\"min-mark\" d=\"{0}\"/>\n",
                     path);
}

std::string svg_scale_bar(const Texts& t, const PlanLayout& layout, const Pieces& pieces) {
  const double length_m = scale_bar_m(pieces.piece_px().x / layout.pixels_per_metre);
  const double y = pieces.whole_px().y - kBelowPlan + 16;
  return fmt::format(
      "<path class=\"scale\" d=\"M1 {0}v6h{1}v-6\"/><text x=\"{2}\" y=\"{3}\" class=\"small\">{4} "
      "m</text>\n",
      svg_number(y - 4), svg_number(length_m * layout.pixels_per_metre),
      svg_number(length_m * layout.pixels_per_metre + 8), svg_number(y + 4),
      format_shortest(t, length_m));
}

std::string hatch_pattern(const std::string& anchor) {
  return "<defs><pattern id=\"hatch-" + anchor +
         "\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
         "patternTransform=\"rotate(45)\">"
         "<path d=\"M1 0v7\" stroke=\"#000\" stroke-opacity=\".75\" stroke-width=\"1.3\"/>"
         "<path d=\"M2.4 0v7\" stroke=\"#fff\" stroke-opacity=\".8\" "
         "stroke-width=\"1.3\"/></pattern></defs>\n";
}

std::string unit_words(const PlanePart& plane) {
  const std::string unit = plane_unit(plane);
  return unit.empty() ? "" : " " + unit;
}

std::string spoken(const Drawing& drawing) {
  const PlanePart& plane = drawing.plane;
  const PointRow& lowest = lowest_point(plane);
  return drawing.t.say<Text::heat_map_of>(
      escape_html(drawing.name), plane.points.size(), plane_words(drawing.t, plane),
      cell_text(drawing, plane.minimum), cell_text(drawing, plane.maximum), unit_words(plane),
      format_position(drawing.t, lowest.position_m));
}

// Lengths in the drawing's pixels for the style sheet of paper.
std::string paper_attribute(const Drawing& drawing) {
  if (!drawing.on_paper) return {};
  const PaperForm& form = *drawing.on_paper;
  const double on_screen_px = number_size_px(drawing);
  std::string lengths = fmt::format("--width:{}mm;--px:{}px", svg_number(form.width_mm),
                                    svg_number(form.px_by_css_px));
  if (on_screen_px > 0.0 && form.number_px > 0.0) {
    lengths += fmt::format(";--number:{}px;--lower:{}px", svg_number(form.number_px),
                           svg_number(0.36 * (form.number_px - on_screen_px)));
  }
  return " style=\"" + lengths + "\"";
}

std::string paper_labels(const Drawing& drawing) {
  if (!drawing.on_paper) return {};
  constexpr double kText_px = 8.7;  // 6.5 points
  const PaperForm& form = *drawing.on_paper;
  return svg_isolux(drawing.t, drawing.layout, drawing.isolux,
                    taken_by_numbers(drawing, form.number_px, true),
                    {kText_px * form.px_by_css_px, "isolux-label paper"})
      .labels;
}

// The window of one piece, and the group that the first one shares with the others: what a <use>
// copies has the styles of a plan by its own class alone.
std::string piece_start(const Drawing& drawing, const Pieces& pieces, int piece) {
  const glm::dvec2 at = pieces.at_px(piece), size = pieces.piece_px(), from = pieces.from_px(piece);
  return fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" width=\"{4}\" height=\"{5}\" viewBox=\"{2} {3} {4} {5}\"><g{6}>\n",
      svg_number(at.x), svg_number(at.y), svg_number(from.x), svg_number(from.y),
      svg_number(size.x), svg_number(size.y),
      piece == 0 && pieces.count() > 1 ? " class=\"plan\" id=\"" + drawing.anchor + "-plan\"" : "");
}

std::string svg_plan(const Drawing& drawing) {
  const PlanLayout& layout = drawing.layout;
  const Pieces pieces(layout, drawing.on_paper ? drawing.on_paper->pieces : 1);
  const std::string width = svg_number(pieces.whole_px().x),
                    height = svg_number(pieces.whole_px().y);
  std::string svg = fmt::format(
      "<svg class=\"plan\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\"{3}>\n",
      width, height, spoken(drawing), paper_attribute(drawing));
  svg += hatch_pattern(drawing.anchor);
  svg += piece_start(drawing, pieces, 0);
  const std::string room = svg_path(layout, layout.room_m);
  if (!room.empty()) svg += fmt::format("<path class=\"floor\" d=\"{}\"/>\n", room);
  if (drawing.plane.points.size() <= kMostSvgCells) {
    svg += svg_cells(drawing);
  } else {
    svg += drawing.route ? plain_cells(drawing) : png_cells(drawing);
  }
  svg += svg_hatch(drawing);
  std::string outline = svg_path(layout, drawing.plane.outline_m);
  for (const auto& hole : drawing.plane.holes_m) outline += svg_path(layout, hole);
  if (!outline.empty()) svg += fmt::format("<path class=\"outline\" d=\"{}\"/>\n", outline);
  svg += svg_furniture(drawing);
  if (!room.empty()) svg += fmt::format("<path class=\"wall\" d=\"{}\"/>\n", room);
  const IsoluxDrawing isolux =
      svg_isolux(drawing.t, drawing.layout, drawing.isolux, taken_places(drawing));
  svg += isolux.lines + svg_luminaires(drawing) + svg_minimum(drawing) + svg_numbers(drawing) +
         svg_sign_labels(drawing) + isolux.labels + paper_labels(drawing) + "</g></svg>\n";
  for (int piece = 1; piece < pieces.count(); ++piece) {
    svg += piece_start(drawing, pieces, piece) +
           fmt::format("<use href=\"#{}-plan\"/></g></svg>\n", drawing.anchor);
  }
  return svg + svg_scale_bar(drawing.t, layout, pieces) + "</svg>\n";
}

// "+x", "−y" for an axis of the world, else its components.
std::string direction_words(const Texts& t, const glm::dvec3& direction) {
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1.0 - 1e-9) continue;
    return std::string(direction[axis] > 0 ? "+" : "−") + kNames[static_cast<std::size_t>(axis)];
  }
  return with_minus(format_position(t, direction));
}

std::string caption(const Drawing& drawing) {
  const calc::SensorGrid& grid = drawing.plane.grid;
  const bool is_planar = is_plain_illuminance(drawing.plane);
  const Text view = is_horizontal(glm::cross(grid.u, grid.v)) ? Text::plan_view
                    : is_planar                               ? Text::from_measured_side
                                                              : Text::from_front;
  const Texts& t = drawing.t;
  const std::string values = values_words(t, drawing.plane), right = direction_words(t, grid.u),
                    up = direction_words(t, grid.v);
  const auto& light = drawing.plane.asked_light;
  return light && light->is_shown
             ? t.say<Text::plan_caption_asked>(values, escape_html(asked_light_words(t, *light)),
                                               t[view], right, up)
             : t.say<Text::plan_caption>(values, t[view], right, up);
}

std::vector<std::size_t> band_counts(const Drawing& drawing) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(drawing.scale.bands));
  for (const PointRow& point : drawing.plane.points)
    ++counts[static_cast<std::size_t>(band_of(drawing.scale, point.measured.value))];
  return counts;
}

PlanSigns signs_of(const Drawing& drawing) {
  PlanSigns signs;
  signs.anchor = drawing.anchor;
  signs.unit = plane_unit(drawing.plane);
  const PlanLayout& layout = drawing.layout;
  signs.has_openings = std::any_of(layout.luminaires_m.begin(), layout.luminaires_m.end(),
                                   [](const auto& sign) { return !sign.outline_m.empty(); });
  signs.luminaires = layout.luminaires_m.size();
  signs.has_directions =
      std::any_of(layout.luminaires_m.begin(), layout.luminaires_m.end(), has_direction);
  signs.has_furniture = !layout.furniture_m.empty();
  signs.has_above = std::any_of(layout.furniture_m.begin(), layout.furniture_m.end(),
                                [](const PlanLine& line) { return line.is_above; });
  for (const IsoluxLevel& level : drawing.isolux) {
    if (level.lines.empty()) continue;
    if (!level.is_required) signs.has_isolux = true;
    if (level.is_required)
      signs.required += (signs.required.empty() ? "" : ", ") +
                        format_limit(drawing.t, level.value, plane_unit(drawing.plane));
  }
  const PointRow& lowest = lowest_point(drawing.plane);
  const Texts& t = drawing.t;
  signs.minimum = t.say<Text::value_at_place>(
      escape_html(cell_text(drawing, lowest.measured)) + unit_words(drawing.plane),
      with_minus(format_position(t, lowest.position_m)));
  const char* unit = plane_unit(drawing.plane);
  for (const PointRow& point : drawing.plane.points) {
    const double value = point.measured.value;
    if (misses(drawing.at_least, value)) {
      const std::string limit = format_limit(t, drawing.at_least->limit, unit);
      const bool is_strict = drawing.at_least->comparison == rules::Comparison::more_than;
      signs.below = is_strict ? t.say<Text::not_above>(limit) : t.say<Text::below>(limit);
    }
    if (misses(drawing.at_most, value)) {
      const std::string limit = format_limit(t, drawing.at_most->limit, unit);
      const bool is_strict = drawing.at_most->comparison == rules::Comparison::less_than;
      signs.above = is_strict ? t.say<Text::not_below>(limit) : t.say<Text::above>(limit);
    }
  }
  return signs;
}

// What is drawn of a plane. has_all: no line of equal value was left out.
Drawing make_drawing(const Texts& t, const SpacePart& space, const PlanePart& plane,
                     const PlaneScale& scale, std::string_view anchor, bool& has_all) {
  const std::vector<PlanLimit> limits = plan_limits(t, plane);
  Drawing drawing{plan_cells(space, plane, {640, 460}),
                  t,
                  plane_name(t, space, plane),
                  scale.scale,
                  scale.among,
                  limits,
                  point_threshold(plane, PointSide::from_below),
                  point_threshold(plane, PointSide::from_above),
                  std::string(anchor)};
  // Lines between numbers must leave them readable.
  drawing.isolux = isolux_levels(plane, scale.scale.has_classes() ? own_scale(plane) : scale.scale,
                                 limits, number_size_px(drawing) > 0 ? 4 : 8);
  has_all = trace_isolux(plane, kMostIsoluxPoints, drawing.isolux);
  return drawing;
}

std::string colour_bar(const Drawing& drawing) {
  return html_colour_bar(drawing.t, drawing.scale, drawing.limits, band_counts(drawing),
                         plane_unit(drawing.plane));
}

}  // namespace

PlanPlace place_beside_tables(Paper paper) {
  return {paper == Paper::letter ? glm::dvec2(74, 38) : glm::dvec2(72, 43)};
}

std::string html_plan(const Texts& t, const SpacePart& space, const PlanePart& plane,
                      const PlaneScale& scale, std::string_view anchor, const PlanPlace& place) {
  bool has_all = true;
  Drawing drawing = make_drawing(t, space, plane, scale, anchor, has_all);
  drawing.on_paper = paper_form(drawing, place);
  std::string left_out = fmt::format(" {}", sharing_words(t, drawing.sharing));
  if (!has_all) left_out += std::string(" ") + t[Text::isolux_left_out];
  if (space.bodies_left_out > 0)
    left_out += " " + t.say<Text::furniture_left_out>(space.bodies_left_out);
  if (drawing.on_paper->columns > 1 || drawing.on_paper->rows > 1) {
    left_out += " <span class=\"on-paper\">" +
                t.say<Text::values_on_paper>(drawing.on_paper->columns, drawing.on_paper->rows) +
                "</span>";
  }
  return "<figure>\n" + svg_plan(drawing) + colour_bar(drawing) +
         html_paper_colour_bar(t, drawing.scale, drawing.limits, plane_unit(plane)) +
         html_plan_key(t, signs_of(drawing)) + "<figcaption>" + caption(drawing) + left_out +
         "</figcaption></figure>\n";
}

PlanIsolux plan_isolux(const Texts& t, const SpacePart& space, const PlanePart& plane,
                       const PlaneScale& scale) {
  PlanIsolux isolux;
  isolux.levels = make_drawing(t, space, plane, scale, "plan", isolux.has_all).isolux;
  return isolux;
}

PlanPictures plan_pictures(const Texts& t, const SpacePart& space, const PlanePart& plane,
                           const PlaneScale& scale) {
  bool has_all = true;
  const Drawing drawing = make_drawing(t, space, plane, scale, "plan", has_all);
  return {svg_plan(drawing), colour_bar(drawing), drawing.layout.width_px(),
          drawing.layout.height_px() + kBelowPlan,
          colour_bar_height_px(drawing.limits.size(), true)};
}

}  // namespace report
