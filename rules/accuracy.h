#pragma once
// When may the calculation of a plane stop?

#include "calc/field.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/requirement.h"

#include <vector>

namespace rules {

// True if every quantity that `requirements` judge on this plane has half-width <= tolerance *
// value, or half-width 0. Without requirements: the maintained average and minimum with every
// luminaire at full output. A quantity that does not exist (uniformity of a dark plane, a point
// outside the grid) gains nothing from more work and counts as accurate. Arguments as for
// judge_plane(); tolerance > 0, relative.
bool is_accurate(const std::vector<Requirement>& requirements, const calc::SensorGrid& grid,
                 const calc::PlaneField& field, const std::vector<calc::LightScene>& scenes,
                 double tolerance, double confidence);

}  // namespace rules
