#pragma once
// The colour bar of a heat map with its limits, and the key of its signs.

#include "report/html/drawings/plan_layout.h"
#include "report/images/heatmap.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns an inline <svg>: one box per band, round numbers below, each limit above at its place (an
// arrow when it is off the scale). counts: points in each band, drawn as bars on the boxes; empty:
// none.
std::string html_colour_bar(const Texts& t, const ColourScale& scale,
                            const std::vector<PlanLimit>& limits,
                            const std::vector<std::size_t>& counts = {},
                            std::string_view unit = "lx");

// Returns the bar for paper, in the pixels of its style sheet and with words of 6.5 points; no
// bars.
std::string html_paper_colour_bar(const Texts& t, const ColourScale& scale,
                                  const std::vector<PlanLimit>& limits, std::string_view unit);

// Returns the height of the first picture in pixels.
double colour_bar_height_px(std::size_t limits, bool has_counts);

// The signs that the key explains.
struct PlanSigns {
  std::string anchor;        // of the plane, for the hatch pattern
  std::string unit = "lx";   // of its values; "" of ratings and ratios
  std::string below, above;  // "below 300 lx": words of hatched cells; "" = none are hatched
  std::string minimum;       // "212 lx at (1.00, 2.00, 0.80)"
  std::size_t luminaires = 0;
  bool has_openings = false;    // their openings are drawn, not points
  bool has_directions = false;  // C0 is drawn at luminaires
  bool has_furniture = false, has_above = false;
  bool has_isolux = false;  // lines of equal value
  std::string required;     // "500 lx": of thick isolux lines; "" = there are none
};
std::string html_plan_key(const Texts& t, const PlanSigns& signs);

}  // namespace report
