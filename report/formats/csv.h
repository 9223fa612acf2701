#pragma once
// Tidy tables for spreadsheets and scripts. RFC 4180: CRLF line ends, fields quoted where needed;
// UTF-8; numbers with '.' in the shortest form that reads back to the same bits; an empty field
// means "none". The first line has the names of the columns; table.h says what is in the rows.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>

namespace report {

// Writes results_table(), and the losses of a revision.
std::unique_ptr<FormatWriter> results_csv_writer(const DocumentFrame& frame,
                                                 const SpillPlace& place);

// Writes points_table().
std::unique_ptr<FormatWriter> points_csv_writer(const DocumentFrame& frame,
                                                const SpillPlace& place);

// Writes luminaires_table().
std::unique_ptr<FormatWriter> luminaires_csv_writer(const DocumentFrame& frame,
                                                    const SpillPlace& place);

}  // namespace report
