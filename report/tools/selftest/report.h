#pragma once
// The validation report: made from runs, never written by hand.

#include "report/tools/selftest/run_result.h"

#include <string>
#include <vector>

namespace cli::selftest {

// Without times unless has_timing, so that equal programs write equal text.
std::string render_report_markdown(const RunResult& result, bool has_timing);
std::string render_report_html(const RunResult& result, bool has_timing);

// What no case looks at, in words.
const std::vector<std::string>& not_covered();

// What reports of other judged cases are made of (tests/validation).
std::string markdown_cell(const std::string& text);  // for a cell of a Markdown table
std::string exact_words(const JudgedNumber& n);      // with its unit
// A page of its own in the style of all reports; style: more CSS; body: HTML.
std::string html_page(const std::string& title, const std::string& style, const std::string& body);
// A case with all its numbers. printed: what others print of each number, as one more column; empty
// = no such column.
std::string case_html(const JudgedCase& item, const std::vector<std::string>& printed,
                      bool has_timing);

}  // namespace cli::selftest
