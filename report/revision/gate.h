#pragma once
// Whether a revision gets through.

#include "report/document/document.h"
#include "report/document/revision.h"

#include <vector>

namespace report {

// What a gate of regressions stops at. Point into the revision.
struct GateReasons {
  std::vector<const ChangedResult*> results;      // broken, new failing, worse by too much
  std::vector<const ChangedQuestion*> questions;  // weaker or exchanged, and nobody accepts it
  bool empty() const { return results.empty() && questions.empty(); }
};
GateReasons reasons_of(const Revision& revision);

// Share that the value may lose.
double allowed_loss(const Gate& gate, const ChangedResult& result);
// Whether a loss of more than that is not excluded: by the interval, or as it is not known.
bool may_have_lost_more(const Gate& gate, const ChangedResult& result);

// Whether anything is asked otherwise, or a verdict is another one; values may differ.
bool is_judged_otherwise(const Revision& revision);

// What the exit code tells. Without a revision, and at GateMode::all: outcome_of(). At
// GateMode::regression failures that were there before do not count; what is undecided or could not
// be judged does, and a revision beside itself is not judged.
rules::Outcome gate_outcome(const Document& document);

}  // namespace report
