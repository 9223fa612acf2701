#pragma once
// Words and symbols shared by all formats, so that all report the same. Functions that take Texts
// use its language; without them the words are English, for data formats.

#include "report/document/document.h"
#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns "✓", "✗", "?", "–", or "○" if nothing was required: colour alone never carries a meaning.
const char* outcome_symbol(rules::Outcome outcome);
const char* verdict_symbol(rules::Verdict verdict);

// Returns "pass", "fail", ..., "waived", "nothing was asked" for people.
const char* outcome_words(const Texts& t, rules::Outcome outcome);
inline const char* outcome_words(rules::Outcome outcome) { return outcome_words({}, outcome); }
const char* verdict_words(const Texts& t, rules::Verdict verdict);

// Returns "maintained", "initial", "end-of-duration".
const char* light_state_words(const Texts& t, rules::LightState state);

// Returns the quantity of a plane's points: "illuminance" (planar), "cylindrical illuminance Ez",
// "glare rating UGR", ...
const char* plane_words(const Texts& t, calc::ReceiverKernel kernel, calc::DerivedQuantity derived);
inline const char* plane_words(const Texts& t, const PlanePart& plane) {
  return plane_words(t, plane.kernel, plane.derived);
}
inline const char* plane_words(const PlanePart& plane) { return plane_words({}, plane); }
// Returns the words after "average": "of glare rating UGR".
const char* of_plane_words(const Texts& t, const PlanePart& plane);
// Returns whether it is plain illuminance, which needs no words.
inline bool is_plain_illuminance(const PlanePart& plane) {
  return plane.kernel == calc::ReceiverKernel::planar &&
         plane.derived == calc::DerivedQuantity::none;
}
// Returns the unit of the plane's values: "lx", or "" for ratings and ratios.
inline const char* plane_unit(const PlanePart& plane) { return calc::unit_of(plane.derived); }
// Returns the light of the plane's values: "Maintained", or "Initial" for glare ratings, which are
// of the new installation.
const char* state_words(const Texts& t, const PlanePart& plane);
// Returns both together: "Maintained illuminance".
std::string state_plane_words(const Texts& t, const PlanePart& plane);
// Returns both with the unit: "Maintained illuminance in lx".
std::string values_words(const Texts& t, const PlanePart& plane);
// Returns the name of a point's value in data: "illuminance_lx", "ugr", "modelling".
const char* value_key(calc::DerivedQuantity derived);

// Returns the quantity of a requirement: "average", "minimum", "Uo (min/avg)", "5 % percentile",
// "value at (1.00, 2.00, 0.80)".
std::string quantity_words(const Texts& t, const rules::Requirement& requirement);
inline std::string quantity_words(const rules::Requirement& requirement) {
  return quantity_words({}, requirement);
}
// Returns the quantity where nothing else names the plane: "average of cylindrical illuminance Ez",
// but only "average" if it is planar.
std::string quantity_words(const Texts& t, const rules::Requirement& requirement,
                           calc::ReceiverKernel kernel);
inline std::string quantity_words(const rules::Requirement& requirement,
                                  calc::ReceiverKernel kernel) {
  return quantity_words({}, requirement, kernel);
}

// Returns "≥", "≤", ">" or "<".
const char* comparison_sign(rules::Comparison comparison);
// Returns whether it is advice that is not followed, which is no failure.
bool is_outside_advice(const rules::Requirement& requirement, rules::Verdict verdict);
inline bool is_outside_advice(const rules::Finding& finding) {
  return is_outside_advice(finding.requirement, finding.verdict);
}
// Returns "recommended: 0.30 to 0.60", or only the limit if no advice of the plane is the other
// end.
std::string advice_range_words(const Texts& t, const PlanePart& plane,
                               const rules::Finding& finding);
// Returns the name of a rule pack's mask; in English, and for an unknown mask, its id.
std::string mask_name(const Texts& t, std::string_view id);

