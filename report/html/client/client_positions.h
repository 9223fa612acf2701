#pragma once
// The places of the luminaires in the plans, for fitters: mark, place, height, aim.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>

namespace report {

// Limit for all projects of a document together: a longer list would fill pages that nobody reads.
inline constexpr std::size_t kMostClientPositions = 200;

struct ClientPositions {
  std::string html;        // "" = no luminaires
  std::size_t listed = 0;  // luminaires
};

// Returns a table with several luminaires side by side, by rooms; by storeys if rooms have so few
// luminaires that their names would take more lines. most: luminaires to list; the caption says how
// many are omitted. is_part: options selected a part of the project.
ClientPositions client_positions(const Texts& t, const ProjectPart& project, bool is_part,
                                 std::size_t most = kMostClientPositions);

}  // namespace report
