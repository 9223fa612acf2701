#include "report/advice/find_advice.h"

#include "calc/base/sentences.h"
#include "report/advice/level_solver.h"
#include "report/text/clause_words.h"
#include "report/text/words.h"
#include "rules/measure/level_conditions.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace cli {
namespace {

// Of a requirement, at a time: few of a plane's points ever matter.
constexpr std::size_t kWorstConditions = 4;
// The conditions keep one half width of the interval away from a limit, since that of a sum of
// groups is not known before; where judging wants more, so much more.
constexpr double kMoreSafety = 1.5;
// What is not met even by the favourable ends of all intervals surely cannot be met.
constexpr double kWholeInterval = -1.0;
constexpr int kMostTries = 10, kMostChecks = 4;
constexpr double kSameStep = 1e-9;
constexpr double kLeastEnergyShare = 1e-6;  // kWh of a year by W

using Levels01 = std::vector<double>;

// A requirement that counts, with where it is in the part, and its conditions.
struct Asked {
  FindingPlace where;
  const PlaneLight* light = nullptr;
  std::optional<rules::LevelConditions> conditions;
  double safety = 1.0;

  bool is_searched() const { return conditions && conditions->problem().empty(); }
};

// Whether some levels meet conditions.
enum class Can { yes, no, unknown };

class SceneSearch {
 public:
  SceneSearch(const report::ProjectPart& part, const LightOfPlanes& light,
              const AdviceSettings& settings, const std::string& scene)
      : part_(part), settings_(settings) {
    advice_.scene = scene;
    advice_.unit = settings.unit;
    find_groups();
    find_asked(light);
    sort_by_name();
  }

  bool is_anything_asked() const { return !asked_.empty(); }

  SceneAdvice search(const CheckLevels& check) {
    settle_costs();
    take_now();
    if (const calc::Message why = why_none(); !why.empty()) {
      advice_.reason = why;
      return std::move(advice_);
    }
    for (int tries = 0; tries < kMostChecks; ++tries) {
      const std::optional<Levels> found = levels_that_judge();
      if (!found) break;
      take(*found);
      advice_.outcome = AdviceOutcome::levels;
      calc::Message reason;
      const std::optional<report::ProjectPart> changed = check(advice_, reason);
      if (!changed) {
        advice_.outcome = AdviceOutcome::none_found;
        advice_.reason = reason;
        return std::move(advice_);
      }
      if (take_findings(*changed)) {
        if (settings_.is_trial ? is_all_that_is_known_met() : broken_by_levels().empty()) {
          return std::move(advice_);
        }
        if (settings_.is_trial) break;
        raise(*found, check);
        return std::move(advice_);
      }
      advice_.outcome = AdviceOutcome::none_found;
      advice_.reason = calc::say<calc::Sentence::advice_not_confirmed>();
    }
    if (settings_.is_trial) {
      for (Asked& asked : asked_) asked.safety = 1.0;
      advice_.outcome = can_be_met(kWholeInterval, {}) == Can::no ? AdviceOutcome::contradiction
                                                                  : AdviceOutcome::none_found;
    } else if (advice_.outcome == AdviceOutcome::none_found && advice_.reason.empty()) {
      explain();
    }
    return std::move(advice_);
  }

 private:
  void find_groups() {
    // Where nothing is asked darkness would save most, and nobody wants that.
    std::set<std::string> asked;
    for (const report::SpacePart& space : part_.spaces) {
      if (!asks_for_light(space)) continue;
      for (const report::LuminaireMark& mark : space.luminaires) asked.insert(mark.group);
    }
    std::map<std::string, AdvisedGroup> groups;
    std::set<std::string> left_alone;
    for (const report::SpacePart& space : part_.spaces) {
      // Of a road one of each row counts, though many give light.
      for (const auto& [group_and_type, count] : space.power.luminaires_of) {
        const auto& [name, type] = group_and_type;
        if (!asked.contains(name)) {
          left_alone.insert(name);
          continue;
        }
        AdvisedGroup& group = groups[name];
        group.group = name;
        group.luminaires += count;
        for (const report::LuminaireRow& row : part_.luminaires) {
          if (row.type_id != type) continue;
          group.power_w += static_cast<double>(count) * row.power_w;
          group.flux_lm += static_cast<double>(count) * row.flux_lm;
          if (settings_.unit == CostUnit::watt && !(row.power_w > 0.0)) {
            advice_.unit = CostUnit::lumen;
          }
          break;
        }
      }
    }
    for (auto& [name, group] : groups) group.energy_kwh = energy_kwh(name);
    const auto scene =
        std::find_if(part_.scenes.begin(), part_.scenes.end(),
                     [&](const report::SceneRow& row) { return row.id == advice_.scene; });
    for (auto& [name, group] : groups) {
      group.now = scene == part_.scenes.end() ? 1.0 : report::level_of(*scene, name);
      advice_.groups.push_back(std::move(group));
    }
    advice_.left_alone.assign(left_alone.begin(), left_alone.end());
  }

