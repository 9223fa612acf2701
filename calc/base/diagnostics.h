#pragma once
// All messages about the program's input: one table of ids and templates (diagnostics.def), one
// collector, one text form. Libraries report here; only the command line prints.

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

// A place in the user's files. line and column count from 1; 0 means "not known".
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

// Returns the stable kebab-case name of an id, e.g. "unknown-attribute". Scripts may rely on it.
std::string diagnostic_name(DiagnosticId id);
// Returns the id of this name; empty if there is none.
std::optional<DiagnosticId> diagnostic_from_name(std::string_view name);
Severity diagnostic_severity(DiagnosticId id);
std::string_view diagnostic_template(DiagnosticId id);

struct Diagnostic {
  DiagnosticId id;
  SourceLocation where;
  std::string message;  // one line, without location and severity

  Severity severity() const { return diagnostic_severity(id); }
};

// Returns "file:12:5: error[unknown-attribute]: message" without an unknown line or column. The
// text is one line and never a command for a CI runner, whatever the file's name.
std::string format_diagnostic(const Diagnostic& diagnostic);

// Limits the messages of one id, because a file may have a million mistakes.
inline constexpr std::size_t kMostMessagesOfAnId = 1000;
// Limits the length of a message, in characters.
inline constexpr std::size_t kLongestMessage = 4000;

// Collects diagnostics in the order they were found: the first kMostMessagesOfAnId of each id, and
// one message that counts the others. Not thread-safe: readers run on one thread.
class Diagnostics {
 public:
  // Reports one message. Arguments fill the template's {} in order; a wrong number of them is a bug
  // and throws fmt::format_error, which the tests of each message would show. A Message among them
  // is written in English.
  template <class... Args>
  void report(DiagnosticId id, const SourceLocation& where, const Args&... args) {
    if (!take(id, 1, where.file)) return;  // not even written
    write(id, where, shown(args)...);
  }

  // Appends the diagnostics of `others`.
  void add(const Diagnostics& others);

  bool has_errors() const { return error_count_ > 0; }
  std::size_t error_count() const { return error_count_; }  // also of those left out
  const std::vector<Diagnostic>& all() const { return all_; }

  // Sorts the messages about `file`, from the `first` on, by line; messages of the same line keep
  // their order. Messages about other files, or that count omitted ones, keep their places.
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
  // Counts the messages and returns whether there is room for another of this id. file: named in
  // the message that counts the omitted ones.
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
