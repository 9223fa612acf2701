#pragma once
// Rows from a table of the user's own (a CSV file) into a complete private rule pack.

#include "calc/base/diagnostics.h"

#include <optional>
#include <string>
#include <string_view>

namespace rules {

// The text of a pack like `like_xml` (the text of a pack for indoor work places) with the id
// `pack_id` and the rows of the table in place of its own. The table's first line names its
// columns; needed are final_ref, activity, Em_required_lx, Em_modified_lx, Uo_min, Ra_min,
// RUGL_max, Ez_m_lx, Em_wall_lx, Em_ceiling_lx, trust and confirmed_fields; final_ref_confidence,
// group, notes and sources are used if they are there, other columns are passed over. An empty
// number is a value that the row does not specify. trust: A is confirmed, A-part confirmed for the
// confirmed_fields and else a single source, B a single source, anything else unverified. Rows
// without final_ref, or dropped_in_final, are left out with a warning. Empty if and only if an
// error was reported.
std::optional<std::string> import_rows(std::string_view csv, const std::string& csv_file,
                                       std::string_view like_xml, const std::string& pack_id,
                                       calc::Diagnostics& diagnostics);

}  // namespace rules
