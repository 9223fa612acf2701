#pragma once
// A workbook for people who continue with the numbers: rooms first, then the tables of CSV
// (table.h) in the reader's language, with names beside ids. Columns for programs, with their CSV
// names, are on the right and are not printed. Numbers are numbers, with enough digits that none
// contradicts its verdict; no cell is a formula. The same document gives the same bytes.

#include "report/document/document.h"
#include "report/formats/xlsx_workbook.h"
#include "report/html/page/print_pages.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <cstddef>
#include <memory>

namespace report {

// Writes the sheets Overview; Projects, if there are several; Requirements, Luminaires (a schedule
// of their types), Positions, Points, Notes; Revision with a baseline; About. most_rows: of one
// sheet; the table continues in another sheet, which About says.
std::unique_ptr<FormatWriter> xlsx_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const Texts& t = {}, Paper paper = Paper::a4,
                                          std::size_t most_rows = kMostSheetRows);

}  // namespace report
