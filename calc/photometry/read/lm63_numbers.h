#pragma once
// Reads the numbers of an LM-63 file, one field after the other, with a message for each that is
// missing or not allowed.

#include "calc/base/diagnostics.h"
#include "calc/photometry/read/number_stream.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

class Lm63Numbers {
 public:
  // text: the text after line `last_line` of file `name`. All must outlive this object.
  Lm63Numbers(std::string_view text, int last_line, const std::string& name,
              Diagnostics& diagnostics);

  // The reading functions report and return false (or nothing) if they fail.
  bool read(std::string_view field, double& value);
  // Reads a whole number (also "1.0") within [lowest, highest].
  bool read_whole(std::string_view field, int lowest, int highest, int& value);
  // Returns whether this many numbers are left; callers check before allocating that much.
  bool check_present(std::string_view what, std::size_t count);
  // Reports that the number read last is not allowed; returns false.
  bool refuse(std::string_view field, double value, std::string_view allowed);

  SourceLocation at(int line) const { return {name_, line, 0}; }
  SourceLocation here() const { return at(line_); }  // of the number read last
  int line() const { return line_; }
  std::size_t count_remaining() const { return numbers_.count_remaining(); }
  std::optional<NumberStream::Token> next_token() { return numbers_.next(); }
  Diagnostics& diagnostics() { return diagnostics_; }

 private:
  NumberStream numbers_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  int line_;
};

}  // namespace calc
