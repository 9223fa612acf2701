#pragma once
// Parts of a document that `check` and `watch` share.

#include "report/check/run.h"
#include "report/check/set_values.h"
#include "report/document/document.h"
#include "report/tools/check/check_options.h"

#include <vector>

namespace cli {

// Adds a message that names the set values, so that no format shows verdicts of a project that
// differs from its file without saying so. Project data of the first page change no verdict and are
// not named.
void tell_set_values(const std::vector<check::SetValue>& set, report::ProjectPart& part);

// Returns the provenance of results of this run, which was opened with these options.
report::Provenance provenance_of(const CheckOptions& options, const check::Run& run);

// Adds the facts that are known once all projects are.
void complete_provenance(report::Provenance& provenance, const report::Totals& totals,
                         const check::Run& run);

}  // namespace cli
