#include "report/revision/revision_tables.h"

#include "report/revision/gate.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

const char* symbol_of(ResultChange change) {
  switch (change) {
    case ResultChange::broken:
    case ResultChange::new_failing:
      return "✗";
    case ResultChange::unsure:
      return "?";
    case ResultChange::worse:
      return "▼";
    case ResultChange::gone:
      return "–";
    case ResultChange::better:
      return "▲";
    case ResultChange::fixed:
    case ResultChange::added:
    case ResultChange::same:
      break;
  }
  return "✓";
}

const char* symbol_of(QuestionChange change) {
  switch (change) {
    case QuestionChange::weaker:
      return "▼";
    case QuestionChange::exchanged:
      return "↔";
    case QuestionChange::stricter:
      break;
  }
  return "▲";
}

// Verdict and value; "" where it was not asked.
std::string state_words(const Texts& t, const ChangedResult& result, bool is_after) {
  const std::optional<rules::Verdict>& verdict =
      is_after ? result.verdict_after : result.verdict_before;
  if (!verdict) return "";
  const calc::Estimate& value = is_after ? result.after : result.before;
  std::string words = verdict_words(t, *verdict);
  if (is_after ? result.is_waived_after : result.is_waived_before) {
    words = t.say<Text::verdict_waived>(words);
  }
  if (std::isnan(value.value)) return words;
  return words + ", " + format_measured(t, value, result.unit);
}

// "-3.2 % (-3.5 to -2.9)"; "" where it is not known.
std::string gain_words(const Texts& t, const calc::Estimate& gain) {
  if (std::isnan(gain.value)) return "";
  constexpr double kNothing = 1e-8;  // what rounding alone may come to
  const auto percent = [&](double share) {
    if (std::abs(share) < kNothing) return format_margin(t, 0.0);
    return std::isfinite(share) ? format_margin(t, share) : std::string(share < 0.0 ? "-∞" : "+∞");
  };
  return fmt::format("{} ({} {} {})", percent(gain.value), percent(gain.low), t[Text::interval_to],
                     percent(gain.high));
}

// As it is asked now; null: it is not, or is an aggregate.
const rules::Requirement* requirement_of(const Document& document, const ChangedResult& result) {
  if (!result.metric || !result.verdict_after) return nullptr;
  for (const ProjectPart& project : document.projects) {
    if (project.path != result.place.project) continue;
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        if (space.id != result.place.space || plane.id != result.place.plane) continue;
        for (const rules::Finding& finding : plane.findings) {
          if (finding.requirement.id == result.place.item) return &finding.requirement;
        }
      }
    }
  }
  return nullptr;
}

void cut(RevisionTable& table, std::size_t most) {
  if (table.rows.size() <= most) return;
  table.left_out = table.rows.size() - most;
  table.rows.resize(most);
}

void add_item(std::string& place, const std::string& item) {
  if (item.empty()) return;
  place += (place.empty() ? "" : " / ") + item;
}

RevisionTable result_table(const Document& document, const Revision& revision, const Texts& t) {
  RevisionTable table;
  table.title = t.say<Text::revision_results>(baseline_words(revision));
  table.head = {t[Text::revision_head_change], t[Text::head_place],
                t[Text::head_quantity],        t[Text::revision_head_before],
                t[Text::revision_head_after],  t[Text::revision_head_gain]};
  for (const ChangedResult& result : revision.results) {
    const rules::Requirement* requirement = requirement_of(document, result);
    // Of what is gone nothing is known but its words.
    if (requirement == nullptr) table.english = {2};
    std::string place = place_words(document, result.place, t);
    if (result.is_aggregate && result.place.space.empty()) add_item(place, result.place.item);
    table.rows.push_back(
        {fmt::format("{} {}", symbol_of(result.change), change_words(t, result.change)), place,
         requirement == nullptr ? result.quantity
                                : quantity_words(t, *requirement) + scene_words(t, *requirement),
         state_words(t, result, false), state_words(t, result, true), gain_words(t, result.gain)});
  }
  return table;
}

RevisionTable question_table(const Document& document, const Revision& revision, const Texts& t) {
  RevisionTable table;
  table.title = t[Text::revision_questions];
  table.head = {t[Text::revision_head_change], t[Text::head_place], t[Text::revision_head_what],
                t[Text::revision_head_before], t[Text::revision_head_after]};
  table.english = {3, 4};
  for (const ChangedQuestion& question : revision.questions) {
    std::string place = place_words(document, question.place, t);
    add_item(place, question.place.item);
    table.rows.push_back(
        {fmt::format("{} {}", symbol_of(question.change), change_words(t, question.change)),
         place.empty() ? t[Text::revision_whole_run] : place, part_words(t, question.part),
         question.before.empty() ? "–" : question.before,
         question.after.empty() ? "–" : question.after});
  }
  return table;
}

