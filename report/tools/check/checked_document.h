#pragma once
// What `check` and `watch` put into a document, and how.

#include "report/check/run.h"
#include "report/check/set_values.h"
#include "report/document/document.h"
#include "report/tools/check/check_options.h"

#include <vector>

namespace cli {

// So that no format shows verdicts of a project that its file is not, and keeps silent about it.
// What the first page says, a revision, changes no verdict and is not told.
void tell_set_values(const std::vector<check::SetValue>& set, report::ProjectPart& part);

// Of results of this run, which was opened by these options.
report::Provenance provenance_of(const CheckOptions& options, const check::Run& run);

// What is known once all projects are.
void complete_provenance(report::Provenance& provenance, const report::Totals& totals,
                         const check::Run& run);

}  // namespace cli
