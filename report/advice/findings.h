#pragma once
// Requirements of a judged project, one by one, wherever they are asked.

#include "report/document/document.h"
#include "rules/catalogue/finding.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

// Of a report::ProjectPart: of its spaces, of the planes of that one, of the findings of that one.
struct FindingPlace {
  std::size_t space = 0, plane = 0, finding = 0;
};

const rules::Finding& finding_at(const report::ProjectPart& part, const FindingPlace& where);

// All that count, in the order of the part.
std::vector<FindingPlace> counted_findings(const report::ProjectPart& part);

// "Office, Desk: average"
std::string finding_words(const report::ProjectPart& part, const FindingPlace& where);

// Values of points are judged anew from their light; what is of the space needs the project.
bool is_of_points(const rules::Requirement& requirement);

// Levels of dimming groups change it.
bool hangs_on_levels(const rules::Requirement& requirement);
// Of points, and from the light of all luminaires together.
bool is_judged_by_light(const rules::Requirement& requirement);

// How many of those that count pass.
struct PassCount {
  std::size_t passing = 0, asked = 0;
  void add(const rules::Finding& finding) {
    ++asked;
    passing += finding.verdict == rules::Verdict::pass ? 1 : 0;
  }
};

// Of all scenes and rooms.
PassCount count_all(const report::ProjectPart& part);

// What counts and does not pass: "Office, Desk: average (fail)"; then aggregates and classes.
std::vector<std::string> not_met_findings(const report::ProjectPart& part);

// What counts, passed before and does not pass after, in whatever scene: "Office, Desk: average
// (fail)"; then aggregates and classes of rule packs. Both are of the same requirements.
std::vector<std::string> broken_findings(const report::ProjectPart& before,
                                         const report::ProjectPart& after);

}  // namespace cli
