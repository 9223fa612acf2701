#pragma once
// What the three luminous dimensions of an LM-63 file mean: shapes are coded in their signs.

#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/web.h"

namespace calc {

struct Lm63Opening {
  LuminousOpening opening;
  // Not empty: words for a shape that is not in the code tables, of which `opening` keeps the
  // bounding size as a box.
  std::string simplified_from;
};

// Whether a luminous height is so small that the opening is used as flat: up to a tenth of the
// longer side. Far away nothing changes; nearby a thin box stands out from its ceiling by less than
// planners place luminaires.
bool is_flat_enough(double length_m, double width_m, double height_m);

// Dimensions as written, already in metres: width across (C90), length along (C0), height. The
// tables of 1986/1991, 1995 and 2002/2019 differ and are mixed in practice: signs decide, the
// version only where the same signs mean different things.
Lm63Opening decode_opening(double width_m, double length_m, double height_m, Lm63Version version);

}  // namespace calc
