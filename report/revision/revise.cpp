#include "report/revision/revise.h"

#include "report/revision/inputs.h"
#include "report/revision/matching.h"
#include "report/revision/questions.h"
#include "report/revision/results.h"
#include "report/revision/values.h"
#include "report/text/words.h"
#include "rules/measure/error_spending.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

using FindingPair = PartPair<rules::Finding>;
using AggregatePair = PartPair<rules::AggregateFinding>;

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
      revision_.notes.push_back(fmt::format(
          "the baseline was calculated with version {} of the numbers, this result with "
          "version {}: small differences may come from the program",
          was.numbers_version, is.numbers_version));
    }
    if (was.seed != is.seed) {
      revision_.notes.push_back(
          fmt::format("the baseline has seed {}, this result {}", was.seed, is.seed));
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
    if (fails && result.verdict_before == rules::Verdict::fail) ++revision_.known_failures;
    if (result.change == ResultChange::same) {
      ++revision_.same;
    } else {
      revision_.results.push_back(std::move(result));
    }
  }
  void add_whole(QuestionPart part, const RevisionPlace& place, bool is_gone,
                 const std::string& words) {
    add({ChangedQuestion{is_gone ? QuestionChange::weaker : QuestionChange::stricter, part, place,
                         is_gone ? words : "", is_gone ? "" : words}});
  }

  // Rooms and planes by the ids that they have now.
  std::string id_now(const std::string& id) const {
    const auto renamed = id_now_.find(id);
    return renamed == id_now_.end() ? id : renamed->second;
  }
  void note_renaming(const std::string& kind, const std::string& before, const std::string& after,
                     const RevisionPlace& place) {
    if (before == after) return;
    revision_.inputs.push_back({place, "id of the " + kind, before, after});
    if (kind != "requirement") id_now_[before] = after;
  }

  // Of planes without anything that says so: whoever has renamed one should say `was`.
  void hint_at_renaming(const std::vector<PartPair<PlanePart>>& planes, const RevisionPlace& room) {
    for (const PartPair<PlanePart>& gone : planes) {
      if (gone.after != nullptr) continue;
      for (const PartPair<PlanePart>& added : planes) {
        if (added.before != nullptr || !is_same_area(*gone.before, *added.after)) continue;
        revision_.notes.push_back(fmt::format(
            "{}: plane '{}' lies where '{}' was; if it is that plane, was=\"{}\" in it says so",
            room.words, added.after->id, gone.before->id, gone.before->id));
        break;
      }
    }
  }

  void add_project(const PartPair<ProjectPart>& pair) {
    static const ProjectPart kNone;
    const ProjectPart &was = pair.before != nullptr ? *pair.before : kNone,
                      &is = pair.after != nullptr ? *pair.after : kNone;
    RevisionPlace place;
    place.project = pair.after != nullptr ? is.path : was.path;
    place.words = std::string(title_of(pair.after != nullptr ? is.name : was.name, place.project));
    if (pair.before == nullptr || pair.after == nullptr) {
      add_whole(QuestionPart::project, place, pair.after == nullptr, place.project);
      if (pair.after == nullptr) return;  // that says it all
    } else {
      if (was.is_judged != is.is_judged) {
        revision_.notes.push_back(
            place.project +
            (is.is_judged ? " could not be judged before: there is nothing to compare it with, and "
                            "all that fails in it is new"
                          : " could not be judged now"));
      }
      // Of what could not be read nothing is known: it is not gone. What could not be judged before
      // is new to the last failure.
      if (!is.is_judged) return;
      if (was.is_judged) {
        add(compare_project_question(was, is, place));
        add(compare_inputs(was, is, place));
      }
    }
    const bool is_there = pair.before != nullptr && pair.after != nullptr;
    id_now_.clear();
    const auto rooms = match_renamed(
        was.spaces, is.spaces, [](const SpacePart& s) { return s.id; },
        [](const SpacePart& s) { return s.was; });
    for (const PartPair<SpacePart>& room : rooms) add_room(room, place, is_there);
    std::vector<rules::AggregateFinding> was_aggregates = was.aggregates;
    for (rules::AggregateFinding& finding : was_aggregates) {
      finding.space_id = id_now(finding.space_id);
      finding.plane_id = id_now(finding.plane_id);
    }
    const auto aggregates =
        match_parts(was_aggregates, is.aggregates, [](const rules::AggregateFinding& f) {
          return fmt::format("{}\n{}\n{}\n{}", calc::name_of(f.kind), f.id, f.space_id, f.plane_id);
        });
    for (const AggregatePair& aggregate : aggregates) add_aggregate(aggregate, place, is_there);
  }

  // is_project_there: on both sides; else the project says it.
  void add_room(const PartPair<SpacePart>& pair, RevisionPlace place, bool is_project_there) {
    static const SpacePart kNone;
    const SpacePart &was = pair.before != nullptr ? *pair.before : kNone,
                    &is = pair.after != nullptr ? *pair.after : kNone;
    const SpacePart& any = pair.after != nullptr ? is : was;
    place.space = any.id;
    place.words = std::string(title_of(any.name, any.id));
    if (pair.before == nullptr || pair.after == nullptr) {
      if (is_project_there && !any.planes.empty()) {
        add_whole(QuestionPart::room, place, pair.after == nullptr, place.words);
      }
    } else {
      note_renaming("room", was.id, is.id, place);
      add(compare_room_question(was, is, place));
      add(compare_inputs(was, is, place));
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
    if (pair.before == nullptr || pair.after == nullptr) {
      if (is_room_there) add_whole(QuestionPart::plane, place, pair.after == nullptr, any.id);
    } else {
      note_renaming("plane", was.id, is.id, place);
      add(compare_plane_question(was, is, place));
      if (auto values = compare_values(was, is, place)) {
        revision_.planes.push_back(std::move(*values));
      }
    }
    const bool is_plane_there = pair.before != nullptr && pair.after != nullptr;
    const auto findings = match_renamed(
        was.findings, is.findings, [](const rules::Finding& f) { return f.requirement.id; },
        [](const rules::Finding& f) { return f.requirement.was; });
    const double confidence =
        rules::look_confidence(after_.provenance.confidence, last_look(any), any.looks_planned);
    for (const FindingPair& finding : findings) {
      add_finding(finding, confidence, place, is_plane_there);
    }
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
    add(compare_results(pair.before, pair.after, confidence, place));
    if (pair.before != nullptr && pair.after != nullptr) {
      note_renaming("requirement", pair.before->requirement.id, any.id, place);
      return add(compare_requirement(pair.before->requirement, pair.after->requirement, place));
    }
    if (!is_plane_there) return;  // the plane says it
    add_whole(QuestionPart::requirement, place, pair.after == nullptr,
              quantity_words(any) + scene_words({}, any));
  }

  void add_aggregate(const AggregatePair& pair, RevisionPlace place, bool is_project_there) {
    const rules::AggregateFinding& any = pair.after != nullptr ? *pair.after : *pair.before;
    place.space = any.space_id;
    place.plane = any.plane_id;
    place.item = any.id;
    place.where = any.where;
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
  std::map<std::string, std::string> id_now_;  // of rooms and planes that were renamed, by the old
};

}  // namespace

Revision revise(const Document& before, const Document& after, const std::string& baseline,
                const Gate& gate) {
  Revision revision;
  revision.baseline = baseline;
  revision.baseline_version = before.provenance.program_version;
  revision.gate = gate;
  Reviser(before, after, revision).run();
  return revision;
}

}  // namespace report
