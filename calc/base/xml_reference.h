#pragma once
// The reference of a file format for people, in Markdown, written from its table as the schema is.

#include "calc/base/xml_schema.h"

#include <string>
#include <string_view>

namespace calc {

// title: of the page. A section for each type of element, from the root on in the order in which
// elements are named: what it means, where it stands, what it holds, and its attributes with what
// they may be.
std::string xml_reference(std::string_view title, const SchemaText& text);

}  // namespace calc
