#include "report/revision/gate.h"

#include <algorithm>

namespace report {
namespace {

// Of 0 before no share is known: then any loss is too much.
bool is_worse_than_allowed(const ChangedResult& result, const Gate& gate) {
  return !(result.gain.high >= -allowed_loss(gate, result));
}

bool stops(const ChangedResult& result, const Gate& gate) {
  if (!result.counts || result.is_waived_after) return false;
  switch (result.change) {
    case ResultChange::broken:
    case ResultChange::new_failing:
      return true;
    case ResultChange::worse:
      return !result.excused_by && is_worse_than_allowed(result, gate);
    default:
      return false;
  }
}

// Of everything that does not fail.
rules::Outcome outcome_beside_failures(const Document& document) {
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  const auto add = [&outcome](rules::Outcome of_one) {
    if (of_one != rules::Outcome::fail) outcome = rules::graver(outcome, of_one);
  };
  for (const ProjectPart& project : document.projects) {
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        for (const rules::Finding& finding : plane.findings) add(rules::outcome_of(finding));
      }
    }
    for (const rules::AggregateFinding& finding : project.aggregates) {
      add(rules::outcome_of(finding));
    }
  }
  return outcome;
}

}  // namespace

double allowed_loss(const Gate& gate, const ChangedResult& result) {
  for (const AllowedLoss& loss : gate.allowed_worse_of) {
    if (result.metric == loss.metric) return loss.share;
  }
  return gate.allowed_worse;
}

bool may_have_lost_more(const Gate& gate, const ChangedResult& result) {
  return result.gain.low < -allowed_loss(gate, result);
}

GateReasons reasons_of(const Revision& revision) {
  GateReasons reasons;
  for (const ChangedResult& result : revision.results) {
    if (stops(result, revision.gate)) reasons.results.push_back(&result);
  }
  if (!revision.gate.weaker_accepted_by.empty()) return reasons;
  for (const ChangedQuestion& question : revision.questions) {
    if (question.change != QuestionChange::stricter) reasons.questions.push_back(&question);
  }
  return reasons;
}

bool is_judged_otherwise(const Revision& revision) {
  return !revision.questions.empty() ||
         std::any_of(revision.results.begin(), revision.results.end(), [](const auto& result) {
           return result.change != ResultChange::worse && result.change != ResultChange::better;
         });
}

rules::Outcome gate_outcome(const Document& document) {
  const rules::Outcome outcome = outcome_of(document);
  if (!document.revision || document.revision->gate.mode == GateMode::all) return outcome;
  if (outcome == rules::Outcome::not_judged || outcome == rules::Outcome::warned) return outcome;
  if (document.revision->is_of_itself) return rules::Outcome::not_judged;
  if (!reasons_of(*document.revision).empty()) return rules::Outcome::fail;
  if (outcome != rules::Outcome::fail) return outcome;
  const rules::Outcome others = outcome_beside_failures(document);
  return others == rules::Outcome::nothing_asked ? rules::Outcome::pass : others;
}

}  // namespace report
