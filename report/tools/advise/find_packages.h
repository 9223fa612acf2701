#pragma once
// Finds lamp packages of the project's luminaire types that are enough.

#include "report/tools/advise/advice.h"
#include "report/tools/advise/room_light.h"

namespace cli {

// Returns the combination of packages of least installed power with which every requirement judged
// from the light of points passes, at the current levels or, if necessary, others, and with which
// every requirement that passes now still passes. Light is linear in the flux, so no ray is traced
// for a combination; the first good ones are checked with other random numbers, and those that do
// not pass are dropped.
PackageAdvice find_packages(const RoomQuestions& questions, const AdviceSettings& settings);

}  // namespace cli
