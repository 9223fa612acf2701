#pragma once
// Writes the illuminance of a plane as an OpenEXR picture (only exr.cpp includes OpenEXR).

#include "report/document/document.h"
#include "report/images/heatmap.h"

#include <string>
#include <vector>

namespace report {

// Returns a picture with one pixel per cell; the top row has the largest v. 32-bit float channels:
// illuminance_lx, low_lx and high_lx (its interval), direct_lx, indirect_lx, and valid: 1 where
// there is a point, else 0 with every other channel 0 (a NaN would break viewers and filters).
// String attributes luxgate.project (path), luxgate.space, luxgate.plane (id), luxgate.quantity
// ("planar", "cylindrical", ...), luxgate.unit and luxgate.version. The channels keep their names
// if the unit is "", for ratings and ratios. Values are rounded to float. Needs has_cells(). Same
// input, same bytes. Throws std::runtime_error when the library refuses.
std::string render_exr(const Provenance& provenance, const ProjectPart& project,
                       const SpacePart& space, const PlanePart& plane);

// Returns a picture of a room: channels illuminance_lx and valid as above, width * height values
// from the top row on, below 0 = nothing there. title: "seen from above a corner", in
// luxgate.picture.
std::string render_room_exr(const std::string& project_path, const std::string& space_id,
                            const std::string& title, int width, int height,
                            const std::vector<float>& lx);

// Returns a picture of a room in colours: R, G, B (linear light, of sRGB's primaries, multiplied by
// A) and A.
std::string render_colour_exr(const std::string& project_path, const std::string& space_id,
                              const std::string& title, const Raster& raster);

}  // namespace report
