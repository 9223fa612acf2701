#pragma once
// Shared parts of searches for luminaires in a room: possible places, the share of missing light
// that a change adds, and the check of the changed project.

#include "calc/scene/point_filter.h"
#include "report/check/room_changes.h"
#include "report/tools/advise/room_light.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Returns the share of the missing light (times `more`) that the gains add, on average over the
// requirements; each counts from `least` to 1.
double mended_share(const std::vector<AskedOfRoom>& asked, const std::vector<double>& gain_lx,
                    double more, double least = 0.0);

// Returns whether centre and corners of its opening are in the room's air.
bool has_room(const calc::Project& project, const calc::PointFilter& filter,
              const calc::Luminaire& luminaire);

// Returns the box of the room from floor to ceiling; the room has a shell.
calc::BoundingBox box_of(const calc::Space& room);

// Elements of the text that place several luminaires, and single luminaires to replace them.
// changed: by their numbers in the room, from 0; luminaires without a place are removed.
struct OneByOne {
  std::vector<calc::SourceLocation> elements;
  std::vector<check::AddedLuminaire> luminaires;
};
OneByOne one_by_one(const RoomQuestions& questions, const calc::Space& room,
                    const std::map<std::size_t, std::optional<AdvisedPlace>>& changed);

// Checks the project with another text and other random numbers; `added`, to 1e-6, must then be
// luminaires of the room. Puts findings of `asked`, passes of the scene and broken requirements
// into `result`, or the reason why there are none.
void check_in_room(const RoomQuestions& questions, std::size_t part_index, const std::string& scene,
                   const std::vector<AskedOfRoom>& asked, const check::ChangedText& changed,
                   const std::vector<check::AddedLuminaire>& added, CheckedPlaces& result);

}  // namespace cli
