#pragma once
// What `check` and `watch` put into a document, and how.

#include "report/check/backend.h"
#include "report/check/check_project.h"
#include "report/document/document.h"
#include "report/tools/check/check_options.h"

#include <string>
#include <vector>

namespace cli {

// Whatever goes wrong in one project must not stop the batch: then it is not judged and says why.
report::ProjectPart check_safely(const std::string& path, const check::Context& context);

// So that no format shows verdicts of a project that its file is not, and keeps silent about it.
// What the first page says, a revision, changes no verdict and is not told.
void tell_set_values(const std::vector<check::SetValue>& set, report::ProjectPart& part);

// description: of the backend.
report::Provenance provenance_of(const CheckOptions& options, check::Backend backend,
                                 const std::string& description);

// What is known once all projects are. today: YYYY-MM-DD, by which waivers were judged.
void complete_provenance(report::Provenance& provenance, const report::Totals& totals,
                         const std::string& today, check::Backend backend);

}  // namespace cli
