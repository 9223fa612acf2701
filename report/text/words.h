#pragma once
// Words and symbols that every format shares, so that all of them tell the same story. Functions
// that take Texts speak its language; without them it is English, as data formats need it.

#include "report/document/document.h"
#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>
#include <vector>

namespace report {

// "✓", "✗", "?", "–", and "○" where nothing was asked: nothing is told by colour alone.
const char* outcome_symbol(rules::Outcome outcome);
const char* verdict_symbol(rules::Verdict verdict);

// "pass", "fail", ..., "waived", "nothing was asked" for people.
const char* outcome_words(const Texts& t, rules::Outcome outcome);
inline const char* outcome_words(rules::Outcome outcome) { return outcome_words({}, outcome); }
const char* verdict_words(const Texts& t, rules::Verdict verdict);

// "maintained", "initial", "end-of-duration".
const char* light_state_words(const Texts& t, rules::LightState state);

// What a plane's points measure: "illuminance" (planar), "cylindrical illuminance Ez", "glare
// rating UGR", ...
const char* plane_words(const Texts& t, calc::ReceiverKernel kernel, calc::DerivedQuantity derived);
inline const char* plane_words(const Texts& t, const PlanePart& plane) {
  return plane_words(t, plane.kernel, plane.derived);
}
inline const char* plane_words(const PlanePart& plane) { return plane_words({}, plane); }
// After "average": "of glare rating UGR".
const char* of_plane_words(const Texts& t, const PlanePart& plane);
// Plain illuminance, which needs no words.
inline bool is_plain_illuminance(const PlanePart& plane) {
  return plane.kernel == calc::ReceiverKernel::planar &&
         plane.derived == calc::DerivedQuantity::none;
}
// Of the plane's values: "lx", or "" of ratings and ratios.
inline const char* plane_unit(const PlanePart& plane) { return calc::unit_of(plane.derived); }
// Of which light the plane's values are: "Maintained", or "Initial" of glare ratings, which are of
// the new installation.
const char* state_words(const Texts& t, const PlanePart& plane);
// Both together: "Maintained illuminance".
std::string state_plane_words(const Texts& t, const PlanePart& plane);
// With the unit: "Maintained illuminance in lx".
std::string values_words(const Texts& t, const PlanePart& plane);
// What a point's value is called in data: "illuminance_lx", "ugr", "modelling".
const char* value_key(calc::DerivedQuantity derived);

// What a requirement looks at: "average", "minimum", "Uo (min/avg)", "5 % percentile", "value at
// (1.00, 2.00, 0.80)".
std::string quantity_words(const Texts& t, const rules::Requirement& requirement);
inline std::string quantity_words(const rules::Requirement& requirement) {
  return quantity_words({}, requirement);
}
// The same where the plane is not named otherwise: "average of cylindrical illuminance Ez", but
// still "average" if it is planar.
std::string quantity_words(const Texts& t, const rules::Requirement& requirement,
                           calc::ReceiverKernel kernel);
inline std::string quantity_words(const rules::Requirement& requirement,
                                  calc::ReceiverKernel kernel) {
  return quantity_words({}, requirement, kernel);
}

// "≥", "≤", ">" or "<".
const char* comparison_sign(rules::Comparison comparison);
// Advice that is not kept to, which is no failure.
bool is_outside_advice(const rules::Requirement& requirement, rules::Verdict verdict);
inline bool is_outside_advice(const rules::Finding& finding) {
  return is_outside_advice(finding.requirement, finding.verdict);
}
// "recommended: 0.30 to 0.60", or the limit alone where no advice of the plane is the other end.
std::string advice_range_words(const Texts& t, const PlanePart& plane,
                               const rules::Finding& finding);
// A mask of a rule pack as it is called; in English, and of one that is not known here, its id.
std::string mask_name(const Texts& t, std::string_view id);

// What must be read with a finding: trust in the requirement, its mask, its decision policy; empty
// if there is nothing to say.
struct NotePart {
  calc::Message message;
  std::string text;      // without a message, in the reader's language
  bool is_mask = false;  // which points count, and how many
};
// ", initial, scene night": what a requirement looks at beyond maintained full output; "" =
// nothing.
std::string scene_words(const Texts& t, const rules::Requirement& requirement);
// Where requirements of a plane are of other light than its picture, its statistics and its values,
// which are of full output with reflected light: that it is so, and of which. "" = they are not.
std::string other_light_words(const Texts& t, const PlanePart& plane);
// "scene night, end-of-duration, direct light only"
std::string asked_light_words(const Texts& t, const AskedLight& light);
// "EN 12464-1:2021 34.2: not the whole row is asked, only task; never asked: surround, ...".
std::string coverage_words(const Texts& t, const rules::RowCoverage& row);
std::vector<NotePart> note_parts(const Texts& t, const rules::Finding& finding);
// The same as one text.
std::string note_words(const Texts& t, const rules::Finding& finding);
// For result files, which have the mark of numbers of one public source at each requirement; a
// report says that once, see one_source_note.h.
std::string marked_note_words(const rules::Finding& finding);
// What was measured, with its unit: "512.5 ± 4.0 lx", "< 10" of a UGR below its scale.
std::string measured_words(const Texts& t, const rules::Requirement& requirement,
                           const calc::Estimate& measured);
inline std::string measured_words(const Texts& t, const rules::Finding& finding) {
  return measured_words(t, finding.requirement, finding.measured);
}
// The same of a point's value, or of an average, minimum or maximum of them.
std::string value_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                        const Thresholds& thresholds = {});
// A point's value alone, short enough for a cell of a plan, see format_cell(); "< 10" of a UGR that
// is below its scale with all of its interval.
std::string cell_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                       const Thresholds& thresholds = {});
// A UGR all of which is below its scale, see is_below_ugr_scale().
bool is_below_scale(const rules::Finding& finding);
// By how much it is met or missed: "+12.5 %", of glare ratings "-5.3 UGR".
std::string margin_words(const Texts& t, const rules::Finding& finding);
inline std::string note_words(const rules::Finding& finding) { return note_words({}, finding); }
// Of a finding that is close; "" for others.
std::string close_words(const Texts& t, const rules::Finding& finding);
inline std::string close_words(const rules::Finding& finding) { return close_words({}, finding); }

