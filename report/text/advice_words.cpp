#include "report/text/advice_words.h"

#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

namespace report {
namespace {

std::string cost_words(const Texts& t, const LevelAdvice& advice, double cost) {
  switch (advice.unit) {
    case CostUnit::watt:
      return format_watts(t, cost) + " W";
    case CostUnit::lumen:
      return format_lumens(t, cost) + " lm";
    case CostUnit::kilowatt_hour:
      break;
  }
  return format_watts(t, cost) + " kWh";
}

std::string level_words(const Texts& t, double level) {
  return t.number(fmt::format("{:.4g} %", 100.0 * level));
}

std::string requirement_words(const Texts& t, const ProjectPart& project,
                              const RequirementName& name) {
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      if (plane.id != name.plane) continue;
      for (const rules::Finding& finding : plane.findings) {
        const rules::Requirement& requirement = finding.requirement;
        if (requirement.id != name.requirement) continue;
        const Threshold threshold{requirement.limit, requirement.comparison};
        return fmt::format("{}, {}{}{} {}", printable(title_of(space.name, space.id)),
                           printable(plane_in_room(t, space, plane)), t[Text::colon],
                           quantity_words(t, requirement, plane.kernel),
                           format_required(t, threshold, rules::unit_of(requirement)));
      }
    }
  }
  return printable(name.plane + ", " + name.requirement);
}

}  // namespace

bool has_advice(const ProjectPart& project) {
  if (!project.advice) return false;
  const rules::Outcome outcome = outcome_of(project);
  return !project.advice->empty() || outcome == rules::Outcome::fail ||
         outcome == rules::Outcome::undecided;
}

std::string advice_scene(const Texts& t, const LevelAdvice& advice) {
  return advice.scene.empty() ? t[Text::advice_full_output]
                              : t.say<Text::advice_scene>(printable(advice.scene));
}

std::string advice_outcome(const Texts& t, const LevelAdvice& advice, const std::string& reason) {
  const std::string advised = cost_words(t, advice, advice.advised),
                    now = cost_words(t, advice, advice.now);
  const std::string by_flux =
      advice.unit == CostUnit::lumen ? std::string(" ") + t[Text::advice_by_flux] : std::string();
  switch (advice.outcome) {
    case AdviceOutcome::levels:
      return t.say<Text::advice_levels>(advice.passing, advice.asked, advised, now) + by_flux;
    case AdviceOutcome::more_light:
      return t.say<Text::advice_more_light>(advice.passing, advice.asked, advised, now) + by_flux;
    case AdviceOutcome::contradiction:
      return t.say<Text::advice_contradiction>(kMostAdvisedLight);
    case AdviceOutcome::too_uncertain:
      return t[Text::advice_too_uncertain];
    case AdviceOutcome::none_found:
      break;
  }
  return t.say<Text::advice_none_found>(reason);
}

std::string advice_outcome(const Texts& t, const LevelAdvice& advice) {
  return advice_outcome(t, advice, printable(sentence(t, advice.reason)));
}

std::vector<AdviceRow> advice_rows(const Texts& t, const LevelAdvice& advice) {
  std::vector<AdviceRow> rows;
  for (const AdvisedGroup& group : advice.groups) {
    rows.push_back({group.group.empty() ? t[Text::no_group] : printable(group.group),
                    fmt::format("{}", group.luminaires), level_words(t, group.now),
                    level_words(t, group.level)});
  }
  return rows;
}

std::vector<AdviceList> advice_lists(const Texts& t, const ProjectPart& project,
                                     const LevelAdvice& advice) {
  std::vector<AdviceList> lists;
  const auto add = [&](Text title, const std::vector<RequirementName>& names,
                       const std::vector<std::string>& more) {
    if (names.empty() && more.empty()) return;
    AdviceList& list = lists.emplace_back();
    list.title = t[title];
    for (const RequirementName& name : names) {
      list.items.push_back(requirement_words(t, project, name));
    }
    for (const std::string& words : more) list.items.push_back(printable(words));
  };
  add(advice.excluding.size() == 1 ? Text::advice_excluding_one : Text::advice_excluding,
      advice.excluding, {});
  add(Text::advice_not_met, advice.not_met, advice.aggregates_not_met);
  return lists;
}

}  // namespace report
