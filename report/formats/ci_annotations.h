#pragma once
// What GitHub and GitLab show in a change: workflow commands and a code quality report.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// A line per problem: "::error file=office.xml,line=12,title=...::..." for what failed or could not
// be judged and for errors, "::warning ..." for undecided and warnings, "::notice ..." for what is
// waived or advice. Passes are left out; the last line is the summary.  [GitHub: workflow commands]
std::unique_ptr<FormatWriter> github_writer(const DocumentFrame& frame, const SpillPlace& place);

// A JSON array of problems with fingerprint, severity (blocker: not judged; critical: fail; major:
// undecided; info: warnings, waived, advice) and line.  [GitLab: code quality report format]
std::unique_ptr<FormatWriter> gitlab_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
