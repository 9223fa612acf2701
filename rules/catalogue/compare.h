#pragma once
// The only place where a quantity meets its limit: comparison, rounding and tolerance as the policy
// says. By default unrounded numbers are compared, with no tolerance except for binary noise. A
// sampled value passes or fails only with its whole interval.

#include "calc/base/field.h"
#include "calc/base/names.h"
#include "rules/catalogue/policy.h"
#include "rules/catalogue/requirement.h"

namespace rules {

enum class Verdict { pass, fail, undecided, not_judged };

// For people: "pass", "fail", "undecided", "not judged". In data: calc::name_of().
const char* verdict_name(Verdict verdict);

// The comparison without rounding or tolerance; a miss by less than 1e-9 of the limit is binary
// noise and meets an inclusive limit, and an exclusive one is met only by more than that.
bool meets(double value, Comparison comparison, double limit);

// What is compared; its ends may be infinite. digits: after the point, of the value as it is
// usually printed; of a small one there are more, so that two are significant.
struct Comparand {
  calc::Estimate measured;
  Comparison comparison = Comparison::at_least;
  calc::Estimate limit;  // an interval if it hangs on another check's result
  int digits = 0;
};

struct Decision {
  Verdict verdict = Verdict::not_judged;
  // Usual rounding (for a policy that rounds: leaving it out) would change the answer for the
  // value.
  bool is_close = false;
  bool by_tolerance = false;  // a pass that is none without the tolerance
};

// pass: the whole interval meets the whole limit; fail: none of it does; else undecided.
Decision decide(const Comparand& comparand, const DecisionPolicy& policy);

// (value - limit) / limit, sign turned for upper limits, so that > 0 is good. Not a number for a
// limit of 0, which has no relative margin.
double margin(double value, Comparison comparison, double limit);
// Of the value; where an end is open, of the other one, which is what is shown.
double margin(const calc::Estimate& measured, Comparison comparison, double limit);

// To so many digits after the point, 0 to 9. 0.595, which is a bit less in binary, is rounded as
// written.
double round_to(double value, int digits, Rounding rounding);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::Verdict> {
  static constexpr EnumName<rules::Verdict> list[] = {{rules::Verdict::pass, "pass"},
                                                      {rules::Verdict::fail, "fail"},
                                                      {rules::Verdict::undecided, "undecided"},
                                                      {rules::Verdict::not_judged, "not-judged"}};
};

}  // namespace calc
