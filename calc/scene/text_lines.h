#pragma once
// Lines of a text with their numbers.

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace calc {

// Lines end with LF, CR LF or CR.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  // False at the end of the text. The line has no line end.
  bool next(std::string_view& line) {
    if (next_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
    line = text_.substr(next_, end - next_);
    next_ = text_.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
    ++number_;
    return true;
  }

  // Of the last line, from 1.
  int number() const { return number_; }
  // What comes after the last line.
  std::string_view rest() const { return text_.substr(std::min(next_, text_.size())); }

 private:
  std::string_view text_;
  std::size_t next_ = 0;
  int number_ = 0;
};

}  // namespace calc
