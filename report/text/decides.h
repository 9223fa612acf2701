#pragma once
// Tells deciding verdicts from others.

#include "rules/verdict/outcome.h"

namespace report {

// Returns whether the finding decides, by itself or as a member of an aggregate; false for advice
// and waived findings.
inline bool decides(const rules::Finding& finding) {
  return rules::counts(rules::outcome_of(finding)) ||
         (finding.requirement.severity == rules::Severity::in_aggregate && !finding.is_waived);
}

}  // namespace report
