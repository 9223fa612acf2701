#pragma once
// Words for aggregates and classes of rule packs, and for sums over the rooms of a building, shared
// by every format: in the language of the Texts, English for data formats. Not escaped.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns "aggregate glare", "class P", or "power density" for a building.
std::string aggregate_title(const Texts& t, const rules::AggregateFinding& finding);
// Returns "any of 2 checks", "at least 90 % of the area of 5 rooms"; for classes the required one,
// "P2"; for sums "≤ 6.5 W/m²".
std::string aggregate_required(const Texts& t, const rules::AggregateFinding& finding);
// Returns "1 of 2 met", "93.1 % of the area, 1 of 2 met"; for classes "P3 reached, P2 possible",
// "none reached"; for sums "5.93 W/m² (14 rooms, 208.4 m²)".
std::string aggregate_measured(const Texts& t, const rules::AggregateFinding& finding);
// Returns "Office / Desk 1", the room, the building or the project.
std::string aggregate_place(const ProjectPart& project, const rules::AggregateFinding& finding);
// Return our own remark on it, "" = none; and the text to be read with it beside the reason,
// including the note of its rule pack.
const char* aggregate_remark(const Texts& t, const rules::AggregateFinding& finding);
std::string aggregate_note(const Texts& t, const rules::AggregateFinding& finding);

}  // namespace report
