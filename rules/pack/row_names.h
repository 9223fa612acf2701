#pragma once
// Names of rows of the packs that come with the program, for reports made long after the pack was
// read.

#include <string>
#include <string_view>

namespace rules {

struct RowName {
  std::string title;    // of the pack with its edition: "EN 12464-1:2021"
  std::string name;     // use of the space: "office desk work"
  std::string name_de;  // the same for readers of the German edition; "" = none
};

// Returns the name of a row. pack: with its edition, "en12464-1:2021". Null: no pack that comes
// with the program has the row. The pointer stays valid.
const RowName* builtin_row_name(std::string_view pack, std::string_view row);

}  // namespace rules
