#pragma once
// Converts XML files in any encoding that luxgate knows to UTF-8.

#include "calc/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns the whole file as valid UTF-8; a UTF-8 mark stays, a UTF-16 mark goes. Reads UTF-8 and
// UTF-16, with or without a mark, and, where declared, ISO-8859-1 and Windows-1252. Refuses other
// encodings, invalid bytes, and declarations that contradict the bytes. name: the path used in
// messages. Empty if and only if an error was reported.
std::optional<std::string> decoded_xml(std::string bytes, const std::string& name,
                                       Diagnostics& diagnostics);

// Returns whether it begins like XML (UTF-8 or UTF-16): blanks, then a tag, declaration or comment.
bool looks_like_xml(std::string_view bytes);

// Returns the name of the first element without its prefix; "" if `text`, the beginning of a file
// in UTF-8, holds none.
std::string first_element_name(std::string_view text);

// Returns whether the first element has this name, with any prefix. Comments of up to 100 kB may
// come before it.
bool has_first_element(std::string_view bytes, std::string_view name);

}  // namespace calc
