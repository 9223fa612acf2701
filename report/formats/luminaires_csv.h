#pragma once
// Where luminaires are, as a table for fitters and spreadsheets.

#include "report/document/document.h"
#include "report/stream/format_writer.h"

#include <memory>
#include <string>

namespace report {

// One row per luminaire: project, space, its number in the plans of the space, id, type, maker and
// article of its photometry file, group, position of the centre of its opening (world, m), height
// above the floor (m; empty in the open), tilt, heading and turn (degrees, see LuminaireAim), flux
// (lm, new), power (W) and maintenance factor. RFC 4180, as results.csv. Empty: not stated, or not
// known.
std::string render_luminaires_csv(const Document& document);
std::unique_ptr<FormatWriter> luminaires_csv_writer(const DocumentFrame& frame,
                                                    const SpillPlace& place);

}  // namespace report