  // Of all luminaires of a group at full output; 0 = one of their rooms does not state its use.
  double energy_kwh(const std::string& group) const {
    double sum_kwh = 0.0;
    for (const report::SpacePart& space : part_.spaces) {
      const auto& here = space.power.luminaires_of;
      if (std::none_of(here.begin(), here.end(),
                       [&](const auto& one) { return one.first.first == group; })) {
        continue;
      }
      if (!space.energy || !space.energy->problem.empty()) return 0.0;
      const auto own = space.energy->kwh_of_group.find(group);
      if (own != space.energy->kwh_of_group.end()) sum_kwh += own->second;
    }
    return sum_kwh;
  }

  bool is_asked_here(const rules::Finding& finding) const {
    const rules::Requirement& requirement = finding.requirement;
    return requirement.scene == advice_.scene && rules::counts(rules::outcome_of(finding)) &&
           hangs_on_levels(requirement);
  }
  bool asks_for_light(const report::SpacePart& space) const {
    return std::any_of(
        space.planes.begin(), space.planes.end(), [&](const report::PlanePart& plane) {
          return std::any_of(plane.findings.begin(), plane.findings.end(),
                             [&](const rules::Finding& one) { return is_asked_here(one); });
        });
  }

  void find_asked(const LightOfPlanes& light) {
    std::vector<std::string> names;
    for (const AdvisedGroup& group : advice_.groups) names.push_back(group.group);
    for (std::size_t s = 0; s < part_.spaces.size(); ++s) {
      for (std::size_t p = 0; p < part_.spaces[s].planes.size(); ++p) {
        const report::PlanePart& plane = part_.spaces[s].planes[p];
        const auto known = light.find(plane.id);
        for (std::size_t f = 0; f < plane.findings.size(); ++f) {
          const rules::Finding& finding = plane.findings[f];
          const rules::Requirement& requirement = finding.requirement;
          if (!is_asked_here(finding)) continue;
          Asked asked{{s, p, f}, nullptr, std::nullopt};
          AdvisedRequirement told{
              asked.where,
              std::string(report::title_of(part_.spaces[s].name, part_.spaces[s].id)),
              std::string(report::title_of(plane.name, plane.id)),
              finding,
              finding,
              {}};
          if (!is_of_points(requirement)) {
            told.not_searched = calc::say<calc::Sentence::condition_elsewhere>();
          } else if (known == light.end() || !known->second.field.problem.empty()) {
            told.not_searched = calc::say<calc::Sentence::condition_not_calculated>();
          } else {
            asked.light = &known->second;
            asked.conditions.emplace(requirement, asked.light->grid, asked.light->field, names,
                                     settings_.confidence);
            told.not_searched = asked.conditions->problem();
          }
          asked_.push_back(std::move(asked));
          advice_.requirements.push_back(std::move(told));
        }
      }
    }
  }

  // So that of several answers the same one is given in any order of planes.
  void sort_by_name() {
    for (std::size_t i = 0; i < asked_.size(); ++i) by_name_.push_back(i);
    const auto name = [this](std::size_t i) {
      const FindingPlace& where = asked_[i].where;
      return std::tie(part_.spaces[where.space].planes[where.plane].id,
                      finding_at(part_, where).requirement.id);
    };
    std::stable_sort(by_name_.begin(), by_name_.end(),
                     [&](std::size_t a, std::size_t b) { return name(a) < name(b); });
  }

  void settle_costs() {
    problem_.steps = settings_.steps;
    problem_.is_stopped = settings_.is_stopped;
    for (const AdvisedGroup& group : advice_.groups) {
      problem_.cost.push_back(cost_of(group));
      problem_.range.push_back({0.0, 1.0});
    }
  }

  double cost_of(const AdvisedGroup& group) const {
    switch (advice_.unit) {
      case CostUnit::watt:
        return group.power_w;
      case CostUnit::lumen:
        return group.flux_lm;
      case CostUnit::kilowatt_hour:
        break;
    }
    // Of what takes no energy as little light as is enough.
    return std::max(group.energy_kwh, kLeastEnergyShare * group.power_w);
  }

