#pragma once
// The only place where a quantity meets its limit. Policy: unrounded numbers are compared, with no
// tolerance except for binary noise; a sampled value passes or fails only with its whole interval.

#include "calc/field.h"
#include "rules/requirement.h"

namespace rules {

enum class Verdict { pass, fail, undecided, not_judged };

const char* verdict_name(Verdict verdict);  // "pass", "fail", "undecided", "not judged"

// value >= limit or value <= limit; a miss by less than 1e-9 of the limit is binary noise and meets
// it.
bool meets(double value, Comparison comparison, double limit);

// pass: the whole interval meets the limit; fail: none of it does; else undecided.
Verdict compare(const calc::Estimate& estimate, Comparison comparison, double limit);

// (value - limit) / limit, sign turned for at_most, so that > 0 is good. 0 for a limit of 0, which
// has no relative margin.
double margin(double value, Comparison comparison, double limit);

// As tables are usually printed: half up, whole lx or two digits of a ratio.
double round_as_printed(double value, Metric metric);

// Would the rounded value change the answer of meets()?
bool is_close_call(double value, Metric metric, Comparison comparison, double limit);

}  // namespace rules
