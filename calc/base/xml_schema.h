#pragma once
// Writes the XML schema (XSD 1.0) of a file format from its table.

#include "calc/base/element_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct SchemaText {
  std::string_view maker;    // what writes the file, for a comment at its beginning
  std::string_view meaning;  // of the file as a whole
  ChildRow root;
  // Rows that replace those of the same type in the table: additions of another module.
  std::vector<ElementRow> instead{};

  const ElementRow& row_for(const ElementRow& row) const {
    for (const ElementRow& other : instead) {
      if (other.type == row.type) return other;
    }
    return row;
  }
};

std::string xml_schema(const SchemaText& text);

}  // namespace calc
