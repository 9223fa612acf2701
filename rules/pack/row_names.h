#pragma once
// What rows of the packs that come with the program are called, for reports that are made long
// after the pack was read.

#include <string>
#include <string_view>

namespace rules {

struct RowName {
  std::string title;    // of the pack with its edition: "EN 12464-1:2021"
  std::string name;     // use of the space: "office desk work"
  std::string name_de;  // the same for readers of the German edition; "" = none
};

// pack: with its edition, "en12464-1:2021". Null: no pack that comes with the program has the row.
// Valid for ever.
const RowName* builtin_row_name(std::string_view pack, std::string_view row);

}  // namespace rules
