#pragma once
// Words and symbols that every format shares, so that all of them tell the same story.

#include "report/document.h"

#include <string>
#include <string_view>

namespace report {

// "✓", "✗", "?", "–": a verdict is never told by colour alone.
const char* verdict_symbol(rules::Verdict verdict);

// Name without blanks for class names and data: "pass", "fail", "undecided", "not-judged".
const char* verdict_key(rules::Verdict verdict);

// What a plane's points measure: "illuminance" (planar), "cylindrical illuminance Ez", ...
const char* kernel_words(calc::ReceiverKernel kernel);
// The same for all quantities: "glare rating UGR", ...
const char* plane_words(calc::ReceiverKernel kernel, calc::DerivedQuantity derived);
inline const char* plane_words(const PlanePart& plane) {
  return plane_words(plane.kernel, plane.derived);
}
// Plain illuminance, which needs no words.
inline bool is_plain_illuminance(const PlanePart& plane) {
  return plane.kernel == calc::ReceiverKernel::planar &&
         plane.derived == calc::DerivedQuantity::none;
}
// Of the plane's values: "lx", or "" of ratings and ratios.
inline const char* plane_unit(const PlanePart& plane) {
  return calc::is_plain_number(plane.derived) ? "" : "lx";
}
// Of which light the plane's values are: "Maintained", or "Initial" of glare ratings, which are of
// the new installation.
const char* state_words(const PlanePart& plane);
// What a point's value is called in data: "illuminance_lx", "ugr", "modelling".
const char* value_key(const PlanePart& plane);

// What a requirement looks at: "average", "minimum", "Uo (min/avg)", "5 % percentile", "value at
// (1.00, 2.00, 0.80)".
std::string quantity_words(const rules::Requirement& requirement);
// The same where the plane is not named otherwise: "average of cylindrical illuminance Ez", but
// still "average" if it is planar.
std::string quantity_words(const rules::Requirement& requirement, calc::ReceiverKernel kernel);

// "at_least", "at_most", "more_than" or "less_than".
const char* comparison_key(rules::Comparison comparison);
// "≥", "≤", ">" or "<".
const char* comparison_sign(rules::Comparison comparison);
// "shall" or "advice".
const char* severity_key(rules::Severity severity);
// What must be read with a finding: trust in the requirement, its mask, its decision policy; "" if
// there is nothing to say.
std::string note_words(const rules::Finding& finding);
// Of a finding that is close; "" for others.
std::string close_words(const rules::Finding& finding);

// Name as given, else the id.
std::string_view title_of(std::string_view name, std::string_view id);

// Stable kebab-case key for data, and a sentence part for people.
const char* stop_key(calc::StopReason stop);
const char* stop_words(calc::StopReason stop);
const char* drop_key(calc::DropReason reason);
const char* drop_words(calc::DropReason reason);

// "5 requirements: 3 pass, 1 fail, 1 undecided; 1 project not judged".
std::string summary_words(const Document& document);

// The gravest verdict, in the order of the exit codes: not_judged (also for a plane without
// result), then fail, then undecided, then pass. Nothing judged: not_judged.
rules::Verdict overall_verdict(const Document& document);
// Its name; "waived" where it is a pass of which every requirement is waived.
const char* outcome_words(const Document& document);

// "3 of 9 planned"; "" where nothing was sampled.
std::string looks_words(const PlanePart& plane);

// What is not to be trusted: "2 of 40 points rest on single samples: ..."; "" if nothing.
std::string doubt_words(const PlanePart& plane);

// "horizontal, facing up", "vertical", "inclined by 30°" ... from the unit normal of a plane.
std::string orientation_words(const glm::dvec3& normal);
bool is_horizontal(const glm::dvec3& normal);

}  // namespace report
