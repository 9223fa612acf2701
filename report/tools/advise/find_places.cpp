#include "report/tools/advise/find_places.h"

#include "calc/scene/solids.h"
#include "report/text/words.h"
#include "report/tools/advise/room_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

// Of all ways of mounting together: a grid as fine as that.
constexpr double kMostCells = 150.0;
constexpr double kLeastStep_m = 0.5, kLeastDistance_m = 0.5;
constexpr std::size_t kMostMountings = 6;
constexpr std::size_t kMostChecked = 3, kMostTogether = 60;
constexpr int kMostChecksTogether = 4;
// What is wanted beyond what lacks, as the check has other random numbers; so much more after each
// check that does not pass.
constexpr double kRoomToSpare = 0.02;
constexpr double kSame = 1.0e-9, kSamePlace_m = 1.0e-6, kVertical = 0.999;

// How luminaires of the room hang: a type, a height, a direction.
struct Mounting {
  calc::Luminaire example;
  std::size_t luminaires = 0;
};

bool is_same_frame(const glm::dmat3& a, const glm::dmat3& b) {
  for (int column = 0; column < 3; ++column) {
    if (glm::length(a[column] - b[column]) > kSame) return false;
  }
  return true;
}

class PlaceSearch {
 public:
  PlaceSearch(const RoomQuestions& questions, std::size_t part_index, const calc::Space& space,
              const std::string& scene)
      : questions_(questions), part_index_(part_index), space_(space) {
    found_.scene = scene;
    found_.space = report::title_of(questions.part.spaces[part_index].name, space.id);
    found_.space_id = space.id;
    if (space.shell) found_.outline_m = space.shell->footprint_m;
    for (const calc::Luminaire& one : space.luminaires) {
      if (type_of(one).counts_as_luminaire()) found_.luminaires_m.emplace_back(one.position_m);
    }
  }

  // Empty: nothing lacks light here.
  std::optional<RoomPlaces> search() {
    asked_ = asked_of_room(questions_, part_index_, found_.scene, true, found_.left_out);
    if (asked_.empty() && found_.left_out.empty()) return std::nullopt;
    if (asked_.empty()) {
      found_.problem =
          "no unmet requirement here is an average, a least value or a value at a point";
      return std::move(found_);
    }
    const PassCount before = count_passes(questions_.part, found_.scene);
    found_.passing = before.passing;
    found_.asked = before.asked;
    find_mountings();
    if (found_.problem.empty()) find_free_places();
    if (!found_.problem.empty()) {
      tell_requirements();
      return std::move(found_);
    }
    const RoomLight light(questions_, space_, found_.scene, asked_, candidates_, {});
    tell_requirements();
    if (!light.problem().empty()) {
      found_.problem = light.problem().english();
      return std::move(found_);
    }
    rank(light);
    check_best();
    if (std::none_of(found_.best.begin(), found_.best.end(),
                     [](const CheckedPlaces& one) { return is_enough(one); })) {
      find_together(light);
    }
    return std::move(found_);
  }

 private:
  void tell_requirements() {
    for (const AskedOfRoom& one : asked_) found_.requirements.push_back(one.told);
  }

  const calc::LuminaireType& type_of(const calc::Luminaire& luminaire) const {
    return questions_.project.luminaire_types[luminaire.type];
  }

  std::string why_not_added(const calc::Luminaire& luminaire) const {
    const calc::LuminaireType& type = type_of(luminaire);
    if (type.is_further_emitter || !type.emitters.empty()) return "it has several emitters";
    // Its type is its own, and not one of the file.
    if (type.photometry_file.empty()) return "it is a luminous area";
    if (type.housing) return "its housing would shade";
    if (std::abs(luminaire.world_from_luminaire[2].z) < kVertical) {
      return "it is aimed, and not straight down or up";
    }
    return "";
  }

