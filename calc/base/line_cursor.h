#pragma once
// Walks through a text line by line without storing the lines; a line ends with CR LF, LF or CR.

#include <cstddef>
#include <optional>
#include <string_view>

namespace calc {

class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : rest_(text) {}

  // Returns the next line without its end; empty after the last.
  std::optional<std::string_view> next();
  // Returns the number of the line that next() returned last, from 1; 0 before the first.
  int line() const { return line_; }
  // Returns the text after that line.
  std::string_view rest() const { return rest_; }
  // Returns the number of lines left, without blank ones at the end.
  std::size_t count_remaining() const;

 private:
  std::string_view rest_;
  int line_ = 0;
};

}  // namespace calc
