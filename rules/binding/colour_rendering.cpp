#include "rules/binding/colour_rendering.h"

#include "calc/base/sentences.h"
#include "calc/photometry/stated_colour.h"
#include "calc/scene/scene_level.h"
#include "rules/catalogue/compare.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace rules {
namespace {

using calc::say;
using calc::Sentence;

// The least Ra of all types together; `type`: the type that states it.
struct Least {
  calc::StatedRa ra;
  const calc::LuminaireType* type = nullptr;
};

const std::string& words_of(const calc::Project& project, const calc::LuminaireType& type) {
  return project.webs[type.web].source().colour_rendering;
}

// Returns why the colour rendering of a type is not known; "" = it is.
calc::Message problem_of(const calc::Project& project, const calc::LuminaireType& type,
                         const std::optional<calc::StatedRa>& ra) {
  // A package is another lamp than that of the file.
  if (type.package) {
    return say<Sentence::rendering_of_package>(type.id, type.packages[*type.package].article);
  }
  // Another flux is another lamp, or the same one driven otherwise: the file does not say which.
  if (type.is_of_other_flux()) return say<Sentence::rendering_of_other_flux>(type.id);
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
  calc::Message unknown;  // why it is of one type
  for (const std::size_t index : types) {
    const calc::LuminaireType& type = project.luminaire_types[index];
    const std::optional<calc::StatedRa> ra = calc::stated_ra(words_of(project, type));
    if (calc::Message problem = problem_of(project, type, ra); !problem.empty()) {
      if (unknown.empty()) unknown = std::move(problem);
      continue;
    }
    const bool is_first = least.type == nullptr;
    if (is_first || ra->low < least.ra.low) least.type = &type;
    least.ra = is_first ? *ra
                        : calc::StatedRa{std::min(ra->low, least.ra.low),
                                         std::min(ra->high, least.ra.high)};
  }
  // One luminaire that is too low is enough to fail, whatever the others are.
  const bool is_failure = least.type != nullptr && is_lower_limit(requirement.comparison) &&
                          !meets(least.ra.high, requirement.comparison, requirement.limit);
  if (!unknown.empty() && !is_failure) {
    requirement.problem = std::move(unknown);
    return;
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

calc::Message rendering_problem(const calc::Project& project, const calc::Space& space,
                                const std::string& scene, Comparison comparison, double limit) {
  const auto named = std::find_if(project.scenes.begin(), project.scenes.end(),
                                  [&](const auto& one) { return one.id == scene; });
  Requirement requirement;
  requirement.comparison = comparison;
  requirement.limit = limit;
  set_colour_rendering(project, space, named == project.scenes.end() ? nullptr : &*named,
                       requirement);
  return requirement.problem;
}

}  // namespace rules
