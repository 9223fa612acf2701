#pragma once
// Text inside HTML and SVG.

#include <string>
#include <string_view>

namespace report {

// Safe as element text and inside a quoted attribute; valid UTF-8, no control characters.
std::string escape_html(std::string_view text);

}  // namespace report