  void take_now() {
    for (std::size_t g = 0; g < advice_.groups.size(); ++g) {
      advice_.now += problem_.cost[g] * advice_.groups[g].now;
    }
  }

  calc::Message why_none() const {
    if (advice_.groups.empty()) return calc::say<calc::Sentence::advice_no_luminaires>();
    for (const AdvisedRequirement& one : advice_.requirements) {
      if (one.before.requirement.state == rules::LightState::end_of_duration) {
        return calc::say<calc::Sentence::advice_of_battery>();
      }
    }
    const bool is_any = std::any_of(asked_.begin(), asked_.end(),
                                    [](const Asked& asked) { return asked.is_searched(); });
    if (is_any) return {};
    const AdvisedRequirement& first = advice_.requirements.front();
    return calc::say<calc::Sentence::advice_no_condition>() + "; " +
           calc::say<calc::Sentence::advice_first_of>(first.plane, first.before.requirement.id,
                                                      first.not_searched);
  }

  // without: indices of requirements that are left out.
  BrokenConditions broken(double safety_share, const std::set<std::size_t>& without = {}) const {
    return [this, safety_share, without](const Levels01& level) {
      std::vector<rules::LevelCondition> all;
      for (const std::size_t i : by_name_) {
        if (!asked_[i].is_searched() || without.contains(i)) continue;
        std::vector<rules::LevelCondition> some =
            asked_[i].conditions->broken(level, safety_share * asked_[i].safety, kWorstConditions);
        for (rules::LevelCondition& one : some) one.asked_by = i;
        std::move(some.begin(), some.end(), std::back_inserter(all));
      }
      return all;
    };
  }

  std::vector<calc::LightScene> scenes_with(const Levels01& level) const {
    calc::LightScene scene;
    scene.id = "advised";
    for (std::size_t g = 0; g < level.size(); ++g) {
      scene.level_of_group.emplace_back(advice_.groups[g].group, level[g]);
    }
    return {scene};
  }

  // As a check with these levels would, of the same light.
  rules::Finding judged(const Asked& asked, const Levels01& level) const {
    rules::Requirement requirement = finding_at(part_, asked.where).requirement;
    requirement.scene = "advised";
    rules::Finding finding =
        rules::judge_plane({requirement}, asked.light->grid, asked.light->field, scenes_with(level),
                           settings_.confidence)
            .front();
    finding.requirement.scene = advice_.scene;
    return finding;
  }

  // Levels by which everything that was searched passes, of the light that is known. Empty: none
  // were found.
  std::optional<Levels> levels_that_judge() {
    for (int tries = 0; tries < kMostTries; ++tries) {
      const LevelAnswer answer = least_levels(problem_, broken(1.0));
      if (!answer.levels) {
        are_no_steps_ = answer.is_proven_none;
        return std::nullopt;
      }
      bool is_good = true;
      for (Asked& asked : asked_) {
        if (!asked.is_searched()) continue;
        if (judged(asked, answer.levels->level).verdict == rules::Verdict::pass) continue;
        asked.safety *= kMoreSafety;
        is_good = false;
      }
      if (is_good) return answer.levels;
    }
    advice_.reason = calc::say<calc::Sentence::advice_wants_room>();
    return std::nullopt;
  }

  void take(const Levels& levels) {
    for (std::size_t g = 0; g < advice_.groups.size(); ++g) {
      advice_.groups[g].level = levels.level[g];
    }
    advice_.advised = levels.cost;
    advice_.least = levels.least_cost;
    take_limits(levels);
  }

  void take_limits(const Levels& levels) {
    advice_.limits.clear();
    std::map<std::size_t, double> dearest;
    for (const ConditionPrice& price : levels.price) {
      const std::size_t i = price.condition.asked_by;
      const Asked& asked = asked_[i];
      const double limit = advice_.requirements[i].before.requirement.limit;
      const double cost =
          0.01 * limit * price.cost_per_lx * std::abs(asked.conditions->lx_per_limit(levels.level));
      auto one = std::find_if(advice_.limits.begin(), advice_.limits.end(),
                              [&](const AdvisedLimit& known) { return known.requirement == i; });
      if (one == advice_.limits.end()) one = advice_.limits.insert(one, {i, 0.0, {}, {}});
      one->cost_per_percent += cost;
      if (cost <= dearest[i]) continue;
      dearest[i] = cost;
      one->lx = asked.conditions->light_lx(price.condition, levels.level);
      one->place_m.reset();
      if (price.condition.point) {
        one->place_m = asked.light->grid.position_m[*price.condition.point];
      }
    }
    std::stable_sort(advice_.limits.begin(), advice_.limits.end(),
                     [](const AdvisedLimit& a, const AdvisedLimit& b) {
                       return a.cost_per_percent > b.cost_per_percent;
                     });
  }

