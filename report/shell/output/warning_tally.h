#pragma once
// Warnings of a run: how many there are, and which of them count like errors (--strict).

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

  // A policy that is not met always counts.
  bool has(calc::DiagnosticId id) const;
  // Somebody has named it: --strict without ids does not. Some doubts are warnings for them alone,
  // and a note in reports for all others.
  bool names(calc::DiagnosticId id) const;
};

// --strict: all; --strict=ID,ID: these.
Option strict_option(StrictWarnings& target);

class WarningTally {
 public:
  explicit WarningTally(StrictWarnings strict) : strict_(std::move(strict)) {}

  // Of one project. Ids of those that count, each once.
  std::vector<calc::DiagnosticId> add(const std::vector<calc::Diagnostic>& diagnostics);

  // Outcome::warned if one counts, else Outcome::nothing_asked.
  rules::Outcome outcome() const;
  // Lines for standard error: why they decide the exit code, and with --quiet, where no warning is
  // printed, that there are others. "" if there is nothing to say.
  std::string words(bool quiet) const;
  void print(bool quiet) const;

 private:
  std::map<calc::DiagnosticId, std::size_t> counting_, others_;  // how many of each id
  StrictWarnings strict_;
};

}  // namespace cli
