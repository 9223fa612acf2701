#pragma once
// The lines of an EULUMDAT file: one value each, read in order, with every problem reported at its
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

  // Place of the line read last.
  SourceLocation here() const { return {name_, lines_.line(), 0}; }
  // Reports a value that is not allowed at that place; always false.
  bool refuse(std::string_view field, double value, std::string_view allowed);

  // field: what the line holds, for messages. Empty (false), with an error, at the end of the file.
  std::optional<std::string_view> text_line(std::string_view field);
  bool skip(int count, std::string_view field);
  // A decimal point or comma; words behind the number are warned of once.
  bool read_number(std::string_view field, double& value);
  // As read_number(); a blank line is 0 and warned of.
  bool read_number_or_blank(std::string_view field, double& value);
  bool read_whole(std::string_view field, int lowest, int highest, int& value);

  std::size_t count_remaining() const { return lines_.count_remaining(); }
  // To look ahead without messages.
  LineCursor cursor() const { return lines_; }

 private:
  const std::string& name_;
  Diagnostics& diagnostics_;
  LineCursor lines_;
  bool warned_of_text_ = false;
};

}  // namespace calc
