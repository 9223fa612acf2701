#pragma once
// What a reader must not take for a verdict that decides.

#include "rules/verdict/outcome.h"

namespace report {

// By itself, or as a member of an aggregate. False of advice and of what is waived.
inline bool decides(const rules::Finding& finding) {
  return rules::counts(rules::outcome_of(finding)) ||
         (finding.requirement.severity == rules::Severity::in_aggregate && !finding.is_waived);
}

}  // namespace report
