#include "report/revision/revise.h"

#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "report/revision/gate.h"
#include "report/revision/inputs.h"
#include "report/revision/matching.h"
#include "report/revision/moved_rooms.h"
#include "report/revision/questions.h"
#include "report/revision/results.h"
#include "report/revision/values.h"
#include "report/text/words.h"
#include "rules/measure/error_spending.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace report {
namespace {

using FindingPair = PartPair<rules::Finding>;
using AggregatePair = PartPair<rules::AggregateFinding>;

// Whether an id is one that a requirement gets that has none: "average", "average-2".
bool is_made(const rules::Requirement& requirement) {
  std::string_view id = requirement.id;
  const std::string_view name = calc::name_of(requirement.metric);
  if (!id.starts_with(name)) return false;
  id.remove_prefix(name.size());
  if (id.empty()) return true;
  return id.size() > 1 && id.front() == '-' &&
         std::all_of(id.begin() + 1, id.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Ids that were made count the requirements of a plane, so that they change where others come and
// go: those that ask the same get the ids that they have now.
std::vector<rules::Finding> with_ids_of_now(std::vector<rules::Finding> before,
                                            const std::vector<rules::Finding>& after) {
  const auto asks_same = [](const rules::Finding& a, const rules::Finding& b) {
    return a.requirement.metric == b.requirement.metric &&
           compare_requirement(a.requirement, b.requirement, {}).empty();
  };
  std::vector<std::size_t> of_after(after.size(), before.size());
  std::vector<bool> is_taken(before.size(), false);
  for (const bool has_same_id : {true, false}) {
    for (std::size_t a = 0; a < after.size(); ++a) {
      if (of_after[a] < before.size() || !is_made(after[a].requirement)) continue;
      for (std::size_t b = 0; b < before.size() && of_after[a] == before.size(); ++b) {
        const bool is_same_id = before[b].requirement.id == after[a].requirement.id;
        if (is_taken[b] || (has_same_id && !is_same_id) || !is_made(before[b].requirement))
          continue;
        if (!asks_same(before[b], after[a])) continue;
        is_taken[b] = true;
        of_after[a] = b;
      }
    }
  }
  // Two change their ids, so that what is left has one, too.
  for (std::size_t a = 0; a < after.size(); ++a) {
    if (of_after[a] == before.size()) continue;
    const std::string given_up = before[of_after[a]].requirement.id;
    const std::string id = after[a].requirement.id;
    if (given_up == id) continue;
    for (std::size_t b = 0; b < before.size(); ++b) {
      if (b != of_after[a] && before[b].requirement.id == id) before[b].requirement.id = given_up;
    }
    before[of_after[a]].requirement.id = id;
  }
  return before;
}

class Reviser {
 public:
  Reviser(const Document& before, const Document& after, Revision& revision)
      : before_(before), after_(after), revision_(revision) {}

  void run() {
    add(compare_settings(before_.provenance, after_.provenance));
    note_provenance();
    for (const PartPair<ProjectPart>& pair : match_projects(before_, after_)) add_project(pair);
    std::stable_sort(
        revision_.results.begin(), revision_.results.end(),
        [](const ChangedResult& a, const ChangedResult& b) { return a.change < b.change; });
    std::stable_sort(
        revision_.questions.begin(), revision_.questions.end(),
        [](const ChangedQuestion& a, const ChangedQuestion& b) { return a.change < b.change; });
  }

 private:
  void note_provenance() {
    const Provenance &was = before_.provenance, &is = after_.provenance;
    if (was.numbers_version != is.numbers_version) {
      revision_.notes.push_back(calc::say<calc::Sentence::baseline_other_numbers>(
          was.numbers_version, is.numbers_version));
    }
    if (was.seed != is.seed) {
      revision_.notes.push_back(calc::say<calc::Sentence::baseline_other_seed>(was.seed, is.seed));
    }
  }

  void add(std::vector<ChangedQuestion> questions) {
    for (ChangedQuestion& question : questions) revision_.questions.push_back(std::move(question));
  }
  void add(std::vector<ChangedInput> inputs) {
    for (ChangedInput& input : inputs) revision_.inputs.push_back(std::move(input));
  }
  void add(ChangedResult result) {
    const bool fails =
        result.verdict_after == rules::Verdict::fail && result.counts && !result.is_waived_after;
    if (fails && result.verdict_before == rules::Verdict::fail && !result.is_waived_before) {
      ++revision_.known_failures;
    }
    if (result.change == ResultChange::same) {
      ++revision_.same;
      if (result.counts && may_have_lost_more(revision_.gate, result)) ++revision_.untold;
    } else {
      revision_.results.push_back(std::move(result));
    }
  }
  void add_whole(QuestionPart part, const RevisionPlace& place, bool is_gone,
                 const std::string& words) {
    add({ChangedQuestion{is_gone ? QuestionChange::weaker : QuestionChange::stricter, part, place,
                         is_gone ? words : "", is_gone ? "" : words}});
  }

  using Renamed = std::map<std::string, std::string>;  // id now, by the id that it had
  static std::string id_now(const Renamed& renamed, const std::string& id) {
    const auto found = renamed.find(id);
    return found == renamed.end() ? id : found->second;
  }
  void note_renaming(const std::string& kind, const std::string& before, const std::string& after,
                     const RevisionPlace& place, Renamed* renamed = nullptr) {
    if (before == after) return;
    revision_.inputs.push_back({place, "id of the " + kind, before, after});
    if (renamed != nullptr) (*renamed)[before] = after;
  }

  // Each warning of before is one of now at most.
  void note_known_warnings(const ProjectPart& before, const ProjectPart& after) {
    std::multiset<std::tuple<calc::DiagnosticId, std::string, std::string>> left;
    for (const calc::Diagnostic& warning : before.diagnostics) {
      left.emplace(warning.id, warning.where.file, warning.message);
    }
    KnownWarnings known{after.path, {}};
    for (std::size_t k = 0; k < after.diagnostics.size(); ++k) {
      const calc::Diagnostic& warning = after.diagnostics[k];
      if (!is_warning(warning) || is_strict_warning(after, warning)) continue;
      const auto found = left.find({warning.id, warning.where.file, warning.message});
      if (found == left.end()) continue;
      left.erase(found);
      known.diagnostics.push_back(k);
    }
    if (!known.diagnostics.empty()) revision_.known_warnings.push_back(std::move(known));
  }

  // Of files that are not as they were, although nothing that is compared has changed.
  void note_files(const ProjectPart& before, const ProjectPart& after, const RevisionPlace& place) {
    const auto has = [](const ProjectPart& project, const std::string& sha256) {
      return std::any_of(project.inputs.begin(), project.inputs.end(),
                         [&](const calc::InputFile& input) { return input.sha256 == sha256; });
    };
    std::vector<calc::Message> names;
    for (const calc::InputFile& input : after.inputs) {
      if (!has(before, input.sha256)) names.push_back(calc::Message::path(input.path));
    }
    if (names.empty()) return;
    constexpr std::size_t kMostNamed = 3;
    revision_.notes.push_back(calc::say<calc::Sentence::baseline_other_files>(
        calc::Message::path(place.project), calc::listed(names, kMostNamed)));
  }

  // Of planes without anything that says so: whoever has renamed one should say `was`.
  void hint_at_renaming(const std::vector<PartPair<PlanePart>>& planes, const RevisionPlace& room) {
    bool is_workplace_told = false;
    for (const PartPair<PlanePart>& gone : planes) {
      if (gone.after != nullptr) continue;
      const auto found = std::find_if(planes.begin(), planes.end(), [&](const auto& added) {
        return added.before == nullptr && is_same_area(*gone.before, *added.after);
      });
      if (found == planes.end()) continue;
      const bool is_of_workplace = !found->after->made_by.empty();
      if (is_of_workplace && is_workplace_told) continue;  // one id for all its planes
      is_workplace_told = is_workplace_told || is_of_workplace;
      const std::string &is = found->after->id, &was = gone.before->id;
      revision_.notes.push_back(
          is_of_workplace
              ? calc::say<calc::Sentence::maybe_renamed_workplace>(room.words, is, was)
              : calc::say<calc::Sentence::maybe_renamed_plane>(room.words, is, was, was));
    }
  }

  void add_project(const PartPair<ProjectPart>& pair) {
    static const ProjectPart kNone;
    const ProjectPart &was = pair.before != nullptr ? *pair.before : kNone,
                      &is = pair.after != nullptr ? *pair.after : kNone;
    const std::size_t said_before = said();
    RevisionPlace place;
    place.project = pair.after != nullptr ? is.path : was.path;
    place.words = std::string(title_of(pair.after != nullptr ? is.name : was.name, place.project));
    if (pair.before == nullptr || pair.after == nullptr) {
      add_whole(QuestionPart::project, place, pair.after == nullptr, place.project);
      if (pair.after == nullptr) return;  // that says it all
    } else {
      if (was.is_judged != is.is_judged) {
        const calc::Message project = calc::Message::path(place.project);
        revision_.notes.push_back(is.is_judged
                                      ? calc::say<calc::Sentence::baseline_not_judged>(project)
                                      : calc::say<calc::Sentence::now_not_judged>(project));
      }
      // Of what could not be read nothing is known: it is not gone. What could not be judged before
      // is new to the last failure.
      if (!is.is_judged) return;
      note_known_warnings(was, is);
      if (was.is_judged) {
        add(compare_project_question(was, is, place));
        add(compare_inputs(was, is, place));
      }
    }
    const bool is_there = pair.before != nullptr && pair.after != nullptr;
    projects_ = {&was, &is};
    renamed_rooms_.clear();
    renamed_planes_.clear();
    for (const PartPair<SpacePart>& room : match_rooms(was, is)) add_room(room, place, is_there);
    std::vector<rules::AggregateFinding> was_aggregates = was.aggregates;
    for (rules::AggregateFinding& finding : was_aggregates) {
      finding.space_id = id_now(renamed_rooms_, finding.space_id);
      finding.plane_id = id_now(renamed_planes_, finding.plane_id);
      if (!finding.sum) continue;
      finding.id = building_id_now(finding, is.aggregates);
      for (rules::AggregateMember& member : finding.members) {
        member.name = id_now(renamed_rooms_, member.name);
      }
    }
    const auto aggregates =
        match_parts(was_aggregates, is.aggregates, [](const rules::AggregateFinding& f) {
          return fmt::format("{}\n{}\n{}\n{}", calc::name_of(f.kind), f.id, f.space_id, f.plane_id);
        });
    for (const AggregatePair& aggregate : aggregates) add_aggregate(aggregate, place, is_there);
    if (is_there && was.is_judged && said() == said_before) note_files(was, is, place);
  }

  // How much is said so far; results that are the same are not.
  std::size_t said() const {
    return revision_.results.size() + revision_.questions.size() + revision_.inputs.size() +
           revision_.planes.size();
  }

  // is_project_there: on both sides; else the project says it.
  void add_room(const PartPair<SpacePart>& pair, RevisionPlace place, bool is_project_there) {
    static const SpacePart kNone;
    const SpacePart &was = pair.before != nullptr ? *pair.before : kNone,
                    &is = pair.after != nullptr ? *pair.after : kNone;
    const SpacePart& any = pair.after != nullptr ? is : was;
    place.space = any.id;
    place.words = std::string(title_of(any.name, any.id));
    is_same_light_ = false;
    dimmer_ = 1.0;
    if (pair.before == nullptr || pair.after == nullptr) {
      if (is_project_there && !any.planes.empty()) {
        add_whole(QuestionPart::room, place, pair.after == nullptr, place.words);
      }
    } else {
      note_renaming("room", was.id, is.id, place, &renamed_rooms_);
      add(compare_room_question(was, is, place));
      std::vector<ChangedInput> inputs = compare_inputs(was, is, place);
      is_same_light_ =
          inputs.empty() && !was.scene_sha256.empty() && was.scene_sha256 == is.scene_sha256;
      dimmer_ = share_of_maintenance({*projects_.before, was, *projects_.after, is});
      add(std::move(inputs));
    }
    const auto planes = match_renamed(
        was.planes, is.planes, [](const PlanePart& p) { return p.id; },
        [](const PlanePart& p) { return p.was; });
    hint_at_renaming(planes, place);
    for (const PartPair<PlanePart>& plane : planes) add_plane(plane, place, pair);
  }

  void add_plane(const PartPair<PlanePart>& pair, RevisionPlace place,
                 const PartPair<SpacePart>& room) {
    static const PlanePart kNone;
    const PlanePart &was = pair.before != nullptr ? *pair.before : kNone,
                    &is = pair.after != nullptr ? *pair.after : kNone;
    const PlanePart& any = pair.after != nullptr ? is : was;
    place.plane = any.id;
    place.words += " / " + std::string(title_of(any.name, any.id));
    place.where = any.where;
    const bool is_room_there = room.before != nullptr && room.after != nullptr;
    is_only_finer_ = false;
    if (pair.before == nullptr || pair.after == nullptr) {
      if (is_room_there) add_whole(QuestionPart::plane, place, pair.after == nullptr, any.id);
    } else {
      note_renaming("plane", was.id, is.id, place, &renamed_planes_);
      is_only_finer_ = is_same_light_ && is_finer_grid(was, is);
      add(compare_plane_question(was, is, is_only_finer_, place));
      if (auto values = compare_values(was, is, place)) {
        revision_.planes.push_back(std::move(*values));
      }
    }
    const bool is_plane_there = pair.before != nullptr && pair.after != nullptr;
    const std::vector<rules::Finding> findings_before = with_ids_of_now(was.findings, is.findings);
    const auto findings = match_renamed(
        findings_before, is.findings, [](const rules::Finding& f) { return f.requirement.id; },
        [](const rules::Finding& f) { return f.requirement.was; });
    // The lower level is the narrower interval, which hides less.
    const double level = std::min(before_.provenance.confidence, after_.provenance.confidence);
    const double confidence = rules::look_confidence(level, last_look(any), any.looks_planned);
    for (const FindingPair& finding : findings) {
      add_finding(finding, confidence, place, is_plane_there);
    }
  }

  // By which stricter question what is lost by one that still passes.
  std::optional<QuestionPart> excuse_of(const ChangedResult& result,
                                        const rules::Requirement& requirement) const {
    if (result.change != ResultChange::worse || result.verdict_after != rules::Verdict::pass) {
      return std::nullopt;
    }
    if (is_only_finer_ && is_same_scene(requirement.scene) &&
        !rules::is_about_space(requirement.metric)) {
      return QuestionPart::grid;
    }
    if (is_of_maintenance(result, requirement)) return QuestionPart::maintenance_factor;
    return std::nullopt;
  }

  // Whether a light scene dims as it did; "": no scene.
  bool is_same_scene(const std::string& id) const {
    const auto levels_in = [&id](const ProjectPart& project) {
      std::vector<std::pair<std::string, double>> levels;
      for (const SceneRow& scene : project.scenes) {
        if (scene.id == id) levels = scene.level_of_group;
      }
      return levels;
    };
    return levels_in(*projects_.before) == levels_in(*projects_.after);
  }

  // What a maintenance factor scales, and no more lost than it takes.
  bool is_of_maintenance(const ChangedResult& result, const rules::Requirement& requirement) const {
    const bool is_scaled = requirement.metric == rules::Metric::average ||
                           requirement.metric == rules::Metric::minimum ||
                           requirement.metric == rules::Metric::percentile;
    return dimmer_ < 1.0 && is_scaled && result.unit == "lx" &&
           requirement.state == rules::LightState::maintained &&
           rules::is_lower_limit(requirement.comparison) &&
           result.gain.high >= dimmer_ * (1.0 - allowed_loss(revision_.gate, result)) - 1.0;
  }

  static int last_look(const PlanePart& plane) {
    return std::max(0, static_cast<int>(plane.counters.active_points.size()) - 1);
  }

  void add_finding(const FindingPair& pair, double confidence, RevisionPlace place,
                   bool is_plane_there) {
    const rules::Requirement& any =
        pair.after != nullptr ? pair.after->requirement : pair.before->requirement;
    place.item = any.id;
    place.where = any.where;
    ChangedResult result = compare_results(pair.before, pair.after, confidence, place);
    result.excused_by = excuse_of(result, any);
    add(std::move(result));
    if (pair.before != nullptr && pair.after != nullptr) {
      note_renaming("requirement", pair.before->requirement.id, any.id, place);
      return add(compare_requirement(pair.before->requirement, pair.after->requirement, place));
    }
    if (!is_plane_there) return;  // the plane says it
    add_whole(QuestionPart::requirement, place, pair.after == nullptr,
              quantity_words(any) + scene_words({}, any));
  }

  // Of a sum that a building or one of its requirements had under another id.
  static std::string building_id_now(const rules::AggregateFinding& before,
                                     const std::vector<rules::AggregateFinding>& now) {
    for (const rules::AggregateFinding& after : now) {
      if (after.kind != before.kind || !after.sum) continue;
      const rules::Requirement &is = after.sum->requirement, &was = before.sum->requirement;
      const bool is_building =
          after.building_id == before.building_id || after.building_was == before.building_id;
      if (is_building && (is.id == was.id || is.was == was.id)) return after.id;
    }
    return before.id;
  }

  void add_aggregate(const AggregatePair& pair, RevisionPlace place, bool is_project_there) {
    const rules::AggregateFinding& any = pair.after != nullptr ? *pair.after : *pair.before;
    place.space = any.space_id;
    place.plane = any.plane_id;
    place.item = any.id;
    place.where = any.where;
    if (any.kind == rules::AggregateKind::building) {
      place.words = std::string(title_of(any.building_name, any.building_id));
    }
    add(compare_results(pair.before, pair.after, place));
    if (pair.before != nullptr && pair.after != nullptr) {
      return add(compare_aggregate(*pair.before, *pair.after, place));
    }
    if (!is_project_there) return;
    add_whole(QuestionPart::aggregate, place, pair.after == nullptr, any.id);
  }

  const Document& before_;
  const Document& after_;
  Revision& revision_;
  Renamed renamed_rooms_, renamed_planes_;
  PartPair<ProjectPart> projects_;  // at hand, neither null
  double dimmer_ = 1.0;             // of the room at hand, see share_of_maintenance()
  bool is_same_light_ = false;      // of the room at hand, but for maintenance and dimming
  bool is_only_finer_ = false;      // of the plane at hand: its grid, and its light is the same
};

}  // namespace

Revision revise(const Document& before, const Document& after, const std::string& baseline,
                const Gate& gate) {
  Revision revision;
  revision.baseline = baseline;
  revision.baseline_version = before.provenance.program_version;
  revision.gate = gate;
  // Rooms that moved to another project are compared like all others.
  const std::optional<MovedRooms> moved = find_moved_rooms(before, after);
  if (moved) revision.notes = moved->notes;
  Reviser(moved ? moved->before : before, after, revision).run();
  return revision;
}

}  // namespace report
