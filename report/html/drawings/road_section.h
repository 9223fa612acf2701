#pragma once
// A street as a cross-section at a drawing scale, seen along it, with a plan of its lanes and
// luminaires below.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a figure for paper, where its scale is valid: at most 180 mm wide, words of 7 points.
// name: of the street, escaped. Returns a sentence if widths or heights are not known or larger
// than those of any road.
std::string road_section(const Texts& t, const RoadPart& road, const std::string& name);

}  // namespace report
