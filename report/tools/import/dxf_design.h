#pragma once
// What a drawing says of a building, by a map: rooms from outlines, luminaires and furniture from
// blocks, planes and routes from polylines.

#include "report/tools/import/design.h"
#include "report/tools/import/dxf_drawing.h"
#include "report/tools/import/import_map.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Ends of lines this close are one corner.
inline constexpr double kSamePlace_m = 0.001;

// Empty if and only if `problem` says why. Whatever the map names and the drawing does not have is
// a note (Kind::left_out).
std::optional<Design> design_of_dxf(const DxfDrawing& drawing, const std::string& file,
                                    const ImportMap& map, const std::string& unit_option,
                                    std::string& problem);

// A map to start from: all layers and blocks with counts, sizes and attributes as comments. It is
// read as it is, but the blanks that it leaves are the user's to fill in.
std::string suggest_map(const DxfDrawing& drawing, const std::string& file);

}  // namespace cli
