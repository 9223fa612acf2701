#pragma once
// What goes to which stream: results to standard output, everything else to standard error.

#include "calc/base/diagnostics.h"
#include "report/shell/process/exit_code.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// To standard error. Where that is closed or full, what cannot be said changes no result.
void tell_text(std::string_view text);
template <class... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
  tell_text(fmt::format(format, std::forward<Args>(args)...));
}

void print_diagnostics(const std::vector<calc::Diagnostic>& diagnostics, bool errors_only);
void print_error(calc::DiagnosticId id, const std::string& a, const std::string& b = "");

// "luxgate: wrote a.html, b.json and 40 more\n"; "" of none.
std::string written_words(const std::vector<std::string>& files);
// To standard error.
void tell_written(const std::vector<std::string>& files);

// To standard output. False if not all of it could be written, e.g. to a full disk.
bool print_result(const std::string& text);

// What a command has to say.
struct CommandOutcome {
  ExitCode code = kAllMet;
  std::string text;  // for standard output
  std::vector<calc::Diagnostic> diagnostics;
};
// Its code, or kNotJudged if it could not be written.
ExitCode print_outcome(const CommandOutcome& outcome, bool quiet = false);

}  // namespace cli
