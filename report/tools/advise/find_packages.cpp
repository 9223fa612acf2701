#include "report/tools/advise/find_packages.h"

#include "calc/scene/luminaire_sums.h"
#include "report/advice/findings.h"
#include "report/advice/written_levels.h"
#include "report/check/package_changes.h"
#include "report/text/words.h"
#include "report/tools/advise/advice_words.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kMostCombinations = 1000, kMostTried = 8;

struct Combination {
  std::vector<std::size_t> choice;  // [type], of TypeChoices::light
  double cost = 0.0, flux_lm = 0.0;
  std::size_t changed = 0;  // types that do not stay as they are
};

struct TypeChoices {
  std::size_t index = 0;  // into Project::luminaire_types
  std::vector<PackageLight> light;
  std::size_t now = 0;  // of them
};

// Channels times their factors, > 0: as if their luminaires had so much more light.
void scale(calc::PlaneField& field, const std::vector<double>& factor) {
  const std::size_t channels = field.channels.size();
  const auto times = [&](std::vector<double>& values, bool is_squared) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double one = factor[i / field.points % channels];
      values[i] *= is_squared ? one * one : one;
    }
  };
  for (std::vector<double>* lx :
       {&field.direct_exact_lx, &field.direct_sampled_lx, &field.indirect_lx,
        &field.even_direct_sampled_lx, &field.even_indirect_lx}) {
    times(*lx, false);
  }
  for (std::vector<double>* glare : {&field.glare.value, &field.glare.low, &field.glare.high}) {
    times(*glare, true);
  }
  // Of which channel the largest sample is nobody knows: the most that it can be.
  const auto [least, most] = std::minmax_element(factor.begin(), factor.end());
  for (float& share : field.largest_share) share *= static_cast<float>(*most / *least);
  for (double& lx : field.largest_sample_lx) lx *= *most;
}

class PackageSearch {
 public:
  PackageSearch(const RoomQuestions& questions, const AdviceSettings& settings)
      : questions_(questions), settings_(settings), part_(questions.part) {
    settings_.is_trial = true;
    // It is copied again and again.
    for (report::SpacePart& space : part_.spaces) {
      for (report::PlanePart& plane : space.planes) plane.points.clear();
    }
    find_types();
  }

  PackageAdvice search() {
    found_.problem = why_none();
    if (!found_.problem.empty()) return std::move(found_);
    take_light();
    for (const Combination& one : all_combinations()) {
      if (settings_.is_stopped()) return std::move(found_);
      if (checked_ == 2 * kMostTried) {
        found_.problem = fmt::format(
            "{} combinations that may be sufficient do not pass the check; the last: {}", checked_,
            why_not_checked_);
        return std::move(found_);
      }
      take(one);
      switch (look_at(one)) {
        case Enough::yes:
          return std::move(found_);
        case Enough::maybe:
          ++found_.not_excluded;
          break;
        case Enough::no:
          break;
      }
    }
    found_.problem =
        checked_ > 0
            ? "the combination that may be sufficient does not pass the check: " + why_not_checked_
            : "no combination of packages meets all requirements on light; with the one that needs "
              "most " +
                  found_.next_below;
    if (found_.not_excluded > 0) {
      found_.problem += fmt::format("; {} of {} are undecided, and a smaller --tolerance may help",
                                    found_.not_excluded, found_.combinations);
    }
    found_.next_below.clear();
    return std::move(found_);
  }

 private:
  const calc::LuminaireType& type_at(const TypeChoices& choices) const {
    return questions_.project.luminaire_types[choices.index];
  }
  // Of a luminaire, or of one of the emitters that it has.
  std::size_t main_type(std::size_t type) const {
    while (questions_.project.luminaire_types[type].is_further_emitter) --type;
    return type;
  }

