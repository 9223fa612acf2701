#pragma once
// The document for clients: cover, contents, rooms in brief, plans, a page for each room, schedule,
// energy, maintenance, and how to read it. Details for checkers (grids, sampling, hashes, messages
// with element names, all values) are only in the full report.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>

namespace report {

// Writes one HTML file without script, made for paper. numbers: see html_writer().
std::unique_ptr<FormatWriter> client_writer(const DocumentFrame& frame, const SpillPlace& place,
                                            const Texts& t, const PageStyle& style,
                                            const PageNumbers* numbers = nullptr);

}  // namespace report