  void find_mountings() {
    if (!space_.shell) {
      found_.problem = "places are found only in rooms whose walls are in the project file";
      return;
    }
    std::set<std::string> refused;
    for (const calc::Luminaire& luminaire : space_.luminaires) {
      if (const std::string why = why_not_added(luminaire); !why.empty()) {
        if (type_of(luminaire).is_further_emitter) continue;
        if (refused.insert(type_of(luminaire).id + why).second) {
          found_.left_out.push_back(fmt::format("type {}: {}", type_of(luminaire).id, why));
        }
        continue;
      }
      const auto same = std::find_if(mountings_.begin(), mountings_.end(), [&](const Mounting& m) {
        return m.example.type == luminaire.type &&
               std::abs(m.example.position_m.z - luminaire.position_m.z) < kSamePlace_m &&
               is_same_frame(m.example.world_from_luminaire, luminaire.world_from_luminaire);
      });
      if (same == mountings_.end()) {
        mountings_.push_back({luminaire, 1});
      } else {
        ++same->luminaires;
      }
    }
    std::stable_sort(
        mountings_.begin(), mountings_.end(),
        [](const Mounting& a, const Mounting& b) { return a.luminaires > b.luminaires; });
    add_other_types();
    if (mountings_.size() > kMostMountings) {
      found_.left_out.push_back(fmt::format("{} less frequent ways of mounting in this room",
                                            mountings_.size() - kMostMountings));
      mountings_.resize(kMostMountings);
    }
    if (mountings_.empty()) {
      found_.problem = "no luminaire of this room can serve as a model for mounting another";
    }
  }

  // Types that hang in other rooms, or nowhere: as what hangs here most.
  void add_other_types() {
    if (mountings_.empty()) return;
    const Mounting usual = mountings_.front();
    const bool is_power_known =
        std::all_of(mountings_.begin(), mountings_.end(),
                    [&](const Mounting& m) { return type_of(m.example).power_w > 0.0; });
    for (std::size_t t = 0; t < questions_.project.luminaire_types.size(); ++t) {
      const bool hangs_here =
          std::any_of(space_.luminaires.begin(), space_.luminaires.end(),
                      [&](const calc::Luminaire& one) { return one.type == t; });
      if (hangs_here) continue;
      Mounting other{usual.example, 0};
      other.example.type = t;
      const calc::LuminaireType& type = type_of(other.example);
      // Costs would be lumens for its sake.
      const bool has_cost = type.power_w > 0.0 || !is_power_known;
      if (has_cost && why_not_added(other.example).empty()) mountings_.push_back(std::move(other));
    }
  }

  glm::dvec3 opening_m(const calc::Luminaire& luminaire) const {
    return questions_.project.webs[type_of(luminaire).web].opening().size_m();
  }
  double diagonal_m(const calc::Luminaire& luminaire) const {
    return glm::length(glm::dvec2(opening_m(luminaire)));
  }

  // Centres of openings that nearly touch are refused, too.
  double least_distance_m(const calc::Luminaire& a, const calc::Luminaire& b) const {
    return std::max(kLeastDistance_m, 0.5 * (diagonal_m(a) + diagonal_m(b)));
  }
  bool is_apart(const calc::Luminaire& a, const calc::Luminaire& b) const {
    return glm::length(a.position_m - b.position_m) >= least_distance_m(a, b);
  }

