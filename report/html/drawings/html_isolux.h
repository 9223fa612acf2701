#pragma once
// Isolux lines of a plan as SVG, with labels where they fit.

#include "report/html/drawings/isolux.h"
#include "report/html/drawings/plan_layout.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace report {

// An axis-parallel box that labels must not cover.
struct LabelBox {
  glm::dvec2 low, high;
  bool meets(const LabelBox& other) const {
    return low.x < other.high.x && high.x > other.low.x && low.y < other.high.y &&
           high.y > other.low.y;
  }
};

inline LabelBox box_around(const glm::dvec2& middle, const glm::dvec2& size) {
  return {middle - 0.5 * size, middle + 0.5 * size};
}

struct IsoluxDrawing {
  std::string lines, labels;
};

// The style of labels: their size, and the names of their styles.
struct LabelStyle {
  double font_px = 10.5;
  const char* names = "isolux-label";
};
// Returns the drawing. taken: boxes that labels must not cover; no label covers another, either.
IsoluxDrawing svg_isolux(const Texts& t, const PlanLayout& layout,
                         const std::vector<IsoluxLevel>& levels, std::vector<LabelBox> taken,
                         const LabelStyle& style = {});

// Returns a closed path's data with corners in metres; "" without corners.
std::string svg_path(const PlanLayout& layout, const std::vector<glm::dvec2>& corners);

}  // namespace report
