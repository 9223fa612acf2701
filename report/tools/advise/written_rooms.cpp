#include "report/tools/advise/written_rooms.h"

#include "report/advice/findings.h"
#include "report/advice/written_levels.h"
#include "report/check/room_changes.h"
#include "report/tools/advise/find_places.h"
#include "report/tools/advise/room_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>

namespace cli {
namespace {

double cost_of(const CheckedPlaces& places) {
  double sum = 0.0;
  for (const AdvisedPlace& place : places.places) sum += place.cost;
  return sum;
}

// What is done to a room in the text of the project; no change: another one does it.
struct RoomChange {
  std::string room;  // its id
  std::vector<RoomRequirement> requirements;
  std::function<check::ChangedText(const std::string& text)> change;
};

// Scenes that are not met now, and have levels.
std::vector<SceneAdvice> scenes_to_dim(const RoomQuestions& questions) {
  std::vector<SceneAdvice> scenes;
  for (const SceneAdvice& scene : questions.scenes) {
    if (scene.outcome == AdviceOutcome::levels &&
        std::any_of(scene.requirements.begin(), scene.requirements.end(),
                    [](const AdvisedRequirement& one) {
                      return one.before.verdict != rules::Verdict::pass;
                    })) {
      scenes.push_back(scene);
    }
  }
  return scenes;
}

// Of what lacks light in these rooms, in words; "" = all of it passes.
std::string not_mended(const std::vector<RoomChange>& changes, const report::ProjectPart& part) {
  for (const FindingPlace& where : counted_findings(part)) {
    const rules::Finding& finding = finding_at(part, where);
    if (finding.verdict == rules::Verdict::pass) continue;
    const auto is_it = [&](const RoomRequirement& one) {
      return one.before.requirement.plane_id == finding.requirement.plane_id &&
             one.before.requirement.id == finding.requirement.id;
    };
    for (const RoomChange& change : changes) {
      if (part.spaces[where.space].id != change.room) continue;
      if (std::any_of(change.requirements.begin(), change.requirements.end(), is_it)) {
        return fmt::format("{} ({})", finding_words(part, where), calc::name_of(finding.verdict));
      }
    }
  }
  return "";
}

// what: of WrittenAdvice.
RoomsText with_changes(const RoomQuestions& questions, const std::vector<RoomChange>& changes,
                       const char* what) {
  std::string text = questions.bytes;
  for (const RoomChange& one : changes) {
    if (!one.change) continue;  // the room is changed already
    check::ChangedText changed = one.change(text);
    if (!changed.text) return {std::nullopt, changed.problem};
    text = *std::move(changed.text);
  }
  const std::vector<SceneAdvice> scenes = scenes_to_dim(questions);
  LevelsText whole = with_levels(text, questions.file, scenes, questions.part);
  if (!whole.text) return {std::nullopt, whole.problem};
  std::string reason;
  const auto part = questions.check(*whole.text, reason);
  if (!part) return {std::nullopt, reason};
  std::string lost = lost_by_writing(scenes, questions.part, *part);
  if (lost.empty()) lost = not_mended(changes, *part);
  if (!lost.empty()) return {std::nullopt, "as a whole it would not pass: " + lost};
  const PassCount count = count_all(*part);
  return {
      std::move(whole.text), "", {"", what, count.passing, count.asked, not_met_findings(*part)}};
}

// Null: none is enough.
const CheckedPlaces* cheapest(const RoomPlaces& room) {
  const CheckedPlaces* found = nullptr;
  const auto look_at = [&](const CheckedPlaces& one) {
    if (!is_enough(one)) return;
    if (found == nullptr || cost_of(one) < cost_of(*found)) found = &one;
  };
  for (const CheckedPlaces& one : room.best) look_at(one);
  if (room.together) look_at(*room.together);
  return found;
}

// As few of them as are enough; null: none are.
const CheckedTurns* fewest(const RoomTurns& room) {
  for (const CheckedTurns& one : room.best) {
    if (is_enough(one.check)) return &one;
  }
  return room.together && is_enough(room.together->check) ? &*room.together : nullptr;
}

// Where the first luminaire of a room stands in the file.
std::pair<int, int> place_in_file(const calc::Space& space) {
  std::pair<int, int> first{0, 0};
  for (const calc::Luminaire& one : space.luminaires) {
    const std::pair<int, int> its{one.where.line, one.where.column};
    if (first == std::pair(0, 0) || its < first) first = its;
  }
  return first;
}

}  // namespace

RoomsText with_places(const RoomQuestions& questions, const std::vector<RoomPlaces>& rooms) {
  // A room that lacks light in several scenes gets what is dearest: the check of the whole tells
  // whether that is enough for all.
  std::map<std::string, const CheckedPlaces*> of_room;
  std::vector<RoomChange> changes;
  for (const RoomPlaces& room : rooms) {
    const CheckedPlaces* found = cheapest(room);
    if (found == nullptr) {
      return {std::nullopt, fmt::format("no sufficient places were found in '{}'", room.space)};
    }
    const CheckedPlaces*& known = of_room[room.space_id];
    if (known == nullptr || cost_of(*found) > cost_of(*known)) known = found;
    changes.push_back({room.space_id, room.requirements, nullptr});
  }
  std::size_t number = 0;
  for (const auto& [room, places] : of_room) {
    std::vector<check::AddedLuminaire> added;
    for (const AdvisedPlace& place : places->places) {
      added.push_back({unused_luminaire_id(questions.project, fmt::format("added-{}", ++number)),
                       place.type, place.position_m, place.c0, place.axis, place.group});
    }
    const auto its = std::find_if(changes.begin(), changes.end(),
                                  [&id = room](const auto& one) { return one.room == id; });
    its->change = [&questions, id = room, added](const std::string& text) {
      return check::with_luminaires(text, questions.file, id, added);
    };
  }
  return with_changes(questions, changes, "places");
}

RoomsText with_turns(const RoomQuestions& questions, const std::vector<RoomTurns>& rooms) {
  // As above, of several scenes those of more luminaires.
  std::map<std::string, const CheckedTurns*> of_room;
  std::vector<RoomChange> changes;
  for (const RoomTurns& room : rooms) {
    const CheckedTurns* found = fewest(room);
    if (found == nullptr) {
      return {std::nullopt, fmt::format("no sufficient turns were found in '{}'", room.space)};
    }
    const CheckedTurns*& known = of_room[room.space_id];
    if (known == nullptr || found->turns.size() > known->turns.size()) known = found;
    changes.push_back({room.space_id, room.requirements, nullptr});
  }
  // Places of elements are those of the file as it was read, so that the last room comes first.
  std::vector<const calc::Space*> from_the_end;
  for (const calc::Space& space : questions.project.spaces) {
    if (of_room.contains(space.id)) from_the_end.push_back(&space);
  }
  std::stable_sort(from_the_end.begin(), from_the_end.end(),
                   [](const calc::Space* a, const calc::Space* b) {
                     return place_in_file(*a) > place_in_file(*b);
                   });
  std::vector<RoomChange> sorted;
  for (const calc::Space* space : from_the_end) {
    std::map<std::size_t, std::optional<AdvisedPlace>> turned;
    for (const AdvisedTurn& turn : of_room[space->id]->turns) turned[turn.luminaire] = turn.place;
    const OneByOne other = one_by_one(questions, *space, turned);
    for (RoomChange& change : changes) {
      if (change.room != space->id) continue;
      const bool is_first = std::none_of(sorted.begin(), sorted.end(), [&](const RoomChange& one) {
        return one.room == change.room;
      });
      if (is_first) {
        change.change = [&questions, id = space->id, other](const std::string& text) {
          return check::with_luminaires_instead(text, questions.file, id, other.elements,
                                                other.luminaires);
        };
      }
      sorted.push_back(std::move(change));
    }
  }
  return with_changes(questions, sorted, "turns");
}

}  // namespace cli
