#pragma once
// Writes the reference of a file format for people, in Markdown, from the table of its schema.

#include "calc/base/xml_schema.h"

#include <string>
#include <string_view>

namespace calc {

// Returns a page under this title. Each type of element has a section, from the root on in the
// order in which elements are named: its meaning, parents and content, and its attributes with
// their values.
std::string xml_reference(std::string_view title, const SchemaText& text);

}  // namespace calc
