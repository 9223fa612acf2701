#include "report/words.h"

#include "calc/units.h"
#include "report/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

constexpr double kStraight = 1e-6;  // of a direction cosine

std::string plural(int count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// "share of points from 300 to 500 lx"
std::string range_words(const rules::ValueRange& range, calc::DerivedQuantity derived) {
  std::string words = "share of points";
  if (range.from > 0.0) words += " from " + format_shortest(range.from);
  if (std::isfinite(range.to)) words += " to " + format_shortest(range.to);
  return words + (calc::is_plain_number(derived) ? "" : " lx");
}

}  // namespace

const char* verdict_symbol(rules::Verdict verdict) {
  switch (verdict) {
    case rules::Verdict::pass:
      return "✓";
    case rules::Verdict::fail:
      return "✗";
    case rules::Verdict::undecided:
      return "?";
    case rules::Verdict::not_judged:
      break;
  }
  return "–";
}

const char* verdict_key(rules::Verdict verdict) {
  return verdict == rules::Verdict::not_judged ? "not-judged" : rules::verdict_name(verdict);
}

const char* kernel_words(calc::ReceiverKernel kernel) {
  switch (kernel) {
    case calc::ReceiverKernel::planar:
      break;
    case calc::ReceiverKernel::cylindrical:
      return "cylindrical illuminance Ez";
    case calc::ReceiverKernel::semicylindrical:
      return "semicylindrical illuminance Esz";
    case calc::ReceiverKernel::hemispherical:
      return "hemispherical illuminance Ehs";
    case calc::ReceiverKernel::scalar:
      return "scalar illuminance Es";
  }
  return "illuminance";
}

const char* plane_words(calc::ReceiverKernel kernel, calc::DerivedQuantity derived) {
  switch (derived) {
    case calc::DerivedQuantity::none:
      break;
    case calc::DerivedQuantity::ugr:
      return "glare rating UGR";
    case calc::DerivedQuantity::modelling:
      return "modelling Ez/E";
    case calc::DerivedQuantity::four_planes:
      return "cylindrical illuminance Ez of four planes";
  }
  return kernel_words(kernel);
}

const char* state_words(const PlanePart& plane) {
  return plane.derived == calc::DerivedQuantity::ugr ? "Initial" : "Maintained";
}

const char* value_key(const PlanePart& plane) {
  if (plane.derived == calc::DerivedQuantity::ugr) return "ugr";
  return plane.derived == calc::DerivedQuantity::modelling ? "modelling" : "illuminance_lx";
}

std::string quantity_words(const rules::Requirement& requirement) {
  switch (requirement.metric) {
    case rules::Metric::average:
      return "average";
    case rules::Metric::minimum:
      return "minimum";
    case rules::Metric::maximum:
      return "maximum";
    case rules::Metric::uniformity_min_avg:
      return "Uo (min/avg)";
    case rules::Metric::uniformity_min_max:
      return "Ud (min/max)";
    case rules::Metric::percentile:
      return format_shortest(requirement.percent) + " % percentile";
    case rules::Metric::share:
      return range_words(requirement.range, requirement.derived);
    case rules::Metric::power_density:
      return "installed power by floor area";
    case rules::Metric::power_per_100_lx:
      return "installed power by floor area and 100 lx";
    case rules::Metric::leni:
      return "LENI, energy for light by floor area and year";
    case rules::Metric::value_at_point:
      break;
  }
  return requirement.point_m ? "value at " + format_position(*requirement.point_m)
                             : "value at a point";
}

std::string quantity_words(const rules::Requirement& requirement, calc::ReceiverKernel kernel) {
  const std::string words = quantity_words(requirement);
  if (rules::is_of_space(requirement.metric)) return words;
  if (kernel == calc::ReceiverKernel::planar &&
      requirement.derived == calc::DerivedQuantity::none) {
    return words;
  }
  return words + " of " + plane_words(kernel, requirement.derived);
}

const char* comparison_key(rules::Comparison comparison) {
  switch (comparison) {
    case rules::Comparison::at_least:
      return "at_least";
    case rules::Comparison::at_most:
      return "at_most";
    case rules::Comparison::more_than:
      return "more_than";
    case rules::Comparison::less_than:
      return "less_than";
  }
  return "";
}

const char* comparison_sign(rules::Comparison comparison) {
  switch (comparison) {
    case rules::Comparison::at_least:
      return "≥";
    case rules::Comparison::at_most:
      return "≤";
    case rules::Comparison::more_than:
      return ">";
    case rules::Comparison::less_than:
      return "<";
  }
  return "";
}

const char* severity_key(rules::Severity severity) {
  return severity == rules::Severity::shall ? "shall" : "advice";
}

std::string note_words(const rules::Finding& finding) {
  std::string words;
  const auto add = [&words](const std::string& text) {
    if (!text.empty()) words += (words.empty() ? "" : "; ") + text;
  };
  const rules::Requirement& requirement = finding.requirement;
  add(requirement.note);
  if (requirement.severity == rules::Severity::advice) add("advice: does not count");
  if (requirement.direct_only) add("direct light only");
  if (!requirement.mask.id.empty()) {
    add(finding.points_used == 0
            ? "mask " + requirement.mask.id
            : fmt::format("mask {}: {} points count", requirement.mask.id, finding.points_used));
  }
  if (!requirement.policy.is_default()) add(rules::policy_text(requirement.policy));
  if (finding.by_tolerance) add("passes only with the tolerance");
  return words;
}

std::string_view title_of(std::string_view name, std::string_view id) {
  return name.empty() ? id : name;
}

