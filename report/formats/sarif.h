#pragma once
// SARIF 2.1.0, which code hosts show beside the lines of a project file.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

enum class SarifContent {
  problems,  // all but passes: GitHub shows every result as an alert, whatever its kind
  all        // passes too, as kind "pass"
};

// Writes one run. Results have kind "fail" (level error), "review" (undecided) or "open" (not
// judged, or advice: level note); waived results are suppressed, with the reason; ruleId is the
// quantity, the location is the requirement's line, the fingerprint depends only on ids. Inputs
// with their hashes are artifacts, diagnostics are notifications of the invocation.  [SARIF]
std::unique_ptr<FormatWriter> sarif_writer(const DocumentFrame& frame, const SpillPlace& place,
                                           SarifContent content);

}  // namespace report
