#include "report/formats/folded_passes.h"

#include "report/text/words.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace report {
namespace {

bool is_plain_pass(const rules::Finding& finding) {
  return finding.verdict == rules::Verdict::pass && !finding.is_close && !finding.by_tolerance &&
         !finding.requirement.waiver && finding.requirement.deviations.empty() &&
         finding.reason.empty() && !finding.requirement.origin.workplaces.empty();
}

bool can_be_folded(const PlanePart& plane) {
  return !plane.made_by.empty() && plane.changed.empty() && !plane.findings.empty() &&
         doubt_words({}, plane).empty() &&
         std::all_of(plane.findings.begin(), plane.findings.end(), is_plain_pass);
}

// The workplace that all of the plane's requirements are of; "" if there are several.
std::string only_workplace(const PlanePart& plane) {
  std::string only;
  for (const rules::Finding& finding : plane.findings) {
    for (const std::string& workplace : finding.requirement.origin.workplaces) {
      if (!only.empty() && workplace != only) return {};
      only = workplace;
    }
  }
  return only;
}

// Advice after everything that counts.
bool is_nearer(const rules::Finding& a, const rules::Finding& b) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const bool is_advice = a.requirement.severity == rules::Severity::advice;
  const bool is_other_advice = b.requirement.severity == rules::Severity::advice;
  return is_advice != is_other_advice ? is_other_advice
                                      : rules::margin_or(a, kFar) < rules::margin_or(b, kFar);
}

std::pair<const PlanePart*, const rules::Finding*> nearest_of(const FoldedPasses& folded) {
  std::pair<const PlanePart*, const rules::Finding*> nearest{nullptr, nullptr};
  for (const PlanePart* plane : folded.planes) {
    for (const rules::Finding& finding : plane->findings) {
      if (nearest.second == nullptr || is_nearer(finding, *nearest.second)) {
        nearest = {plane, &finding};
      }
    }
  }
  return nearest;
}

}  // namespace

std::size_t FoldedPasses::requirements() const {
  std::size_t count = 0;
  for (const PlanePart* plane : planes) {
    for (const rules::Finding& finding : plane->findings) {
      if (finding.requirement.severity != rules::Severity::advice) ++count;
    }
  }
  return count;
}

const rules::Finding& FoldedPasses::nearest() const { return *nearest_of(*this).second; }
const PlanePart& FoldedPasses::plane_of_nearest() const { return *nearest_of(*this).first; }

std::vector<FoldedPasses> folded_passes(const SpacePart& space) {
  std::vector<FoldedPasses> all;
  std::map<std::string, std::size_t> place_of;  // by workplace
  for (const PlanePart& plane : space.planes) {
    if (!can_be_folded(plane)) continue;
    const std::string workplace = only_workplace(plane);
    const auto [place, is_new] = place_of.try_emplace(workplace, all.size());
    if (is_new) all.push_back({{}, workplace.empty()});
    all[place->second].planes.push_back(&plane);
  }
  std::erase_if(all, [](const FoldedPasses& folded) {
    return folded.planes.size() < 2 || folded.requirements() == 0;
  });
  return all;
}

}  // namespace report
