#pragma once
// JUnit XML, which most CI systems show as test results.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// A <testsuite> per project, a <testcase> per finding of CiFindings: classname is
// "project.room", name "plane / requirement", both of ids, so that branches can be compared. fail
// and undecided are a <failure> (type: the verdict), since both end the run with an exit code other
// than 0; not judged is an <error>; what is
// waived or advice and does not pass is <skipped>; a pass carries its measured value in
// <system-out>. file and line are those of the requirement. There are no times: equal input gives
// equal bytes.  [the set of elements documented by testmoapp/junitxml; GitLab shows bodies rather
// than attributes, so the words are in both]
std::unique_ptr<FormatWriter> junit_writer(const DocumentFrame& frame, const SpillPlace& place);

}  // namespace report
