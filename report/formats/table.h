#pragma once
// A table of a document, project by project: what CSV and spreadsheets have in common. Columns and
// what stands in them are said here once.

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

// Not finite: as if it were not there, since no table can hold it.
struct TableNumber {
  double value = 0.0;
  int decimals = kOfColumn;  // shown in a spreadsheet
  bool is_percent = false;   // shown so in a spreadsheet: 0.025 as +2.5%
};

// Nothing, a text as it came (whoever writes it makes it safe), a number or a count.
using TableCell = std::variant<std::monostate, std::string, TableNumber, std::int64_t>;

// In the order of the columns, as many as these; valid during the call.
using VisitRow = std::function<void(std::span<const TableCell>)>;

struct DocumentTable {
  std::span<const TableColumn> columns;  // new ones of CSV come at the end
  void (*rows)(const ProjectPart& project, const VisitRow& visit);
};

// One row per requirement, and one (no requirement, verdict "not judged") per project that could
// not be judged, so that nothing unchecked is missed; then rows whose verdict is "in part", "left
// out", "warning" or "strict warning": what must be read with the others.
const DocumentTable& results_table();
// The same rows with their words in the reader's language; what are names in data (verdict,
// quantity, scene, state, severity ...) stays so. In English it is the table.
void results_in(const Texts& t, const ProjectPart& project, const VisitRow& visit);
// Rows of the same table for errors of no single project, whose verdict is "error".
void results_of_errors(const Texts& t, const DocumentEnd& end, const VisitRow& visit);
// The row of the same table for what is said once of numbers of one public source; none without.
void result_of_one_source(const DocumentEnd& end, const VisitRow& visit);
// Rows of the same table for what a revision made worse, or asks less; document: with a revision.
void results_of_revision(const Texts& t, const Document& document, const VisitRow& visit);
// What stands for a notice beside verdicts: "note", "in part", ...
const char* notice_kind_words(const Texts& t, NoticeKind kind);

// One row per calculation point of every computed plane.
const DocumentTable& points_table();

// One row per luminaire: project, space, its number in the space, id, type, maker and
// article of its photometry file or lamp package, group, position of the centre of its opening
// (world, m), height above the floor (m; none in the open), tilt, heading and turn (degrees, see
// LuminaireAim), flux (lm, new), power (W), maintenance factor, and of its type the letter in the
// schedule, the product's name, efficacy (lm/W), colour temperature and Ra; at the end the mark in
// all plans and documents. What is not stated or not known is not there.
const DocumentTable& luminaires_table();

// Place of a column by its name, or else std::logic_error.
std::size_t column_of(std::span<const TableColumn> columns, std::string_view name);

}  // namespace report
