#pragma once
// The validation report: made from runs, never written by hand.

#include "report/tools/selftest/run_result.h"

#include <string>
#include <vector>

namespace cli::selftest {

// Returns the report; without times unless has_timing, so that equal programs write equal text.
std::string render_report_markdown(const RunResult& result, bool has_timing);
std::string render_report_html(const RunResult& result, bool has_timing);

// Returns subjects that no case tests, in words.
const std::vector<std::string>& not_covered();

// Return parts for reports of other judged cases (tests/validation).
std::string markdown_cell(const std::string& text);  // for a cell of a Markdown table
std::string exact_words(const JudgedNumber& n);      // with its unit
// Returns a separate page in the style of all reports; style: more CSS; body: HTML.
std::string html_page(const std::string& title, const std::string& style, const std::string& body);
// Returns a case with all its numbers. printed: values printed by others, as one more column; empty
// = no such column.
std::string case_html(const JudgedCase& item, const std::vector<std::string>& printed,
                      bool has_timing);

}  // namespace cli::selftest
