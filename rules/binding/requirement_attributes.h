#pragma once
// The grammar of <require> in one table: its attributes, where each belongs, what each may hold
// whatever the others say, and a sentence about it. The reader and the project's schema are made
// from it. What attributes mean together is not here but in requirement_reader.cpp.

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

// In the order in which messages and the schema name them.
const std::vector<RequirementAttribute>& requirement_attributes();
// By a name that there is, or else std::logic_error.
const RequirementAttribute& requirement_attribute(std::string_view name);

// As the tables of the project file would have them, which know no rules.
const calc::ElementRow& require_element();
const calc::ElementRow& workplace_element();
const calc::ElementRow& workplace_grid_element();

// What `at` holds.
inline constexpr std::string_view kPointWords = "3 numbers (x y z) in metres, in world coordinates";

// Reports what no other attribute can make right: a word that is none, a number out of every range.
// For what is left unread because something that it hangs on was wrong. Nothing if it is not there.
void check_value(calc::ElementReader& reader, std::string_view name);

}  // namespace rules
