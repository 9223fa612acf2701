#pragma once
// Problems for GitHub and GitLab to show in a change: workflow commands and a code quality report.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// Writes a line per problem: "::error file=office.xml,line=12,title=...::..." for failures,
// requirements that could not be judged, and errors; "::warning ..." for undecided and warnings;
// "::notice ..." for waived findings and advice. Passes are omitted; the last line is the summary.
// [GitHub: workflow commands]
std::unique_ptr<FormatWriter> github_writer(const DocumentFrame& frame, const SpillPlace& place);

// Writes a JSON array of problems with fingerprint, severity (blocker: not judged; critical: fail;
// major: undecided; info: warnings, waived, advice) and line.  [GitLab: code quality report format]
std::unique_ptr<FormatWriter> gitlab_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
