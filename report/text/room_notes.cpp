#include "report/text/room_notes.h"

#include "calc/base/glare_limits.h"
#include "calc/base/sentences.h"
#include "calc/glare/ugr_table.h"
#include "report/document/one_source.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/notices.h"
#include "report/text/plain_text.h"
#include "report/text/room_causes.h"
#include "report/text/room_titles.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace report {
namespace {

using calc::MessagePart;
using calc::PartKind;
using calc::Sentence;

// How a quantity is come by, and how well numbers of standards are known where they are known: true
// of every result of the kind. What is not in this list is told.
constexpr std::array kOfMethod{
    Sentence::ugr_background,     Sentence::ugr_table_ends,     Sentence::ugr_table_mixture,
    Sentence::observers_see_none, Sentence::not_made,           Sentence::readings_differ,
    Sentence::energy_stated,      Sentence::road_method,        Sentence::road_standard,
    Sentence::road_by_lane,       Sentence::road_by_edge,       Sentence::road_stated,
    Sentence::road_rows_go_on,    Sentence::field_glare_method, Sentence::field_stated,
    Sentence::strongest_of,       Sentence::upward_method,      Sentence::glare_zone_of,
    Sentence::distance_method,    Sentence::nearest_of,         Sentence::points_alike,
    Sentence::mesh_room_faces};

// By how much another way to the same UGR can differ, which may be a verdict near the limit.
constexpr std::array kOfUgrMethod{Sentence::ugr_method, Sentence::ugr_by_table};
static_assert(calc::kUgrTablesDiffer == calc::kTableOfIndicesDiffers);

// Whether such a difference leaves the verdict as it is.
bool is_clear_ugr(const rules::Finding& finding) {
  const calc::Estimate& measured = finding.measured;
  const double limit = finding.requirement.limit;
  return std::string_view(rules::rating_of(finding.requirement)) == "UGR" &&
         std::max(limit - measured.high, measured.low - limit) >= calc::kTableOfIndicesDiffers;
}

bool is_clear_ugr(const PlanePart& plane) {
  return std::all_of(plane.findings.begin(), plane.findings.end(), [](const auto& finding) {
    return rules::is_of_space(finding.requirement.metric) || is_clear_ugr(finding);
  });
}

// Between two sentences that could stand apart.
bool is_separator(const MessagePart& part) {
  return part.kind == PartKind::glue && part.text == "; ";
}

std::vector<calc::Message> told_apart(const calc::Message& message) {
  std::vector<calc::Message> list(1);
  for (const MessagePart& part : message.parts()) {
    if (is_separator(part)) {
      list.emplace_back();
    } else {
      list.back().parts().push_back(part);
    }
  }
  return list;
}

bool is_of_workplaces(const MessagePart& part) {
  return part.kind == PartKind::sentence && !part.arguments.empty() &&
         (part.id == Sentence::of_workplace || part.id == Sentence::of_workplaces);
}

bool is_of_method(const calc::Message& message, bool has_clear_ugr);

// Words are not: what is not known to be of method is a doubt.
bool is_of_method(const MessagePart& part, bool has_clear_ugr) {
  if (part.kind != PartKind::sentence) return false;
  if (is_of_workplaces(part)) return is_of_method(part.arguments.back(), has_clear_ugr);
  const auto is_in = [&part](const auto& list) {
    return std::find(list.begin(), list.end(), part.id) != list.end();
  };
  return is_in(kOfMethod) || (has_clear_ugr && is_in(kOfUgrMethod));
}

bool is_of_method(const calc::Message& message, bool has_clear_ugr) {
  return std::all_of(message.parts().begin(), message.parts().end(), [&](const MessagePart& part) {
    return is_separator(part) || is_of_method(part, has_clear_ugr);
  });
}

// A name for what differs in its arguments alone; "" of what has words of its own, or is to be read
// wherever it is said.
std::string kind_of(const calc::Message& message) {
  std::string kind;
  for (const MessagePart& part : message.parts()) {
    if (is_separator(part)) {
      kind += part.text;
      continue;
    }
    const bool is_sentence = part.kind == PartKind::sentence;
    if (!is_sentence || part.id == Sentence::left_out || part.id == Sentence::task_anywhere)
      return {};
    kind += std::to_string(static_cast<int>(part.id));
    if (!is_of_workplaces(part)) continue;
    const std::string of = kind_of(part.arguments.back());
    if (of.empty()) return {};
    kind += "(" + of + ")";
  }
  return kind;
}

class NotesOnce {
 public:
  NotesOnce(const Texts& t, bool folds) : t_(t), folds_(folds) {}

