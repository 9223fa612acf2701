#pragma once
// The points of a room that lack light, and the light from luminaires and surfaces on them.

#include "calc/radiosity/paths/importance.h"
#include "calc/scene/project.h"
#include "report/advice/find_advice.h"
#include "report/document/document.h"
#include "report/tools/advise/room_advice.h"
#include "rules/catalogue/requirement.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// The inputs of searches in rooms.
struct RoomQuestions {
  const std::string& file;   // path of the project
  const std::string& bytes;  // of it
  const calc::Project& project;
  const report::ProjectPart& part;  // judged
  const LightOfPlanes& light;
  const std::vector<SceneAdvice>& scenes;
  double confidence;
  calc::ImportanceSettings importance;
  CheckText check;
  // Returns the light of planes with a channel for each luminaire of the room, in their order, if
  // possible.
  std::function<LightOfPlanes()> light_apart;
};

// A requirement with its points.
struct AskedOfRoom {
  std::size_t plane = 0, finding = 0;  // in the room's part
  RoomRequirement told;
  double lack_lx = 0.0;  // of the lower end of its interval; <= 0: none
  bool is_mean = false;
  std::vector<std::size_t> points;  // of the grid: all that count, or the darkest ones
  std::vector<double> value_lx;     // as many; of a mean the mean alone
  const calc::SensorGrid* grid = nullptr;
  std::size_t first_target = 0;  // of a mean one target, else one for each point
};

// Returns lower limits on illuminance that count in a scene, on flat planes: averages, least values
// and values at points. only_lacking: only those that do not pass. Words for other requirements
// that lack light are appended to left_out.
std::vector<AskedOfRoom> asked_of_room(const RoomQuestions& questions, std::size_t space,
                                       const std::string& scene, bool only_lacking,
                                       std::vector<std::string>& left_out);

// Light of luminaires at the targets of the requirements, maintained or initial as required.
class RoomLight {
 public:
  // luminaires: existing or possible ones in this room. surfaces: as in surface_of_body(), each a
  // class; may be empty.
  RoomLight(const RoomQuestions& questions, const calc::Space& space, const std::string& scene,
            std::vector<AskedOfRoom>& asked, const std::vector<calc::Luminaire>& luminaires,
            const std::vector<std::string>& surfaces);

  const calc::Message& problem() const { return light_.problem; }
  // Returns the gain of the requirement's value from this luminaire; the interval holds at the
  // run's confidence.
  calc::Estimate gain_lx(const AskedOfRoom& asked, std::size_t luminaire) const;
  // Returns the gain from this luminaire in place of another; the common part of the same paths
  // cancels.
  calc::Estimate gain_instead_lx(const AskedOfRoom& asked, std::size_t luminaire,
                                 std::size_t of) const;
  // Returns the gain of each of the requirement's values, see AskedOfRoom::value_lx.
  std::vector<double> added_lx(const AskedOfRoom& asked, std::size_t luminaire) const;
  // Returns the light from a surface lit by all luminaires; is_slope: by its initial slope.
  calc::Estimate surface_lx(const AskedOfRoom& asked, std::size_t surface, bool is_slope) const;

 private:
  double weight(const AskedOfRoom& asked, std::size_t luminaire) const;
  template <class Batch>
  calc::Estimate grown(const AskedOfRoom& asked, const Batch& batch_lx) const;

  const calc::LightScene* scene_ = nullptr;
  double confidence_;
  std::vector<calc::LightChannel> channels_;  // [luminaire]
  calc::LightByLuminaire light_;
};

// Returns "floor" for "<room>.floor", "walls" for "<room>.wall2", up to the number of corners of
// its outline; "" for anything else, and in rooms without an outline.
std::string surface_of_body(const calc::Space& room, const std::string& body);

// Returns an id that no luminaire of the project has.
std::string unused_luminaire_id(const calc::Project& project, const std::string& wish);

// Counts the requirements that count in a scene.
PassCount count_passes(const report::ProjectPart& part, const std::string& scene);

// Returns the part's space; null: there is none.
const calc::Space* space_of(const RoomQuestions& questions, std::size_t part_index);

// Returns the results of Search(questions, index of the part's space, space, scene).search(), an
// optional, for every scene and room. only_without_levels: only in scenes that no levels can make
// pass.
template <class Search>
auto searched_rooms(const RoomQuestions& questions, bool only_without_levels) {
  std::vector<typename decltype(std::declval<Search>().search())::value_type> all;
  for (const SceneAdvice& scene : questions.scenes) {
    if (only_without_levels && scene.outcome == AdviceOutcome::levels) continue;
    for (std::size_t s = 0; s < questions.part.spaces.size(); ++s) {
      const calc::Space* space = space_of(questions, s);
      if (space == nullptr) continue;
      if (auto found = Search(questions, s, *space, scene.scene).search()) {
        all.push_back(*std::move(found));
      }
    }
  }
  return all;
}

}  // namespace cli
