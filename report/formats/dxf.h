#pragma once
// The results as a drawing for CAD programs: an ASCII DXF file of release 12 (AC1009), which all of
// them read, and which needs neither handles nor classes. $INSUNITS names the unit, which the
// release itself does not know; the legend names it, too.

#include "report/document/document.h"
#include "report/html/page/page_style.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>

namespace report {

// Writes everything at its place in the project: rooms, each with a block of its results;
// furniture; luminaires as inserts of a block for each type, with attributes; planes with verdicts
// by colour and word, values, isolux lines. Planes that are no task areas are on frozen layers.
// Beside the plan is a legend, and on a frozen layer the table of `text`, with every verdict,
// warning and doubt. Each project is beside the one before it; so are storeys, see dxf_storeys.h.
// style: the scale, which sets the height of all texts, the unit, and the sharing of colours, on
// which the levels of isolux lines depend.
std::unique_ptr<FormatWriter> dxf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, const PageStyle& style);

}  // namespace report
