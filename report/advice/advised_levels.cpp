#include "report/advice/advised_levels.h"

#include "calc/base/sentences.h"
#include "report/advice/findings.h"
#include "report/advice/written_levels.h"
#include "rules/verdict/outcome.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cli {
namespace {

std::vector<std::string> scenes_not_met(const report::ProjectPart& part) {
  std::vector<std::string> scenes;
  for (const FindingPlace& where : counted_findings(part)) {
    const rules::Finding& finding = finding_at(part, where);
    const rules::Requirement& requirement = finding.requirement;
    const bool is_open =
        finding.verdict == rules::Verdict::fail || finding.verdict == rules::Verdict::undecided;
    if (!is_open || !hangs_on_levels(requirement)) continue;
    if (std::find(scenes.begin(), scenes.end(), requirement.scene) == scenes.end()) {
      scenes.push_back(requirement.scene);
    }
  }
  return scenes;
}

// Levels that only save power of what passes make nothing pass.
bool mends_something(const SceneAdvice& advice, const report::ProjectPart& before) {
  return std::any_of(advice.requirements.begin(), advice.requirements.end(),
                     [&](const AdvisedRequirement& one) {
                       return finding_at(before, one.where).verdict != rules::Verdict::pass &&
                              one.after.verdict == rules::Verdict::pass;
                     });
}

// before: as it was checked first, only as far as verdicts needed.
report::LevelAdvice told(const SceneAdvice& advice, const report::ProjectPart& part,
                         const report::ProjectPart& before) {
  report::LevelAdvice level;
  level.scene = advice.scene;
  level.outcome = advice.outcome;
  level.reason = advice.reason;
  level.unit = advice.unit;
  const auto name = [&](std::size_t index) {
    const FindingPlace& where = advice.requirements[index].where;
    return report::RequirementName{part.spaces[where.space].planes[where.plane].id,
                                   finding_at(part, where).requirement.id};
  };
  for (const std::size_t i : advice.contradicting) level.excluding.push_back(name(i));
  if (!advice.has_levels()) return level;
  if (!mends_something(advice, before)) {
    level.outcome = AdviceOutcome::none_found;
    level.reason = calc::say<calc::Sentence::advice_not_searched>();
    return level;
  }
  level.now = advice.now;
  level.advised = advice.advised;
  level.groups = advice.groups;
  level.asked = advice.requirements.size();
  for (std::size_t i = 0; i < advice.requirements.size(); ++i) {
    if (advice.requirements[i].after.verdict == rules::Verdict::pass) {
      ++level.passing;
    } else {
      level.not_met.push_back(name(i));
    }
  }
  level.aggregates_not_met = advice.aggregates_not_met;
  return level;
}

}  // namespace

std::vector<report::LevelAdvice> advised_levels(const CheckedText& project,
                                                const AdviceSettings& settings,
                                                const CheckLight& check_light,
                                                const CheckText& check) {
  std::vector<report::LevelAdvice> all;
  const std::vector<std::string> scenes = scenes_not_met(project.part);
  if (scenes.empty()) return all;
  KeptLight light;
  const std::optional<report::ProjectPart> part = check_light(light);
  if (!part) {
    for (const std::string& scene : scenes) {
      report::LevelAdvice& one = all.emplace_back();
      one.scene = scene;
      one.reason = calc::say<calc::Sentence::advice_no_light>();
    }
    return all;
  }
  for (const std::string& scene : scenes) {
    AdviceSettings of_scene = settings;
    of_scene.is_one_scene = true;
    of_scene.scene = scene;
    for (const SceneAdvice& one :
         find_advice(*part, light.planes(), of_scene,
                     levels_check(project.bytes, project.file, *part, check))) {
      all.push_back(told(one, *part, project.part));
    }
  }
  return all;
}

}  // namespace cli