  void add(const std::string& place, const std::string& words, bool is_method,
           const std::string& kind = {}) {
    if (words.empty()) return;
    // What is a doubt in one place and of method in another is two notes, each with its places.
    const bool is_folded = folds_ && !is_method && !kind.empty();
    const std::string key = (is_method ? "m" : is_folded ? "k" : "d") + (is_folded ? kind : words);
    const auto [known, is_new] = number_.try_emplace(key, notes_.size());
    if (is_new) notes_.push_back({is_method, words, {}, 0});
    RoomNote& note = notes_[known->second];
    if (words != note.words && alike_[known->second].insert(words).second) ++note.alike;
    if (std::find(note.places.begin(), note.places.end(), place) == note.places.end()) {
      note.places.push_back(place);
    }
  }
  // has_clear_ugr: no UGR that the message is about is near its limit.
  void add(const std::string& place, const calc::Message& message, bool is_method,
           bool has_clear_ugr = false) {
    for (const calc::Message& one : told_apart(message)) {
      add(place, printable(sentence(t_, one)), is_method || is_of_method(one, has_clear_ugr),
          kind_of(one));
    }
  }
  std::vector<RoomNote> take() { return std::move(notes_); }

 private:
  Texts t_;
  bool folds_;
  std::vector<RoomNote> notes_;
  std::map<std::string, std::size_t> number_;
  std::map<std::size_t, std::set<std::string>> alike_;  // words of those that are folded
};

// "" = it is as recommended.
std::string recommendation_words(const Texts& t, const PlanePart& plane,
                                 const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const std::string quantity =
      quantity_words(t, requirement, plane.kernel) + scene_words(t, requirement);
  const std::string required = format_required(
      t, Threshold{requirement.limit, requirement.comparison}, rules::unit_of(requirement));
  switch (finding.verdict) {
    case rules::Verdict::pass:
      break;
    case rules::Verdict::fail:
      return t.say<Text::advice_not_reached>(quantity, required);
    case rules::Verdict::undecided:
      return t.say<Text::advice_undecided>(quantity, required);
    case rules::Verdict::not_judged:
      return t.say<Text::advice_not_judged>(quantity, required);
  }
  return {};
}

// What must be read with one finding. Masks of standards are no doubt.
void add_finding(const Texts& t, const std::string& place, const PlanePart& plane,
                 rules::Finding finding, NotesOnce& notes) {
  const bool is_of_pack = rules::source_of(finding.requirement) == rules::LimitSource::pack;
  const bool is_advice = finding.requirement.severity == rules::Severity::advice;
  const bool is_in_causes = rules::outcome_of(finding) != rules::Outcome::nothing_asked &&
                            finding.verdict != rules::Verdict::pass;
  if (!is_in_causes) notes.add(place, finding.reason, is_advice);
  if (is_advice) notes.add(place, printable(recommendation_words(t, plane, finding)), false);
  if (is_of_pack) finding.requirement.mask.id.clear();
  // Emergency lighting is judged by direct light wherever its standard says so.
  if (is_of_pack && finding.requirement.direct_only) {
    notes.add(place, t[Text::note_direct_only], true);
    finding.requirement.direct_only = false;
  }
  finding.requirement.severity = rules::Severity::shall;
  notes.add(place, printable(foreign_clause_words(t, finding.requirement)), false);
  for (const NotePart& part : note_parts(t, finding)) {
    if (part.message.empty()) {
      notes.add(place, printable(part.text), false);
    } else {
      notes.add(place, part.message, false, is_clear_ugr(finding));
    }
  }
  if (finding.is_close) notes.add(place, close_words(t, finding), false);
}

void add_notice(const Texts& t, const std::string& place, const Notice& notice, NotesOnce& notes) {
  switch (notice.kind) {
    case NoticeKind::note:
    case NoticeKind::remark:
      return notes.add(place, *notice.message, false,
                       notice.plane != nullptr && is_clear_ugr(*notice.plane));
    case NoticeKind::changed:
      return notes.add(place,
                       printable(t.say<Text::made_and_changed>(sentence(t, notice.plane->made_by),
                                                               sentence(t, notice.plane->changed))),
                       false);
    case NoticeKind::left_out:
    case NoticeKind::doubt:
      return notes.add(place, notice_words(t, notice), false);
    case NoticeKind::row:
    case NoticeKind::in_part:
      break;
  }
}

// Of rows of which all that is possible is asked, whichever they are; "" = of others.
std::string row_kind(const Texts& t, rules::RowCoverage row) {
  if (!row.is_whole() || row.has_exceptions()) return {};
  row.workplace.clear();
  row.clause = {};
  return coverage_words(t, row);
}

void add_room(const Texts& t, const SpacePart& space, const std::string& room, NotesOnce& notes) {
  for (const PlanePart& plane : space.planes) {
    const std::string place = room + " / " + printable(plane_in_room(t, space, plane));
    for (const rules::Finding& finding : plane.findings) {
      add_finding(t, place, plane, finding, notes);
    }
  }
  for (const Notice& notice : notices_of(space)) {
    // Of planes of which nothing is asked the table of the rest tells; rows follow.
    const bool is_told = notice.plane != nullptr && notice.plane->findings.empty();
    if (is_told) continue;
    add_notice(t,
               notice.plane == nullptr
                   ? room
                   : room + " / " + printable(plane_in_room(t, space, *notice.plane)),
               notice, notes);
  }
  for (const rules::RowCoverage& row : together(t, space.coverage)) {
    notes.add(room, coverage_words(t, row), row.asks_all() && !row.has_exceptions(),
              row_kind(t, row));
  }
}

}  // namespace

