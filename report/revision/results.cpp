#include "report/revision/results.h"

#include "report/document/document.h"
#include "report/text/words.h"
#include "rules/measure/leave_one_out.h"

#include <cmath>
#include <string>

namespace report {
namespace {

using rules::Verdict;

bool is_decided(Verdict verdict) { return verdict == Verdict::pass || verdict == Verdict::fail; }

// How something was judged; none: it was not asked.
struct Judged {
  std::optional<Verdict> verdict;
  bool is_waived = false;

  bool fails() const { return verdict == Verdict::fail && !is_waived; }
};

// By verdicts alone; empty: they leave it open. A failure that is waived does not count: one that
// no longer is, is as one that was none.
std::optional<ResultChange> change_of_verdicts(const Judged& before, const Judged& after) {
  if (!after.verdict) return ResultChange::gone;
  if (!before.verdict) return after.fails() ? ResultChange::new_failing : ResultChange::added;
  const Verdict was = *before.verdict, is = *after.verdict;
  if (after.fails() && !before.fails()) return ResultChange::broken;
  if (is == Verdict::fail && was != Verdict::fail) return ResultChange::broken;
  if (is == Verdict::pass && (was == Verdict::fail || was == Verdict::not_judged)) {
    return ResultChange::fixed;
  }
  if (is_decided(was) && !is_decided(is)) return ResultChange::unsure;
  if (was == Verdict::undecided && is == Verdict::not_judged) return ResultChange::unsure;
  return std::nullopt;
}

Judged judged_before(const ChangedResult& result) {
  return {result.verdict_before, result.is_waived_before};
}
Judged judged_after(const ChangedResult& result) {
  return {result.verdict_after, result.is_waived_after};
}

// What sums in another order may differ by is no difference.
constexpr double kRounding = 1e-9;

calc::Estimate beyond_rounding(const calc::Estimate& difference, double of) {
  const double rounding = kRounding * std::abs(of);
  return {difference.value, difference.low - rounding, difference.high + rounding};
}

bool is_known(const calc::Estimate& estimate) { return !std::isnan(estimate.value); }

// (after - before) / |before|, turned so that more is better.
calc::Estimate gain_of(const calc::Estimate& before, const calc::Estimate& difference,
                       rules::Comparison comparison) {
  const double scale = std::abs(before.value);
  if (!is_known(difference) || !(scale > 0.0) || !std::isfinite(scale)) return no_estimate();
  if (rules::is_lower_limit(comparison)) {
    return {difference.value / scale, difference.low / scale, difference.high / scale};
  }
  return {-difference.value / scale, -difference.high / scale, -difference.low / scale};
}

// By the difference, turned so that more is better; of 0 before only the sign is known.
ResultChange change_of_values(const ChangedResult& result, rules::Comparison comparison) {
  const calc::Estimate& difference = result.difference;
  if (calc::is_nothing(result.before) != calc::is_nothing(result.after)) {
    const bool is_more = calc::is_nothing(result.before);
    return is_more == rules::is_lower_limit(comparison) ? ResultChange::better
                                                        : ResultChange::worse;
  }
  if (!is_known(difference)) return ResultChange::unsure;
  const bool is_lower = rules::is_lower_limit(comparison);
  if (difference.high < 0.0) return is_lower ? ResultChange::worse : ResultChange::better;
  if (difference.low > 0.0) return is_lower ? ResultChange::better : ResultChange::worse;
  return ResultChange::same;
}

// Whether the two numbers are of one quantity in one light.
bool is_comparable(const rules::Requirement& before, const rules::Requirement& after) {
  return before.metric == after.metric && before.derived == after.derived &&
         rules::argument_of<rules::Percentile>(before) ==
             rules::argument_of<rules::Percentile>(after) &&
         before.direct_only == after.direct_only &&
         rules::is_lower_limit(before.comparison) == rules::is_lower_limit(after.comparison);
}

// A doubtful value may rest on a sample that only one of the two has drawn.
bool can_be_paired(const rules::Finding& before, const rules::Finding& after) {
  return before.without_replicate.size() >= 2 &&
         before.without_replicate.size() == after.without_replicate.size() && !before.is_doubtful &&
         !after.is_doubtful;
}

calc::Estimate measured_of(const rules::Finding* finding) {
  const bool is_there = finding != nullptr && finding->verdict != Verdict::not_judged;
  return is_there ? finding->measured : no_estimate();
}

}  // namespace

calc::Estimate difference_of(const calc::Estimate& before, const calc::Estimate& after) {
  if (calc::is_nothing(before) && calc::is_nothing(after)) return {0.0, 0.0, 0.0};
  const double value = after.value - before.value;
  if (!std::isfinite(value)) return no_estimate();
  const auto both = [](double a, double b) { return std::sqrt(a * a + b * b); };
  const double down = both(after.value - after.low, before.high - before.value);
  const double up = both(after.high - after.value, before.value - before.low);
  return {value, value - down, value + up};
}

ChangedResult compare_results(const rules::Finding* before, const rules::Finding* after,
                              double confidence, const RevisionPlace& place) {
  const rules::Finding& any = after != nullptr ? *after : *before;
  ChangedResult result;
  result.place = place;
  result.metric = any.requirement.metric;
  result.quantity = quantity_words(any.requirement) + scene_words({}, any.requirement);
  result.unit = rules::unit_of(any.requirement);
  result.counts = any.requirement.severity == rules::Severity::shall;
  if (before != nullptr) result.verdict_before = before->verdict;
  if (after != nullptr) result.verdict_after = after->verdict;
  result.is_waived_before = before != nullptr && before->is_waived;
  result.is_waived_after = after != nullptr && after->is_waived;
  result.before = measured_of(before);
  result.after = measured_of(after);
  result.difference = result.gain = no_estimate();
  const bool is_pair = before != nullptr && after != nullptr &&
                       is_comparable(before->requirement, after->requirement);
  if (is_pair && is_known(result.before) && is_known(result.after)) {
    result.is_paired = can_be_paired(*before, *after);
    result.difference = result.is_paired ? rules::paired_difference(
                                               before->without_replicate, after->without_replicate,
                                               result.after.value - result.before.value, confidence)
                                         : difference_of(result.before, result.after);
    result.difference = beyond_rounding(result.difference, result.before.value);
    result.gain = gain_of(result.before, result.difference, after->requirement.comparison);
  }
  if (const auto change = change_of_verdicts(judged_before(result), judged_after(result))) {
    result.change = *change;
  } else if (*result.verdict_after == Verdict::not_judged) {
    result.change = ResultChange::same;  // as it was
  } else {
    result.change = change_of_values(result, after->requirement.comparison);
  }
  return result;
}

ChangedResult compare_results(const rules::AggregateFinding* before,
                              const rules::AggregateFinding* after, const RevisionPlace& place) {
  const rules::AggregateFinding& any = after != nullptr ? *after : *before;
  if (any.sum && any.kind == rules::AggregateKind::building) {
    // Nothing of it is sampled, so that no level of confidence is in it.
    const auto sum_of = [](const rules::AggregateFinding* finding) {
      return finding == nullptr || !finding->sum ? nullptr : &*finding->sum;
    };
    ChangedResult of_sum = compare_results(sum_of(before), sum_of(after), 0.95, place);
    of_sum.is_aggregate = true;
    return of_sum;
  }
  ChangedResult result;
  result.place = place;
  result.is_aggregate = true;
  result.quantity = std::string(calc::name_of(any.kind));
  result.counts = any.severity == rules::Severity::shall;
  result.before = result.after = result.difference = result.gain = no_estimate();
  if (before != nullptr) result.verdict_before = before->verdict;
  if (after != nullptr) result.verdict_after = after->verdict;
  result.is_waived_before = before != nullptr && before->is_waived;
  result.is_waived_after = after != nullptr && after->is_waived;
  result.change =
      change_of_verdicts(judged_before(result), judged_after(result)).value_or(ResultChange::same);
  return result;
}

}  // namespace report
