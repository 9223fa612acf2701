#pragma once
// Reads the reference of `luxgate converge`.

#include "calc/base/diagnostics.h"
#include "calc/radiosity/looks/solve.h"
#include "report/tools/converge/converge_statistics.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Reads a table with a head line. Columns, in any order: lx; either plane, column and row as in
// points.csv of `check` or x, y and z in metres (the point must be within 1 mm); optionally plane
// beside x, y, z, and error_lx, the standard error, 0 or more. Lines beginning with # and other
// columns are ignored. Every point of every task needs exactly one line; further lines for other
// planes are allowed. Empty after errors.
std::optional<std::vector<report::ConvergeTruth>> read_reference(
    std::string_view text, const std::string& path, const std::vector<calc::PlaneTask>& tasks,
    calc::Diagnostics& diagnostics);

}  // namespace cli
