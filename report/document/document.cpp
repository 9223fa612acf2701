#include "report/document/document.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/one_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace report {
namespace {

void count(rules::Outcome outcome, VerdictCounts& counts) {
  switch (outcome) {
    case rules::Outcome::not_judged:
      ++counts.not_judged;
      return;
    case rules::Outcome::fail:
      ++counts.fail;
      return;
    case rules::Outcome::undecided:
      ++counts.undecided;
      return;
    case rules::Outcome::pass:
      ++counts.pass;
      return;
    case rules::Outcome::waived:
      ++counts.waived;
      return;
    case rules::Outcome::warned:  // of no requirement
    case rules::Outcome::nothing_asked:
      return;
  }
}

void add(const VerdictCounts& counts, VerdictCounts& sum) {
  sum.pass += counts.pass;
  sum.fail += counts.fail;
  sum.undecided += counts.undecided;
  sum.not_judged += counts.not_judged;
  sum.waived += counts.waived;
  sum.deviating += counts.deviating;
}

bool is_judged_with_deviations(const rules::Finding& finding) {
  return finding.verdict != rules::Verdict::not_judged && !finding.requirement.deviations.empty();
}

rules::Outcome outcome_of(const PlanePart& plane) {
  if (!plane.is_computed) return rules::Outcome::not_judged;
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  for (const rules::Finding& finding : plane.findings) {
    outcome = graver(outcome, outcome_of(finding));
  }
  return outcome;
}

// It has a waiver or a stated deviation.
bool does_hang_on_the_day(const ProjectPart& project) {
  const auto is_stated = [](const rules::Deviation& deviation) {
    return deviation.stated.has_value();
  };
  const auto is_one = [&](const rules::Finding& finding) {
    const auto& deviations = finding.requirement.deviations;
    return finding.requirement.waiver ||
           std::any_of(deviations.begin(), deviations.end(), is_stated);
  };
  const auto leaves_out = [](const rules::RowCoverage& row) {
    return std::any_of(row.roles.begin(), row.roles.end(),
                       [](const auto& role) { return !role.left_out.empty(); });
  };
  for (const SpacePart& space : project.spaces) {
    if (std::any_of(space.coverage.begin(), space.coverage.end(), leaves_out)) return true;
    for (const PlanePart& plane : space.planes) {
      if (std::any_of(plane.findings.begin(), plane.findings.end(), is_one)) return true;
    }
  }
  return std::any_of(
      project.aggregates.begin(), project.aggregates.end(),
      [&](const rules::AggregateFinding& finding) { return finding.sum && is_one(*finding.sum); });
}

// A run that was cut short depends on how fast the machine was.
bool was_cut_short(const ProjectPart& project) {
  const auto is_cut = [](const PlanePart& plane) {
    return plane.stop == calc::StopReason::time_limit ||
           plane.stop == calc::StopReason::interrupted;
  };
  return std::any_of(project.spaces.begin(), project.spaces.end(), [&](const SpacePart& space) {
    return std::any_of(space.planes.begin(), space.planes.end(), is_cut);
  });
}

}  // namespace

calc::Estimate no_estimate() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {kNone, kNone, kNone};
}

calc::Estimate settled(const calc::Estimate& estimate) {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  if (calc::is_nothing(estimate)) {
    return {-kOpen, -kOpen, std::isfinite(estimate.high) ? estimate.high : -kOpen};
  }
  if (!std::isfinite(estimate.value)) return no_estimate();
  return {estimate.value, std::isfinite(estimate.low) ? estimate.low : -kOpen,
          std::isfinite(estimate.high) ? estimate.high : kOpen};
}

void settle_estimates(PlanePart& plane) {
  const auto settle = [](calc::Estimate& estimate) { estimate = settled(estimate); };
  for (calc::Estimate* estimate : {&plane.average, &plane.minimum, &plane.maximum,
                                   &plane.uniformity_min_avg, &plane.uniformity_min_max}) {
    settle(*estimate);
  }
  for (PointRow& point : plane.points) settle(point.measured);
  if (plane.asked_light) {
    AskedLight& light = *plane.asked_light;
    for (calc::Estimate* estimate : {&light.average, &light.minimum, &light.maximum,
                                     &light.uniformity_min_avg, &light.uniformity_min_max}) {
      settle(*estimate);
    }
    for (AskedPoint& point : light.points) settle(point.measured);
  }
  for (GroupShare& share : plane.groups) settle(share.average_lx);
  for (rules::Finding& finding : plane.findings) {
    if (finding.verdict == rules::Verdict::not_judged) continue;
    settle(finding.measured);
    if (!std::isfinite(finding.margin)) finding.margin = no_estimate().value;
  }
  for (PlaneLook& look : plane.looks) {
    settle(look.average);
    for (LookFinding& finding : look.findings) {
      if (finding.verdict != rules::Verdict::not_judged) settle(finding.measured);
    }
  }
}

