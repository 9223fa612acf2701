#pragma once
// The lowest layer of DXF: pairs of a group code and a value, from text or binary files of any
// version. The meaning of pairs is not known here.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cli {

struct DxfPair {
  int code = 0;
  std::string_view text;  // bytes as in the file, without the line's end; of numbers in text files
  std::optional<double> number;  // of numbers in binary files
  std::size_t place = 0;         // line of the code, from 1; in binary files its byte, from 0
};

// Reads a file once from start to end. The bytes must outlive it.
class DxfPairs {
 public:
  explicit DxfPairs(std::string_view bytes);

  // Reads the next pair. Returns false at the end of the file, which is the pair 0 EOF (anything
  // after it is ignored), and at a problem. Comments (999) are skipped.
  bool next(DxfPair& pair);
  // Returns "" or the problem, with its line or byte. A file without its end is a problem: it was
  // cut.
  const std::string& problem() const { return problem_; }
  // Returns whether the problem is a missing end after a whole last pair.
  bool is_cut() const { return is_cut_; }
  bool is_binary() const { return is_binary_; }
  // Returns the first of the comments so far: many programs write their name there.
  std::string_view first_comment() const { return first_comment_; }
  // Returns "line 12", "byte 120".
  std::string place_words(std::size_t place) const;

 private:
  bool fail(std::size_t place, const std::string& why);
  std::optional<std::string_view> line();
  bool next_of_text(DxfPair& pair);
  bool next_of_binary(DxfPair& pair);
  bool read_code(int& code);
  // Reads a little-endian number. Empty if the file ends before.
  std::optional<std::uint64_t> read_unsigned(std::size_t bytes);

  std::string_view bytes_, first_comment_;
  std::size_t at_ = 0, line_ = 0;
  bool is_binary_ = false, has_wide_codes_ = true, is_over_ = false, is_cut_ = false;
  std::string problem_;
};

// Returns a finite number; empty if it is not one.
std::optional<double> dxf_number(const DxfPair& pair);
// Returns a whole number that fits into an int.
std::optional<int> dxf_integer(const DxfPair& pair);

// Converts texts of a file to UTF-8.
class DxfTexts {
 public:
  // version: $ACADVER; code_page: $DWGCODEPAGE; "" = not stated.
  void set(std::string_view version, std::string_view code_page);
  // Returns the text by the rules of the version, with \U+XXXX as the character.
  std::string decoded(std::string_view bytes);
  // Returns one remark on texts that were guessed or could not be read; "" = none.
  const std::string& doubt() const { return doubt_; }

 private:
  std::string of_code_page(std::string_view bytes);

  bool is_utf8_ = false;
  std::string code_page_, doubt_;
};

// Returns the text of TEXT and ATTRIB without their %%-codes, and of MTEXT without its formats: one
// line, words separated by single blanks.
std::string plain_dxf_text(std::string_view text);
std::string plain_dxf_mtext(std::string_view text);

}  // namespace cli
