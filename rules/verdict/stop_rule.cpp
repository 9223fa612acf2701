#include "rules/verdict/stop_rule.h"

#include "rules/measure/error_spending.h"
#include "rules/measure/measure.h"
#include "rules/verdict/judge.h"

#include <algorithm>
#include <utility>

namespace rules {
namespace {

// Returns the default quantities; ratings and ratios of points have no average.
std::vector<Requirement> default_quantities(calc::DerivedQuantity derived) {
  Requirement first;
  first.metric = calc::is_plain_number(derived) ? Metric::maximum : Metric::average;
  Requirement minimum;
  minimum.metric = Metric::minimum;
  return {first, minimum};
}

bool is_accurate(const Measurement& measurement, double tolerance) {
  if (measurement.has_doubtful_points()) return false;
  if (!measurement.metric || !measurement.nothing_there.empty()) return true;
  if (measurement.by_samples && !calc::is_finite(*measurement.by_samples)) {
    return true;  // nothing but what is not sampled
  }
  const calc::Estimate estimate = measurement.by_samples.value_or(measurement.metric->estimate);
  return estimate.half_width() <= tolerance * estimate.value;  // 0 <= 0 for an exact darkness
}

bool is_decided(const Requirement& requirement, Measurement measurement,
                const calc::SensorGrid& grid) {
  measurement.is_cut_off = measurement.has_missing_light = false;  // no sample brings it back
  const Finding finding = judge_measurement(requirement, measurement, grid);
  // The first sample that arrives makes a uniformity defined.
  if (finding.verdict == Verdict::not_judged && measurement.unseen_points > 0) return false;
  return finding.verdict != Verdict::undecided ||
         (measurement.is_open_for_good && !finding.is_doubtful);
}

// Collects the points of all unfinished quantities.
class ActivePoints {
 public:
  void add(const std::vector<std::uint8_t>& marks) {
    if (marks.empty()) wants_all_ = true;
    marks_.resize(std::max(marks_.size(), marks.size()));
    for (std::size_t i = 0; i < marks.size(); ++i) marks_[i] = marks_[i] | marks[i];
  }

  std::vector<std::uint8_t> take() {
    const auto is_marked = [](std::uint8_t mark) { return mark != 0; };
    if (wants_all_ || std::all_of(marks_.begin(), marks_.end(), is_marked) ||
        std::none_of(marks_.begin(), marks_.end(), is_marked)) {
      return {};
    }
    return std::move(marks_);
  }

 private:
  std::vector<std::uint8_t> marks_;
  bool wants_all_ = false;
};

}  // namespace

LookJudgement judge_look(const StopRule& rule, const std::vector<Requirement>& requirements,
                         const calc::SensorGrid& grid, const calc::PlaneField& field,
                         const std::vector<calc::LightScene>& scenes) {
  const Goal goal = requirements.empty() ? Goal::accuracy : rule.goal;
  const double level = look_confidence(rule.confidence, field);
  LookJudgement look;
  ActivePoints active;
  bool is_finished = true;
  const std::vector<Requirement> judged =
      requirements.empty() ? default_quantities(grid.derived) : requirements;
  for (const Requirement& requirement : judged) {
    const Measurement measurement = measure(requirement, grid, field, scenes, level, goal);
    // What matters for a limit is not what matters for the quantity itself.
    if (!requirements.empty()) {
      look.findings.push_back(judge_measurement(
          requirement,
          goal == Goal::verdict ? measurement : measure(requirement, grid, field, scenes, level),
          grid, field));
    }
    if (goal == Goal::verdict ? is_decided(requirement, measurement, grid)
                              : is_accurate(measurement, rule.tolerance)) {
      continue;
    }
    is_finished = false;
    active.add(measurement.active);
  }
  if (is_finished) {
    look.finished = goal == Goal::verdict ? calc::StopReason::decided : calc::StopReason::accurate;
  } else {
    look.active = active.take();
  }
  return look;
}

}  // namespace rules