  void find_types() {
    const calc::Project& project = questions_.project;
    for (std::size_t i = 0; i < project.luminaire_types.size(); ++i) {
      const calc::LuminaireType& type = project.luminaire_types[i];
      if (type.packages.empty() || type.is_further_emitter) continue;
      std::size_t asked = 0, unasked = 0;
      for (std::size_t s = 0; s < questions_.part.spaces.size(); ++s) {
        const calc::Space* space = space_of(questions_, s);
        if (space == nullptr) continue;
        const auto count = static_cast<std::size_t>(
            std::count_if(space->luminaires.begin(), space->luminaires.end(),
                          [&](const calc::Luminaire& one) { return one.type == i; }));
        (asks_for_light(questions_.part.spaces[s]) ? asked : unasked) += count;
      }
      if (asked == 0) continue;
      TypeChoices choices{i, {}, 0};
      if (!type.package) {
        choices.light.push_back({"", calc::luminaire_flux_lm(project, type), type.power_w});
        found_.is_by_flux = found_.is_by_flux || !(type.power_w > 0.0);
      }
      for (const calc::LampPackage& package : type.packages) {
        choices.light.push_back({package.article, package.flux_lm, package.power_w});
      }
      choices.now = type.package.value_or(0);
      const PackageLight& now = choices.light[choices.now];
      found_.types.push_back({type.id, asked + unasked, unasked, now, now});
      types_.push_back(std::move(choices));
    }
    found_.passing_now = count_all(questions_.part).passing;
  }

  // Where nothing is asked darkness would be cheapest, and nobody wants that.
  static bool asks_for_light(const report::SpacePart& space) {
    return std::any_of(
        space.planes.begin(), space.planes.end(), [](const report::PlanePart& plane) {
          return std::any_of(plane.findings.begin(), plane.findings.end(),
                             [](const rules::Finding& one) {
                               return rules::counts(rules::outcome_of(one)) &&
                                      is_judged_by_light(one.requirement) &&
                                      rules::is_lower_limit(one.requirement.comparison);
                             });
        });
  }

  double cost(const AdvisedPackage& type, const PackageLight& light) const {
    return static_cast<double>(type.luminaires) *
           (found_.is_by_flux ? light.flux_lm : light.power_w);
  }

  std::string why_none() {
    if (types_.empty()) {
      return "no luminaire type in a room with requirements has a <package>";
    }
    for (const FindingPlace& where : counted_findings(questions_.part)) {
      const rules::Finding& finding = finding_at(questions_.part, where);
      if (finding.verdict != rules::Verdict::not_judged) continue;
      if (!is_judged_by_light(finding.requirement)) continue;
      return fmt::format("{} is not judged, whatever the light: {}",
                         finding_words(questions_.part, where), finding.reason.english());
    }
    std::size_t combinations = 1;
    for (const TypeChoices& type : types_) {
      combinations *= type.light.size();
      if (combinations > kMostCombinations) {
        return fmt::format("the packages have more than {} combinations", kMostCombinations);
      }
    }
    found_.combinations = combinations;
    for (const AdvisedPackage& type : found_.types) found_.now += cost(type, type.now);
    return "";
  }

  // Cheapest first; of equal ones that which changes least.
  std::vector<Combination> all_combinations() const {
    std::vector<Combination> all;
    for (std::size_t number = 0; number < found_.combinations; ++number) {
      Combination one;
      std::size_t rest = number;
      for (std::size_t t = 0; t < types_.size(); ++t) {
        const std::size_t choice = rest % types_[t].light.size();
        rest /= types_[t].light.size();
        const PackageLight& light = types_[t].light[choice];
        one.choice.push_back(choice);
        one.cost += cost(found_.types[t], light);
        one.flux_lm += static_cast<double>(found_.types[t].luminaires) * light.flux_lm;
        one.changed += choice != types_[t].now ? 1 : 0;
      }
      all.push_back(std::move(one));
    }
    std::stable_sort(all.begin(), all.end(), [](const Combination& a, const Combination& b) {
      if (a.cost != b.cost) return a.cost < b.cost;
      if (a.changed != b.changed) return a.changed < b.changed;
      return a.flux_lm < b.flux_lm;
    });
    return all;
  }

  // Which type every channel of every plane is of; where luminaires of several types share one, the
  // light of each luminaire.
  void take_light() {
    std::optional<LightOfPlanes> apart;
    for (std::size_t s = 0; s < questions_.part.spaces.size(); ++s) {
      const calc::Space* space = space_of(questions_, s);
      if (space == nullptr) continue;
      std::map<std::string, std::set<std::size_t>> types_of_group;
      for (const calc::Luminaire& one : space->luminaires) {
        types_of_group[one.group].insert(main_type(one.type));
      }
      const bool is_mixed = std::any_of(types_of_group.begin(), types_of_group.end(),
                                        [](const auto& group) { return group.second.size() > 1; });
      if (is_mixed && !apart) apart = questions_.light_apart();
      const LightOfPlanes& light = is_mixed ? *apart : questions_.light;
      for (const report::PlanePart& plane : questions_.part.spaces[s].planes) {
        const auto known = light.find(plane.id);
        if (known == light.end()) continue;
        const calc::PlaneField& field = known->second.field;
        std::vector<std::size_t> types;
        for (std::size_t c = 0; c < field.channels.size(); ++c) {
          const std::set<std::size_t>& of_group = types_of_group[field.channels[c].group];
          if (is_mixed && c < space->luminaires.size()) {
            types.push_back(main_type(space->luminaires[c].type));
          } else if (of_group.size() == 1) {
            types.push_back(*of_group.begin());
          }
        }
        if (types.size() != field.channels.size()) continue;  // the check says what it is like
        light_.emplace(plane.id, known->second);
        types_of_channels_.emplace(plane.id, std::move(types));
      }
    }
  }

