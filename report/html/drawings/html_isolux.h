#pragma once
// Isolux lines of a plan as SVG, with labels where there is room for them.

#include "report/html/drawings/isolux.h"
#include "report/html/drawings/plan_layout.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace report {

// Axis-parallel boxes of what labels must not cover.
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

// How labels are drawn: their size, and the names of their styles.
struct LabelStyle {
  double font_px = 10.5;
  const char* names = "isolux-label";
};
// taken: what labels must not cover; no label covers another one either.
IsoluxDrawing svg_isolux(const Texts& t, const PlanLayout& layout,
                         const std::vector<IsoluxLevel>& levels, std::vector<LabelBox> taken,
                         const LabelStyle& style = {});

// Corners in metres as a closed path's data; "" without corners.
std::string svg_path(const PlanLayout& layout, const std::vector<glm::dvec2>& corners);

}  // namespace report
