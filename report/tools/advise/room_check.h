#pragma once
// What searches for luminaires in a room have in common: which places are possible, what is mended,
// and whether the checked project agrees.

#include "calc/scene/point_filter.h"
#include "report/check/room_changes.h"
#include "report/tools/advise/room_light.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Of what lacks (times `more`), on average over the requirements; each counts from `least` to 1.
double mended_share(const std::vector<AskedOfRoom>& asked, const std::vector<double>& gain_lx,
                    double more, double least = 0.0);

// The centre and the corners of its opening lie in the room's air.
bool has_room(const calc::Project& project, const calc::PointFilter& filter,
              const calc::Luminaire& luminaire);

// Of the room from floor to ceiling; it has a shell.
calc::BoundingBox box_of(const calc::Space& room);

// Elements of the text that place several luminaires, and what takes their place: luminaires one by
// one. changed: by their numbers in the room, from 0; without a place they are gone.
struct OneByOne {
  std::vector<calc::SourceLocation> elements;
  std::vector<check::AddedLuminaire> luminaires;
};
OneByOne one_by_one(const RoomQuestions& questions, const calc::Space& room,
                    const std::map<std::size_t, std::optional<AdvisedPlace>>& changed);

// The project with another text, checked with other random numbers; `added`, to 1e-6, must be
// luminaires of the room then. Findings of `asked`, passes of the scene and what is broken go to
// `result`, or why there are none.
void check_in_room(const RoomQuestions& questions, std::size_t part_index, const std::string& scene,
                   const std::vector<AskedOfRoom>& asked, const check::ChangedText& changed,
                   const std::vector<check::AddedLuminaire>& added, CheckedPlaces& result);

}  // namespace cli
