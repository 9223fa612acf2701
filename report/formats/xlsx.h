#pragma once
// A workbook for people who go on working with the numbers: the tables of CSV (table.h) with their
// heads, units and colours, and a summary. English, as CSV. Numbers are numbers and show so many
// digits that none contradicts its verdict; no cell is a formula. The same document gives the same
// bytes.

#include "report/document/document.h"
#include "report/formats/xlsx_workbook.h"
#include "report/stream/format_writer.h"

#include <cstddef>
#include <memory>

namespace report {

// Sheets: Summary, Projects, Requirements, Points, Luminaires, Types, Warnings, and Revision with a
// baseline. most_rows: of one sheet; the table goes on in another one, which the summary says.
std::unique_ptr<FormatWriter> xlsx_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          std::size_t most_rows = kMostSheetRows);

}  // namespace report
