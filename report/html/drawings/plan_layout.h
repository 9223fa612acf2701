#pragma once
// The layout of a plane's drawing: (u, v) of the plane to picture coordinates, and the limits that
// can be read from it.

#include "report/document/document.h"
#include "report/images/heatmap.h"
#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace report {

// A luminaire in the drawing, in metres.
struct PlanLuminaire {
  std::string label;  // LuminaireMark::label
  glm::dvec2 place_m{0.0};
  std::vector<glm::dvec2> outline_m;  // empty: a point
  glm::dvec2 c0{0.0};                 // direction of C0; 0: none in the drawing
};

// A line of furniture.
struct PlanLine {
  glm::dvec2 from_m{0.0}, to_m{0.0};
  bool is_above = false;  // all of that piece is above the plane
};

// The contents of the drawing, in metres from grid.origin_m along u and v.
struct PlanLayout {
  glm::dvec2 low_m{0.0}, high_m{0.0};  // of the picture
  double pixels_per_metre = 1.0;
  std::vector<glm::dvec2> room_m;  // the room's outline; empty unless the plane is horizontal
  std::vector<PlanLuminaire> luminaires_m;  // in the picture; empty unless horizontal
  std::vector<PlanLine> furniture_m;        // empty unless the plane is horizontal

  double width_px() const { return (high_m.x - low_m.x) * pixels_per_metre; }
  double height_px() const { return (high_m.y - low_m.y) * pixels_per_metre; }
  // Returns the place in the picture: v points up in the plan, y down in the picture.
  glm::dvec2 pixel(const glm::dvec2& uv_m) const {
    return {(uv_m.x - low_m.x) * pixels_per_metre, (high_m.y - uv_m.y) * pixels_per_metre};
  }
};

// Returns a layout of the whole room if the plane fills a fair part of it, else of the plane and
// its surroundings. Fits wanted_px.
PlanLayout lay_out_plan(const SpacePart& space, const PlanePart& plane,
                        const glm::dvec2& wanted_px);

// A limit that can be read from the points of the drawing: maintained, every luminaire at full
// output, in the plane's unit.
struct PlanLimit {
  std::string words;  // "average ≥ 500 lx"
  double limit = 0.0;
};
std::vector<PlanLimit> plan_limits(const Texts& t, const PlanePart& plane);

// Returns the length of a scale bar: 1, 2 or 5 times a power of ten, at most a third of width_m >
// 0.
double scale_bar_m(double width_m);

}  // namespace report
