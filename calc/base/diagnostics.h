#pragma once
// Everything the program has to say about its input: one table of ids and message templates
// (diagnostics.def), one collector, one text form. Libraries report here; only the command line
// prints.

#include "calc/base/names.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Where in the user's files something was found. line and column count from 1; 0 means "not known".
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { warning, error };

template <>
struct EnumNames<Severity> {
  static constexpr EnumName<Severity> list[] = {{Severity::error, "error"},
                                                {Severity::warning, "warning"}};
};

enum class DiagnosticId {
#define LUXGATE_DIAGNOSTIC(id, severity, text) id,
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC
};

// Stable kebab-case name of an id, e.g. "unknown-attribute". Scripts may rely on it.
std::string diagnostic_name(DiagnosticId id);
// The inverse; empty if there is none of that name.
std::optional<DiagnosticId> diagnostic_from_name(std::string_view name);
Severity diagnostic_severity(DiagnosticId id);
std::string_view diagnostic_template(DiagnosticId id);

struct Diagnostic {
  DiagnosticId id;
  SourceLocation where;
  std::string message;  // one line, without location and severity

  Severity severity() const { return diagnostic_severity(id); }
};

// "file:12:5: error[unknown-attribute]: message"; unknown line or column is left out.
std::string format_diagnostic(const Diagnostic& diagnostic);

// Collects diagnostics in the order they were found. Not thread-safe: readers run on one thread.
class Diagnostics {
 public:
  // Arguments fill the template's {} in order; a count that does not match is our own mistake and
  // throws fmt::format_error, which the tests of each message would show.
  template <class... Args>
  void report(DiagnosticId id, const SourceLocation& where, const Args&... args) {
    add(id, where, fmt::vformat(diagnostic_template(id), fmt::make_format_args(args...)));
  }

  // Those of `others`, after its own.
  void add(const Diagnostics& others);

  bool has_errors() const { return error_count_ > 0; }
  std::size_t error_count() const { return error_count_; }
  const std::vector<Diagnostic>& all() const { return all_; }

  // Messages about `file` from the `first` one on go into the order of its lines; those of a line
  // keep theirs, and those about other files keep their places.
  void sort_by_line(std::string_view file, std::size_t first);

 private:
  void add(DiagnosticId id, const SourceLocation& where, std::string message);

  std::vector<Diagnostic> all_;
  std::size_t error_count_ = 0;
};

}  // namespace calc