  void take(const Combination& one) {
    found_.advised = one.cost;
    scaled_ = light_;
    std::map<std::size_t, double> factor_of_type;
    for (std::size_t t = 0; t < types_.size(); ++t) {
      const PackageLight& light = types_[t].light[one.choice[t]];
      found_.types[t].advised = light;
      factor_of_type[types_[t].index] = light.flux_lm / found_.types[t].now.flux_lm;
      for (report::LuminaireRow& row : part_.luminaires) {
        if (row.type_id != type_at(types_[t]).id) continue;
        row.flux_lm = light.flux_lm;
        row.power_w = light.power_w;
      }
    }
    for (auto& [plane, light] : scaled_) {
      std::vector<double> factor;
      for (const std::size_t type : types_of_channels_.at(plane)) {
        const auto known = factor_of_type.find(type);
        factor.push_back(known == factor_of_type.end() ? 1.0 : known->second);
      }
      if (!factor.empty()) scale(light.field, factor);
    }
  }

  struct NotMet {
    std::string scene, words;
    bool is_sure = false;  // it fails, and is not only undecided
  };
  // With the levels of now, by the same light.
  std::vector<NotMet> not_met_now() const {
    std::vector<NotMet> all;
    for (const report::SpacePart& space : questions_.part.spaces) {
      for (const report::PlanePart& plane : space.planes) {
        const auto light = scaled_.find(plane.id);
        if (light == scaled_.end() || !light->second.field.problem.empty()) continue;
        for (const rules::Finding& finding : judged_by_light(
                 plane, light->second, questions_.project.scenes, questions_.confidence)) {
          if (finding.verdict == rules::Verdict::pass) continue;
          all.push_back({finding.requirement.scene,
                         fmt::format("{}, {}: {}, {}", report::title_of(space.name, space.id),
                                     report::title_of(plane.name, plane.id),
                                     asked_words(finding.requirement), value_words(finding)),
                         finding.verdict == rules::Verdict::fail});
        }
      }
    }
    return all;
  }

  enum class Enough { yes, no, maybe };

  Enough look_at(const Combination& one) {
    const std::vector<NotMet> not_met = not_met_now();
    calc::Diagnostics diagnostics;
    std::map<std::string, std::string> articles;
    for (std::size_t t = 0; t < types_.size(); ++t) {
      if (one.choice[t] == types_[t].now) continue;
      articles[found_.types[t].type] = found_.types[t].advised.article;
    }
    const auto text =
        check::with_packages(questions_.bytes, questions_.file, articles, diagnostics);
    if (!text) return Enough::maybe;  // it has been read before
    const bool may_be_met = std::none_of(not_met.begin(), not_met.end(),
                                         [](const NotMet& known) { return known.is_sure; });
    // What is undecided here is decided there, as the check goes on until it is.
    // Many of these would leave no run for what is surely enough.
    const bool may_be_tried = checked_ < kMostTried;
    const std::size_t checked_before = checked_;
    if (may_be_met && (not_met.empty() || may_be_tried) && is_confirmed(*text, {})) {
      return Enough::yes;
    }
    const OtherLevels other = other_levels(not_met);
    if (other.is_found && may_be_tried && is_confirmed(*text, other.scenes)) return Enough::yes;
    // Of the last one that is not enough: when one is, that stands next below it.
    const bool was_checked = checked_ > checked_before;
    if (not_met.empty() || (may_be_met && was_checked)) {
      found_.next_below = "the check does not pass: " + why_not_checked_;
    } else {
      found_.next_below = not_met.front().words;
    }
    return other.is_surely_none && !may_be_met ? Enough::no : Enough::maybe;
  }

