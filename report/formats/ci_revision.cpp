#include "report/formats/ci_revision.h"

#include "calc/base/file_hash.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace report {
namespace {

std::string key_of(const RevisionPlace& place, const std::string& what) {
  return fmt::format("{}:{}/{}/{}", what, place.space, place.plane, place.item);
}

std::string full_place(const RevisionPlace& place) {
  std::string words = place.words.empty() ? place.project : place.words;
  if (words.empty() && place.item.empty()) return Texts()[Text::revision_whole_run];
  if (!place.item.empty()) words += (words.empty() ? "" : " / ") + place.item;
  return words;
}

CiChange change_at(const RevisionPlace& place, const char* rule, const std::string& what) {
  CiChange change;
  change.project = place.project;
  change.rule = rule;
  change.key = printable(key_of(place, what));
  change.where = place.where;
  if (change.where.file.empty()) change.where.file = place.project;
  return change;
}

CiChange of_result(const ChangedResult& result) {
  CiChange change = change_at(result.place, "worse", "worse");
  std::string by;
  if (!std::isnan(result.gain.value)) {
    by = fmt::format(", {} ({} to {})", format_margin(result.gain.value),
                     format_margin(result.gain.low), format_margin(result.gain.high));
  }
  change.message = printable(fmt::format(
      "{}: {} became worse: {}, before {}{}", full_place(result.place), result.quantity,
      format_measured(result.after, result.unit), format_measured(result.before, result.unit), by));
  return change;
}

CiChange of_question(const ChangedQuestion& question) {
  const std::string part(calc::name_of(question.part));
  CiChange change = change_at(question.place, "weaker-question", part);
  const auto or_none = [](const std::string& text) { return text.empty() ? "none" : text; };
  change.message = printable(fmt::format(
      "{}: {} ({}): {}, before {}", full_place(question.place), change_words({}, question.change),
      part_words({}, question.part), or_none(question.after), or_none(question.before)));
  return change;
}

template <class Item>
bool holds(const std::vector<const Item*>& list, const Item& item) {
  return std::find(list.begin(), list.end(), &item) != list.end();
}

// Repeats are numbered.
void make_unique(std::vector<CiChange>& changes) {
  std::set<std::pair<std::string, std::string>> taken;
  for (CiChange& change : changes) {
    const std::string key = change.key;
    for (int k = 2; !taken.emplace(change.project, change.key).second; ++k) {
      change.key = fmt::format("{}-{}", key, k);
    }
    change.fingerprint =
        calc::sha256_hex(std::to_string(change.project.size()) + ":" + change.project + change.key);
  }
}

}  // namespace

std::vector<CiChange> ci_changes(const Document& document) {
  std::vector<CiChange> changes;
  if (!document.revision) return changes;
  const Revision& revision = *document.revision;
  const bool is_gate = revision.gate.mode == GateMode::regression;
  const GateReasons reasons = reasons_of(revision);
  for (const ChangedResult& result : revision.results) {
    if (result.change != ResultChange::worse) continue;
    changes.push_back(of_result(result));
    changes.back().stops = is_gate && holds(reasons.results, result);
  }
  for (const ChangedQuestion& question : revision.questions) {
    if (question.change == QuestionChange::stricter) continue;
    changes.push_back(of_question(question));
    changes.back().stops = is_gate && holds(reasons.questions, question);
  }
  make_unique(changes);
  return changes;
}

}  // namespace report
