#pragma once
// Bytes as text.  [RFC 4648, section 4]

#include <optional>
#include <string>
#include <string_view>

namespace report {

std::string base64(std::string_view bytes);

// Of text that base64() may have written, to the letter; else empty.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace report
