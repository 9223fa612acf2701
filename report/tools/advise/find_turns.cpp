#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "report/text/words.h"
#include "report/tools/advise/find_places.h"
#include "report/tools/advise/room_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

// Of a room: each of them is looked at in all ways.
constexpr std::size_t kMostTurned = 60;
constexpr std::size_t kMostTriedByRun = 3;
// What a check could not tell from nothing, of what lacks.
constexpr double kLeastShare = 0.01;
constexpr double kWorst = -1.0;  // what is lost elsewhere counts as much as what is mended

struct Way {
  double turn_deg = 0.0, tilt_deg = 0.0, tilt_to_deg = 0.0;
};

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (int step = 1; step < 8; ++step) ways.push_back({45.0 * step, 0.0, 0.0});
  for (const double tilt_deg : {15.0, 30.0}) {
    for (const double to_deg : {0.0, 90.0, 180.0, 270.0}) ways.push_back({0.0, tilt_deg, to_deg});
  }
  return ways;
}

// frame: its columns are C0, C90 and backwards.
glm::dmat3 turned(const glm::dmat3& frame, const Way& way) {
  const auto sine = [](double degrees) { return calc::sin(calc::radians_from_degrees(degrees)); };
  const auto cosine = [](double degrees) { return calc::cos(calc::radians_from_degrees(degrees)); };
  if (way.turn_deg != 0.0) {
    const double c = cosine(way.turn_deg), s = sine(way.turn_deg);
    return {c * frame[0] + s * frame[1], c * frame[1] - s * frame[0], frame[2]};
  }
  const double c = cosine(way.tilt_deg), s = sine(way.tilt_deg);
  const glm::dvec3 axis = -frame[2],
                   towards = cosine(way.tilt_to_deg) * frame[0] + sine(way.tilt_to_deg) * frame[1],
                   about = glm::cross(axis, towards);
  const auto tilted = [&](const glm::dvec3& v) {
    return glm::dot(v, axis) * (c * axis + s * towards) +
           glm::dot(v, towards) * (c * towards - s * axis) + glm::dot(v, about) * about;
  };
  return {tilted(frame[0]), tilted(frame[1]), tilted(frame[2])};
}

class TurnSearch {
 public:
  TurnSearch(const RoomQuestions& questions, std::size_t part_index, const calc::Space& space,
             const std::string& scene)
      : questions_(questions), part_index_(part_index), space_(space) {
    found_.scene = scene;
    found_.space = report::title_of(questions.part.spaces[part_index].name, space.id);
    found_.space_id = space.id;
  }

  // Empty: nothing lacks light here.
  std::optional<RoomTurns> search() {
    asked_ = asked_of_room(questions_, part_index_, found_.scene, true, found_.left_out);
    if (asked_.empty()) {
      if (found_.left_out.empty()) return std::nullopt;
      found_.problem =
          "no unmet requirement here is an average, a least value or a value at a point";
      return std::move(found_);
    }
    const PassCount before = count_passes(questions_.part, found_.scene);
    found_.passing = before.passing;
    found_.asked = before.asked;
    find_candidates();
    if (!found_.problem.empty()) return told();
    const RoomLight light(questions_, space_, found_.scene, asked_, candidates_, {});
    found_.problem = light.problem().english();
    if (!found_.problem.empty()) return told();
    found_.turns = ranked(light);
    if (found_.turns.empty()) {
      found_.problem = "no turn of one of them surely adds a hundredth of the missing light";
      return told();
    }
    for (std::size_t t = 0; t < std::min(kMostTriedByRun, found_.turns.size()); ++t) {
      found_.best.push_back(checked({found_.turns[t]}));
    }
    std::vector<AdvisedTurn> several = together(found_.turns);
    if (several.size() > 1) found_.together = checked(std::move(several));
    return told();
  }

 private:
  struct Source {
    std::size_t luminaire = 0;  // of the space
    Way way;                    // none: as it is
  };

  std::optional<RoomTurns> told() {
    for (const AskedOfRoom& one : asked_) found_.requirements.push_back(one.told);
    return std::move(found_);
  }

  const calc::LuminaireType& type_of(const calc::Luminaire& luminaire) const {
    return questions_.project.luminaire_types[luminaire.type];
  }

  std::string why_not_turned(const calc::Luminaire& luminaire) const {
    const calc::LuminaireType& type = type_of(luminaire);
    if (type.is_further_emitter || !type.emitters.empty()) return "it has several emitters";
    if (type.photometry_file.empty()) return "it is a luminous area";
    if (type.housing) return "its housing would shade differently";
    const check::ChangedText left_out = check::with_luminaires_instead(
        questions_.bytes, questions_.file, space_.id, {luminaire.where}, {});
    return left_out.problem;
  }

