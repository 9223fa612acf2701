#pragma once
// After every look at a plane's growing results: what it came to, is it finished, and if not, which
// points go on?

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
  double confidence = 0.95;  // over all looks of a plane, in (0, 1)
};

struct LookJudgement {
  std::vector<Finding> findings;             // as judge_plane() has them
  std::optional<calc::StopReason> finished;  // empty: go on
  // [point]: 1 where more samples would help; empty: everywhere. Not for a finished plane.
  std::vector<std::uint8_t> active;
};

// Goal::verdict: a plane is finished (decided) once none of its requirements is undecided, or only
// by what no sample can tell (Measurement::is_open_for_good). Goal::accuracy: it is finished
// (accurate) once every quantity that its requirements judge has half-width <= tolerance * value,
// as far as it is sampled. A plane without requirements has nothing to decide; for either goal it
// is finished once its maintained average and minimum, with every luminaire at full output, are
// accurate. What does not exist (the uniformity of a dark plane, a point outside the grid) gains
// nothing from more work.
//
// Points that no unfinished quantity hangs on are left out of further looks and keep their
// replicates. That spoils no limit of a single point: it was as good at the look after which the
// point was left out, which the level of a look allows for. Judged at the level of one look, see
// look_confidence() and PlaneField::looks_planned. Other arguments as for judge_plane().
LookJudgement judge_look(const StopRule& rule, const std::vector<Requirement>& requirements,
                         const calc::SensorGrid& grid, const calc::PlaneField& field,
                         const std::vector<calc::LightScene>& scenes);

}  // namespace rules