  // True: all that was searched passes.
  bool take_findings(const report::ProjectPart& changed) {
    bool is_good = true;
    advice_.aggregates_not_met.clear();
    for (const rules::AggregateFinding& finding : changed.aggregates) {
      if (!rules::counts(rules::outcome_of(finding)) || finding.verdict == rules::Verdict::pass) {
        continue;
      }
      advice_.aggregates_not_met.push_back(fmt::format(
          "{} ({})", finding.clause.empty() ? finding.id : report::clause_words({}, finding),
          calc::name_of(finding.verdict)));
    }
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      Asked& asked = asked_[i];
      advice_.requirements[i].after = finding_at(changed, asked.where);
      if (!asked.is_searched()) continue;
      if (advice_.requirements[i].after.verdict == rules::Verdict::pass) continue;
      asked.safety *= kMoreSafety;
      is_good = false;
    }
    return is_good;
  }

  // What passes now, takes no part in the search and does not pass with the levels taken.
  std::vector<std::size_t> broken_by_levels() const {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const AdvisedRequirement& one = advice_.requirements[i];
      if (!asked_[i].is_searched() && one.before.verdict == rules::Verdict::pass &&
          one.after.verdict != rules::Verdict::pass) {
        broken.push_back(i);
      }
    }
    return broken;
  }

  // Also what takes no part in the search, as far as light alone judges it.
  bool is_all_that_is_known_met() const {
    return std::all_of(advice_.requirements.begin(), advice_.requirements.end(),
                       [](const AdvisedRequirement& one) {
                         return !is_judged_by_light(one.after.requirement) ||
                                one.after.verdict == rules::Verdict::pass;
                       });
  }

  bool is_all_searched_met_now() const {
    return std::all_of(advice_.requirements.begin(), advice_.requirements.end(),
                       [](const AdvisedRequirement& one) {
                         return !one.not_searched.empty() ||
                                one.before.verdict == rules::Verdict::pass;
                       });
  }

  // Levels between those found and those of now, which break nothing: what the search knows is met
  // on all of the way, if it is met at both ends, since conditions that are linear leave no gap.
  void raise(const Levels& found, const CheckLevels& check) {
    constexpr int kHalvings = 6;
    const std::vector<std::size_t> broken = broken_by_levels();
    std::optional<SceneAdvice> best;
    double low = 0.0, high = 1.0;
    const int halvings = is_all_searched_met_now() ? kHalvings : 0;
    for (int halving = 0; halving < halvings; ++halving) {
      const double part = 0.5 * (low + high);
      Levels levels{{}, 0.0, found.least_cost, {}};
      for (std::size_t g = 0; g < advice_.groups.size(); ++g) {
        const double from = found.level[g], to = advice_.groups[g].now;
        // Whole steps, towards the levels of now.
        const double steps = (from + part * (to - from)) * settings_.steps;
        const double whole =
            (to > from ? std::ceil(steps - kSameStep) : std::floor(steps + kSameStep)) /
            settings_.steps;
        levels.level.push_back(to > from ? std::min(whole, to) : std::max(whole, to));
        levels.cost += problem_.cost[g] * levels.level.back();
      }
      take(levels);
      calc::Message reason;
      const std::optional<report::ProjectPart> changed = check(advice_, reason);
      if (!changed) break;
      if (take_findings(*changed) && broken_by_levels().empty()) {
        best = advice_;
        high = part;
      } else {
        low = part;
      }
    }
    if (best) {
      advice_ = *std::move(best);
      advice_.raised_for = broken;
      return;
    }
    advice_.outcome = AdviceOutcome::none_found;
    advice_.reason = calc::say<calc::Sentence::advice_breaks>(
        advice_.requirements[broken.front()].plane,
        advice_.requirements[broken.front()].before.requirement.id);
    for (AdvisedRequirement& one : advice_.requirements) one.after = one.before;
  }

  // Levels up to full output, of any size.
  Can can_be_met(double safety_share, const std::set<std::size_t>& without) const {
    LevelProblem any = problem_;
    any.steps = 0;
    const LevelAnswer answer = least_levels(any, broken(safety_share, without));
    if (answer.levels) return Can::yes;
    return answer.is_proven_none ? Can::no : Can::unknown;
  }

  // Why there are no levels.
  void explain() {
    for (Asked& asked : asked_) asked.safety = 1.0;
    if (can_be_met(1.0, {}) == Can::yes) {
      advice_.reason = are_no_steps_ ? calc::say<calc::Sentence::advice_no_steps>()
                                     : calc::say<calc::Sentence::advice_maybe_steps>();
      return;
    }
    if (is_all_searched_met_now()) {
      advice_.reason = calc::say<calc::Sentence::advice_now_passes>();
      return;
    }
    switch (can_be_met(kWholeInterval, {})) {
      case Can::yes:
        advice_.outcome = AdviceOutcome::too_uncertain;
        return;
      case Can::unknown:
        advice_.reason = calc::say<calc::Sentence::advice_search_ended>();
        return;
      case Can::no:
        break;
    }
    find_contradiction();
    find_more_light();
  }

  // What cannot be met together: one after the other is left out, and comes back unless there are
  // still surely no levels without it.
  void find_contradiction() {
    std::set<std::size_t> without;
    for (const std::size_t i : by_name_) {
      if (!asked_[i].is_searched()) continue;
      without.insert(i);
      if (can_be_met(kWholeInterval, without) != Can::no) {
        without.erase(i);
        advice_.contradicting.push_back(i);
      }
    }
    std::sort(advice_.contradicting.begin(), advice_.contradicting.end());
    advice_.outcome = AdviceOutcome::contradiction;
  }

  void find_more_light() {
    LevelProblem more = problem_;
    for (LevelRange& range : more.range) range.high = kMostAdvisedLight;
    for (int tries = 0; tries < kMostTries; ++tries) {
      const LevelAnswer answer = least_levels(more, broken(1.0));
      if (!answer.levels) break;
      bool is_good = true;
      for (std::size_t i = 0; i < asked_.size(); ++i) {
        if (asked_[i].light == nullptr) {
          rules::Finding& after = advice_.requirements[i].after;
          after = advice_.requirements[i].before;
          after.verdict = rules::Verdict::not_judged;
          after.reason = calc::say<calc::Sentence::more_light_not_calculated>();
          continue;
        }
        rules::Finding finding = judged(asked_[i], answer.levels->level);
        if (asked_[i].is_searched() && finding.verdict != rules::Verdict::pass) {
          asked_[i].safety *= kMoreSafety;
          is_good = false;
        }
        advice_.requirements[i].after = std::move(finding);
      }
      if (!is_good) continue;
      take(*answer.levels);
      advice_.outcome = AdviceOutcome::more_light;
      return;
    }
    for (AdvisedRequirement& one : advice_.requirements) one.after = one.before;
  }

  const report::ProjectPart& part_;
  const AdviceSettings& settings_;
  SceneAdvice advice_;
  std::vector<Asked> asked_;
  std::vector<std::size_t> by_name_;  // of them
  LevelProblem problem_;
  bool are_no_steps_ = false;  // proven: no levels in whole steps
};

}  // namespace

