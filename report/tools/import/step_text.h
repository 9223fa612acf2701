#pragma once
// The text form of STEP data (ISO 10303-21), in which IFC files are written: a header, and numbered
// instances `#12=NAME(arguments);`. The text is scanned once, when it is opened; arguments are read
// from it on demand. So memory is that of the text and 28 bytes for each instance.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Why a file cannot be read. line: from 1; 0 = it is about the whole file.
struct StepProblem {
  std::size_t line = 0;
  std::string what;
};

// Deepest nesting of lists, typed values included.
inline constexpr int kDeepestStepList = 64;

// An argument: a slice of the text, which must outlive it.
class StepValue {
 public:
  enum class Kind {
    null,         // $
    derived,      // *
    number,       // 3, 0.5, 1.E-5
    text,         // 'a'
    enumeration,  // .METRE.
    binary,       // "0FF"
    reference,    // #12
    list,         // (a,b)
    typed         // IFCLABEL('a')
  };

  StepValue() = default;
  StepValue(Kind kind, std::string_view slice) : slice_(slice), kind_(kind) {}

  Kind kind() const { return kind_; }
  bool is_null() const { return kind_ == Kind::null || kind_ == Kind::derived; }
  std::string_view slice() const { return slice_; }  // as it is written

  // Return the value; empty if it is of another kind.
  std::optional<double> number() const;            // finite
  std::optional<std::uint64_t> reference() const;  // of an instance, which may not exist
  // Returns UTF-8 with all escapes resolved; is_sure: as in step_string().
  std::optional<std::string> text(bool* is_sure = nullptr) const;
  std::string enumeration() const;  // in capitals, without its dots: "METRE"
  std::string type_name() const;    // of a typed value, in capitals
  // Returns the items of a list, or between the brackets of a typed value.
  std::vector<StepValue> items() const;
  // Returns the only argument of a typed value, else the value itself.
  StepValue untyped() const;

 private:
  std::string_view slice_;
  Kind kind_ = Kind::null;
};

// Returns a string from between its quotes in UTF-8. is_sure becomes false if letters had to be
// guessed: bytes that are not UTF-8 are read as Windows-1252, escapes without a character become
// U+FFFD (for \S\ those missing in the alphabet of \P\, ISO 8859-1 to -9), and a \P\ of any other
// alphabet stays as written, its letters U+FFFD.
std::string step_string(std::string_view between_quotes, bool* is_sure = nullptr);

// Returns a string with its quotes, only in ASCII, so that it reads the same in every alphabet.
// Text that is not UTF-8 becomes U+FFFD. It contains no "/*", which begins a comment.
std::string step_literal(std::string_view utf8);
// Returns a finite number as a REAL, "0.5", "500.", "1.E-07": it reads back to the same bits.
std::string step_real(double value);

inline constexpr std::uint64_t kLargestStepNumber = 999'999'999'999'999'999;  // of an instance

class StepText {
 public:
  StepText(StepText&&) = default;
  StepText& operator=(StepText&&) = default;

  // Opens a text, whose bytes must outlive the result. Empty with a problem: a syntax error
  // anywhere, an early end, a number that is given twice. References to missing instances are
  // allowed.
  static std::optional<StepText> open(std::string_view bytes, StepProblem& problem);

  const std::vector<std::string>& schema() const { return schema_; }  // "IFC4", in capitals
  bool is_utf8() const { return is_utf8_; }                           // the whole text
  // Returns where ENDSEC of the last DATA section begins, as an offset in the bytes; 0: there is
  // none.
  std::size_t data_end() const { return data_end_; }

  // Returns the number of instances, which count from 0 in the order of their numbers.
  std::size_t size() const { return instance_.size(); }
  std::optional<std::uint32_t> find(std::uint64_t number) const;
  std::optional<std::uint32_t> find(const StepValue& reference) const;
  std::uint64_t number(std::uint32_t instance) const { return instance_[instance].number; }
  // Returns the name in capitals; "" for an instance with several types: #1=(A()B()).
  const std::string& name(std::uint32_t instance) const { return *name_[instance_[instance].name]; }
  std::size_t line(std::uint32_t instance) const;  // from 1
  std::size_t bytes(std::uint32_t instance) const { return instance_[instance].size; }
  // Returns the instances with a name in capitals.
  std::span<const std::uint32_t> of_name(std::string_view name) const;
  std::vector<StepValue> arguments(std::uint32_t instance) const;  // none of several at once

 private:
  StepText() = default;

  struct Instance {
    std::uint64_t number;
    std::uint32_t name, begin, size;  // begin, size: the arguments with their brackets
  };
  class Opener;

  std::size_t line_at(std::size_t offset) const;

  std::string_view bytes_;
  std::vector<Instance> instance_;
  std::map<std::string, std::uint32_t, std::less<>> name_number_;
  std::vector<const std::string*> name_;          // keys of name_number_
  std::vector<std::uint32_t> by_name_, name_at_;  // instances by name; where each name begins
  std::vector<std::uint32_t> lines_before_;       // line ends before each block of the text
  std::vector<std::string> schema_;
  std::size_t data_end_ = 0;
  bool is_utf8_ = true;
};

}  // namespace cli
