#pragma once
// Where the luminaires of the plans are, as a fitter reads it: mark, place, height, aim.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Of all projects of a document together: more of them make pages that nobody reads.
inline constexpr std::size_t kMostClientPositions = 200;

struct ClientPositions {
  std::string html;        // "" = no luminaires
  std::size_t listed = 0;  // luminaires
};

// A table with several luminaires side by side, by rooms; by storeys where rooms have so few
// luminaires that their names would take more lines than these. most: luminaires to list; the
// caption says how many are omitted. is_part: options chose a part of the project.
ClientPositions client_positions(const Texts& t, const ProjectPart& project, bool is_part,
                                 std::size_t most = kMostClientPositions);

}  // namespace report