// Name as given, else the id.
std::string_view title_of(std::string_view name, std::string_view id);

// A role of a rule pack, or a part of it, "wall.2", as it is called: "task" is "Bereich der
// Sehaufgabe". In English, and of a role that is not known here, as the pack names it.
std::string role_words(const Texts& t, std::string_view role);
// Title of a plane. Of one that a workplace made the role is in the reader's language: "Desk:
// task".
std::string plane_title(const Texts& t, const PlanePart& plane);

// A sentence part for people.
const char* stop_words(const Texts& t, calc::StopReason stop);
const char* drop_words(const Texts& t, calc::DropReason reason);

// "5 requirements: 3 pass, 1 fail, 1 undecided; 1 project not judged", "0 requirements: nothing was
// asked".
std::string summary_words(const Texts& t, const Totals& totals);
inline std::string summary_words(const Totals& totals) { return summary_words({}, totals); }

// That paths were left out (redact.h), a sentence; "" where nothing was.
std::string redaction_words(const Provenance& provenance, const Texts& t = {});
// That only a part was judged, and by which options; "" of all.
std::string selection_words(const Provenance& provenance, const Texts& t = {});
// By which policy it was judged; "" = by none.
std::string policy_words(const Provenance& provenance, const Texts& t = {});
// All of these, one after the other.
std::string provenance_remarks(const Provenance& provenance, const Texts& t = {});

// "3 of 9 planned"; "" where nothing was sampled.
std::string looks_words(const Texts& t, const PlanePart& plane);

// What is not to be trusted: "2 of 40 points rest on single samples: ..."; "" if nothing.
std::string doubt_words(const Texts& t, const PlanePart& plane);
inline std::string doubt_words(const PlanePart& plane) { return doubt_words({}, plane); }

// "horizontal, facing up", "vertical", "inclined by 30°" ... from the unit normal of a plane.
std::string orientation_words(const Texts& t, const glm::dvec3& normal);
// "(0.50, -0.87)": x and y alone.
std::string heading_words(const Texts& t, const glm::dvec3& direction);
bool is_horizontal(const glm::dvec3& normal);

}  // namespace report
