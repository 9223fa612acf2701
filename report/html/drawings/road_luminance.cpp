#include "report/html/drawings/road_luminance.h"

#include "report/document/road_facts.h"
#include "report/html/drawings/technical_drawing.h"
#include "report/html/page/html_markup.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>

namespace report {
namespace {

// In millimetres on paper; y points down.
constexpr double kChartWidth_mm = 180, kBefore_mm = 20, kBehind_mm = 10;
constexpr double kRoadCell_mm = 4.4, kFieldTop_mm = 4.5, kBelow_mm = 8, kNumber_mm = 2.4;
constexpr std::size_t kMostCellsAlong = 24;  // beside each other

std::string cell_number(const Texts& t, double cd_m2) {
  constexpr double kTwoDigits = 9.995;
  return format_fixed(t, cd_m2, cd_m2 < kTwoDigits ? 2 : 1);
}

// An eye that looks to the right, or to the left.
std::string eye_sign(const glm::dvec2& at, bool looks_left) {
  const double way = looks_left ? -1.0 : 1.0;
  return drawing_path("eye", fmt::format("M{0} {1}q2.2 -2.4 4.4 0q-2.2 2.4 -4.4 0z",
                                         svg_number(at.x - 2.2), svg_number(at.y)) +
                                 circle_path({at.x + 0.5 * way, at.y}, 0.7)) +
         drawing_path("traffic", fmt::format("M{0} {1}h{2}m{3} -0.9l{4} 0.9l{3} 0.9",
                                             svg_number(at.x + 3.0 * way), svg_number(at.y),
                                             svg_number(2.6 * way), svg_number(-1.1 * way),
                                             svg_number(1.1 * way)));
}

// Columns [first, last) of the field, one cell for each point.
class LuminancePiece {
 public:
  LuminancePiece(const Texts& t, const RoadPart& road, const calc::RoadObserver& observer,
                 const ColourScale& scale, std::size_t first, std::size_t last, double top_mm)
      : t_(t),
        road_(road),
        observer_(observer),
        scale_(scale),
        first_(first),
        last_(last),
        top_mm_(top_mm) {}

  static double height_mm(const RoadPart& road) {
    return kFieldTop_mm + kRoadCell_mm * static_cast<double>(road.light.grid.across()) + kBelow_mm;
  }

  // The eye is before the field: at its first piece, and of oncoming traffic at its last one.
  std::string draw() const {
    const bool has_eye = observer_.is_oncoming ? last_ == grid().along() : first_ == 0;
    return cells() + lane_ends() + numbers() + axes() + luminaires() + (has_eye ? eye() : "");
  }

 private:
  const calc::RoadGrid& grid() const { return road_.light.grid; }
  double cell_width_mm() const {
    return (kChartWidth_mm - kBefore_mm - kBehind_mm) / static_cast<double>(last_ - first_);
  }
  double x_mm(std::size_t column) const {
    return kBefore_mm + cell_width_mm() * static_cast<double>(column - first_);
  }
  // Upper end of a row: the first one is at the bottom.
  double y_mm(std::size_t row) const {
    return top_mm_ + kFieldTop_mm + kRoadCell_mm * static_cast<double>(grid().across() - 1 - row);
  }
  double bottom_mm() const { return y_mm(0) + kRoadCell_mm; }
  double value(std::size_t column, std::size_t row) const {
    return observer_.cd_m2[row * grid().along() + column];
  }

  template <class Use>
  void for_cells(const Use& use) const {
    for (std::size_t row = 0; row < grid().across(); ++row) {
      for (std::size_t column = first_; column < last_; ++column) use(column, row);
    }
  }

  std::string cells() const {
    std::map<int, std::string> by_band;
    for_cells([&](std::size_t column, std::size_t row) {
      by_band[band_of(scale_, value(column, row))] += fmt::format(
          "M{} {}h{}v{}h{}z", svg_number(x_mm(column)), svg_number(y_mm(row)),
          svg_number(cell_width_mm()), svg_number(kRoadCell_mm), svg_number(-cell_width_mm()));
    });
    std::string svg;
    for (const auto& [band, data] : by_band) {
      svg += fmt::format("<path class=\"cell\" style=\"fill:{}\" d=\"{}\"/>\n",
                         hex_colour(band_colour(scale_, band)), data);
    }
    return svg;
  }

