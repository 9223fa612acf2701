#pragma once
// Tables of a document, project by project, shared by CSV and spreadsheets. Columns and their
// contents are defined only here.

#include "report/document/document.h"
#include "report/text/notices.h"
#include "report/text/texts.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace report {

inline constexpr int kOfColumn = -1;  // as the column has it

struct TableColumn {
  std::string_view name;     // in the first line of a CSV file
  std::string_view heading;  // in a spreadsheet, with its unit
  int width;                 // in a spreadsheet, characters
  int decimals = kOfColumn;  // shown in a spreadsheet; kOfColumn: as many as the number has
  bool is_in_csv = true;     // false: for people alone, says in words what other columns have
};

// A number for a cell; if it is not finite the cell is empty, because no table can hold it.
struct TableNumber {
  double value = 0.0;
  int decimals = kOfColumn;  // shown in a spreadsheet
  bool is_percent = false;   // shown so in a spreadsheet: 0.025 as +2.5%
};

// A cell: nothing, an unchanged text (the writer makes it safe), a number or a count.
using TableCell = std::variant<std::monostate, std::string, TableNumber, std::int64_t>;

// Receives a row with as many cells as columns, in their order; valid during the call.
using VisitRow = std::function<void(std::span<const TableCell>)>;

struct DocumentTable {
  std::span<const TableColumn> columns;  // new ones of CSV come at the end
  void (*rows)(const ProjectPart& project, const VisitRow& visit);
};

// Returns one row per requirement, and one (no requirement, verdict "not judged") per project that
// could not be judged, so that nothing unchecked is missed; then notices, whose verdict is "in
// part", "left out", "warning" or "strict warning".
const DocumentTable& results_table();
// Visits the same rows in the reader's language; data names (verdict, quantity, scene, state,
// severity ...) stay unchanged. In English it is the table.
void results_in(const Texts& t, const ProjectPart& project, const VisitRow& visit);
// Visits rows of the same table for errors of no single project, whose verdict is "error".
void results_of_errors(const Texts& t, const DocumentEnd& end, const VisitRow& visit);
// The row of the same table for what is said once of numbers of one public source; none without.
void result_of_one_source(const DocumentEnd& end, const VisitRow& visit);
// Rows of the same table for what a revision made worse, or asks less; document: with a revision.
void results_of_revision(const Texts& t, const Document& document, const VisitRow& visit);
// Returns the word for a notice in the verdict column: "note", "in part", ...
const char* notice_kind_words(const Texts& t, NoticeKind kind);

// Returns one row per calculation point of every computed plane.
const DocumentTable& points_table();

// Returns one row per luminaire: project, space, its number in the space, id, type, maker and
// article of its photometry file or lamp package, group, position of the centre of its opening
// (world, m), height above the floor (m; none in the open), tilt, heading and turn (degrees, see
// LuminaireAim), flux (lm, new), power (W), maintenance factor, and of its type the letter in the
// schedule, the product's name, efficacy (lm/W), colour temperature and Ra; at the end the mark in
// all plans and documents. Cells that are not stated or not known are empty.
const DocumentTable& luminaires_table();

// Returns the place of a column by its name; throws std::logic_error if there is none.
std::size_t column_of(std::span<const TableColumn> columns, std::string_view name);

}  // namespace report
