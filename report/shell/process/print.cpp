#include "report/shell/process/print.h"

#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <cstddef>
#include <cstdio>

namespace cli {

void tell_text(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::clearerr(stderr);
}

void print_diagnostics(const std::vector<calc::Diagnostic>& diagnostics, bool errors_only) {
  for (const calc::Diagnostic& diagnostic : diagnostics) {
    if (errors_only && diagnostic.severity() != calc::Severity::error) continue;
    tell("{}\n", calc::format_diagnostic(diagnostic));
  }
}

void print_error(calc::DiagnosticId id, const std::string& a, const std::string& b) {
  calc::Diagnostics diagnostics;
  diagnostics.report(id, {}, a, b);
  print_diagnostics(diagnostics.all(), true);
}

std::string written_words(const std::vector<std::string>& files) {
  if (files.empty()) return "";
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(calc::printable_path(file));
  return fmt::format("luxgate: wrote {}\n", calc::list_names(names, kMostNamed));
}

void tell_written(const std::vector<std::string>& files) { tell_text(written_words(files)); }

bool print_result(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  return std::fflush(stdout) == 0 && written;
}

ExitCode print_outcome(const CommandOutcome& outcome, bool quiet) {
  print_diagnostics(outcome.diagnostics, quiet);
  return print_result(outcome.text) ? outcome.code : kNotJudged;
}

}  // namespace cli
