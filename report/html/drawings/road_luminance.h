#pragma once
// The luminances of a street for a driver: each point is a cell with its number.

#include "report/document/document.h"
#include "report/images/heatmap.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Returns the scale for all observers of a street, in cd/m2.
ColourScale road_luminance_scale(const calc::RoadLight& light);

// Returns an <svg>, 180 mm wide on paper; a field of many points in pieces below each other, so
// that numbers keep 6 points. observer: of road.light. words: name for screen readers, escaped.
std::string road_luminance(const Texts& t, const RoadPart& road, std::size_t observer,
                           const ColourScale& scale, const std::string& words);

}  // namespace report
