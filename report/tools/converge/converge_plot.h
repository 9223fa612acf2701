#pragma once
// Log-log plots of errors as SVG. Colours come from the page: classes m0 to m7.

#include "report/text/texts.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace report {

struct PlotPoint {
  double x = 0.0, y = 0.0, low = 0.0, high = 0.0;  // > 0 to be shown
  bool is_hollow = false;                          // less sure than the others
  std::string words;                               // shown on hovering
};

struct PlotSeries {
  std::size_t colour = 0;
  std::vector<PlotPoint> points;  // x ascending
};

enum class PlotUnit { seconds, count };

struct PlotSpec {
  std::string title, x_title;  // plain text
  PlotUnit unit = PlotUnit::seconds;
  std::vector<PlotSeries> series;
  std::optional<double> floor;  // a dashed line: what the reference is known to
  Texts t = {};                 // of numbers and of the dashed line
};

// Returns the plot; "" if there is nothing to show. y in shares, labelled in per cent; a faint line
// falls with the exponent -1/2, that of plain random sampling.
std::string log_log_plot(const PlotSpec& spec);

}  // namespace report
