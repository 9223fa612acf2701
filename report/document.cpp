#include "report/document.h"

#include <cmath>
#include <limits>

namespace report {
namespace {

void count(rules::Verdict verdict, VerdictCounts& counts) {
  switch (verdict) {
    case rules::Verdict::pass:
      ++counts.pass;
      return;
    case rules::Verdict::fail:
      ++counts.fail;
      return;
    case rules::Verdict::undecided:
      ++counts.undecided;
      return;
    case rules::Verdict::not_judged:
      ++counts.not_judged;
      return;
  }
}

}  // namespace

calc::Estimate no_estimate() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {kNone, kNone, kNone};
}

calc::Estimate settled(const calc::Estimate& estimate) {
  if (!std::isfinite(estimate.value)) return no_estimate();
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  return {estimate.value, std::isfinite(estimate.low) ? estimate.low : -kOpen,
          std::isfinite(estimate.high) ? estimate.high : kOpen};
}

void settle_estimates(PlanePart& plane) {
  const auto settle = [](calc::Estimate& estimate) { estimate = settled(estimate); };
  for (calc::Estimate* estimate : {&plane.average_lx, &plane.minimum_lx, &plane.maximum_lx,
                                   &plane.uniformity_min_avg, &plane.uniformity_min_max}) {
    settle(*estimate);
  }
  for (PointRow& point : plane.points) settle(point.maintained_lx);
  for (GroupShare& share : plane.groups) settle(share.average_lx);
  for (rules::Finding& finding : plane.findings) {
    if (finding.verdict == rules::Verdict::not_judged) continue;
    settle(finding.measured);
    if (!std::isfinite(finding.margin)) finding.margin = no_estimate().value;
  }
  for (PlaneLook& look : plane.looks) {
    settle(look.average_lx);
    for (LookFinding& finding : look.findings) {
      if (finding.verdict != rules::Verdict::not_judged) settle(finding.measured);
    }
  }
}

VerdictCounts count_verdicts(const ProjectPart& project) {
  VerdictCounts counts;
  if (!project.is_judged) count(rules::Verdict::not_judged, counts);
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        if (finding.requirement.severity != rules::Severity::shall) continue;
        if (finding.is_waived) {
          ++counts.waived;
        } else {
          count(finding.verdict, counts);
        }
      }
    }
  }
  for (const rules::AggregateFinding& finding : project.aggregates) {
    if (finding.severity != rules::Severity::shall) continue;
    if (finding.is_waived) {
      ++counts.waived;
    } else {
      count(finding.verdict, counts);
    }
  }
  return counts;
}

VerdictCounts count_verdicts(const Document& document) {
  VerdictCounts sum;
  for (const ProjectPart& project : document.projects) {
    const VerdictCounts counts = count_verdicts(project);
    sum.pass += counts.pass;
    sum.fail += counts.fail;
    sum.undecided += counts.undecided;
    sum.not_judged += counts.not_judged;
    sum.waived += counts.waived;
  }
  return sum;
}

bool has_uncomputed_plane(const Document& document) {
  for (const ProjectPart& project : document.projects) {
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        if (!plane.is_computed) return true;
      }
    }
  }
  return false;
}

}  // namespace report
