#pragma once
// Words that text and Markdown share, for levels, places and surfaces. Names in them are printable,
// and not yet escaped for Markdown.

#include "report/tools/advise/advice.h"

#include <string>

namespace cli {

// Returns "345.6 W", "864 kWh a year" or, if power is not known, lumens.
std::string cost_words(double cost, CostUnit unit);
std::string cost_words(double cost, bool is_by_flux);
// Returns the cost of the levels, of the current levels, and the lower bound for all levels.
std::string cost_sentence(const SceneAdvice& advice);
inline constexpr const char* kByFlux =
    "The power of a luminaire is not known: the levels minimise light instead.";
inline constexpr const char* kByEnergy =
    "Energy is that of a year in which these levels hold in all hours of use.";
// Returns a remark on the unit of costs; "" = none.
constexpr const char* unit_note(CostUnit unit) {
  return unit == CostUnit::lumen ? kByFlux : unit == CostUnit::kilowatt_hour ? kByEnergy : "";
}
inline constexpr const char* kRaised =
    "They are nearer to those of now than the least ones, which would not meet what the search "
    "does "
    "not know:";
// Returns "64 %".
std::string level_words(double level);
std::string name_of_group(const std::string& group);
// Returns the words of a scene. scene: an id; "" = full output.
std::string scene_words(const std::string& scene);
// Returns "9 requirements".
std::string requirement_count(const SceneAdvice& advice);
// Returns the outcome as a sentence.
std::string outcome_words(const SceneAdvice& advice);
// Returns the groups that stay unchanged; "" if there are none.
std::string left_alone_words(const SceneAdvice& advice);
// Returns a remark on requirements that exclude each other.
std::string contradiction_words(const SceneAdvice& advice);
// Returns "average at-least 500 lx".
std::string asked_words(const rules::Requirement& requirement);
std::string requirement_words(const AdvisedRequirement& one);
std::string value_words(const rules::Finding& finding);
// Returns the written parts as lines.
std::string written_words(const WrittenAdvice& written);
// Returns the verdict with the levels; requirements that need further equipment "would" pass.
std::string verdict_words(const SceneAdvice& advice, const AdvisedRequirement& one);
// Returns the groups' shares of the light at the tightest limit, largest first; "" if all light is
// from one group.
std::string share_words(const SceneAdvice& advice, const AdvisedLimit& limit);

}  // namespace cli
