#pragma once
// Planes of a drawing: their names, places and layers there.

#include "calc/scene/sensor_grid.h"
#include "report/document/document.h"
#include "report/html/drawings/flat_box.h"
#include "report/text/texts.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace report {

// The suffix of layers of planes that are no task areas.
inline constexpr const char* kOtherLayers = "_OTHER";

// Returns the gravest outcome of its requirements; not_judged if it was not computed.
rules::Outcome gravest_outcome(const PlanePart& plane);

bool is_level_plane(const PlanePart& plane);

// Returns "Task: pass", with the quantity if it is not plain illuminance. Not yet dxf_text().
std::string plane_label(const Texts& t, const SpacePart& space, const PlanePart& plane);

// Returns whether the room is lit for this plane: a task area, or a plane that the project itself
// describes - only those with requirements, if there are any.
bool is_task_area(const SpacePart& space, const PlanePart& plane);

// The place where a plane is drawn: its place in the world, or flat beside the plan.
class Placing {
 public:
  static Placing world(const glm::dvec2& shift_m) { return Placing(shift_m); }
  // grid: must outlive this. corner_m: place of its origin in the drawing.
  static Placing flat(const calc::SensorGrid& grid, const glm::dvec2& corner_m) {
    Placing placing(corner_m);
    placing.grid_ = &grid;
    return placing;
  }

  glm::dvec3 at(const glm::dvec3& world_m) const {
    if (grid_ == nullptr) return world_m + glm::dvec3(shift_m_, 0.0);
    const glm::dvec3 offset = world_m - grid_->origin_m;
    return {shift_m_.x + glm::dot(offset, grid_->u), shift_m_.y + glm::dot(offset, grid_->v), 0.0};
  }
  // uv_m: from the grid's origin.
  glm::dvec3 at(const calc::SensorGrid& grid, const glm::dvec2& uv_m) const {
    return at(grid.origin_m + uv_m.x * grid.u + uv_m.y * grid.v);
  }

 private:
  explicit Placing(const glm::dvec2& shift_m) : shift_m_(shift_m) {}

  glm::dvec2 shift_m_;
  const calc::SensorGrid* grid_ = nullptr;
};

// The layers of a plane's parts.
struct PlaneLayers {
  std::string outlines, names, values, isolux, limits, labels;
};

// Returns "LUX_VALUES", "LUX_VALUES_2", "LUX_VALUES_OTHER", ...
PlaneLayers plane_layers(bool is_task, std::size_t tier);

// Returns the box of its outline and its points, in the world; empty without either.
FlatBox drawn_box(const PlanePart& plane);

// Assigns planes to levels in which no plane's values overlap another's.
class Tiers {
 public:
  // Returns the level, from 0. plane: must outlive this.
  std::size_t tier_of(const PlanePart& plane);

 private:
  std::vector<std::vector<std::pair<const PlanePart*, FlatBox>>> tiers_;
};

}  // namespace report
