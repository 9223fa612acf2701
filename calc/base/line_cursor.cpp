#include "calc/base/line_cursor.h"

#include "calc/base/text.h"

#include <algorithm>

namespace calc {

std::optional<std::string_view> LineCursor::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end);
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
  ++line_;
  return line;
}

std::size_t LineCursor::count_remaining() const {
  LineCursor ahead(rest_);
  std::size_t seen = 0;
  std::size_t last_with_text = 0;
  while (const std::optional<std::string_view> line = ahead.next()) {
    ++seen;
    if (!trim(*line).empty()) last_with_text = seen;
  }
  return last_with_text;
}

}  // namespace calc
