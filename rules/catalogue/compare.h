#pragma once
// The only place where a quantity is compared with its limit, with the policy's rounding and
// tolerance. By default unrounded numbers are compared, with no tolerance except for binary noise.
// A sampled value passes or fails only with its whole interval.

#include "calc/base/field.h"
#include "calc/base/names.h"
#include "rules/catalogue/policy.h"
#include "rules/catalogue/requirement.h"

namespace rules {

enum class Verdict { pass, fail, undecided, not_judged };

// Returns a name for people: "pass", "fail", "undecided", "not judged". For data: calc::name_of().
const char* verdict_name(Verdict verdict);

// Compares without rounding or tolerance. A miss by less than 1e-9 of the limit is binary noise and
// meets an inclusive limit; an exclusive limit must be exceeded by more than that.
bool meets(double value, Comparison comparison, double limit);

// The compared value; its ends may be infinite. digits: usually printed after the point; small
// values have more, so that two are significant.
struct Comparand {
  calc::Estimate measured;
  Comparison comparison = Comparison::at_least;
  calc::Estimate limit;  // an interval if it depends on another check's result
  int digits = 0;
};

struct Decision {
  Verdict verdict = Verdict::not_judged;
  // The usual rounding (if the policy rounds: no rounding) would change the answer for the value.
  bool is_close = false;
  bool by_tolerance = false;  // a pass that is none without the tolerance
};

// Returns pass if the whole interval meets the whole limit, fail if none of it does, else
// undecided.
Decision decide(const Comparand& comparand, const DecisionPolicy& policy);

// Returns (value - limit) / limit, with the sign turned for upper limits, so that > 0 is good. NaN
// for a limit of 0, which has no relative margin.
double margin(double value, Comparison comparison, double limit);
// Returns the margin of the value; if an end is open, that of the other end, which is shown.
double margin(const calc::Estimate& measured, Comparison comparison, double limit);

// Rounds to this many digits after the point, 0 to 9. 0.595, slightly less in binary, is rounded as
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
