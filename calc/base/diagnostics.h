#pragma once
// Everything the program has to say about its input: one table of ids and message templates
// (diagnostics.def), one collector, one text form. Libraries report here; only the command line
// prints.

#include "calc/base/names.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
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

enum class DiagnosticId : std::uint16_t;  // see calc/base/diagnostic_ids.h
class Message;

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

// "file:12:5: error[unknown-attribute]: message"; unknown line or column is left out. One line, and
// no command for a CI runner, whatever the name of the file.
std::string format_diagnostic(const Diagnostic& diagnostic);

// Of one id, so that a file of a million mistakes does not fill memory and logs.
inline constexpr std::size_t kMostMessagesOfAnId = 1000;
// In characters.
inline constexpr std::size_t kLongestMessage = 4000;

// Collects diagnostics in the order they were found: of each id the first kMostMessagesOfAnId, and
// one that counts the others. Not thread-safe: readers run on one thread.
class Diagnostics {
 public:
  // Arguments fill the template's {} in order; a count that does not match is our own mistake and
  // throws fmt::format_error, which the tests of each message would show. A Message among them is
  // told in English.
  template <class... Args>
  void report(DiagnosticId id, const SourceLocation& where, const Args&... args) {
    if (!take(id, 1, where.file)) return;  // not even written
    write(id, where, shown(args)...);
  }

  // Those of `others`, after its own.
  void add(const Diagnostics& others);

  bool has_errors() const { return error_count_ > 0; }
  std::size_t error_count() const { return error_count_; }  // also of those left out
  const std::vector<Diagnostic>& all() const { return all_; }

  // Messages about `file` from the `first` one on go into the order of its lines; those of a line
  // keep theirs, and those about other files, or that count what is left out, keep their places.
  void sort_by_line(std::string_view file, std::size_t first);

 private:
  template <class T>
  static const T& shown(const T& argument) {
    return argument;
  }
  static std::string shown(const Message& message);

  template <class... Args>
  void write(DiagnosticId id, const SourceLocation& where, const Args&... args) {
    add(id, where, fmt::vformat(diagnostic_template(id), fmt::make_format_args(args...)));
  }
  void add(DiagnosticId id, const SourceLocation& where, std::string message);
  // Counts them. Whether there is room for one more of the id. file: of which the first one that is
  // left out is told.
  bool take(DiagnosticId id, std::size_t count, const std::string& file);

  struct OfAnId {
    std::size_t count = 0;     // found
    std::size_t left_out = 0;  // place of the message that counts those left out; 0 = there is none
  };
  std::vector<Diagnostic> all_;
  std::map<DiagnosticId, OfAnId> of_id_;
  std::size_t error_count_ = 0;
};

}  // namespace calc
