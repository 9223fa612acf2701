#include "report/text/words.h"
#include "report/tools/advise/find_places.h"
#include "report/tools/advise/room_check.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace cli {
namespace {

// Every one of them is judged without any other one.
constexpr std::size_t kMostLuminairesTried = 200;

bool counts_here(const rules::Finding& finding) {
  return rules::counts(rules::outcome_of(finding));
}

// Glare of its sources is by channel as well, and is left to the check.
void switch_off(calc::PlaneField& field, std::size_t luminaire) {
  const std::size_t channels = field.channels.size(), points = field.points;
  const auto clear = [&](std::vector<double>& lx) {
    for (std::size_t row = luminaire; row * points < lx.size(); row += channels) {
      std::fill_n(lx.begin() + static_cast<std::ptrdiff_t>(row * points), points, 0.0);
    }
  };
  clear(field.direct_exact_lx);
  clear(field.direct_sampled_lx);
  clear(field.indirect_lx);
  clear(field.even_direct_sampled_lx);
  clear(field.even_indirect_lx);
}

class SpareSearch {
 public:
  SpareSearch(const RoomQuestions& questions, std::size_t part_index, const calc::Space& space,
              const LightOfPlanes& apart)
      : questions_(questions), part_index_(part_index), space_(space) {
    const report::SpacePart& room = questions.part.spaces[part_index];
    found_.space = report::title_of(room.name, room.id);
    found_.space_id = space.id;
    for (const calc::Luminaire& one : space.luminaires) {
      const calc::LuminaireType& type = type_of(one);
      found_.of += type.counts_as_luminaire() ? 1 : 0;
      found_.is_by_flux = found_.is_by_flux || !(type.power_w > 0.0);
    }
    for (const report::PlanePart& plane : room.planes) {
      const auto light = apart.find(plane.id);
      if (light == apart.end() || !light->second.field.problem.empty()) continue;
      if (light->second.field.channels.size() != space.luminaires.size()) continue;
      planes_.emplace_back(&plane, light->second);
    }
  }

  RoomSpare search() {
    found_.problem = why_none();
    if (!found_.problem.empty()) return std::move(found_);
    std::vector<std::size_t> gone = all_that_can_go();
    if (gone.empty()) {
      found_.problem =
          "no luminaire can be removed: a requirement would not be met; luminaires of assemblies "
          "and lists were not considered";
    }
    // All of them, one fewer, then half as many again and again.
    for (std::size_t count = gone.size(); count > 0;) {
      gone.resize(count);
      if (is_confirmed(gone)) {
        for (const std::size_t l : gone) found_.luminaires.push_back(told(l));
        found_.problem.clear();
        break;
      }
      count = is_first_try_ ? count - 1 : count == 1 ? 0 : std::min(count - 1, (count + 1) / 2);
      is_first_try_ = false;
    }
    return std::move(found_);
  }

 private:
  const calc::LuminaireType& type_of(const calc::Luminaire& luminaire) const {
    return questions_.project.luminaire_types[luminaire.type];
  }
  double cost(std::size_t l) const {
    const calc::LuminaireType& type = type_of(space_.luminaires[l]);
    return found_.is_by_flux ? questions_.project.webs[type.web].flux_lm() * type.flux_scale
                             : type.power_w;
  }
  SpareLuminaire told(std::size_t l) const {
    const calc::Luminaire& one = space_.luminaires[l];
    return {one.id, type_of(one).id, one.group, one.position_m, cost(l)};
  }

  std::string why_none() const {
    if (!space_.shell) return "only rooms whose walls are in the project file are considered";
    if (space_.luminaires.size() > kMostLuminairesTried) {
      return fmt::format("only rooms of up to {} luminaires are considered", kMostLuminairesTried);
    }
    for (const calc::Luminaire& one : space_.luminaires) {
      const calc::LuminaireType& type = type_of(one);
      if (type.is_further_emitter || !type.emitters.empty()) {
        return "rooms with luminaires of several emitters are not considered";
      }
      if (type.housing) return "rooms with luminaires that have housings are not considered";
    }
    if (planes_.empty()) return "the light of single luminaires is not known";
    return "";
  }

