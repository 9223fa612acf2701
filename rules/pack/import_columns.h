#pragma once
// The columns of a table that `luxgate rules import` reads: their names and meanings.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace rules {

enum ImportColumnIndex : std::size_t {
  kRefColumn,
  kNameColumn,
  kGroupColumn,
  kPlaneColumn,
  kEmColumn,
  kEmModifiedColumn,
  kUoColumn,
  kRaColumn,
  kRuglColumn,
  kEzColumn,
  kEwallColumn,
  kEceilingColumn,
  kTrustColumn,
  kConfirmedColumn,
  kStatusColumn,
  kNotesColumn,
  kSourcesColumn,
  kImportColumnCount
};

struct ImportColumn {
  std::string_view name;     // as the template has it
  std::string_view aliases;  // further plain names, separated by blanks
  std::string_view meaning;  // with what is allowed
  bool is_needed = false;
  std::array<std::string_view, 2> examples;  // of the template: a floor and a desk
};

const std::array<ImportColumn, kImportColumnCount>& import_columns();

// Returns the names of all columns, for calc::CsvColumns.
const std::array<std::string_view, kImportColumnCount>& import_column_names();

// Returns only letters and digits, in lower case, without macrons and a unit lx at the end:
// "emrequired" for "Em, required (lx)".
std::string plain_column_name(std::string_view written);

// Returns the column name for a written name; the written name itself if it is not a column.
std::string_view import_column_name(std::string_view written);

// Returns "; did you mean 'Uo'?", or "".
std::string import_column_suggestion(std::string_view written);

// Returns a table with one row about a floor and one about a desk.
std::string import_template();

// Returns the text for the help: a paragraph for each column.
std::string import_columns_help();

}  // namespace rules
