#pragma once
// Reads points with normals from a CSV file, e.g. the places of a site measurement.

#include "calc/base/diagnostics.h"
#include "calc/scene/project.h"

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Reads a table with the first line "x_m,y_m,z_m,nx,ny,nz", with another unit of units.h in all
// three, or "x,y,z,..." (metres); then six numbers per line (csv.h); empty lines are skipped.
// Normals are made unit vectors. name: path used in messages and in PointList::file. Empty if and
// only if an error was reported.
std::optional<PointList> parse_point_list(std::string_view bytes, const std::string& name,
                                          Diagnostics& diagnostics);

}  // namespace calc
