#include "report/text/csv_field.h"

#include "report/text/plain_text.h"

namespace report {
namespace {

// Whether a spreadsheet would calculate it. "-1 UG" is the name of a floor: what begins with a sign
// does harm only where it calls something.
bool is_formula(std::string_view text) {
  if (text.empty()) return false;
  if (text.front() == '=' || text.front() == '@') return true;
  const bool has_sign = text.front() == '+' || text.front() == '-';
  return has_sign && text.find_first_of("(|!@=") != std::string_view::npos;
}

}  // namespace

std::string csv_field(std::string_view text) {
  std::string safe = printable(text);
  if (is_formula(safe)) safe.insert(safe.begin(), '\'');
  if (safe.find_first_of(",\"") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace report
