#pragma once
// Turns a drawing into a building by a map: rooms from outlines, luminaires and furniture from
// blocks, planes and routes from polylines.

#include "report/tools/import/design.h"
#include "report/tools/import/dxf_drawing.h"
#include "report/tools/import/import_map.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Ends of lines at most this far apart are one corner.
inline constexpr double kSamePlace_m = 0.001;

// Returns the design; empty exactly if `problem` says why. Anything that the map names and the
// drawing lacks is a note (Kind::left_out).
std::optional<Design> design_of_dxf(const DxfDrawing& drawing, const std::string& file,
                                    const ImportMap& map, const std::string& unit_option,
                                    std::string& problem);

// Returns a map to start from: all layers and blocks with counts, sizes and attributes as comments.
// It can be read as it is, but users must fill in its blanks.
std::string suggest_map(const DxfDrawing& drawing, const std::string& file);

}  // namespace cli