  void find_free_places() {
    const calc::BoundingBox box = box_of(space_);
    const glm::dvec2 size_m(box.upper - box.lower);
    const double wanted_m =
        std::sqrt(size_m.x * size_m.y * static_cast<double>(mountings_.size()) / kMostCells);
    // Whole decimetres.
    const double step_m = std::max(kLeastStep_m, std::ceil(10.0 * wanted_m) / 10.0);
    const auto cells = [&](double side_m) { return std::max(1.0, std::round(side_m / step_m)); };
    const double columns = cells(size_m.x), rows = cells(size_m.y);
    found_.step_m = {size_m.x / columns, size_m.y / rows};
    found_.least_distance_m = kLeastDistance_m;
    const calc::PointFilter filter(space_, calc::ReceiverKernel::planar, box);
    for (const Mounting& mounting : mountings_) {
      for (const calc::Luminaire& other : space_.luminaires) {
        found_.least_distance_m =
            std::max(found_.least_distance_m, least_distance_m(mounting.example, other));
      }
      for (double row = 0.0; row < rows; ++row) {
        for (double column = 0.0; column < columns; ++column) {
          ++found_.cells;
          calc::Luminaire place = mounting.example;
          place.id.clear();
          place.position_m.x = box.lower.x + (column + 0.5) * found_.step_m.x;
          place.position_m.y = box.lower.y + (row + 0.5) * found_.step_m.y;
          const bool is_free =
              std::all_of(space_.luminaires.begin(), space_.luminaires.end(),
                          [&](const calc::Luminaire& other) { return is_apart(place, other); });
          if (!is_free || !has_room(questions_.project, filter, place)) continue;
          place.group = nearest_group(place);
          candidates_.push_back(std::move(place));
        }
      }
    }
    if (candidates_.empty()) found_.problem = "there is no free place";
  }

  // It is switched with what hangs next to it, of its type if there is any.
  std::string nearest_group(const calc::Luminaire& place) const {
    const bool has_its_type =
        std::any_of(space_.luminaires.begin(), space_.luminaires.end(),
                    [&](const calc::Luminaire& other) { return other.type == place.type; });
    const calc::Luminaire* nearest = nullptr;
    for (const calc::Luminaire& other : space_.luminaires) {
      if (has_its_type && other.type != place.type) continue;
      if (nearest == nullptr || glm::length(other.position_m - place.position_m) <
                                    glm::length(nearest->position_m - place.position_m)) {
        nearest = &other;
      }
    }
    return nearest == nullptr ? "" : nearest->group;
  }

  double cost(const calc::Luminaire& luminaire) const {
    const calc::LuminaireType& type = type_of(luminaire);
    return found_.is_by_flux ? questions_.project.webs[type.web].flux_lm() * type.flux_scale
                             : type.power_w;
  }

  AdvisedPlace told(const RoomLight& light, std::size_t candidate) const {
    const calc::Luminaire& luminaire = candidates_[candidate];
    AdvisedPlace place;
    place.type = type_of(luminaire).id;
    place.group = luminaire.group;
    place.position_m = luminaire.position_m;
    place.c0 = luminaire.world_from_luminaire[0];
    place.axis = -luminaire.world_from_luminaire[2];
    place.cost = cost(luminaire);
    std::vector<double> gain_lx;
    for (const AskedOfRoom& one : asked_) {
      place.gain_lx.push_back(light.gain_lx(one, candidate));
      // The best of many would often be the luckiest: what is sure counts.
      gain_lx.push_back(place.gain_lx.back().low);
    }
    place.share = mended_share(asked_, gain_lx, 1.0);
    return place;
  }

