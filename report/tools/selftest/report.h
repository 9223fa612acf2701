#pragma once
// The validation report: made from runs, never written by hand.

#include "report/tools/selftest/open_cases.h"
#include "report/tools/selftest/run_result.h"

#include <string>

namespace cli::selftest {

// Without times unless has_timing, so that equal programs write equal text.
std::string render_report_markdown(const RunResult& result, bool has_timing);
// Of the open cases alone; "" without any.
std::string render_open_markdown(const OpenCases& open);
std::string render_report_html(const RunResult& result, const OpenCases& open, bool has_timing);

// What no case looks at, in words.
const std::vector<std::string>& not_covered();

}  // namespace cli::selftest