int VerdictCounts::of(rules::Verdict verdict) const {
  switch (verdict) {
    case rules::Verdict::pass:
      return pass;
    case rules::Verdict::fail:
      return fail;
    case rules::Verdict::undecided:
      return undecided;
    case rules::Verdict::not_judged:
      break;
  }
  return not_judged;
}

VerdictCounts count_verdicts(const SpacePart& space) {
  VerdictCounts counts;
  for (const PlanePart& plane : space.planes) {
    for (const rules::Finding& finding : plane.findings) {
      count(outcome_of(finding), counts);
      if (is_judged_with_deviations(finding)) ++counts.deviating;
    }
  }
  return counts;
}

VerdictCounts count_verdicts(const ProjectPart& project) {
  VerdictCounts counts;
  if (!project.is_judged) count(rules::Outcome::not_judged, counts);
  for (const SpacePart& space : project.spaces) add(count_verdicts(space), counts);
  for (const rules::AggregateFinding& finding : project.aggregates) {
    count(outcome_of(finding), counts);
  }
  return counts;
}

bool hangs_on_the_day(const Document& document) { return totals_of(document).hangs_on_the_day; }

double level_of(const SceneRow& scene, const std::string& group) {
  for (const auto& [name, level] : scene.level_of_group)
    if (name == group) return level;
  return 1.0;
}

VerdictCounts count_verdicts(const Document& document) { return totals_of(document).verdicts; }

bool is_warning(const calc::Diagnostic& diagnostic) {
  return diagnostic.severity() == calc::Severity::warning;
}

bool is_strict_warning(const ProjectPart& project, const calc::Diagnostic& diagnostic) {
  const std::vector<calc::DiagnosticId>& ids = project.strict_warnings;
  return is_warning(diagnostic) && std::find(ids.begin(), ids.end(), diagnostic.id) != ids.end();
}

WarningCounts count_warnings(const ProjectPart& project) {
  WarningCounts counts;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    counts.all += is_warning(diagnostic) ? 1 : 0;
    counts.strict += is_strict_warning(project, diagnostic) ? 1 : 0;
  }
  return counts;
}

WarningCounts count_warnings(const Document& document) { return totals_of(document).warnings; }

rules::Outcome outcome_of(const ProjectPart& project) {
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  if (count_warnings(project).strict > 0) outcome = rules::Outcome::warned;
  if (!project.is_judged) outcome = graver(outcome, rules::Outcome::not_judged);
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) outcome = graver(outcome, outcome_of(plane));
  }
  for (const rules::AggregateFinding& finding : project.aggregates) {
    outcome = graver(outcome, outcome_of(finding));
  }
  return outcome;
}

rules::Outcome outcome_of(const Document& document) { return totals_of(document).outcome; }

bool is_nothing_chosen(const ProjectPart& project) {
  const auto says_so = [](const calc::Diagnostic& diagnostic) {
    return diagnostic.id == calc::DiagnosticId::nothing_selected;
  };
  return project.is_judged &&
         std::any_of(project.diagnostics.begin(), project.diagnostics.end(), says_so);
}

void Totals::add(const ProjectPart& project) {
  ++projects;
  projects_not_judged += project.is_judged ? 0 : 1;
  projects_unchosen += is_nothing_chosen(project) ? 1 : 0;
  report::add(count_verdicts(project), verdicts);
  const WarningCounts counts = count_warnings(project);
  warnings.all += counts.all;
  warnings.strict += counts.strict;
  for (const SpacePart& space : project.spaces) {
    for (const rules::RowCoverage& row : space.coverage) rows_in_part += row.asks_all() ? 0 : 1;
  }
  gravest = graver(gravest, outcome_of(project));
  outcome = is_selection_empty() ? rules::Outcome::not_judged : gravest;
  hangs_on_the_day = hangs_on_the_day || does_hang_on_the_day(project);
  is_cut_short = is_cut_short || was_cut_short(project);
  add_one_source_rows(project, one_source_rows);
}

Totals totals_of(const Document& document) {
  Totals totals;
  for (const ProjectPart& project : document.projects) totals.add(project);
  return totals;
}

DocumentFrame frame_of(const Document& document) {
  DocumentFrame frame;
  frame.provenance = document.provenance;
  for (const ProjectPart& project : document.projects) frame.paths.push_back(project.path);
  if (document.revision) frame.revised = &document;
  return frame;
}

DocumentEnd end_of(const Document& document) {
  DocumentEnd end{document.provenance, totals_of(document)};
  const std::optional<Revision>& revision = document.revision;
  if (revision && revision->is_of_itself && revision->gate.mode == GateMode::regression) {
    end.own_revision = revision->baseline;
  }
  return end;
}

std::vector<calc::Diagnostic> document_errors(const DocumentEnd& end) {
  calc::Diagnostics errors;
  if (end.totals.is_selection_empty()) {
    errors.report(calc::DiagnosticId::selection_empty, {}, end.provenance.selection);
  }
  if (!end.own_revision.empty()) {
    errors.report(calc::DiagnosticId::revision_is_head, {}, end.own_revision);
  }
  return errors.all();
}

}  // namespace report