  void find_candidates() {
    if (!space_.shell) {
      found_.problem = "only rooms whose walls are in the project file are considered";
      return;
    }
    if (space_.luminaires.size() > kMostTurned) {
      found_.problem = fmt::format("only rooms of up to {} luminaires are considered", kMostTurned);
      return;
    }
    const calc::PointFilter filter(space_, calc::ReceiverKernel::planar, box_of(space_));
    std::set<std::string> refused;
    for (std::size_t l = 0; l < space_.luminaires.size(); ++l) {
      const calc::Luminaire& luminaire = space_.luminaires[l];
      if (const std::string why = why_not_turned(luminaire); !why.empty()) {
        if (type_of(luminaire).is_further_emitter) continue;
        if (refused.insert(type_of(luminaire).id + why).second) {
          found_.left_out.push_back(fmt::format("type {}: {}", type_of(luminaire).id, why));
        }
        continue;
      }
      ++found_.luminaires;
      const std::size_t as_it_is = candidates_.size();
      candidates_.push_back(luminaire);
      sources_.push_back({l, {}});
      now_.push_back(as_it_is);
      for (const Way& way : all_ways()) {
        calc::Luminaire other = luminaire;
        other.world_from_luminaire = turned(luminaire.world_from_luminaire, way);
        if (!has_room(questions_.project, filter, other)) continue;
        ++found_.tried;
        candidates_.push_back(std::move(other));
        sources_.push_back({l, way});
        now_.push_back(as_it_is);
      }
    }
    if (found_.tried == 0) found_.problem = "no luminaire of this room can be turned";
  }

  AdvisedTurn turn_of(const RoomLight& light, std::size_t candidate) const {
    const calc::Luminaire& luminaire = candidates_[candidate];
    const Source& source = sources_[candidate];
    AdvisedTurn turn;
    turn.id = space_.luminaires[source.luminaire].id;
    turn.luminaire = source.luminaire;
    turn.turn_deg = source.way.turn_deg;
    turn.tilt_deg = source.way.tilt_deg;
    turn.tilt_to_deg = source.way.tilt_to_deg;
    turn.place.type = type_of(luminaire).id;
    turn.place.group = luminaire.group;
    turn.place.position_m = luminaire.position_m;
    turn.place.c0 = luminaire.world_from_luminaire[0];
    turn.place.axis = -luminaire.world_from_luminaire[2];
    std::vector<double> sure_lx;
    for (const AskedOfRoom& one : asked_) {
      turn.place.gain_lx.push_back(light.gain_instead_lx(one, candidate, now_[candidate]));
      sure_lx.push_back(turn.place.gain_lx.back().low);
    }
    turn.place.share = mended_share(asked_, sure_lx, 1.0, kWorst);
    return turn;
  }

  // What surely mends, most first; of a luminaire in all ways.
  std::vector<AdvisedTurn> ranked(const RoomLight& light) const {
    std::vector<AdvisedTurn> turns;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      if (c == now_[c]) continue;
      AdvisedTurn turn = turn_of(light, c);
      if (turn.place.share >= kLeastShare) turns.push_back(std::move(turn));
    }
    std::stable_sort(turns.begin(), turns.end(), [](const AdvisedTurn& a, const AdvisedTurn& b) {
      return a.place.share > b.place.share;
    });
    return turns;
  }

  // Of each luminaire the best way: light adds up, but what is enough of one requirement mends
  // nothing more.
  std::vector<AdvisedTurn> together(const std::vector<AdvisedTurn>& turns) const {
    std::vector<AdvisedTurn> chosen;
    std::set<std::size_t> taken;
    std::vector<double> sum_lx(asked_.size(), 0.0);
    double now = 0.0;
    for (const AdvisedTurn& turn : turns) {
      if (taken.contains(turn.luminaire)) continue;
      std::vector<double> with_lx = sum_lx;
      for (std::size_t r = 0; r < asked_.size(); ++r) with_lx[r] += turn.place.gain_lx[r].low;
      const double then = mended_share(asked_, with_lx, 1.0, kWorst);
      if (then < now + kLeastShare) continue;
      taken.insert(turn.luminaire);
      chosen.push_back(turn);
      sum_lx = std::move(with_lx);
      now = then;
    }
    return chosen;
  }

  CheckedTurns checked(std::vector<AdvisedTurn> turns) const {
    CheckedTurns result;
    std::map<std::size_t, std::optional<AdvisedPlace>> changed;
    for (const AdvisedTurn& turn : turns) {
      changed[turn.luminaire] = turn.place;
      result.check.places.push_back(turn.place);
    }
    const OneByOne other = one_by_one(questions_, space_, changed);
    check_in_room(questions_, part_index_, found_.scene, asked_,
                  check::with_luminaires_instead(questions_.bytes, questions_.file, space_.id,
                                                 other.elements, other.luminaires),
                  other.luminaires, result.check);
    result.turns = std::move(turns);
    return result;
  }

  const RoomQuestions& questions_;
  std::size_t part_index_;
  const calc::Space& space_;
  RoomTurns found_;
  std::vector<AskedOfRoom> asked_;
  std::vector<calc::Luminaire> candidates_;
  std::vector<Source> sources_;   // [candidate]
  std::vector<std::size_t> now_;  // [candidate]: that of the same luminaire as it is
};

}  // namespace

std::vector<RoomTurns> find_turns(const RoomQuestions& questions) {
  return searched_rooms<TurnSearch>(questions, true);
}

}  // namespace cli