  // Dark numbers on light cells, light ones on dark cells.
  std::string numbers() const {
    std::string dark, light;
    for_cells([&](std::size_t column, std::size_t row) {
      const double cd_m2 = value(column, row);
      const bool is_dark = needs_dark_text(band_colour(scale_, band_of(scale_, cd_m2)));
      (is_dark ? dark : light) += svg_text(x_mm(column) + 0.5 * cell_width_mm(),
                                           y_mm(row) + 0.5 * kRoadCell_mm + 0.36 * kNumber_mm,
                                           "middle", cell_number(t_, cd_m2));
    });
    return fmt::format(
        "<g class=\"on-light\" font-size=\"{0}\">{1}</g>\n<g class=\"on-dark\" "
        "font-size=\"{0}\">{2}</g>\n",
        kNumber_mm, dark, light);
  }

  // Between lanes, and along both edges.
  std::string lane_ends() const {
    std::string data;
    for (std::size_t row = 0; row <= grid().across(); row += calc::kRoadRowsPerLane) {
      data += fmt::format("M{} {}H{}", svg_number(kBefore_mm),
                          svg_number(bottom_mm() - kRoadCell_mm * static_cast<double>(row)),
                          svg_number(x_mm(last_)));
    }
    return drawing_path("lane-end", data);
  }

  std::string axes() const {
    std::string svg;
    for (std::size_t column = first_; column < last_; ++column) {
      svg += drawing_words({x_mm(column) + 0.5 * cell_width_mm(), bottom_mm() + 5.6},
                           format_fixed(t_, grid().x_m[column], 1));
    }
    for (std::size_t row = 0; row < grid().across(); ++row) {
      svg +=
          drawing_words({kBefore_mm - 1.2, y_mm(row) + 0.5 * kRoadCell_mm + 0.36 * kDrawingText_mm},
                        format_fixed(t_, grid().y_m[row], 2), "end");
    }
    return svg + drawing_words({x_mm(last_) + 1.2, bottom_mm() + 5.6}, "x", "start") +
           drawing_words({kBefore_mm - 1.2, top_mm_ + kFieldTop_mm - 1.4}, "y", "end");
  }

  // Beside the edge on whose side they stand.
  std::string luminaires() const {
    const double cell_m = road_.spacing_m / static_cast<double>(grid().along());
    const double from_m = cell_m * static_cast<double>(first_);
    const double to_m = cell_m * static_cast<double>(last_);
    std::string data;
    for (const RoadRowPart& row : road_.rows) {
      const double shift_m = first_shift_m(row.shift_m, road_.spacing_m);
      for (const double x_m : {shift_m, shift_m + road_.spacing_m}) {
        if (x_m < from_m || x_m > to_m) continue;
        const double x = kBefore_mm + (x_m - from_m) / cell_m * cell_width_mm();
        data += is_on_the_left(road_, row)
                    ? fmt::format("M{} {}l1 -1.8h-2z", svg_number(x),
                                  svg_number(top_mm_ + kFieldTop_mm))
                    : fmt::format("M{} {}l1 1.8h-2z", svg_number(x), svg_number(bottom_mm()));
      }
    }
    return drawing_path("lamp", data);
  }

  std::string eye() const {
    const auto middle = static_cast<std::size_t>(observer_.lane * calc::kRoadRowsPerLane +
                                                 calc::kRoadRowsPerLane / 2);
    const double x = observer_.is_oncoming ? kChartWidth_mm - 2.6 : 2.6;
    return eye_sign({x, y_mm(middle) + 0.5 * kRoadCell_mm}, observer_.is_oncoming);
  }

  const Texts& t_;
  const RoadPart& road_;
  const calc::RoadObserver& observer_;
  const ColourScale& scale_;
  std::size_t first_, last_;
  double top_mm_;
};

}  // namespace

ColourScale road_luminance_scale(const calc::RoadLight& light) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const calc::RoadObserver& observer : light.observers) {
    for (const double cd_m2 : observer.cd_m2) {
      low = std::min(low, cd_m2);
      high = std::max(high, cd_m2);
    }
  }
  return make_colour_scale(std::min(low, high), high);
}

std::string road_luminance(const Texts& t, const RoadPart& road, std::size_t observer,
                           const ColourScale& scale, const std::string& words) {
  const std::size_t along = road.light.grid.along();
  const std::size_t pieces = (along + kMostCellsAlong - 1) / kMostCellsAlong;
  const double piece_mm = LuminancePiece::height_mm(road);
  std::string svg = fmt::format(
      "<svg class=\"layout road\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-size=\"{2}\" role=\"img\" aria-label=\"{3}\">\n",
      kChartWidth_mm, svg_number(piece_mm * static_cast<double>(pieces)), kDrawingText_mm, words);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    svg += LuminancePiece(t, road, road.light.observers[observer], scale, along * piece / pieces,
                          along * (piece + 1) / pieces, piece_mm * static_cast<double>(piece))
               .draw();
  }
  return svg + "</svg>\n";
}

}  // namespace report
