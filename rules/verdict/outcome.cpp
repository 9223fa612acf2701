#include "rules/verdict/outcome.h"

namespace rules {
namespace {

Outcome outcome_of(Verdict verdict, Severity severity, bool is_waived) {
  if (severity != Severity::shall) return Outcome::nothing_asked;
  return is_waived ? Outcome::waived : outcome_of(verdict);
}

}  // namespace

static_assert(std::is_sorted(kGravestFirst.begin(), kGravestFirst.end(),
                             [](Verdict a, Verdict b) { return outcome_of(a) < outcome_of(b); }));

Outcome outcome_of(const Finding& finding) {
  return outcome_of(finding.verdict, finding.requirement.severity, finding.is_waived);
}

Outcome outcome_of(const AggregateFinding& finding) {
  return outcome_of(finding.verdict, finding.severity, finding.is_waived);
}

}  // namespace rules
