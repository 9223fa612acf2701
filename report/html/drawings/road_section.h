#pragma once
// A street as a cross-section to a scale of drawings, seen along it, with a plan of its lanes and
// luminaires below.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A figure for paper, where its scale holds: at most 180 mm wide, words of 7 points. name: of the
// street, escaped. A sentence where widths or heights are not known or beyond all roads.
std::string road_section(const Texts& t, const RoadPart& road, const std::string& name);

}  // namespace report
