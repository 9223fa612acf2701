#pragma once
// Text inside HTML, SVG and Markdown.

#include <string>
#include <string_view>

namespace report {

// Safe as element text and inside a quoted attribute; valid UTF-8, no control characters.
std::string escape_html(std::string_view text);

// As plain text in a cell of a table: nothing in it is markup, a link or a mention.
std::string escape_markdown(std::string_view text);

}  // namespace report
