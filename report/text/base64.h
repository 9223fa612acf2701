#pragma once
// Converts bytes to text and back.  [RFC 4648, section 4]

#include <optional>
#include <string>
#include <string_view>

namespace report {

std::string base64(std::string_view bytes);

// Returns the bytes of a text exactly as base64() writes it; otherwise empty.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace report
