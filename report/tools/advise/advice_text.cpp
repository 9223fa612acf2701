#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"
#include "report/tools/advise/advice.h"
#include "report/tools/advise/advice_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cli {
namespace {

// Of what limits; all are in the JSON.
constexpr std::size_t kMostNamedLimits = 5;

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
                        group.luminaires, level_words(group.now), level_words(group.level));
  }
  return text;
}

std::string nearest_limits(const SceneAdvice& advice) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<const AdvisedRequirement*> near;
  for (const AdvisedRequirement& one : advice.requirements) {
    if (one.not_searched.empty() && one.after.verdict == rules::Verdict::pass) near.push_back(&one);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const AdvisedRequirement* a, const AdvisedRequirement* b) {
                     return rules::margin_or(a->after, kFar) < rules::margin_or(b->after, kFar);
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

std::string what_limits(const SceneAdvice& advice) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostNamedLimits, advice.limits.size()); ++i) {
    const AdvisedLimit& limit = advice.limits[i];
    const AdvisedRequirement& one = advice.requirements[limit.requirement];
    text += fmt::format(
        "    {}: {}{}; {}\n", requirement_words(one), value_words(one.after),
        limit.place_m ? ", least room at " + report::format_position(*limit.place_m) : "",
        cost_words(limit.cost_per_percent, advice.unit));
    if (const std::string shares = share_words(advice, limit); !shares.empty()) {
      text += "      " + shares + "\n";
    }
  }
  return "  Limits that decide, and what each would save if 1 % looser:\n" + text;
}

std::string not_met(const SceneAdvice& advice) {
  std::string text;
  for (const AdvisedRequirement& one : advice.requirements) {
    if (one.after.verdict == rules::Verdict::pass) continue;
    text += fmt::format("    {}: {}, {}{}\n", requirement_words(one), value_words(one.after),
                        calc::name_of(one.after.verdict),
                        one.not_searched.empty() ? "" : " (" + one.not_searched.english() + ")");
  }
  for (const std::string& one : advice.aggregates_not_met) {
    text += "    " + report::printable(one) + "\n";
  }
  return text.empty() ? "" : "  Not met with these levels:\n" + text;
}

std::string found_words(const SceneAdvice& advice) {
  std::string text = "  " + cost_sentence(advice) + "\n";
  if (const std::string note = unit_note(advice.unit); !note.empty()) text += "  " + note + "\n";
  if (!advice.raised_for.empty()) {
    text += std::string("  ") + kRaised + "\n";
    for (const std::size_t i : advice.raised_for) {
      text += fmt::format("    {}: {}\n", requirement_words(advice.requirements[i]),
                          value_words(advice.requirements[i].after));
    }
  }
  const std::string left_alone = left_alone_words(advice);
  return text + group_table(advice) + (left_alone.empty() ? "" : "  " + left_alone + "\n") +
         (advice.limits.empty() ? nearest_limits(advice) : what_limits(advice)) + not_met(advice);
}

std::string scene_text(const SceneAdvice& advice) {
  std::string text = fmt::format("{}: {}\n", scene_words(advice.scene), outcome_words(advice));
  if (advice.has_levels()) text += found_words(advice);
  if (advice.contradicting.empty()) return text;
  text += "  " + contradiction_words(advice) + ":\n";
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
  if (!advice.not_met_besides.empty()) text += "\nNot met, whatever the levels:\n";
  for (const std::string& one : advice.not_met_besides) {
    text += "  " + report::printable(one) + "\n";
  }
  if (advice.packages) text += "\n" + render_package_advice_text(*advice.packages);
  text += render_room_advice_text(advice.rooms);
  return advice.written ? text + "\nWritten: " + written_words(*advice.written) : text;
}

}  // namespace cli
