#include "calc/photometry/read/lm63_numbers.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/text_encoding.h"

#include <fmt/format.h>

#include <cmath>

namespace calc {

Lm63Numbers::Lm63Numbers(std::string_view text, int last_line, const std::string& name,
                         Diagnostics& diagnostics)
    : numbers_(text, last_line), name_(name), diagnostics_(diagnostics), line_(last_line) {}

bool Lm63Numbers::read(std::string_view field, double& value) {
  const std::optional<NumberStream::Token> token = numbers_.next();
  if (!token) {
    diagnostics_.report(DiagnosticId::photometry_end, at(numbers_.line()), field);
    return false;
  }
  line_ = token->line;
  const std::optional<double> number = parse_photometry_number(token->text);
  if (!number) {
    diagnostics_.report(DiagnosticId::photometry_number, here(), field, quotable(token->text));
    return false;
  }
  value = *number;
  return true;
}

bool Lm63Numbers::read_whole(std::string_view field, int lowest, int highest, int& value) {
  double found = 0.0;
  if (!read(field, found)) return false;
  if (found != std::floor(found) || found < lowest || found > highest) {
    return refuse(field, found, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  value = static_cast<int>(found);
  return true;
}

bool Lm63Numbers::check_present(std::string_view what, std::size_t count) {
  const std::size_t present = numbers_.count_remaining();
  if (count <= present) return true;
  diagnostics_.report(DiagnosticId::photometry_count, here(), what, count, present);
  return false;
}

bool Lm63Numbers::refuse(std::string_view field, double value, std::string_view allowed) {
  diagnostics_.report(DiagnosticId::photometry_value, here(), field, fmt::format("{}", value),
                      allowed);
  return false;
}

}  // namespace calc
