#pragma once
// Single requirements of a judged project, with their places.

#include "report/document/document.h"
#include "rules/catalogue/finding.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

// Indices into a report::ProjectPart: of its spaces, of that space's planes, of that plane's
// findings.
struct FindingPlace {
  std::size_t space = 0, plane = 0, finding = 0;
};

const rules::Finding& finding_at(const report::ProjectPart& part, const FindingPlace& where);

// Returns all findings that count, in the order of the part.
std::vector<FindingPlace> counted_findings(const report::ProjectPart& part);

// Returns "Office, Desk: average".
std::string finding_words(const report::ProjectPart& part, const FindingPlace& where);

// Returns whether it is about points, whose values can be judged again from their light; values of
// the space need the project.
bool is_of_points(const rules::Requirement& requirement);

// Returns whether levels of dimming groups change it.
bool hangs_on_levels(const rules::Requirement& requirement);
// Returns whether it is about points and judged from the light of all luminaires together.
bool is_judged_by_light(const rules::Requirement& requirement);

// Counts requirements that count, and those that pass.
struct PassCount {
  std::size_t passing = 0, asked = 0;
  void add(const rules::Finding& finding) {
    ++asked;
    passing += finding.verdict == rules::Verdict::pass ? 1 : 0;
  }
};

// Counts over all scenes and rooms.
PassCount count_all(const report::ProjectPart& part);

// Returns requirements that count and do not pass: "Office, Desk: average (fail)"; then aggregates
// and classes.
std::vector<std::string> not_met_findings(const report::ProjectPart& part);

// Returns requirements that count, passed before and do not pass after, in any scene: "Office,
// Desk: average (fail)"; then aggregates and classes of rule packs. Both parts have the same
// requirements.
std::vector<std::string> broken_findings(const report::ProjectPart& before,
                                         const report::ProjectPart& after);

}  // namespace cli
