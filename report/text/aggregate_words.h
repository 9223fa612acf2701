#pragma once
// Aggregates and classes of rule packs, and sums over the rooms of a building, in words that every
// format shares: in the language of the Texts, English for data formats. Not escaped.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// "aggregate glare", "class P", of a building "power density".
std::string aggregate_title(const Texts& t, const rules::AggregateFinding& finding);
// "any of 2 checks", "at least 90 % of the area of 5 rooms"; of classes what is asked for, "P2";
// of sums "≤ 6.5 W/m²".
std::string aggregate_required(const Texts& t, const rules::AggregateFinding& finding);
// "1 of 2 met", "93.1 % of the area, 1 of 2 met"; of classes "P3 reached, P2 possible", "none
// reached"; of sums "5.93 W/m² (14 rooms, 208.4 m²)".
std::string aggregate_measured(const Texts& t, const rules::AggregateFinding& finding);
// "Office / Desk 1", the room, the building or the project.
std::string aggregate_place(const ProjectPart& project, const rules::AggregateFinding& finding);
// Our own remark on it, "" = none; and what must be read with it beside the reason, together with
// the note of its rule pack.
const char* aggregate_remark(const Texts& t, const rules::AggregateFinding& finding);
std::string aggregate_note(const Texts& t, const rules::AggregateFinding& finding);

}  // namespace report
