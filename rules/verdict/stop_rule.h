#pragma once
// Judges a plane after every sampling round: its findings, whether it is finished, and which points
// continue.

#include "calc/base/field.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"
#include "rules/catalogue/finding.h"
#include "rules/catalogue/goal.h"
#include "rules/catalogue/requirement.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rules {

struct StopRule {
  Goal goal = Goal::verdict;
  double tolerance = 0.02;   // relative half-width, > 0: of Goal::accuracy
  double confidence = 0.95;  // over all sampling rounds of a plane, in (0, 1)
};

struct LookJudgement {
  std::vector<Finding> findings;             // as judge_plane() has them
  std::optional<calc::StopReason> finished;  // empty: go on
  // [point]: 1 where more samples would help; empty: everywhere. Not for a finished plane.
  std::vector<std::uint8_t> active;
};

// Judges one sampling round. Goal::verdict: a plane is finished (decided) once none of its
// requirements is undecided, or only for reasons that no sample can settle
// (Measurement::is_open_for_good). Goal::accuracy: it is finished (accurate) once every judged
// quantity has half-width <= tolerance * value, as far as it is sampled. A plane without
// requirements is finished, for either goal, once its maintained average and minimum, with every
// luminaire at full output, are accurate. A quantity that does not exist (uniformity of a dark
// plane, a point outside the grid) needs no more work.
//
// Points on which no unfinished quantity depends are omitted from further rounds and keep their
// replicates. No limit of a single point suffers: it was valid at the point's last round, and the
// level of a round allows for that. See look_confidence() for that level, and
// PlaneField::looks_planned. Other arguments as for judge_plane().
LookJudgement judge_look(const StopRule& rule, const std::vector<Requirement>& requirements,
                         const calc::SensorGrid& grid, const calc::PlaneField& field,
                         const std::vector<calc::LightScene>& scenes);

}  // namespace rules