  // The smallest margin with these points' light; empty: something is not met.
  std::optional<double> margin(
      const std::vector<std::pair<const report::PlanePart*, PlaneLight>>& planes,
      std::size_t without) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [plane, light] : planes) {
      PlaneLight left = light;
      switch_off(left.field, without);
      for (const rules::Finding& finding :
           judged_by_light(*plane, left, questions_.project.scenes, questions_.confidence)) {
        if (finding.verdict != rules::Verdict::pass) return std::nullopt;
        least = std::min(least, finding.margin);
      }
    }
    return least;
  }

  // Luminaires of assemblies and lists.
  std::set<std::size_t> placed_elsewhere() const {
    std::map<std::tuple<std::string, int, int>, bool> is_known;  // by file, line and column
    std::set<std::size_t> elsewhere;
    for (std::size_t l = 0; l < space_.luminaires.size(); ++l) {
      const calc::SourceLocation& where = space_.luminaires[l].where;
      const auto [known, is_new] =
          is_known.try_emplace({where.file, where.line, where.column}, false);
      if (is_new) {
        known->second = check::with_luminaires_instead(questions_.bytes, questions_.file, space_.id,
                                                       {where}, {})
                            .text.has_value();
      }
      if (!known->second) elsewhere.insert(l);
    }
    return elsewhere;
  }

  // What saves most first, then what leaves the most room.
  std::vector<std::size_t> all_that_can_go() const {
    std::vector<std::pair<const report::PlanePart*, PlaneLight>> planes = planes_;
    std::vector<std::size_t> gone;
    // Without which something is not met, or which the text cannot leave out: they stay.
    std::set<std::size_t> tried = placed_elsewhere();
    while (gone.size() + 1 < space_.luminaires.size()) {
      std::optional<std::size_t> best;
      double best_margin = 0.0;
      for (std::size_t l = 0; l < space_.luminaires.size(); ++l) {
        if (tried.contains(l) || std::find(gone.begin(), gone.end(), l) != gone.end()) continue;
        const std::optional<double> left = margin(planes, l);
        if (!left) {
          tried.insert(l);
        } else if (!best || cost(l) > cost(*best) ||
                   (cost(l) == cost(*best) && *left > best_margin)) {
          best = l;
          best_margin = *left;
        }
      }
      if (!best) break;
      gone.push_back(*best);
      for (auto& [plane, light] : planes) switch_off(light.field, *best);
    }
    return gone;
  }

  bool is_confirmed(const std::vector<std::size_t>& gone) {
    std::map<std::size_t, std::optional<AdvisedPlace>> without;
    for (const std::size_t l : gone) without[l] = std::nullopt;
    const OneByOne left = one_by_one(questions_, space_, without);
    const check::ChangedText changed = check::with_luminaires_instead(
        questions_.bytes, questions_.file, space_.id, left.elements, left.luminaires);
    found_.problem = changed.problem;
    if (!changed.text) return false;
    const auto part = questions_.check(*changed.text, found_.problem);
    if (!part) return false;
    if (part->spaces[part_index_].luminaires.size() + gone.size() != space_.luminaires.size()) {
      found_.problem = "the changed project does not have the expected luminaires";
      return false;
    }
    found_.problem = "the check finds a requirement that is not met without them";
    if (!broken_findings(questions_.part, *part).empty()) return false;
    const PassCount count = count_all(*part);
    found_.passing = count.passing;
    found_.asked = count.asked;
    return true;
  }

  const RoomQuestions& questions_;
  std::size_t part_index_;
  const calc::Space& space_;
  std::vector<std::pair<const report::PlanePart*, PlaneLight>> planes_;
  RoomSpare found_;
  bool is_first_try_ = true;
};

// Everything in it is met, and something is asked for that light has to be there for.
bool is_all_met(const report::SpacePart& room) {
  bool has_lower_limit = false;
  for (const report::PlanePart& plane : room.planes) {
    for (const rules::Finding& finding : plane.findings) {
      if (!counts_here(finding)) continue;
      if (finding.verdict != rules::Verdict::pass) return false;
      has_lower_limit = has_lower_limit || rules::is_lower_limit(finding.requirement.comparison);
    }
  }
  return has_lower_limit;
}

}  // namespace

std::vector<RoomSpare> find_spare(const RoomQuestions& questions) {
  std::vector<RoomSpare> all;
  std::optional<LightOfPlanes> apart;
  for (std::size_t s = 0; s < questions.part.spaces.size(); ++s) {
    const calc::Space* space = space_of(questions, s);
    if (space == nullptr || space->luminaires.empty() || !is_all_met(questions.part.spaces[s])) {
      continue;
    }
    if (!apart) apart = questions.light_apart();
    all.push_back(SpareSearch(questions, s, *space, *apart).search());
  }
  return all;
}

}  // namespace cli