const char* stop_key(calc::StopReason stop) {
  switch (stop) {
    case calc::StopReason::exact:
      return "exact";
    case calc::StopReason::decided:
      return "decided";
    case calc::StopReason::accurate:
      return "accurate";
    case calc::StopReason::path_limit:
      return "path-limit";
    case calc::StopReason::time_limit:
      return "time-limit";
    case calc::StopReason::memory_limit:
      return "memory-limit";
    case calc::StopReason::endless_path:
      return "endless-path";
    case calc::StopReason::interrupted:
      break;
  }
  return "interrupted";
}

const char* stop_words(calc::StopReason stop) {
  switch (stop) {
    case calc::StopReason::exact:
      return "exact, nothing had to be sampled";
    case calc::StopReason::decided:
      return "stopped when every verdict was decided";
    case calc::StopReason::accurate:
      return "stopped when the intervals were narrow enough";
    case calc::StopReason::path_limit:
      return "stopped at the path limit, before the goal was reached";
    case calc::StopReason::time_limit:
      return "stopped at the time limit, before the goal was reached";
    case calc::StopReason::memory_limit:
      return "stopped where more light vertices would not fit into memory, before the intervals "
             "were narrow enough";
    case calc::StopReason::endless_path:
      return "stopped at a light path that would not end, before the intervals were narrow enough";
    case calc::StopReason::interrupted:
      break;
  }
  return "interrupted, before the goal was reached";
}

const char* drop_key(calc::DropReason reason) {
  switch (reason) {
    case calc::DropReason::outside_area:
      return "outside-area";
    case calc::DropReason::within_margin:
      return "within-margin";
    case calc::DropReason::outside_room:
      return "outside-room";
    case calc::DropReason::inside_solid:
      break;
  }
  return "inside-solid";
}

const char* drop_words(calc::DropReason reason) {
  switch (reason) {
    case calc::DropReason::outside_area:
      return "outside the area";
    case calc::DropReason::within_margin:
      return "in the margin";
    case calc::DropReason::outside_room:
      return "outside the room";
    case calc::DropReason::inside_solid:
      break;
  }
  return "inside a solid";
}

std::string summary_words(const Document& document) {
  VerdictCounts counts = count_verdicts(document);
  const auto not_judged_projects = static_cast<int>(
      std::count_if(document.projects.begin(), document.projects.end(),
                    [](const ProjectPart& project) { return !project.is_judged; }));
  counts.not_judged -= not_judged_projects;
  const int total =
      counts.pass + counts.fail + counts.undecided + counts.not_judged + counts.waived;
  std::string text = plural(total, "requirement");
  const char* separator = ": ";
  const auto add = [&](int count, const char* word) {
    if (count == 0) return;
    text += fmt::format("{}{} {}", separator, count, word);
    separator = ", ";
  };
  add(counts.pass, "pass");
  add(counts.fail, "fail");
  add(counts.undecided, "undecided");
  add(counts.not_judged, "not judged");
  add(counts.waived, "waived");
  if (not_judged_projects > 0)
    text += "; " + plural(not_judged_projects, "project") + " not judged";
  return text;
}

rules::Verdict overall_verdict(const Document& document) {
  const VerdictCounts counts = count_verdicts(document);
  if (counts.not_judged > 0 || has_uncomputed_plane(document)) return rules::Verdict::not_judged;
  if (counts.fail > 0) return rules::Verdict::fail;
  if (counts.undecided > 0) return rules::Verdict::undecided;
  return counts.pass + counts.waived > 0 ? rules::Verdict::pass : rules::Verdict::not_judged;
}

std::string close_words(const rules::Finding& finding) {
  if (!finding.is_close) return {};
  return finding.requirement.policy.compares_rounded
             ? "close: without rounding the verdict would be another"
             : "close: usual rounding would change the verdict";
}

const char* outcome_words(const Document& document) {
  const rules::Verdict overall = overall_verdict(document);
  const bool is_met = overall == rules::Verdict::pass && count_verdicts(document).pass > 0;
  return overall == rules::Verdict::pass && !is_met ? "waived" : rules::verdict_name(overall);
}

std::string looks_words(const PlanePart& plane) {
  const std::size_t taken = plane.counters.active_points.size();
  return taken == 0 ? "" : fmt::format("{} of {} planned", taken, plane.looks_planned);
}

std::string doubt_words(const PlanePart& plane) {
  std::string text;
  const auto add = [&](std::size_t count, const char* words) {
    if (count == 0) return;
    text += fmt::format("{}{} of {} points {}", text.empty() ? "" : "; ", count,
                        plane.points.size(), words);
  };
  add(plane.unseen_points, "got no sample of the light that may reach them");
  add(plane.single_sample_points, "rest on single samples: their intervals cannot be trusted");
  return text;
}

bool is_horizontal(const glm::dvec3& normal) { return std::abs(normal.z) > 1.0 - kStraight; }

std::string orientation_words(const glm::dvec3& normal) {
  if (is_horizontal(normal))
    return normal.z > 0 ? "horizontal, facing up" : "horizontal, facing down";
  if (std::abs(normal.z) < kStraight) {
    return fmt::format("vertical, facing ({}, {})", format_fixed(normal.x, 2),
                       format_fixed(normal.y, 2));
  }
  const double tilt_deg = calc::degrees_from_radians(std::acos(std::clamp(normal.z, -1.0, 1.0)));
  return fmt::format("inclined by {}° from horizontal", format_fixed(tilt_deg, 1));
}

}  // namespace report
