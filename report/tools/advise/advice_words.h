#pragma once
// What text and Markdown of an advice, and of places and surfaces, have in common. Names in it are
// printable, and not yet escaped for Markdown.

#include "report/tools/advise/advice.h"

#include <string>

namespace cli {

// "345.6 W", "864 kWh a year" or, where power is not known, lumens.
std::string cost_words(double cost, CostUnit unit);
std::string cost_words(double cost, bool is_by_flux);
// What the levels need, what is needed now, and what no levels undercut.
std::string cost_sentence(const SceneAdvice& advice);
inline constexpr const char* kByFlux =
    "The power of a luminaire is not known: the levels minimise light instead.";
inline constexpr const char* kByEnergy =
    "Energy is that of a year in which these levels hold in all hours of use.";
// What is to be said of the unit of costs; "" = nothing.
constexpr const char* unit_note(CostUnit unit) {
  return unit == CostUnit::lumen ? kByFlux : unit == CostUnit::kilowatt_hour ? kByEnergy : "";
}
inline constexpr const char* kRaised =
    "They are nearer to those of now than the least ones, which would not meet what the search "
    "does "
    "not know:";
// "64 %"
std::string level_words(double level);
std::string name_of_group(const std::string& group);
// scene: an id; "" = full output.
std::string scene_words(const std::string& scene);
// "9 requirements"
std::string requirement_count(const SceneAdvice& advice);
// One sentence.
std::string outcome_words(const SceneAdvice& advice);
// Of groups that stay as they are; "" where there are none.
std::string left_alone_words(const SceneAdvice& advice);
// What is said of the requirements that exclude each other.
std::string contradiction_words(const SceneAdvice& advice);
// "average at-least 500 lx"
std::string asked_words(const rules::Requirement& requirement);
std::string requirement_words(const AdvisedRequirement& one);
std::string value_words(const rules::Finding& finding);
// Lines.
std::string written_words(const WrittenAdvice& written);
// Of the requirement with the levels: what nobody has installed would only pass.
std::string verdict_words(const SceneAdvice& advice, const AdvisedRequirement& one);
// Shares of the groups in the light where a limit has the least room, largest first; "" where all
// is of one.
std::string share_words(const SceneAdvice& advice, const AdvisedLimit& limit);

}  // namespace cli
