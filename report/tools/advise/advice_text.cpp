#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"
#include "report/tools/advise/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cli {
namespace {

// Of what limits; all are in the JSON.
constexpr std::size_t kMostNamedLimits = 5;

std::string cost_words(const SceneAdvice& advice, double cost) {
  return advice.is_by_flux ? report::format_lumens(cost) + " lm"
                           : report::format_watts(cost) + " W";
}

std::string name_of_group(const std::string& group) {
  return group.empty() ? "(without a group)" : report::printable(group);
}

std::string requirement_words(const AdvisedRequirement& one) {
  const rules::Requirement& requirement = one.before.requirement;
  const std::string limit = report::format_limit(requirement.limit, rules::unit_of(requirement));
  return fmt::format("{}, {}: {} {} {}", report::printable(one.space), report::printable(one.plane),
                     report::quantity_words(requirement),
                     rules::comparison_name(requirement.comparison), limit);
}

std::string value_words(const rules::Finding& finding) {
  if (finding.verdict == rules::Verdict::not_judged) return "not judged";
  return report::format_measured(finding.measured, rules::unit_of(finding.requirement));
}

std::string group_table(const SceneAdvice& advice) {
  std::size_t width = 5;
  for (const AdvisedGroup& group : advice.groups) {
    width = std::max(width, report::display_width(name_of_group(group.group)));
  }
  const auto padded = [&](const std::string& name) {
    return name + std::string(width - report::display_width(name), ' ');
  };
  std::string text = fmt::format("    {}  luminaires     now  advised\n", padded("group"));
  for (const AdvisedGroup& group : advice.groups) {
    text += fmt::format("    {}  {:>10}  {:>6}  {:>7}\n", padded(name_of_group(group.group)),
                        group.luminaires, fmt::format("{:.4g} %", 100.0 * group.now),
                        fmt::format("{:.4g} %", 100.0 * group.level));
  }
  return text;
}

std::string limits(const SceneAdvice& advice) {
  std::vector<const AdvisedRequirement*> near;
  for (const AdvisedRequirement& one : advice.requirements) {
    if (one.not_searched.empty() && one.after.verdict == rules::Verdict::pass) near.push_back(&one);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const AdvisedRequirement* a, const AdvisedRequirement* b) {
                     return a->after.margin < b->after.margin;
                   });
  if (near.size() > kMostNamedLimits) near.resize(kMostNamedLimits);
  std::string text;
  for (const AdvisedRequirement* one : near) {
    text += fmt::format(
        "    {}: {}{}\n", requirement_words(*one), value_words(one->after),
        one->after.place_m ? " at " + report::format_position(*one->after.place_m) : "");
  }
  return text.empty() ? "" : "  Nearest to their limits:\n" + text;
}

std::string not_met(const SceneAdvice& advice) {
  std::string text;
  for (const AdvisedRequirement& one : advice.requirements) {
    if (one.after.verdict == rules::Verdict::pass) continue;
    text += fmt::format("    {}: {}, {}{}\n", requirement_words(one), value_words(one.after),
                        calc::name_of(one.after.verdict),
                        one.not_searched.empty() ? "" : " (" + one.not_searched + ")");
  }
  for (const std::string& one : advice.aggregates_not_met) {
    text += "    " + report::printable(one) + "\n";
  }
  return text.empty() ? "" : "  Not met with these levels:\n" + text;
}

std::string saving_words(const SceneAdvice& advice) {
  if (!(advice.now > 0.0)) return "";
  const double share = advice.advised / advice.now - 1.0;
  return fmt::format(" ({}{:.1f} %)", share > 0.0 ? "+" : "", 100.0 * share);
}

std::string found_words(const SceneAdvice& advice) {
  std::string text = fmt::format(
      "  {} with these levels; now {}{}. No levels that meet the conditions need less than {}.\n",
      cost_words(advice, advice.advised), cost_words(advice, advice.now), saving_words(advice),
      cost_words(advice, advice.least));
  if (advice.is_by_flux) {
    text += "  The power of a luminaire is not known: the least light was looked for instead.\n";
  }
  if (!advice.raised_for.empty()) {
    text +=
        "  They are nearer to those of now than the least ones, which would not meet what the\n"
        "  search does not know:\n";
    for (const std::size_t i : advice.raised_for) {
      text += fmt::format("    {}: {}\n", requirement_words(advice.requirements[i]),
                          value_words(advice.requirements[i].after));
    }
  }
  return text + group_table(advice) + limits(advice) + not_met(advice);
}

std::string scene_text(const SceneAdvice& advice) {
  std::string text = advice.scene.empty()
                         ? "Full output:"
                         : fmt::format("Scene '{}':", report::printable(advice.scene));
  const std::string asked = fmt::format("{} requirements", advice.requirements.size());
  switch (advice.outcome) {
    case AdviceOutcome::levels: {
      const auto met = std::count_if(
          advice.requirements.begin(), advice.requirements.end(),
          [](const AdvisedRequirement& one) { return one.after.verdict == rules::Verdict::pass; });
      text += fmt::format(" levels found; checked with other random numbers, {} of {} pass\n", met,
                          asked);
      return text + found_words(advice);
    }
    case AdviceOutcome::more_light:
      text +=
          " no levels up to full output meet all conditions; with more light these would, by\n"
          "  the same light as calculated (100 % is what the luminaires have)\n";
      text += found_words(advice);
      break;
    case AdviceOutcome::contradiction:
      text += fmt::format(
          " no levels meet all conditions; none up to {:g} times the light were found either\n",
          kMostAdvisedLight);
      break;
    case AdviceOutcome::too_uncertain:
      return text + " the intervals are too wide to find levels; a smaller --tolerance helps\n";
    case AdviceOutcome::none_found:
      return text + fmt::format(" no levels: {}\n", report::printable(advice.reason));
  }
  text += "  These cannot be met together by dimming; without any one of them all others can:\n";
  for (const std::size_t i : advice.contradicting) {
    text += fmt::format("    {}: {} now\n", requirement_words(advice.requirements[i]),
                        value_words(advice.requirements[i].before));
  }
  return text;
}

}  // namespace

std::string render_advice_text(const Advice& advice) {
  std::string text = report::printable(advice.project) + "\n";
  for (const SceneAdvice& scene : advice.scenes) text += "\n" + scene_text(scene);
  return text;
}

}  // namespace cli
