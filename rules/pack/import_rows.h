#pragma once
// Turns rows of a user's table (a CSV file) into a complete private rule pack.

#include "calc/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace rules {

struct ImportedPack {
  std::string text;
  int rows = 0;
  int floor_rows = 0;    // of them, about a task on the floor
  int upright_rows = 0;  // of them, about an upright one
  int left_out = 0;      // beside them
};

// Returns the text of a pack like `like_xml` (the text of a pack for indoor work places) with the
// id `pack_id` and the table's rows in place of its own. The table's first line names its columns,
// see import_columns.h. An empty number means that the row does not specify the value; for Em it
// needs a reason in the notes. Rows without a ref, or dropped in the final edition, are omitted
// with a warning; unusual values are warned of, too. Empty exactly if an error was reported.
std::optional<ImportedPack> import_rows(std::string_view csv, const std::string& csv_file,
                                        std::string_view like_xml, const std::string& pack_id,
                                        calc::Diagnostics& diagnostics);

}  // namespace rules
