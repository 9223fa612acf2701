#pragma once
// Finds things in foreign XML: by local names (namespace prefixes are ignored), past unknown
// elements, with numbers in the text of elements.

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

std::string_view local_name(std::string_view name);

// Returns the first child of one of these names, the earlier name first; null if there is none.
const XmlElement* child_of(const XmlElement& parent, std::initializer_list<std::string_view> names);
const XmlElement* child_of(const XmlElement& parent, std::string_view name);
// Returns the element at the end of a path of names; null if there is none.
const XmlElement* descend(const XmlElement& from, std::initializer_list<std::string_view> path);
std::vector<const XmlElement*> children_of(const XmlElement& parent, std::string_view name);

// Returns the text, trimmed and with single blanks inside; "" for a null element.
std::string text_of(const XmlElement* element);
// Returns the same of an attribute, found by its local name; "" if there is none.
std::string attribute_of(const XmlElement& element, std::string_view name);

// Returns the text as a finite number. Empty if the element is null, or its text is not a number,
// which is reported.
std::optional<double> number_in(const XmlElement* element, Diagnostics& diagnostics);
// Returns the value of a true/false element; empty if absent or anything else.
std::optional<bool> flag_in(const XmlElement* element);

// Returns the letters and digits, in lower case: "CIE _ C" and "CIE_C" are both "ciec".
std::string letters_of(std::string_view text);

}  // namespace calc
