#pragma once
// Converts LM-63 tables of photometric types A and B to tables over full circles.

#include "calc/photometry/read/web_assembly.h"

#include <string>
#include <vector>

namespace calc {

enum class Lm63Type { c = 1, b = 2, a = 3 };

// The table in the file, all factors applied. Angles ascend within [-90, 90]; a list that starts at
// 0 includes its mirror image.
struct TypeAbTable {
  Lm63Type type = Lm63Type::b;
  std::vector<double> vertical_deg, horizontal_deg;
  std::vector<double> intensity_cd;  // [horizontal][vertical]
};

// Returns the table with directions as in LM-63-2002, 3 - horizontal angles run clockwise - in the
// frame of PhotometricWeb:
//   A: (cos V cos H, -cos V sin H, sin V)   planes of constant H about the vertical: H = -C,
//                                           V = gamma - 90
//   B: (cos H sin V, -sin H, -cos H cos V)  the same about the line of C90: TableAxis::lateral with
//                                           C = V, gamma = H + 90
// Both are C-gamma tables of that axis: nothing is resampled. Beyond the listed angles there is no
// light; the table falls to 0 within 1e-5 degrees there. A type B file with a single horizontal
// angle is a beam of equal light around straight down. problem: set, and the result useless, if the
// angles are not consistent (words for a message).
FileTable table_of_type_ab(const TypeAbTable& file, std::string& problem);

}  // namespace calc