std::vector<rules::RowCoverage> together(const Texts& t, std::vector<rules::RowCoverage> rows) {
  std::map<std::string, std::vector<std::string>> workplaces;  // by what is said
  const auto said = [&](rules::RowCoverage row) {
    if (!row.workplace.empty()) row.workplace = "?";
    return coverage_words(t, row);
  };
  for (const rules::RowCoverage& row : rows) workplaces[said(row)].push_back(row.workplace);
  std::vector<rules::RowCoverage> result;
  for (rules::RowCoverage& row : rows) {
    const auto names = workplaces.find(said(row));
    if (names == workplaces.end()) continue;
    row.workplace = some_names(t, names->second);
    workplaces.erase(names);
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<RoomNote> room_notes(const Texts& t, const ProjectPart& project, bool folds) {
  NotesOnce notes(t, folds);
  const std::vector<std::string> titles = room_titles(project);
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    const std::string room = printable(titles[s]);
    add_room(t, space, room, notes);
    for (const rules::AggregateFinding& finding : project.aggregates) {
      if (finding.space_id != space.id) continue;
      notes.add(room + " / " + printable(aggregate_title(t, finding)),
                without_one_source(finding.note), false);
      if (!finding.is_user_supplied || finding.clause.empty()) continue;
      notes.add(room, printable(clause_words(t, finding)), false);
    }
  }
  return notes.take();
}

std::string note_line(const Texts& t, const RoomNote& note) {
  const std::string words =
      note.alike == 0 ? note.words : t.say<Text::note_and_alike>(note.words, note.alike);
  return some_names(t, note.places) + t[Text::colon] + words;
}

}  // namespace report
