#pragma once
// Reads the free stream of numbers after the TILT= line of an LM-63 file: separated by blanks,
// tabs, commas and line ends in any mixture; records may be broken anywhere [LM-63, edition of
// 2002, 3].

#include <cstddef>
#include <optional>
#include <string_view>

namespace calc {

class NumberStream {
 public:
  struct Token {
    std::string_view text;
    int line;
  };

  // text: the text after the line with number last_line.
  NumberStream(std::string_view text, int last_line) : rest_(text), line_(last_line + 1) {}

  std::optional<Token> next();
  // Returns the line of the end of the last token.
  int line() const { return line_; }
  // Returns the tokens left without storing any, to check a count from the file before allocating.
  std::size_t count_remaining() const;

 private:
  void skip_delimiters();

  std::string_view rest_;
  int line_;
};

// Returns a number of LM-63 and EULUMDAT files: decimal, finite, exponent with E or Fortran's D.
std::optional<double> parse_photometry_number(std::string_view text);

}  // namespace calc