RevisionTable input_table(const Document& document, const Revision& revision, const Texts& t) {
  RevisionTable table;
  table.title = t[Text::revision_inputs];
  table.head = {t[Text::head_place], t[Text::revision_head_what], t[Text::revision_head_before],
                t[Text::revision_head_after]};
  table.english = {1, 2, 3};
  for (const ChangedInput& input : revision.inputs) {
    std::string place = place_words(document, input.place, t);
    add_item(place, input.place.item);
    table.rows.push_back({place, input.what, input.before.empty() ? "–" : input.before,
                          input.after.empty() ? "–" : input.after});
  }
  return table;
}

// "1 %, Uo (min/avg) 2 %".
std::string allowed_words(const Gate& gate, const Texts& t) {
  std::string words = format_percent(t, gate.allowed_worse);
  for (const AllowedLoss& loss : gate.allowed_worse_of) {
    words += fmt::format(", {} {}", calc::name_of(loss.metric), format_percent(t, loss.share));
  }
  return words;
}

void add_gate(const Document& document, const Revision& revision, const Texts& t,
              std::vector<std::string>& remarks) {
  if (revision.gate.mode == GateMode::all) return;
  if (revision.known_failures > 0) {
    remarks.push_back(t.say<Text::gate_known_failures>(revision.known_failures));
  }
  const auto excused_by = [&revision](QuestionPart part) {
    return std::count_if(revision.results.begin(), revision.results.end(),
                         [&](const ChangedResult& result) { return result.excused_by == part; });
  };
  if (const auto count = excused_by(QuestionPart::maintenance_factor); count > 0) {
    remarks.push_back(t.say<Text::gate_maintenance>(count));
  }
  if (const auto count = excused_by(QuestionPart::grid); count > 0) {
    remarks.push_back(t.say<Text::gate_finer_grid>(count));
  }
  const bool asks_otherwise =
      std::any_of(revision.questions.begin(), revision.questions.end(),
                  [](const auto& question) { return question.change != QuestionChange::stricter; });
  if (asks_otherwise && !revision.gate.weaker_accepted_by.empty()) {
    remarks.push_back(t.say<Text::gate_accepted>(revision.gate.weaker_accepted_by));
  }
  remarks.push_back(gate_words(document, t));
}

}  // namespace

std::string gate_words(const Document& document, const Texts& t) {
  if (!document.revision || document.revision->gate.mode == GateMode::all) return {};
  const GateReasons reasons = reasons_of(*document.revision);
  if (reasons.empty()) {
    const rules::Outcome outcome = gate_outcome(document);
    return rules::counts(outcome) && outcome != rules::Outcome::pass
               ? t.say<Text::gate_waits>(outcome_words(t, outcome))
               : t.say<Text::gate_open>(allowed_words(document.revision->gate, t));
  }
  std::string why;
  if (!reasons.results.empty()) {
    why = t.say<Text::gate_stopped_by_results>(reasons.results.size());
  }
  if (!reasons.questions.empty()) {
    why += (why.empty() ? "" : ", ") +
           t.say<Text::gate_stopped_by_questions>(reasons.questions.size());
  }
  return t.say<Text::gate_stopped>(why);
}

const char* change_words(const Texts& t, ResultChange change) {
  switch (change) {
    case ResultChange::broken:
      return t[Text::change_broken];
    case ResultChange::new_failing:
      return t[Text::change_new_failing];
    case ResultChange::unsure:
      return t[Text::change_unsure];
    case ResultChange::worse:
      return t[Text::change_worse];
    case ResultChange::gone:
      return t[Text::change_gone];
    case ResultChange::fixed:
      return t[Text::change_fixed];
    case ResultChange::better:
      return t[Text::change_better];
    case ResultChange::added:
      return t[Text::change_added];
    case ResultChange::same:
      break;
  }
  return t[Text::change_same];
}

const char* change_words(const Texts& t, QuestionChange change) {
  switch (change) {
    case QuestionChange::weaker:
      return t[Text::asks_weaker];
    case QuestionChange::exchanged:
      return t[Text::asks_exchanged];
    case QuestionChange::stricter:
      break;
  }
  return t[Text::asks_stricter];
}

