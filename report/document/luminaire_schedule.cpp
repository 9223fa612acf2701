#include "report/document/luminaire_schedule.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace report {
namespace {

constexpr double kSameHeight_m = 0.005;

void add_height(double height_m, std::vector<double>& heights_m) {
  const bool is_known = std::any_of(heights_m.begin(), heights_m.end(), [&](double known_m) {
    return std::abs(known_m - height_m) <= kSameHeight_m;
  });
  if (!is_known) heights_m.push_back(height_m);
}

// Of a luminaire that shines straight up or down: of others the plan does not show the shape.
void take_outline(const LuminaireMark& mark, ScheduleRow& row) {
  constexpr double kUpright = 0.9998;  // cosine of one degree
  const glm::dvec2 c0(mark.c0);
  const double length = glm::length(c0);
  if (!row.outline_m.empty() || mark.outline_m.size() < 3) return;
  if (std::abs(mark.axis.z) < kUpright || !(length > 0.0)) return;
  const glm::dvec2 along = c0 / length, across(-along.y, along.x);
  glm::dvec2 low(0.0), high(0.0);
  for (const glm::dvec2& corner : mark.outline_m) {
    const glm::dvec2 arm = corner - glm::dvec2(mark.position_m);
    row.outline_m.emplace_back(glm::dot(arm, along), glm::dot(arm, across));
    low = glm::min(low, row.outline_m.back());
    high = glm::max(high, row.outline_m.back());
  }
  row.opening_m = high - low;
}

void take_marks(const SpacePart& space, ScheduleRow& row) {
  for (const LuminaireMark& mark : space.luminaires) {
    if (mark.type_id != row.type->type_id) continue;
    if (row.spaces.empty() || row.spaces.back() != &space) row.spaces.push_back(&space);
    if (space.footprint_m.empty()) {
      add_height(mark.position_m.z, row.heights_above_zero_m);
    } else {
      add_height(mark.position_m.z - space.floor_z_m, row.heights_m);
    }
    take_outline(mark, row);
  }
}

}  // namespace

LuminaireSchedule schedule_of(const ProjectPart& project) {
  LuminaireSchedule schedule;
  schedule.totals = totals_of(project.luminaires);
  for (std::size_t i = 0; i < project.luminaires.size(); ++i) {
    ScheduleRow row{&project.luminaires[i], position_letter(i)};
    for (const SpacePart& space : project.spaces) take_marks(space, row);
    std::sort(row.heights_m.begin(), row.heights_m.end());
    std::sort(row.heights_above_zero_m.begin(), row.heights_above_zero_m.end());
    (row.type->count > 0 ? schedule.used : schedule.unused).push_back(std::move(row));
  }
  for (const SpacePart& space : project.spaces) {
    if (is_power_of_spacing(space)) schedule.roads.push_back(&space);
  }
  return schedule;
}

}  // namespace report
