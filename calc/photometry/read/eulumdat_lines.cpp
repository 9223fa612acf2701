#include "calc/photometry/read/eulumdat_lines.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/photometry/read/number_stream.h"
#include "calc/photometry/read/text_encoding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace calc {

bool EulumdatLines::refuse(std::string_view field, double value, std::string_view allowed) {
  diagnostics_.report(DiagnosticId::photometry_value, here(), field, fmt::format("{}", value),
                      allowed);
  return false;
}

std::optional<std::string_view> EulumdatLines::text_line(std::string_view field) {
  const std::optional<std::string_view> line = lines_.next();
  if (!line) diagnostics_.report(DiagnosticId::photometry_end, here(), field);
  return line;
}

bool EulumdatLines::skip(int count, std::string_view field) {
  for (int i = 0; i < count; ++i) {
    if (!text_line(field)) return false;
  }
  return true;
}

bool EulumdatLines::read_number(std::string_view field, double& value) {
  const std::optional<std::string_view> line = text_line(field);
  if (!line) return false;
  const std::vector<std::string_view> words = split_words(line->substr(0, 200));
  std::string word(words.empty() ? std::string_view() : words.front());
  if (word.find('.') == std::string::npos) std::replace(word.begin(), word.end(), ',', '.');
  const std::optional<double> found = parse_photometry_number(word);
  if (!found) {
    diagnostics_.report(DiagnosticId::photometry_number, here(), field, quotable(trim(*line)));
    return false;
  }
  if (words.size() > 1 && !warned_of_text_) {
    diagnostics_.report(DiagnosticId::photometry_text_after_number, here(), quotable(trim(*line)));
    warned_of_text_ = true;
  }
  value = *found;
  return true;
}

bool EulumdatLines::read_number_or_blank(std::string_view field, double& value) {
  LineCursor ahead = lines_;
  const std::optional<std::string_view> line = ahead.next();
  if (!line || !trim(*line).empty()) return read_number(field, value);
  lines_ = ahead;
  diagnostics_.report(DiagnosticId::photometry_blank, here(), field);
  value = 0.0;
  return true;
}

bool EulumdatLines::read_whole(std::string_view field, int lowest, int highest, int& value) {
  double found = 0.0;
  if (!read_number(field, found)) return false;
  if (found != std::floor(found) || found < lowest || found > highest) {
    return refuse(field, found, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  value = static_cast<int>(found);
  return true;
}

}  // namespace calc