const char* part_words(const Texts& t, QuestionPart part) {
  switch (part) {
    case QuestionPart::project:
      return t[Text::part_project];
    case QuestionPart::room:
      return t[Text::part_room];
    case QuestionPart::plane:
      return t[Text::part_plane];
    case QuestionPart::requirement:
      return t[Text::part_requirement];
    case QuestionPart::aggregate:
      return t[Text::part_aggregate];
    case QuestionPart::limit:
      return t[Text::part_limit];
    case QuestionPart::quantity:
      return t[Text::part_quantity];
    case QuestionPart::severity:
      return t[Text::part_severity];
    case QuestionPart::light:
      return t[Text::part_light];
    case QuestionPart::rule:
      return t[Text::part_rule];
    case QuestionPart::waiver:
      return t[Text::part_waiver];
    case QuestionPart::deviation:
      return t[Text::part_deviation];
    case QuestionPart::policy:
      return t[Text::part_policy];
    case QuestionPart::mask:
      return t[Text::part_mask];
    case QuestionPart::area:
      return t[Text::part_area];
    case QuestionPart::grid:
      return t[Text::part_grid];
    case QuestionPart::margin:
      return t[Text::part_margin];
    case QuestionPart::lost_points:
      return t[Text::part_lost_points];
    case QuestionPart::role:
      return t[Text::part_role];
    case QuestionPart::maintenance_factor:
      return t[Text::part_maintenance_factor];
    case QuestionPart::flux:
      return t[Text::part_flux];
    case QuestionPart::power:
      return t[Text::part_power];
    case QuestionPart::confidence:
      return t[Text::part_confidence];
    case QuestionPart::method:
      return t[Text::part_method];
    case QuestionPart::energy:
      return t[Text::part_energy];
    case QuestionPart::stated:
      return t[Text::part_stated];
    case QuestionPart::accuracy:
      break;
  }
  return t[Text::part_accuracy];
}

std::string place_words(const Document& document, const RevisionPlace& place, const Texts&) {
  const bool is_of_project = place.space.empty();
  if (document.projects.size() < 2) return is_of_project ? "" : place.words;
  return is_of_project || place.words.empty() ? place.project : place.project + ": " + place.words;
}

std::string baseline_words(const Revision& revision) {
  const std::vector<std::string>& commits = revision.commits;
  if (commits.empty() || commits.front().starts_with(revision.baseline)) return revision.baseline;
  constexpr std::size_t kDigits = 10;
  std::string ids;
  for (const std::string& commit : commits) {
    ids += (ids.empty() ? "" : ", ") + commit.substr(0, kDigits);
  }
  return fmt::format("{} ({})", revision.baseline, ids);
}

std::vector<RevisionTable> revision_tables(const Document& document, const Texts& t,
                                           std::size_t most) {
  std::vector<RevisionTable> tables;
  if (!document.revision) return tables;
  const Revision& revision = *document.revision;
  for (RevisionTable table :
       {result_table(document, revision, t), question_table(document, revision, t),
        input_table(document, revision, t)}) {
    if (table.rows.empty()) continue;
    cut(table, most);
    tables.push_back(std::move(table));
  }
  return tables;
}

std::vector<std::string> revision_remarks(const Document& document, const Texts& t) {
  std::vector<std::string> remarks;
  if (!document.revision) return remarks;
  const Revision& revision = *document.revision;
  // Of what could not be judged nobody knows.
  const bool is_known = std::all_of(document.projects.begin(), document.projects.end(),
                                    [](const ProjectPart& project) { return project.is_judged; });
  if (is_known && revision.results.empty() && revision.questions.empty()) {
    remarks.push_back(t.say<Text::revision_nothing>(baseline_words(revision)));
  }
  if (revision.same > 0) {
    // Where nothing above says against what.
    const bool is_named = !revision.results.empty() || revision.questions.empty();
    const std::string same = t.say<Text::revision_same>(revision.same);
    remarks.push_back(
        is_named ? same : t.say<Text::revision_results>(baseline_words(revision)) + ": " + same);
  }
  if (revision.untold > 0) {
    remarks.push_back(
        t.say<Text::revision_untold>(revision.untold, allowed_words(revision.gate, t)));
  }
  for (const calc::Message& note : revision.notes) remarks.push_back(sentence(t, note));
  add_gate(document, revision, t, remarks);
  return remarks;
}

}  // namespace report
