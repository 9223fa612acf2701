#pragma once
// Prints to the right stream: results to standard output, everything else to standard error.

#include "calc/base/diagnostics.h"
#include "report/shell/process/exit_code.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// Prints to standard error. If that is closed or full, the lost text changes no result.
void tell_text(std::string_view text);
template <class... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
  tell_text(fmt::format(format, std::forward<Args>(args)...));
}

void print_diagnostics(const std::vector<calc::Diagnostic>& diagnostics, bool errors_only);
void print_error(calc::DiagnosticId id, const std::string& a, const std::string& b = "");

// Returns "luxgate: wrote a.html, b.json and 40 more\n"; "" for none.
std::string written_words(const std::vector<std::string>& files);
// Prints these words to standard error.
void tell_written(const std::vector<std::string>& files);

// Prints to standard output. Returns false if not all of it could be written, e.g. to a full disk.
bool print_result(const std::string& text);

// The output of a command.
struct CommandOutcome {
  ExitCode code = kAllMet;
  std::string text;  // for standard output
  std::vector<calc::Diagnostic> diagnostics;
};
// Returns its code, or kNotJudged if it could not be written.
ExitCode print_outcome(const CommandOutcome& outcome, bool quiet = false);

}  // namespace cli
