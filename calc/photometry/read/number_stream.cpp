#include "calc/photometry/read/number_stream.h"

#include "calc/base/text.h"

#include <algorithm>
#include <string>

namespace calc {
namespace {

constexpr std::string_view kDelimiters = " \t,\r\n\f\v";

}  // namespace

void NumberStream::skip_delimiters() {
  std::size_t i = 0;
  for (; i < rest_.size() && kDelimiters.find(rest_[i]) != std::string_view::npos; ++i) {
    const bool second_half_of_crlf = rest_[i] == '\n' && i > 0 && rest_[i - 1] == '\r';
    if ((rest_[i] == '\n' && !second_half_of_crlf) || rest_[i] == '\r') ++line_;
  }
  rest_.remove_prefix(i);
}

std::optional<NumberStream::Token> NumberStream::next() {
  const int line_before = line_;
  skip_delimiters();
  if (rest_.empty()) {
    line_ = line_before;
    return std::nullopt;
  }
  const std::size_t end = std::min(rest_.find_first_of(kDelimiters), rest_.size());
  const Token token{rest_.substr(0, end), line_};
  rest_.remove_prefix(end);
  return token;
}

std::size_t NumberStream::count_remaining() const {
  NumberStream ahead = *this;
  std::size_t count = 0;
  while (ahead.next()) ++count;
  return count;
}

std::optional<double> parse_photometry_number(std::string_view text) {
  if (const std::optional<double> value = parse_number(text)) return value;
  const std::size_t exponent = text.find_first_of("dD");
  if (exponent == std::string_view::npos || text.size() > 64) return std::nullopt;
  std::string with_e(text);
  with_e[exponent] = 'e';
  return parse_number(with_e);
}

}  // namespace calc
