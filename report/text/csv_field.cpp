#include "report/text/csv_field.h"

#include "report/text/plain_text.h"

namespace report {
namespace {

// Whether a spreadsheet would calculate what begins so. "-1 UG" is the name of a floor: what begins
// with a sign does harm only where it calls something.
bool is_formula(std::string_view text) {
  if (text.empty()) return false;
  if (text.front() == '=' || text.front() == '@') return true;
  const bool has_sign = text.front() == '+' || text.front() == '-';
  return has_sign && text.find_first_of("(|!@=") != std::string_view::npos;
}

// Of German and French spreadsheets a ';' begins a cell, too, whatever quotes stand around.
std::string without_formulas(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ';';
    if (begins && is_formula(text.substr(i))) safe += '\'';
    safe += text[i];
  }
  return safe;
}

}  // namespace

std::string csv_field(std::string_view text) {
  const std::string safe = without_formulas(printable(text));
  // A line that begins with "::" is an order to a CI runner.
  if (safe.find_first_of(",\"") == std::string::npos && !safe.starts_with(':')) return safe;
  std::string quoted = "\"";
  for (const char c : safe) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace report
