#pragma once
// Reads tables of comma-separated values; every reader of such files uses it. [RFC 4180]

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

// Line and column (in characters) of a file, from 1.
struct CsvPlace {
  int line = 1, column = 1;
};

struct CsvCell {
  std::string text;  // without its quotes, trimmed; a line end within quotes is a blank
  CsvPlace place;    // of its first character: the quote of a quoted one
};

struct CsvRecord {
  int line = 1;                // where it begins; quotes may stretch it over several
  std::string_view text;       // as it is written, trimmed
  std::vector<CsvCell> cells;  // at least one

  bool is_blank() const { return cells.size() == 1 && cells[0].text.empty(); }
};

// A mistake with quotes or separators: nobody knows where the cells after it end.
struct CsvProblem {
  CsvPlace place;  // of the quote or the separator
  std::string what;
  bool is_of_separator = false;
};

enum class CsvComments { none, hash };  // hash: a line that begins with # is a blank one

// Cells are separated by commas only. Quotes may enclose a cell; a comma or a line end between them
// is text, and a doubled quote is one. A quote anywhere else, or one that is never closed, is a
// problem, and so is a first line with semicolons or tabs instead of commas. Lines end with CR LF,
// LF or CR. How many cells a record must have is the caller's to say.
class CsvReader {
 public:
  // Reads UTF-8 and UTF-16, with or without a byte order mark; bytes that are not UTF-8 are read as
  // Windows-1252. The reader must outlive its records.
  explicit CsvReader(std::string_view bytes, CsvComments comments = CsvComments::none);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  // Returns the next record, blank ones included; empty after the last, and from a problem on.
  std::optional<CsvRecord> next();
  const std::optional<CsvProblem>& problem() const { return problem_; }

 private:
  bool is_at(char c) const { return !rest_.empty() && rest_.front() == c; }
  bool is_at_blank() const { return is_at(' ') || is_at('\t'); }
  bool is_at_line_end() const { return rest_.empty() || is_at('\n') || is_at('\r'); }
  void take();  // a byte, or a line end
  void check_separator();
  CsvCell read_cell();
  std::string read_quoted();

  std::string text_;  // in UTF-8
  std::string_view rest_;
  CsvComments comments_;
  CsvPlace here_;  // of rest_
  bool has_checked_separator_ = false;
  std::optional<CsvProblem> problem_;
};

// Reports the problem of the file `name`; returns false if there is none.
bool report_csv_problem(const CsvReader& table, const std::string& name, Diagnostics& diagnostics);

// "; write it with a decimal point", or "" of what would not be a number then.
std::string decimal_comma_hint(std::string_view text);

// A column "x_mm" holds lengths: name "x", 0.001 m. No metres: the name ends with no unit of
// length.
struct LengthColumn {
  std::string_view name;
  std::optional<double> metres;
};
LengthColumn length_column(std::string_view written);

// Maps the columns that a reader knows to their places in a table.
class CsvColumns {
 public:
  using PlainName = std::string_view (*)(std::string_view);

  CsvColumns() = default;
  // names: all known columns. plain_name: returns the known name for a written one, where a column
  // has several names.
  CsvColumns(const CsvRecord& header, std::span<const std::string_view> names,
             PlainName plain_name = nullptr);

  std::size_t width() const { return width_; }  // cells of the header; 0 = it was not read yet
  bool has(std::size_t name) const { return at_[name] != kAbsent; }
  // Returns the cell of a record with width() cells; "" if there is no such column.
  const std::string& cell(const CsvRecord& record, std::size_t name) const;

  const std::vector<std::string>& unknown() const { return unknown_; }  // as they are written
  // Returns the first column that appears twice, as written; "" if there is none.
  const std::string& doubled() const { return doubled_; }

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  std::vector<std::size_t> at_;  // of each name
  std::size_t width_ = 0;
  std::vector<std::string> unknown_;
  std::string doubled_;
};

}  // namespace calc
