#pragma once
// Tidy tables for spreadsheets and scripts. RFC 4180: CRLF line ends, fields quoted where needed;
// UTF-8; numbers with '.' in the shortest form that reads back to the same bits; an empty field
// means "none".

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>
#include <string>

namespace report {

// One row per requirement, and one row (no requirement, verdict "not judged") per project that
// could not be judged, so that nothing unchecked is missed. Columns: see the first line.
std::string render_results_csv(const Document& document);
std::unique_ptr<FormatWriter> results_csv_writer(const DocumentFrame& frame,
                                                 const SpillPlace& place);

// One row per calculation point of every computed plane. Columns: see the first line.
std::string render_points_csv(const Document& document);
std::unique_ptr<FormatWriter> points_csv_writer(const DocumentFrame& frame,
                                                const SpillPlace& place);

}  // namespace report
