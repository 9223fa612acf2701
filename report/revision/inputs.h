#pragma once
// Changes of the input that change no requirement: luminaires, photometry, materials, bodies.

#include "report/document/revision.h"
#include "report/revision/matching.h"

#include <vector>

namespace report {

// Returns the changes. place: of the project, or of the room.
std::vector<ChangedInput> compare_inputs(const ProjectPart& before, const ProjectPart& after,
                                         const RevisionPlace& place);
std::vector<ChangedInput> compare_inputs(const SpacePart& before, const SpacePart& after,
                                         const RevisionPlace& place);

}  // namespace report
