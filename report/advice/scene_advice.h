#pragma once
// What was found for one light scene: plain data.

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
  // Why it is no condition on the sum of groups: it took no part in the search, and was checked
  // all the same. "" = it took part.
  calc::Message not_searched;
};

// What holds the least cost up.
struct AdvisedLimit {
  std::size_t requirement = 0;    // of SceneAdvice::requirements
  double cost_per_percent = 0.0;  // how much a limit would save that is looser by one percent
  // Where, and what gives the light there: the worst point, or empty, the average of the plane.
  std::optional<glm::dvec3> place_m;
  std::vector<double> lx;  // each group with its level, last the light that no level changes
};

struct SceneAdvice {
  std::string scene;  // "" = full output
  AdviceOutcome outcome = AdviceOutcome::none_found;
  calc::Message reason;  // of none_found, in words
  CostUnit unit = CostUnit::watt;
  // With the levels now, with those advised, and what no levels undercut.
  double now = 0.0, advised = 0.0, least = 0.0;
  std::vector<AdvisedGroup> groups;
  // Groups of rooms in which nothing is asked of this scene: they stay as they are, and are in no
  // sum.
  std::vector<std::string> left_alone;
  // All that count in this scene; `after` is of the check of the changed project, of more_light
  // by the same light. Without levels `after` says nothing.
  std::vector<AdvisedRequirement> requirements;
  std::vector<std::size_t> contradicting;  // of them: without any one of these there are levels
  // Of them: what takes no part in the search and would not be met with the least power, so that
  // the levels are higher.
  std::vector<std::size_t> raised_for;
  // Of the least levels of any size, dearest first; empty where the levels are not the least ones.
  std::vector<AdvisedLimit> limits;
  // Aggregates, classes and sums of rule packs that count and do not pass in the changed project:
  // "LEED v4.1 ... (fail)".
  std::vector<std::string> aggregates_not_met;

  bool has_levels() const {
    return outcome == AdviceOutcome::levels || outcome == AdviceOutcome::more_light;
  }
  // Every requirement of the scene, and what rule packs make of all together.
  bool is_all_met() const {
    if (!aggregates_not_met.empty()) return false;
    for (const AdvisedRequirement& one : requirements) {
      if (one.after.verdict != rules::Verdict::pass) return false;
    }
    return true;
  }
};

}  // namespace cli
