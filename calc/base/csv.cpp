#include "calc/base/csv.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"

#include <algorithm>
#include <utility>

namespace calc {

CsvReader::CsvReader(std::string_view bytes, CsvComments comments) : comments_(comments) {
  const std::string other = other_kind_problem(bytes, "", FileUse::table);
  if (!other.empty()) problem_ = {{}, other};
  DecodedText decoded = decoded_text(std::string(bytes));
  text_ = first_invalid_utf8(decoded.utf8) ? utf8_from_windows_1252(decoded.utf8)
                                           : std::move(decoded.utf8);
  rest_ = without_byte_order_mark(text_);
  if (!decoded.problem.empty()) problem_ = {{}, decoded.problem};
}

void CsvReader::take() {
  if (is_at_line_end()) {
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
    here_ = {here_.line + 1, 1};
    return;
  }
  rest_.remove_prefix(1);
  // The next byte begins a character, or goes on with this one.
  if (rest_.empty() || !is_utf8_continuation(rest_.front())) ++here_.column;
}

std::optional<CsvRecord> CsvReader::next() {
  if (rest_.empty() || problem_) return std::nullopt;
  const std::string_view begin = rest_;
  CsvRecord record;
  record.line = here_.line;
  while (is_at_blank()) take();
  if (comments_ == CsvComments::hash && is_at('#')) {
    while (!is_at_line_end()) take();
  }
  check_separator();
  record.cells.push_back(read_cell());
  while (!problem_ && is_at(',')) {
    take();
    record.cells.push_back(read_cell());
  }
  if (problem_) return std::nullopt;
  record.text = trim(begin.substr(0, begin.size() - rest_.size()));
  if (!rest_.empty()) take();
  return record;
}

// Looks at the first line that is not blank. Where the next line has commas it is the first line
// alone, such as a remark.
void CsvReader::check_separator() {
  if (has_checked_separator_ || is_at_line_end() || problem_) return;
  has_checked_separator_ = true;
  std::optional<CsvPlace> first;
  char separator = ';';
  bool is_quoted = false;
  CsvPlace at = here_;
  const std::string_view line = trim(rest_.substr(0, rest_.find_first_of("\r\n")));
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted && c == ',') return;
    const bool is_first = !first && (c == ';' || c == '\t');
    if (!is_quoted && is_first) {
      first = at;
      separator = c;
    }
    if (!is_utf8_continuation(c)) ++at.column;
  }
  if (!first) return;
  const std::string_view below = trim(rest_.substr(rest_.find(line) + line.size()));
  const std::string_view next = below.substr(0, below.find_first_of("\r\n"));
  const auto has = [next](char c) { return next.find(c) != std::string_view::npos; };
  if (has(',') && !has(separator)) return;
  problem_ = {*first,
              fmt::format("cells are separated by {}; commas are needed between cells, and decimal "
                          "points in numbers",
                          separator == ';' ? "semicolons" : "tabs"),
              true};
}

// Up to the comma or line end after it.
CsvCell CsvReader::read_cell() {
  while (is_at_blank()) take();
  CsvCell cell;
  cell.place = here_;
  const bool is_quoted = is_at('"');
  if (is_quoted) cell.text = read_quoted();
  const std::string_view begin = rest_;
  for (; !is_at_line_end() && !is_at(',') && !problem_; take()) {
    if (is_at('"') || (is_quoted && !is_at_blank())) {
      problem_ = {
          is_quoted ? cell.place : here_,
          "misplaced quote; enclose the whole cell in quotes and write a quote in it twice"};
    }
  }
  cell.text += begin.substr(0, begin.size() - rest_.size());
  cell.text = std::string(trim(cell.text));
  return cell;
}

std::string CsvReader::read_quoted() {
  const CsvPlace opened = here_;
  std::string text;
  for (take(); !rest_.empty(); take()) {
    if (rest_.starts_with("\"\"")) {
      take();
    } else if (is_at('"')) {
      take();
      return text;
    }
    text += is_at_line_end() ? ' ' : rest_.front();
  }
  problem_ = {opened, "a quote is not closed"};
  return text;
}

bool report_csv_problem(const CsvReader& table, const std::string& name, Diagnostics& diagnostics) {
  if (!table.problem()) return false;
  const auto& [place, what, is_of_separator] = *table.problem();
  const SourceLocation where{name, place.line, place.column};
  if (is_of_separator) {
    diagnostics.report(DiagnosticId::csv_separator, where, what);
  } else {
    diagnostics.report(DiagnosticId::csv_quotes, where, what);
  }
  return true;
}

std::string decimal_comma_hint(std::string_view text) {
  std::string with_point(text);
  const std::size_t comma = with_point.find(',');
  if (comma == std::string::npos) return "";
  with_point[comma] = '.';
  return parse_number(with_point) ? "; write it with a decimal point" : "";
}

LengthColumn length_column(std::string_view written) {
  const std::size_t bar = written.rfind('_');
  if (bar == std::string_view::npos || bar == 0) return {written, std::nullopt};
  for (const LengthUnit& unit : kLengthUnits) {
    if (written.substr(bar + 1) == unit.name) return {written.substr(0, bar), unit.metres};
  }
  return {written, std::nullopt};
}

CsvColumns::CsvColumns(const CsvRecord& header, std::span<const std::string_view> names,
                       PlainName plain_name)
    : at_(names.size(), kAbsent), width_(header.cells.size()) {
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string& written = header.cells[i].text;
    const std::string_view name = plain_name == nullptr ? written : plain_name(written);
    const auto known = std::find(names.begin(), names.end(), name);
    if (known == names.end()) {
      unknown_.push_back(written);
      continue;
    }
    std::size_t& at = at_[static_cast<std::size_t>(known - names.begin())];
    if (at == kAbsent) {
      at = i;
    } else if (doubled_.empty()) {
      doubled_ = written;
    }
  }
}

const std::string& CsvColumns::cell(const CsvRecord& record, std::size_t name) const {
  static const std::string kNone;
  return has(name) ? record.cells[at_[name]].text : kNone;
}

}  // namespace calc
