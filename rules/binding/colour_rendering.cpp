#include "rules/binding/colour_rendering.h"

#include "calc/base/sentences.h"
#include "calc/photometry/stated_colour.h"
#include "calc/scene/scene_level.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace rules {
namespace {

using calc::say;
using calc::Sentence;

// Of all types together; `type`: of the one that states the least.
struct Least {
  calc::StatedRa ra;
  const calc::LuminaireType* type = nullptr;
};

const std::string& words_of(const calc::Project& project, const calc::LuminaireType& type) {
  return project.webs[type.web].source().colour_rendering;
}

// Why a type is of no known colour rendering; "" = it is.
calc::Message problem_of(const calc::Project& project, const calc::LuminaireType& type,
                         const std::optional<calc::StatedRa>& ra) {
  // A package is another lamp than that of the file.
  if (type.package) {
    return say<Sentence::rendering_of_package>(type.id, type.packages[*type.package].article);
  }
  if (ra) return {};
  const std::string& words = words_of(project, type);
  return words.empty() ? say<Sentence::rendering_missing>(type.id)
                       : say<Sentence::rendering_unclear>(type.id, words);
}

}  // namespace

void set_colour_rendering(const calc::Project& project, const calc::Space& space,
                          const calc::LightScene* scene, Requirement& requirement) {
  if (!requirement.problem.empty()) return;
  std::set<std::size_t> types;
  for (const calc::Luminaire& luminaire : space.road ? space.road->rows : space.luminaires) {
    if (calc::level_in_scene(scene, luminaire.group) > 0.0) types.insert(luminaire.type);
  }
  Least least;
  for (const std::size_t index : types) {
    const calc::LuminaireType& type = project.luminaire_types[index];
    const std::optional<calc::StatedRa> ra = calc::stated_ra(words_of(project, type));
    requirement.problem = problem_of(project, type, ra);
    if (!requirement.problem.empty()) return;
    const bool is_first = least.type == nullptr;
    if (is_first || ra->low < least.ra.low) least.type = &type;
    least.ra = is_first ? *ra
                        : calc::StatedRa{std::min(ra->low, least.ra.low),
                                         std::min(ra->high, least.ra.high)};
  }
  if (least.type == nullptr) {
    requirement.problem = say<Sentence::no_luminaire_is_on>();
    return;
  }
  const std::string& words = words_of(project, *least.type);
  if (least.ra.low < requirement.limit && requirement.limit <= least.ra.high) {
    requirement.problem = say<Sentence::rendering_unclear>(least.type->id, words);
    return;
  }
  requirement.of_space = {least.ra.low, least.ra.low, least.ra.high};
  requirement.stated_words = say<Sentence::rendering_stated>(least.type->id, words);
  add_note(requirement.stated_words, requirement);
}

}  // namespace rules
