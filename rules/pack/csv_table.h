#pragma once
// Comma-separated values with quotes (RFC 4180): a header line and records.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

struct CsvRecord {
  int line = 0;  // where it begins, from 1
  std::vector<std::string> fields;
};

// Empty lines are passed over; "" in a quoted field is a quote, and line ends in it are kept as
// blanks. Empty if a quote is never closed.
std::optional<std::vector<CsvRecord>> read_csv(std::string_view text);

}  // namespace rules