  // What meets everything by the pool first, by its cost; then by what a watt mends.
  void rank(const RoomLight& light) {
    for (const calc::Luminaire& one : candidates_) {
      found_.is_by_flux = found_.is_by_flux || !(type_of(one).power_w > 0.0);
    }
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      found_.places.push_back(told(light, c));
    }
    const auto is_all = [](const AdvisedPlace& place) { return place.share >= 1.0 - kSame; };
    std::stable_sort(found_.places.begin(), found_.places.end(),
                     [&](const AdvisedPlace& a, const AdvisedPlace& b) {
                       if (is_all(a) != is_all(b)) return is_all(a);
                       if (is_all(a) && a.cost != b.cost) return a.cost < b.cost;
                       if (is_all(a)) return room_left(a) > room_left(b);
                       return a.share / a.cost > b.share / b.cost;
                     });
  }

  // Beyond what lacks, as a share of it, of the requirement with the least.
  double room_left(const AdvisedPlace& place) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < asked_.size(); ++r) {
      least = std::min(least, place.gain_lx[r].low / std::max(asked_[r].lack_lx, 1.0e-9));
    }
    return least;
  }

  CheckedPlaces checked(std::vector<AdvisedPlace> places) const {
    CheckedPlaces result;
    std::vector<check::AddedLuminaire> added;
    for (const AdvisedPlace& place : places) {
      const std::string wish = fmt::format("added-{}", added.size() + 1);
      added.push_back({unused_luminaire_id(questions_.project, wish), place.type, place.position_m,
                       place.c0, place.axis, place.group});
    }
    result.places = std::move(places);
    check_in_room(questions_, part_index_, found_.scene, asked_,
                  check::with_luminaires(questions_.bytes, questions_.file, space_.id, added),
                  added, result);
    return result;
  }

  void check_best() {
    for (std::size_t p = 0; p < std::min(kMostChecked, found_.places.size()); ++p) {
      found_.best.push_back(checked({found_.places[p]}));
    }
  }

  // One after the other, each where it mends most of what still lacks.
  std::vector<std::size_t> enough(const RoomLight& light, double more) const {
    using ByTarget = std::vector<double>;
    std::vector<std::vector<ByTarget>> added(candidates_.size());  // [candidate][requirement]
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      for (const AskedOfRoom& one : asked_) added[c].push_back(light.added_lx(one, c));
    }
    std::vector<ByTarget> values;  // [requirement], with those that were chosen
    for (const AskedOfRoom& one : asked_) values.push_back(one.value_lx);
    const auto share_with = [&](std::size_t c) {
      std::vector<double> gain_lx;
      for (std::size_t r = 0; r < asked_.size(); ++r) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t t = 0; t < values[r].size(); ++t) {
          least = std::min(least, values[r][t] + added[c][r][t]);
        }
        gain_lx.push_back(least -
                          *std::min_element(asked_[r].value_lx.begin(), asked_[r].value_lx.end()));
      }
      return mended_share(asked_, gain_lx, more);
    };
    std::vector<std::size_t> chosen;
    double now = 0.0;
    while (chosen.size() < kMostTogether && now < 1.0 - kSame) {
      std::optional<std::size_t> best;
      double best_value = 0.0, best_share = now;
      for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const bool is_free = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
          return is_apart(candidates_[c], candidates_[other]);
        });
        if (!is_free) continue;
        const double its_share = share_with(c);
        const double value = (its_share - now) / cost(candidates_[c]);
        if (value <= best_value) continue;
        best = c;
        best_value = value;
        best_share = its_share;
      }
      if (!best) return {};
      chosen.push_back(*best);
      now = best_share;
      for (std::size_t r = 0; r < asked_.size(); ++r) {
        for (std::size_t t = 0; t < values[r].size(); ++t) values[r][t] += added[*best][r][t];
      }
    }
    return now < 1.0 - kSame ? std::vector<std::size_t>() : chosen;
  }

  void find_together(const RoomLight& light) {
    double more = 1.0 + kRoomToSpare;
    for (int tries = 0; tries < kMostChecksTogether; ++tries, more += 2.0 * kRoomToSpare) {
      const std::vector<std::size_t> chosen = enough(light, more);
      if (chosen.empty()) return;
      std::vector<AdvisedPlace> places;
      for (const std::size_t c : chosen) places.push_back(told(light, c));
      found_.together = checked(std::move(places));
      if (is_enough(*found_.together) || !found_.together->problem.empty()) return;
    }
  }

  const RoomQuestions& questions_;
  std::size_t part_index_;
  const calc::Space& space_;
  RoomPlaces found_;
  std::vector<AskedOfRoom> asked_;
  std::vector<Mounting> mountings_;
  std::vector<calc::Luminaire> candidates_;
};

}  // namespace

bool is_enough(const CheckedPlaces& checked) {
  return checked.problem.empty() && !checked.after.empty() && checked.broken.empty() &&
         std::all_of(checked.after.begin(), checked.after.end(),
                     [](const rules::Finding& one) { return one.verdict == rules::Verdict::pass; });
}

std::vector<RoomPlaces> find_places(const RoomQuestions& questions) {
  return searched_rooms<PlaceSearch>(questions, true);
}

}  // namespace cli
