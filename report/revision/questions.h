#pragma once
// Compares requirements with earlier ones, because a gate can also be passed by weaker
// requirements.

#include "report/document/revision.h"
#include "report/revision/matching.h"

#include <vector>

namespace report {

// Compares settings of the whole run: confidence and accuracy.
std::vector<ChangedQuestion> compare_settings(const Provenance& before, const Provenance& after);

// Compare two parts as a whole, but not their contents: rooms, planes and requirements are compared
// separately. Both must exist. place: of the part.
std::vector<ChangedQuestion> compare_project_question(const ProjectPart& before,
                                                      const ProjectPart& after,
                                                      const RevisionPlace& place);
std::vector<ChangedQuestion> compare_room_question(const SpacePart& before, const SpacePart& after,
                                                   const RevisionPlace& place);
// Compares two planes. is_only_finer: is_finer_grid(), and the light of the room is the same
// (SpacePart::scene_sha256): then points that the grid omits are inside earlier obstacles.
std::vector<ChangedQuestion> compare_plane_question(const PlanePart& before, const PlanePart& after,
                                                    bool is_only_finer, const RevisionPlace& place);
std::vector<ChangedQuestion> compare_requirement(const rules::Requirement& before,
                                                 const rules::Requirement& after,
                                                 const RevisionPlace& place);
std::vector<ChangedQuestion> compare_aggregate(const rules::AggregateFinding& before,
                                               const rules::AggregateFinding& after,
                                               const RevisionPlace& place);

// Returns whether two planes have the same place and outline.
bool is_same_area(const PlanePart& before, const PlanePart& after);

// Returns whether the same area has more cells now, not fewer along either side, points with the
// same direction, and at least one point in each cell that had one.
bool is_finer_grid(const PlanePart& before, const PlanePart& after);

// The light sources of a room before and now, each from its project.
struct RoomPair {
  const ProjectPart& project_before;
  const SpacePart& before;
  const ProjectPart& project_after;
  const SpacePart& after;
};

// Returns the ratio of maintenance factors now to before: the smallest reduction of all luminaires
// in the room, by name, photometry and place. 1 if any has the same factor, or no earlier one.
double share_of_maintenance(const RoomPair& room);

}  // namespace report
