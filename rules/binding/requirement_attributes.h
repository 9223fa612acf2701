#pragma once
// The grammar of <require> in one table: each attribute with its form, its possible values and a
// sentence about it. The reader and the project's schema are made from it. Rules between attributes
// are in requirement_reader.cpp.

#include "calc/base/element_table.h"
#include "calc/base/xml_reader.h"

#include <optional>
#include <string_view>
#include <vector>

namespace rules {

enum class AttributeForm {
  own,     // of a limit of its own
  row,     // of a row of a rule pack
  either,  // of both
  waiver,  // beside a limit of its own
};

enum class AttributeKind { id, text, empty_text, words, number, point, date };

struct RequirementAttribute {
  std::string_view name;
  AttributeForm form;
  AttributeKind kind;
  const calc::ValueType* type;  // with words or a range, as the kind says
  std::string_view meaning;
  std::optional<calc::Presence> of_workplace{};  // <workplace> has it, too
};

// Returns the attributes in the order in which messages and the schema name them.
const std::vector<RequirementAttribute>& requirement_attributes();
// Returns the attribute of this name; throws std::logic_error if there is none.
const RequirementAttribute& requirement_attribute(std::string_view name);

// Return the rows for the tables of the project file, which do not know rules.
const calc::ElementRow& require_element();
const calc::ElementRow& workplace_element();
const calc::ElementRow& workplace_grid_element();

// The words for the value of `at`.
inline constexpr std::string_view kPointWords = "3 numbers (x y z) in metres, in world coordinates";

// Reports a value that is wrong whatever the other attributes are: an unknown word, a number out of
// range. For attributes left unread because another one was wrong; an absent one is not reported.
void check_value(calc::ElementReader& reader, std::string_view name);

}  // namespace rules
