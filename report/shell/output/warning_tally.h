#pragma once
// Counts the warnings of a run, and those that count like errors (--strict).

#include "calc/base/diagnostics.h"
#include "report/shell/command/command.h"
#include "rules/verdict/outcome.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cli {

struct StrictWarnings {
  bool all = false;
  std::vector<calc::DiagnosticId> ids = {};
  bool has_policy = false;  // a policy names some of them, or all

  // Returns whether the warning counts; a policy that is not met always does.
  bool has(calc::DiagnosticId id) const;
  // Somebody has named it: --strict without ids does not. Some doubts are warnings for them alone,
  // and a note in reports for all others.
  bool names(calc::DiagnosticId id) const;
};

// Returns --strict: all warnings; --strict=ID,ID: these.
Option strict_option(StrictWarnings& target);

class WarningTally {
 public:
  explicit WarningTally(StrictWarnings strict) : strict_(std::move(strict)) {}

  // Adds the warnings of a project. Returns the ids of those that count, each once.
  std::vector<calc::DiagnosticId> add(const std::vector<calc::Diagnostic>& diagnostics);

  // Returns Outcome::warned if a warning counts, else Outcome::nothing_asked.
  rules::Outcome outcome() const;
  // Returns lines for standard error: why they decide the exit code, and with --quiet, which prints
  // no warning, that there are others. "" if there is nothing to say.
  std::string words(bool quiet) const;
  void print(bool quiet) const;

 private:
  std::map<calc::DiagnosticId, std::size_t> counting_, others_;  // how many of each id
  StrictWarnings strict_;
};

}  // namespace cli
