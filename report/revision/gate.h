#pragma once
// Decides whether a revision passes its gate.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <vector>

namespace report {

// The reasons why a gate for regressions stops a revision; they point into it.
struct GateReasons {
  std::vector<const ChangedResult*> results;      // broken, new failing, worse by too much
  std::vector<const ChangedQuestion*> questions;  // weaker or exchanged, and not accepted
  bool empty() const { return results.empty() && questions.empty(); }
};
GateReasons reasons_of(const Revision& revision);

// Returns the share that the value may lose.
double allowed_loss(const Gate& gate, const ChangedResult& result);
// Returns whether a greater loss is possible, by the interval or because it is not known.
bool may_have_lost_more(const Gate& gate, const ChangedResult& result);

// Returns whether any requirement or verdict differs; values may differ.
bool is_judged_otherwise(const Revision& revision);

// Returns the outcome for the exit code. Without a revision, and at GateMode::all: outcome_of(). At
// GateMode::regression earlier failures do not count; undecided and not judged results do, and a
// revision compared with itself is not judged.
rules::Outcome gate_outcome(const Document& document);

}  // namespace report
