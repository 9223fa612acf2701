#pragma once
// One field of a CSV table.

#include <string>
#include <string_view>

namespace report {

// The text made safe to show (plain_text.h), in quotes where RFC 4180 wants them. What a
// spreadsheet would take for a formula has an apostrophe before it.
std::string csv_field(std::string_view text);

}  // namespace report
