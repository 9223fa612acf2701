#pragma once
// The polar diagram of a luminaire: intensity over gamma in the plane pairs C0-C180 and C90-C270.

#include "calc/photometry/web.h"

#include <string>
#include <vector>

namespace report {

struct PolarPoint {
  double x = 0.0, y = 0.0;  // pixels, y downwards
};

// The purpose of a line or a text; renderers choose its colour.
enum class PolarRole { grid, frame, c0_c180, c90_c270, text, faint_text };

struct PolarLine {
  PolarRole role = PolarRole::grid;
  double width = 1.0;
  bool dashed = false;
  std::vector<PolarPoint> points;
};

struct PolarLabel {
  PolarRole role = PolarRole::text;
  PolarPoint at;  // middle of the text's height
  enum class Anchor { start, middle, end } anchor = Anchor::middle;
  std::string text;
  bool is_title = false;
};

struct PolarDrawing {
  double width = 0.0, height = 0.0;
  double header = 0.0;  // of that the strip that holds nothing but the title
  std::string title;
  std::vector<PolarLine> lines;
  std::vector<PolarLabel> labels;
};

// Draws the diagram: nadir down; C0 and C90 to the right, C180 and C270 to the left; C0-C180 solid,
// C90-C270 dashed; rings at round values of cd. A half without light (below 1 % of the maximum) is
// omitted. title: UTF-8, made safe here.
PolarDrawing draw_polar_diagram(const calc::PhotometricWeb& web, const std::string& title);

// Returns a self-contained file, which follows the reader's light or dark colour scheme.
std::string render_polar_svg(const PolarDrawing& drawing);

// Returns dark lines on white, twice the drawing's size, without the strip of the title (file names
// have it). Throws std::runtime_error as encode_png() does.
std::string render_polar_png(const PolarDrawing& drawing);

// Returns the distance of rings that gives three to six of them up to a highest value > 0: 1, 2 or
// 5 times a power of ten.
double polar_ring_step(double highest);

}  // namespace report