std::vector<rules::Finding> judged_by_light(const report::PlanePart& plane, const PlaneLight& light,
                                            const std::vector<calc::LightScene>& scenes,
                                            double confidence) {
  std::vector<rules::Requirement> requirements;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& requirement = finding.requirement;
    if (rules::counts(rules::outcome_of(finding)) && is_judged_by_light(requirement)) {
      requirements.push_back(requirement);
    }
  }
  return rules::judge_plane(requirements, light.grid, light.field, scenes, confidence);
}

std::vector<SceneAdvice> find_advice(const report::ProjectPart& part, const LightOfPlanes& light,
                                     const AdviceSettings& settings, const CheckLevels& check) {
  std::vector<std::string> scenes;
  const auto add = [&](const std::string& scene) {
    if (settings.is_one_scene && scene != settings.scene) return;
    if (std::find(scenes.begin(), scenes.end(), scene) == scenes.end()) scenes.push_back(scene);
  };
  add("");
  for (const report::SceneRow& scene : part.scenes) add(scene.id);
  std::vector<SceneAdvice> all;
  for (const std::string& scene : scenes) {
    SceneSearch search(part, light, settings, scene);
    if (search.is_anything_asked()) all.push_back(search.search(check));
  }
  return all;
}

}  // namespace cli
