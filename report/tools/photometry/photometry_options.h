#pragma once
// What can only be seen with all options of `luxgate photometry` together.

#include "report/cli/options.h"

#include <string>

namespace cli {

// "" = nothing is wrong.
std::string photometry_contradiction(const PhotometryOptions& photometry);

}  // namespace cli