  struct OtherLevels {
    bool is_found = false, is_surely_none = false;
    std::vector<SceneAdvice> scenes;
  };

  // For scenes in which something is not met with the levels of now.
  OtherLevels other_levels(const std::vector<NotMet>& not_met) const {
    OtherLevels other;
    for (const SceneAdvice& scene : questions_.scenes) {
      if (std::none_of(not_met.begin(), not_met.end(),
                       [&](const NotMet& one) { return one.scene == scene.scene; })) {
        continue;
      }
      AdviceSettings one = settings_;
      one.is_one_scene = true;
      one.scene = scene.scene;
      std::vector<SceneAdvice> found =
          find_advice(part_, scaled_, one, [this](const SceneAdvice& advice, calc::Message&) {
            return std::optional(by_the_same_light(advice));
          });
      if (found.empty() || found.front().outcome != AdviceOutcome::levels) {
        other.is_surely_none =
            !found.empty() && found.front().outcome == AdviceOutcome::contradiction;
        return other;
      }
      other.scenes.push_back(std::move(found.front()));
    }
    other.is_found = !other.scenes.empty();
    return other;
  }

  // The project as a check with these levels would judge it, by the light that is known.
  report::ProjectPart by_the_same_light(const SceneAdvice& advice) const {
    calc::LightScene levels;
    levels.id = "advised";
    for (const AdvisedGroup& group : advice.groups) {
      levels.level_of_group.emplace_back(group.group, group.level);
    }
    report::ProjectPart judged = part_;
    for (report::SpacePart& space : judged.spaces) {
      for (report::PlanePart& plane : space.planes) {
        const auto light = scaled_.find(plane.id);
        if (light == scaled_.end() || !light->second.field.problem.empty()) continue;
        for (rules::Finding& finding : plane.findings) {
          if (finding.requirement.scene != advice.scene) continue;
          if (!is_judged_by_light(finding.requirement)) continue;
          rules::Requirement requirement = finding.requirement;
          requirement.scene = levels.id;
          finding = rules::judge_plane({requirement}, light->second.grid, light->second.field,
                                       {levels}, questions_.confidence)
                        .front();
          finding.requirement.scene = advice.scene;
        }
      }
    }
    return judged;
  }

  // By other random numbers.
  bool is_confirmed(const std::string& text, const std::vector<SceneAdvice>& scenes) {
    ++checked_;
    const LevelsText whole = with_levels(text, questions_.file, scenes, part_);
    why_not_checked_ = whole.problem;
    if (!whole.text) return false;
    const auto part = questions_.check(*whole.text, why_not_checked_);
    if (!part) return false;
    for (const SceneAdvice& scene : scenes) {
      why_not_checked_ = not_dimmed(scene, levels_of(scene, part_), *part).english();
      if (!why_not_checked_.empty()) return false;
    }
    const std::vector<std::string> broken = broken_findings(questions_.part, *part);
    if (!broken.empty()) {
      why_not_checked_ = broken.front();
      return false;
    }
    for (const FindingPlace& where : counted_findings(*part)) {
      const rules::Finding& finding = finding_at(*part, where);
      if (finding.verdict != rules::Verdict::pass && is_judged_by_light(finding.requirement)) {
        why_not_checked_ =
            fmt::format("{} ({})", finding_words(*part, where), calc::name_of(finding.verdict));
        return false;
      }
    }
    const PassCount count = count_all(*part);
    found_.passing = count.passing;
    found_.asked = count.asked;
    found_.not_met = not_met_findings(*part);
    found_.is_all_met = found_.not_met.empty();
    found_.scenes = scenes;
    found_.text = *whole.text;
    return true;
  }

  const RoomQuestions& questions_;
  AdviceSettings settings_;
  report::ProjectPart part_;  // with the luminaires of the combination that is tried
  std::vector<TypeChoices> types_;
  LightOfPlanes light_, scaled_;
  std::map<std::string, std::vector<std::size_t>> types_of_channels_;  // by plane id
  std::size_t checked_ = 0;  // combinations that were checked by a run
  std::string why_not_checked_;
  PackageAdvice found_;
};

}  // namespace

bool PackageAdvice::is_as_now() const {
  return scenes.empty() && std::all_of(types.begin(), types.end(), [](const AdvisedPackage& type) {
           return type.now.article == type.advised.article;
         });
}

PackageAdvice find_packages(const RoomQuestions& questions, const AdviceSettings& settings) {
  return PackageSearch(questions, settings).search();
}

}  // namespace cli
