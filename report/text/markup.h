#pragma once
// Makes text safe inside HTML, SVG and Markdown.

#include <string>
#include <string_view>

namespace report {

// Returns text that is safe as element text and inside a quoted attribute: valid UTF-8, no control
// characters.
std::string escape_html(std::string_view text);

// Returns plain text for a cell of a table: nothing in it is markup, a link or a mention.
std::string escape_markdown(std::string_view text);

}  // namespace report
