#pragma once
// The columns of a table that `luxgate rules import` reads: what they are called, what they mean.

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

// Their names, as calc::CsvColumns takes them.
const std::array<std::string_view, kImportColumnCount>& import_column_names();

// Letters and digits alone, small, with neither macrons nor the unit lx at the end: "Em, required
// (lx)" is "emrequired".
std::string plain_column_name(std::string_view written);

// The name that a written one stands for; itself if it is of no column.
std::string_view import_column_name(std::string_view written);

// "; did you mean 'Uo'?", or "".
std::string import_column_suggestion(std::string_view written);

// A table with a row about a floor and one about a desk.
std::string import_template();

// For the help: a column a paragraph.
std::string import_columns_help();

}  // namespace rules
