#pragma once
// Writes PNG bytes (only png.cpp includes libpng).

#include "report/images/heatmap.h"

#include <string>

namespace report {

// Returns an RGBA picture as a PNG file in memory; same raster, same bytes. Throws
// std::runtime_error when libpng refuses (an empty raster, no memory).
std::string encode_png(const Raster& raster);

// Returns the heat map of a plane, about 1024 pixels on its longer side, cells without a point
// white, with its legend below: a raster for slides and page layouts; limits and lines are in the
// HTML report and the SVG file. Needs has_cells(). title: of the plane; note: of the scale.
std::string render_heatmap_png(const PlanePart& plane, const ColourScale& scale,
                               const std::string& title = {}, const std::string& note = {});

}  // namespace report
