#pragma once
// JUnit XML, which most CI systems show as test results.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// Writes a <testsuite> per project, a <testcase> per finding of CiFindings: classname is
// "project.room", name "plane / requirement", both of ids, so that branches can be compared. fail
// and undecided are a <failure> (type: the verdict), because both end the run with a nonzero exit
// code; not judged is an <error>; waived findings and advice that do not pass are <skipped>; a pass
// has its measured value in <system-out>. file and line are those of the requirement. There are no
// times: equal input gives equal bytes.  [the set of elements documented by testmoapp/junitxml;
// GitLab shows bodies rather than attributes, so the words are in both]
std::unique_ptr<FormatWriter> junit_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
