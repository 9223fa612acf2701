#pragma once
// One zone of a workplace: the area that a rule pack gives to a role in a room, with the project's
// changes.

#include "calc/base/message.h"
#include "calc/scene/project.h"
#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <optional>
#include <string>

namespace rules {

// All inputs of a zone. The room is a prism: space.shell is set.
struct ZoneSource {
  const RulePack& pack;
  const RuleRow& row;
  const calc::Workplace& workplace;
  const calc::Space& space;
};

struct ZonePlane {
  calc::PlanarArea area;  // with its grid
  calc::Message words;    // "band of 0.5 m around the task, 0.75 m above the floor, ..."
  calc::Message changed;  // by the project, in words; or ""
  std::optional<double> narrow_margin_m;  // as the room is narrow, in place of the rule's
  calc::Message not_made;                 // why there is no such zone in this room; "" = there is
  bool is_place_unknown = false;          // why: no source says where it would be
  calc::Message problem;                  // an error: why nothing is left of it; "" = none
  bool is_simple = true;                  // false: the problem is that the outline crosses itself
};

// Returns the plane of a zone. rule: of the pack, with an area; change: empty if the project
// changes nothing; wall: from 0, for walls only.
//
// The task is the given area, or the whole room without the margin along its walls. Bands surround
// the zone inside them and end at the room's walls, less the margin; the first band loses nothing
// where the task itself reaches into that margin. The cells of a band are at most as large as its
// width, so that it has points all round.
ZonePlane make_zone_plane(const ZoneSource& source, const RulePlane& rule,
                          const calc::ZoneText* change, std::optional<std::size_t> wall);

}  // namespace rules
