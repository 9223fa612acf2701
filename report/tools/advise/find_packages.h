#pragma once
// Which lamp packages of the project's luminaire types are enough.

#include "report/tools/advise/advice.h"
#include "report/tools/advise/room_light.h"

namespace cli {

// The combination of packages of least installed power with which every requirement that is judged
// from the light of points passes, with the levels of now or, where these are not enough, others,
// and with which nothing is lost that passes now. Light is linear in it, so that no ray is traced
// for a combination; the first good ones are checked with other random numbers, and what does not
// pass is none.
PackageAdvice find_packages(const RoomQuestions& questions, const AdviceSettings& settings);

}  // namespace cli
