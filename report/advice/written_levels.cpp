#include "report/advice/written_levels.h"

#include "calc/base/sentences.h"
#include "report/advice/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace cli {
namespace {

calc::Message no_group_words(std::size_t without, std::size_t all) {
  return calc::say<calc::Sentence::advice_no_group>(without, all);
}

std::string unused(const std::string& wish, const std::set<std::string>& taken) {
  std::string name = wish;
  for (int i = 2; taken.contains(name); ++i) name = fmt::format("{}-{}", wish, i);
  return name;
}

}  // namespace

check::SceneLevels levels_of(const SceneAdvice& advice, const report::ProjectPart& part) {
  check::SceneLevels levels;
  std::set<std::string> scenes, groups;
  for (const report::SceneRow& scene : part.scenes) scenes.insert(scene.id);
  for (const AdvisedGroup& group : advice.groups) groups.insert(group.group);
  levels.takes_full_output = advice.scene.empty();
  levels.scene = levels.takes_full_output ? unused("advised", scenes) : advice.scene;
  for (const AdvisedGroup& group : advice.groups) {
    levels.level_of_group.emplace_back(group.group, group.level);
  }
  if (groups.contains("")) levels.group_of_others = unused("others", groups);
  return levels;
}

LevelsText with_levels(const std::string& bytes, const std::string& file,
                       const std::vector<SceneAdvice>& scenes, const report::ProjectPart& part) {
  std::string text = bytes;
  for (const SceneAdvice& scene : scenes) {
    if (scene.outcome != AdviceOutcome::levels) continue;
    calc::Diagnostics diagnostics;
    auto changed = check::with_scene_levels(text, file, levels_of(scene, part), diagnostics);
    if (!changed) return {std::nullopt, diagnostics.all().front().message};
    text = std::move(changed->text);
  }
  return {std::move(text), ""};
}

CheckLevels levels_check(const std::string& bytes, const std::string& file,
                         const report::ProjectPart& part, const CheckText& check) {
  return
      [&](const SceneAdvice& advice, calc::Message& reason) -> std::optional<report::ProjectPart> {
        calc::Diagnostics diagnostics;
        const check::SceneLevels levels = levels_of(advice, part);
        const auto text = check::with_scene_levels(bytes, file, levels, diagnostics);
        if (!text) {
          reason = calc::Message::words(diagnostics.all().front().message);
          return std::nullopt;
        }
        if (!levels.group_of_others.empty() && text->grouped == 0) {
          for (const AdvisedGroup& group : advice.groups) {
            if (group.group.empty()) reason = no_group_words(group.luminaires, group.luminaires);
          }
          return std::nullopt;
        }
        std::string problem;
        auto changed = check(text->text, problem);
        reason = changed ? not_dimmed(advice, levels, *changed) : calc::Message::words(problem);
        return reason.empty() ? std::move(changed) : std::nullopt;
      };
}

calc::Message not_dimmed(const SceneAdvice& advice, const check::SceneLevels& levels,
                         const report::ProjectPart& changed) {
  for (const AdvisedGroup& group : advice.groups) {
    const std::string& name = group.group.empty() ? levels.group_of_others : group.group;
    std::size_t count = 0;
    for (const report::SpacePart& space : changed.spaces) {
      for (const auto& [group_and_type, luminaires] : space.power.luminaires_of) {
        if (group_and_type.first == name) count += luminaires;
      }
    }
    if (count == group.luminaires) continue;
    return group.group.empty()
               ? no_group_words(group.luminaires - std::min(count, group.luminaires),
                                group.luminaires)
               : calc::say<calc::Sentence::advice_group_differs>(group.group, group.luminaires,
                                                                 count);
  }
  return {};
}

std::string lost_by_writing(const std::vector<SceneAdvice>& scenes,
                            const report::ProjectPart& before, const report::ProjectPart& after) {
  for (const SceneAdvice& scene : scenes) {
    if (scene.outcome != AdviceOutcome::levels) continue;
    for (const AdvisedRequirement& one : scene.requirements) {
      const rules::Verdict verdict = finding_at(after, one.where).verdict;
      if (one.after.verdict == rules::Verdict::pass && verdict != rules::Verdict::pass) {
        return fmt::format("{} ({})", finding_words(before, one.where), calc::name_of(verdict));
      }
    }
  }
  const std::vector<std::string> broken = broken_findings(before, after);
  return broken.empty() ? "" : broken.front();
}

}  // namespace cli
