#pragma once
// Writes one field of a CSV table.

#include <string>
#include <string_view>

namespace report {

// Returns the text made safe to show (plain_text.h), in quotes where RFC 4180 requires them. A text
// that a spreadsheet would read as a formula gets an apostrophe before it.
std::string csv_field(std::string_view text);

}  // namespace report