// A remark to be read with a finding: trust in the requirement, its mask, its decision policy;
// empty if there is nothing to say.
struct NotePart {
  calc::Message message;
  std::string text;      // without a message, in the reader's language
  bool is_mask = false;  // which points count, and how many
};
// Returns ", initial, scene night": conditions of a requirement other than maintained full output;
// "" = none.
std::string scene_words(const Texts& t, const rules::Requirement& requirement);
// Returns a remark if requirements of a plane are for other light than its picture, statistics and
// values (full output with reflected light), with that light. "" = they are not.
std::string other_light_words(const Texts& t, const PlanePart& plane);
// Returns "scene night, end-of-duration, direct light only".
std::string asked_light_words(const Texts& t, const AskedLight& light);
// Returns "EN 12464-1:2021 34.2: not the whole row is asked, only task; never asked: surround,
// ...".
std::string coverage_words(const Texts& t, const rules::RowCoverage& row);
std::vector<NotePart> note_parts(const Texts& t, const rules::Finding& finding);
// Returns the remarks on a finding as one text.
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
// Returns a point's value, or an average, minimum or maximum of values, in the same way.
std::string value_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                        const Thresholds& thresholds = {});
// Returns a point's value alone, short enough for a cell of a plan, see format_cell(); "< 10" for a
// UGR whose whole interval is below its scale.
std::string cell_words(const Texts& t, const PlanePart& plane, const calc::Estimate& value,
                       const Thresholds& thresholds = {});
// Returns whether it is a UGR that is all below its scale, see is_below_ugr_scale().
bool is_below_scale(const rules::Finding& finding);
// Returns the margin: "+12.5 %", for glare ratings "-5.3 UGR".
std::string margin_words(const Texts& t, const rules::Finding& finding);
inline std::string note_words(const rules::Finding& finding) { return note_words({}, finding); }
// Returns the remark on a finding that is close to its limit; "" for others.
std::string close_words(const Texts& t, const rules::Finding& finding);
inline std::string close_words(const rules::Finding& finding) { return close_words({}, finding); }

// Returns the name, or the id if there is no name.
std::string_view title_of(std::string_view name, std::string_view id);

// Returns the name of a role of a rule pack, or of a part of it, "wall.2": "task" is "Bereich der
// Sehaufgabe". In English, and for unknown roles, the name in the pack.
std::string role_words(const Texts& t, std::string_view role);
// Returns the title of a plane. For planes of a workplace the role is in the reader's language:
// "Desk: task".
std::string plane_title(const Texts& t, const PlanePart& plane);

// Returns a part of a sentence for people.
const char* stop_words(const Texts& t, calc::StopReason stop);
const char* drop_words(const Texts& t, calc::DropReason reason);

// Returns "5 requirements: 3 pass, 1 fail, 1 undecided; 1 project not judged", "0 requirements:
// nothing was asked".
std::string summary_words(const Texts& t, const Totals& totals);
inline std::string summary_words(const Totals& totals) { return summary_words({}, totals); }

// Returns a sentence that paths were omitted (redact.h); "" if none were.
std::string redaction_words(const Provenance& provenance, const Texts& t = {});
// Returns a sentence that only a part was judged, with the options; "" if everything was.
std::string selection_words(const Provenance& provenance, const Texts& t = {});
// Returns a sentence that names the policy of the check; "" = no policy.
std::string policy_words(const Provenance& provenance, const Texts& t = {});
// Returns all of these, one after the other.
std::string provenance_remarks(const Provenance& provenance, const Texts& t = {});

// Returns "3 of 9 planned"; "" if nothing was sampled.
std::string looks_words(const Texts& t, const PlanePart& plane);

// Returns what is not to be trusted: "2 of 40 points rest on single samples: ..."; "" if nothing.
std::string doubt_words(const Texts& t, const PlanePart& plane);
inline std::string doubt_words(const PlanePart& plane) { return doubt_words({}, plane); }

// Returns "horizontal, facing up", "vertical", "inclined by 30°" ... from the unit normal of a
// plane.
std::string orientation_words(const Texts& t, const glm::dvec3& normal);
// Returns "(0.50, -0.87)": only x and y.
std::string heading_words(const Texts& t, const glm::dvec3& direction);
bool is_horizontal(const glm::dvec3& normal);

}  // namespace report
