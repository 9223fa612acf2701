#pragma once
// The unified glare rating of a room by the tabular method, as EN 12464-1 requires.  [CIE 117; CIE
// 190; handbooks on how tables are read]
//
// The room and the height of its luminaires above seated eyes determine the room in a maker's
// table. The table's numbers are calculated here, from the photometry, as in ugr_table.h, without
// interpolation between its lines:
//   - X and Y are the room's sides in multiples of H, from 2 to 12, the range of tables;
//   - reflectances are the room's, of walls their mean by area, but no more than the brightest
//     column of tables has (0.7, 0.5, 0.2): so a light room is rated as its table would;
//   - the flux is the luminaires' own;
//   - eyes look along both sides of the room, both ways, from the middle of the wall behind
//     them, and the largest value counts.
//
// Luminaires of several types, heights or directions in one room: the sums of their arrays,
// weighted by their numbers, give the value. It cannot exceed the rating of the worst of these
// arrays on its own, which is the upper end.

#include "calc/base/field.h"
#include "calc/base/message.h"
#include "calc/scene/project.h"

#include <string>

namespace calc {

inline constexpr double kSeatedEye_m = 1.2;  // above the floor

struct RoomUgr {
  // Why there is no rating, in words: why_no_room_ugr(), or no light is reflected; "" = there is.
  Message problem;
  Estimate ugr;   // is_nothing() where no luminaire shines to where the eye has one in its field
  Message words;  // what it was calculated for
};

// Returns why the method does not apply to this room, in words; "" = it does. It is for rectangular
// rooms with a ceiling, and for luminaires in the room that hang level, above the eyes, with a
// luminous area of at most 1.5 m2 as eyes below see it, also of those that touch unless they form a
// line. Luminaires of one photometry and height must be in rows and columns spread evenly over the
// room: no gap between two, nor twice that to a wall, is more than half as wide again as with an
// exactly even spread. Only walls, luminaires and dimming count, not the objects in the room.
//
// scene: null, or one of the project's: the luminaires count with its levels.
Message why_no_room_ugr(const Project& project, const Space& space, const LightScene* scene);

RoomUgr room_ugr(const Project& project, const Space& space, const LightScene* scene);

}  // namespace calc
