#pragma once
// Reads the lines of an EULUMDAT file in order, one value each, and reports every problem at its
// line.

#include "calc/base/diagnostics.h"
#include "calc/base/line_cursor.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace calc {

class EulumdatLines {
 public:
  // text and name must outlive this object.
  EulumdatLines(std::string_view text, const std::string& name, Diagnostics& diagnostics)
      : name_(name), diagnostics_(diagnostics), lines_(text) {}

  // Returns the place of the line read last.
  SourceLocation here() const { return {name_, lines_.line(), 0}; }
  // Reports a value that is not allowed at that place; always returns false.
  bool refuse(std::string_view field, double value, std::string_view allowed);

  // Returns a line; empty (false), with an error, at the end of the file. field: for messages.
  std::optional<std::string_view> text_line(std::string_view field);
  bool skip(int count, std::string_view field);
  // Reads a number with a decimal point or comma; warns once of words behind a number.
  bool read_number(std::string_view field, double& value);
  // Reads like read_number(); a blank line is 0, with a warning.
  bool read_number_or_blank(std::string_view field, double& value);
  bool read_whole(std::string_view field, int lowest, int highest, int& value);

  std::size_t count_remaining() const { return lines_.count_remaining(); }
  // Returns a cursor to look ahead without messages.
  LineCursor cursor() const { return lines_; }

 private:
  const std::string& name_;
  Diagnostics& diagnostics_;
  LineCursor lines_;
  bool warned_of_text_ = false;
};

}  // namespace calc
