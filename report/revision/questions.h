#pragma once
// What is asked now, beside what was asked before: a gate can also be passed by asking for less.

#include "report/document/revision.h"
#include "report/revision/matching.h"

#include <vector>

namespace report {

// Of the whole run: confidence and accuracy.
std::vector<ChangedQuestion> compare_settings(const Provenance& before, const Provenance& after);

// Each from the whole of the two parts, but for what is in them: rooms, planes and requirements are
// compared by themselves. Both must be there. place: of the part.
std::vector<ChangedQuestion> compare_project_question(const ProjectPart& before,
                                                      const ProjectPart& after,
                                                      const RevisionPlace& place);
std::vector<ChangedQuestion> compare_room_question(const SpacePart& before, const SpacePart& after,
                                                   const RevisionPlace& place);
// is_only_finer: is_finer_grid(), and the light of the room is the same (SpacePart::scene_sha256):
// then what the grid leaves out lies in what was in the way before.
std::vector<ChangedQuestion> compare_plane_question(const PlanePart& before, const PlanePart& after,
                                                    bool is_only_finer, const RevisionPlace& place);
std::vector<ChangedQuestion> compare_requirement(const rules::Requirement& before,
                                                 const rules::Requirement& after,
                                                 const RevisionPlace& place);
std::vector<ChangedQuestion> compare_aggregate(const rules::AggregateFinding& before,
                                               const rules::AggregateFinding& after,
                                               const RevisionPlace& place);

// Whether two planes have one place and outline.
bool is_same_area(const PlanePart& before, const PlanePart& after);

// Whether the one area has more cells now, not fewer along either of its sides, points that face as
// they did, and one at least in each cell that had one.
bool is_finer_grid(const PlanePart& before, const PlanePart& after);

// What lights a room before and now, of one project each.
struct RoomPair {
  const ProjectPart& project_before;
  const SpacePart& before;
  const ProjectPart& project_after;
  const SpacePart& after;
};

// Maintenance factors now beside those before: the least change of all luminaires that hang in the
// room, by name, photometry and place. 1 where one is as it was, or nothing was before it.
double share_of_maintenance(const RoomPair& room);

}  // namespace report
