#pragma once
// The advice for a light scene: plain data.

#include "calc/base/message.h"
#include "report/advice/findings.h"
#include "report/document/level_advice.h"
#include "rules/catalogue/finding.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

using report::AdviceOutcome;
using report::AdvisedGroup;
using report::CostUnit;
using report::kMostAdvisedLight;

struct AdvisedRequirement {
  FindingPlace where;
  std::string space, plane;  // as reports title them
  rules::Finding before, after;
  // Why it is no condition on the sum of groups: the search did not use it, but it was checked. ""
  // = the search used it.
  calc::Message not_searched;
};

// A limit that determines the least cost.
struct AdvisedLimit {
  std::size_t requirement = 0;    // of SceneAdvice::requirements
  double cost_per_percent = 0.0;  // how much a limit would save that is looser by one percent
  // The place and the sources of the light there: the worst point, or empty: the average of the
  // plane.
  std::optional<glm::dvec3> place_m;
  std::vector<double> lx;  // each group with its level, last the light that no level changes
};

struct SceneAdvice {
  std::string scene;  // "" = full output
  AdviceOutcome outcome = AdviceOutcome::none_found;
  calc::Message reason;  // of none_found, in words
  CostUnit unit = CostUnit::watt;
  // Costs: at the current levels, at the advised levels, and a lower bound for all levels.
  double now = 0.0, advised = 0.0, least = 0.0;
  std::vector<AdvisedGroup> groups;
  // Groups of rooms without requirements in this scene: they stay unchanged, and are in no sum.
  std::vector<std::string> left_alone;
  // All requirements that count in this scene; `after` is from the check of the changed project,
  // for more_light from the same light. Without levels `after` has no meaning.
  std::vector<AdvisedRequirement> requirements;
  std::vector<std::size_t> contradicting;  // of them: without any one of these there are levels
  // Indices of requirements that the search did not use and that would not be met at the least
  // power, so that the levels are higher.
  std::vector<std::size_t> raised_for;
  // For the least levels of any size, dearest first; empty if the levels are not the least ones.
  std::vector<AdvisedLimit> limits;
  // Aggregates, classes and sums of rule packs that count and do not pass in the changed project:
  // "LEED v4.1 ... (fail)".
  std::vector<std::string> aggregates_not_met;

  bool has_levels() const {
    return outcome == AdviceOutcome::levels || outcome == AdviceOutcome::more_light;
  }
  // Returns whether every requirement of the scene is met, and the aggregates of rule packs, too.
  bool is_all_met() const {
    if (!aggregates_not_met.empty()) return false;
    for (const AdvisedRequirement& one : requirements) {
      if (one.after.verdict != rules::Verdict::pass) return false;
    }
    return true;
  }
};

}  // namespace cli
