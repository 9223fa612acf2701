#include "report/tools/advise/written_places.h"

#include "report/advice/written_levels.h"
#include "report/check/room_changes.h"
#include "report/tools/advise/find_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace cli {
namespace {

double cost_of(const CheckedPlaces& places) {
  double sum = 0.0;
  for (const AdvisedPlace& place : places.places) sum += place.cost;
  return sum;
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

}  // namespace

PlacesText with_places(const RoomQuestions& questions, const std::vector<RoomPlaces>& rooms) {
  // A room that lacks light in several scenes gets what is dearest: the check of the whole tells
  // whether that is enough for all.
  std::map<std::string, const CheckedPlaces*> of_room;
  for (const RoomPlaces& room : rooms) {
    const CheckedPlaces* found = cheapest(room);
    if (found == nullptr) {
      return {std::nullopt,
              fmt::format("no places were found that are enough in '{}'", room.space)};
    }
    const CheckedPlaces*& known = of_room[room.space_id];
    if (known == nullptr || cost_of(*found) > cost_of(*known)) known = found;
  }
  std::string text = questions.bytes;
  std::size_t number = 0;
  for (const auto& [room, places] : of_room) {
    std::vector<check::AddedLuminaire> added;
    for (const AdvisedPlace& place : places->places) {
      added.push_back({unused_luminaire_id(questions.project, fmt::format("added-{}", ++number)),
                       place.type, place.position_m, place.c0, place.axis, place.group});
    }
    check::ChangedText changed = check::with_luminaires(text, questions.file, room, added);
    if (!changed.text) return {std::nullopt, changed.problem};
    text = *std::move(changed.text);
  }
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
  LevelsText whole = with_levels(text, questions.file, scenes, questions.part);
  if (!whole.text) return {std::nullopt, whole.problem};
  std::string reason;
  const auto part = questions.check(*whole.text, reason);
  if (!part) return {std::nullopt, reason};
  if (const std::string lost = lost_by_writing(scenes, questions.part, *part); !lost.empty()) {
    return {std::nullopt, "as a whole it would not pass: " + lost};
  }
  for (const RoomPlaces& room : rooms) {
    for (const FindingPlace& where : counted_findings(*part)) {
      if (part->spaces[where.space].id != room.space_id) continue;
      const rules::Finding& finding = finding_at(*part, where);
      const auto is_it = [&](const RoomRequirement& one) {
        return one.before.requirement.plane_id == finding.requirement.plane_id &&
               one.before.requirement.id == finding.requirement.id;
      };
      if (finding.verdict != rules::Verdict::pass &&
          std::any_of(room.requirements.begin(), room.requirements.end(), is_it)) {
        return {std::nullopt,
                fmt::format("as a whole it would not pass: {} ({})", finding_words(*part, where),
                            calc::name_of(finding.verdict))};
      }
    }
  }
  const PassCount count = count_all(*part);
  return {std::move(whole.text),
          "",
          {"", "places", count.passing, count.asked, not_met_findings(*part)}};
}

}  // namespace cli
