#pragma once
// Decodes the three luminous dimensions of an LM-63 file: their signs encode shapes.

#include "calc/photometry/read/ies_header.h"
#include "calc/photometry/web.h"

namespace calc {

struct Lm63Opening {
  LuminousOpening opening;
  // Words for a shape that is not in the code tables; `opening` then keeps its bounding size as a
  // box. Empty: the shape is in the tables.
  std::string simplified_from;
};

// Returns whether a luminous height is so small, up to a tenth of the longer side, that the opening
// is used as flat. Far away nothing changes; nearby a thin box differs from a flat opening by less
// than the accuracy of luminaire placement.
bool is_flat_enough(double length_m, double width_m, double height_m);

// Decodes dimensions as written, already in metres: width across (C90), length along (C0), height.
// The tables of 1986/1991, 1995 and 2002/2019 differ and are mixed in practice: signs decide, the
// version only where the same signs have different meanings.
Lm63Opening decode_opening(double width_m, double length_m, double height_m, Lm63Version version);

}  // namespace calc
