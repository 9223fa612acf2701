#pragma once
// The results as a drawing for CAD programs: an ASCII DXF file of release 12 (AC1009), the one that
// all of them read, and that needs neither handles nor classes. It knows no unit: lengths are
// metres, as the legend says.

#include "report/document/document.h"
#include "report/html/drawings/shared_scale.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>

namespace report {

// Everything at its place in the project: rooms, furniture, luminaires as inserts of a block for
// each type, with attributes; planes with verdicts by colour and word, values, isolux lines; beside
// them a legend with the table of `text`, which has every verdict, warning and doubt. Of several
// projects each lies beside the one before it. sharing: as for HTML, on whose scale the levels of
// isolux lines depend.
std::unique_ptr<FormatWriter> dxf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, ScaleSharing sharing);

}  // namespace report
