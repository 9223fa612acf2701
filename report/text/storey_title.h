#pragma once
// The title of a storey in plans and drawings.

#include "report/text/texts.h"

#include <string>

namespace report {

// Returns "Storey at +3.10 m", rounded to 5 cm, because floors of a storey differ by their
// coverings.
std::string storey_title(const Texts& t, double floor_z_m);

}  // namespace report
