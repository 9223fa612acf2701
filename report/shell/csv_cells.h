#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// The trimmed parts between commas; a part in quotes may hold some. [RFC 4180, one line]
std::vector<std::string> csv_cells(std::string_view line);

}  // namespace cli
