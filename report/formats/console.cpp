#include "report/formats/console.h"

#include "report/document/room_summary.h"
#include "report/formats/folded_passes.h"
#include "report/revision/revision_tables.h"
#include "report/stream/text_list.h"
#include "report/text/about_words.h"
#include "report/text/advice_words.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/decides.h"
#include "report/text/notices.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/room_causes.h"
#include "report/text/room_overview.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

enum Column : std::size_t {
  kVerdict,
  kPlace,
  kQuantity,
  kRequired,
  kMeasured,
  kMargin,
  kWhere,
  kColumns
};

constexpr std::size_t kGap = 2;
constexpr std::size_t kNarrowestName = 12;

// A table row, or (cells empty) a note below one.
struct TableLine {
  std::array<std::string, kColumns> cells;
  std::string note;
  std::string_view colour = "";
  bool is_heading = false;
};

constexpr const char* kBold = "\033[1m";
constexpr const char* kDim = "\033[2m";
constexpr const char* kReset = "\033[0m";

const char* outcome_colour(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::not_judged:
    case rules::Outcome::warned:
      break;
    case rules::Outcome::fail:
      return "\033[1;31m";
    case rules::Outcome::undecided:
      return "\033[1;33m";
    case rules::Outcome::pass:
    case rules::Outcome::waived:
      return "\033[32m";
    case rules::Outcome::nothing_asked:
      return kDim;
  }
  return "\033[1;35m";
}

const char* verdict_colour(rules::Verdict verdict) {
  return outcome_colour(rules::outcome_of(verdict));
}

// A failure that counts stands out in a log without colours, too: it alone is in capitals.
std::string verdict_cell(const Texts& t, rules::Verdict verdict, bool counts = true) {
  const bool stands_out = counts && verdict == rules::Verdict::fail;
  const char* word = stands_out ? t[Text::fail_in_capitals] : verdict_words(t, verdict);
  return std::string(verdict_symbol(verdict)) + " " + word;
}

std::string place_cell(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  return printable(title_of(space.name, space.id)) + " / " + printable(plane_title(t, plane));
}

void add_finding(const Texts& t, const SpacePart& space, const PlanePart& plane,
                 const rules::Finding& finding, std::vector<TableLine>& lines) {
  const rules::Requirement& requirement = finding.requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  TableLine line;
  line.colour = decides(finding) ? verdict_colour(finding.verdict) : kDim;
  line.cells[kVerdict] = verdict_cell(t, finding.verdict, decides(finding));
  line.cells[kPlace] = place_cell(t, space, plane);
  line.cells[kQuantity] =
      quantity_words(t, requirement, plane.kernel) + scene_words(t, requirement);
  line.cells[kRequired] = format_required(t, threshold, unit);
  if (finding.verdict != rules::Verdict::not_judged) {
    line.cells[kMeasured] = format_measured(t, finding.measured, unit, threshold);
    line.cells[kMargin] = margin_words(t, finding);
    if (finding.place_m) line.cells[kWhere] = format_position(t, *finding.place_m);
  }
  lines.push_back(std::move(line));
  const auto note = [&lines](const std::string& text) { lines.emplace_back().note = text; };
  // Clauses have no column here; who must not be taken for a standard is named all the same.
  if (const std::string words = foreign_clause_words(t, requirement); !words.empty())
    note(printable(words));
  if (!finding.reason.empty()) note(printable(sentence(t, finding.reason)));
  if (const std::string words = note_words(t, finding); !words.empty()) note(printable(words));
  if (finding.is_close) note(close_words(t, finding));
}

void add_doubt(const Texts& t, const PlanePart& plane, std::vector<TableLine>& lines) {
  const std::string doubt = doubt_words(t, plane);
  if (!doubt.empty()) lines.emplace_back().note = doubt;
}

void add_remarks(const Texts& t, const PlanePart& plane, std::vector<TableLine>& lines) {
  for (const calc::Message& remark : plane.remarks)
    lines.emplace_back().note = printable(sentence(t, remark));
}

std::string statistics_text(const Texts& t, const PlanePart& plane) {
  if (calc::is_plain_number(plane.derived)) {
    return t.say<Text::brief_extremes>(format_measured(t, plane.minimum, plane_unit(plane)),
                                       format_measured(t, plane.maximum, plane_unit(plane)));
  }
  return t.say<Text::brief_statistics>(format_measured(t, plane.average, plane_unit(plane)),
                                       format_measured(t, plane.minimum, plane_unit(plane)),
                                       format_measured(t, plane.uniformity_min_avg, ""));
}

// Of planes that a workplace has made: what the project has changed about them.
void add_change(const Texts& t, const PlanePart& plane, std::vector<TableLine>& lines) {
  if (plane.changed.empty()) return;
  lines.emplace_back().note = printable(
      t.say<Text::made_and_changed>(sentence(t, plane.made_by), sentence(t, plane.changed)));
}

void add_plane(const Texts& t, const SpacePart& space, const PlanePart& plane,
               std::vector<TableLine>& lines) {
  for (const rules::Finding& finding : plane.findings) add_finding(t, space, plane, finding, lines);
  if (!plane.findings.empty()) {
    add_change(t, plane, lines);
    add_remarks(t, plane, lines);
    return add_doubt(t, plane, lines);
  }
  TableLine line;
  line.cells[kPlace] = place_cell(t, space, plane);
  line.cells[kVerdict] = plane.is_computed ? std::string("  ") + t[Text::no_limit]
                                           : std::string("– ") + t[Text::not_computed];
  lines.push_back(std::move(line));
  const std::string quantity =
      is_plain_illuminance(plane) ? "" : std::string(plane_words(t, plane)) + ": ";
  lines.emplace_back().note = plane.is_computed ? quantity + statistics_text(t, plane)
                                                : printable(sentence(t, plane.reason));
  add_remarks(t, plane, lines);
  add_doubt(t, plane, lines);
}

// "Desk [0,0]" and "task" of "Desk [0,0]: task"; of what the room's workplaces share there is one
// part only.
std::pair<std::string, std::string> place_and_role(const Texts& t, const PlanePart& plane,
                                                   bool of_several) {
  const std::string title(plane_title(t, plane));
  const std::size_t colon = title.rfind(": ");
  if (of_several || colon == std::string::npos) return {"", title};
  return {title.substr(0, colon), title.substr(colon + 2)};
}

std::string folded_words(const Texts& t, const FoldedPasses& folded) {
  std::string roles;
  for (const PlanePart* plane : folded.planes) {
    roles += (roles.empty() ? "" : ", ") + place_and_role(t, *plane, folded.of_several).second;
    const bool is_advice = std::all_of(
        plane->findings.begin(), plane->findings.end(), [](const rules::Finding& finding) {
          return finding.requirement.severity == rules::Severity::advice;
        });
    if (is_advice) roles += fmt::format(" ({})", t[Text::note_advice]);
  }
  const rules::Finding& nearest = folded.nearest();
  const rules::Requirement& requirement = nearest.requirement;
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  const PlanePart& plane = folded.plane_of_nearest();
  return printable(t.say<Text::folded_passes>(
      roles, place_and_role(t, plane, folded.of_several).second,
      quantity_words(t, requirement, plane.kernel) + scene_words(t, requirement),
      format_measured(t, nearest.measured, unit, threshold), format_required(t, threshold, unit)));
}

// What must be read with any of them, each text once. Masks are the standard's own and no doubt,
// and that a role is advice only is said beside it.
std::vector<std::string> folded_notes(const Texts& t, const FoldedPasses& folded) {
  std::vector<std::string> notes;
  const auto add = [&](const std::string& note) {
    const bool is_new = std::find(notes.begin(), notes.end(), note) == notes.end();
    if (!note.empty() && is_new) notes.push_back(note);
  };
  for (const PlanePart* plane : folded.planes) {
    for (rules::Finding finding : plane->findings) {
      finding.requirement.mask.id.clear();
      finding.requirement.severity = rules::Severity::shall;
      add(printable(foreign_clause_words(t, finding.requirement)));
      add(printable(note_words(t, finding)));
    }
    for (const calc::Message& remark : plane->remarks) add(printable(sentence(t, remark)));
  }
  return notes;
}

void add_folded(const Texts& t, const SpacePart& space, const FoldedPasses& folded,
                std::vector<TableLine>& lines) {
  TableLine line;
  line.colour = verdict_colour(rules::Verdict::pass);
  line.cells[kVerdict] = verdict_cell(t, rules::Verdict::pass);
  const std::string place = place_and_role(t, *folded.planes.front(), folded.of_several).first;
  line.cells[kPlace] =
      printable(title_of(space.name, space.id)) + (place.empty() ? "" : " / " + printable(place));
  line.cells[kQuantity] = t.say<Text::requirements>(folded.requirements());
  line.cells[kMargin] = margin_words(t, folded.nearest());
  lines.push_back(std::move(line));
  lines.emplace_back().note = folded_words(t, folded);
  for (std::string& note : folded_notes(t, folded)) lines.emplace_back().note = std::move(note);
}

// Folded passes stand where the first of their planes would.
void add_planes(const Texts& t, const SpacePart& space, bool lists_passes,
                std::vector<TableLine>& lines) {
  const std::vector<FoldedPasses> all =
      lists_passes ? std::vector<FoldedPasses>() : folded_passes(space);
  for (const PlanePart& plane : space.planes) {
    const auto folded = std::find_if(all.begin(), all.end(), [&](const FoldedPasses& one) {
      return std::find(one.planes.begin(), one.planes.end(), &plane) != one.planes.end();
    });
    if (folded == all.end()) {
      add_plane(t, space, plane, lines);
    } else if (folded->planes.front() == &plane) {
      add_folded(t, space, *folded, lines);
    }
  }
}

// A long note that several requirements have is said once, "[1] ...", and then referred to.
void number_repeated_notes(std::vector<TableLine>& lines) {
  constexpr std::size_t kWorthIt = 60;  // characters; shorter ones are read as fast as a number
  std::map<std::string, int> count, number;
  for (const TableLine& line : lines) ++count[line.note];
  std::vector<TableLine> shorter;
  bool is_after_reference = false;
  for (TableLine& line : lines) {
    const std::string note = line.note;
    const bool is_repeated = display_width(note) > kWorthIt && count[note] > 1;
    const auto [mark, is_first] =
        is_repeated ? number.try_emplace(note, static_cast<int>(number.size()) + 1)
                    : std::pair(number.end(), false);
    if (is_repeated) line.note = fmt::format("[{}]{}", mark->second, is_first ? " " + note : "");
    const bool is_reference = is_repeated && !is_first;
    if (is_reference && is_after_reference) {
      shorter.back().note += " " + line.note;
    } else {
      shorter.push_back(std::move(line));
    }
    is_after_reference = is_reference;
  }
  lines = std::move(shorter);
}

void add_aggregate(const Texts& t, const ProjectPart& project,
                   const rules::AggregateFinding& finding, std::vector<TableLine>& lines) {
  TableLine line;
  const bool counts = rules::counts(rules::outcome_of(finding));
  line.colour = counts ? verdict_colour(finding.verdict) : kDim;
  line.cells[kVerdict] = verdict_cell(t, finding.verdict, counts);
  line.cells[kPlace] = printable(aggregate_place(project, finding));
  line.cells[kQuantity] = printable(aggregate_title(t, finding));
  line.cells[kRequired] = printable(aggregate_required(t, finding));
  line.cells[kMeasured] = printable(aggregate_measured(t, finding));
  if (finding.sum && finding.verdict != rules::Verdict::not_judged)
    line.cells[kMargin] = format_margin(t, finding.sum->margin);
  lines.push_back(std::move(line));
  const auto note = [&lines](const std::string& text) { lines.emplace_back().note = text; };
  const bool is_of_pack = !finding.sum && !finding.is_user_supplied;
  if (!is_of_pack && !finding.clause.empty()) note(printable(clause_words(t, finding)));
  if (!finding.reason.empty()) note(printable(sentence(t, finding.reason)));
  if (const std::string words = aggregate_note(t, finding); !words.empty()) note(printable(words));
}

constexpr bool is_number_column(std::size_t column) {
  return column == kRequired || column == kMeasured || column == kMargin;
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
  const std::size_t used = display_width(text);
  const std::string blanks(used < width ? width - used : 0, ' ');
  return to_the_right ? blanks + text : text + blanks;
}

using Widths = std::array<std::size_t, kColumns>;

TableLine heading(const Texts& t) {
  TableLine line;
  line.cells = {t[Text::head_verdict],  t[Text::head_place],    t[Text::head_quantity],
                t[Text::head_required], t[Text::head_measured], t[Text::head_margin],
                t[Text::head_at]};
  line.colour = kDim;
  line.is_heading = true;
  return line;
}

// Column widths over all projects, so that their tables line up; 0: nobody has anything in it.
void widen(const Texts& t, const std::vector<TableLine>& lines, Widths& widths) {
  const TableLine head = heading(t);
  for (const TableLine& line : lines) {
    if (line.is_heading) continue;
    for (std::size_t c = 0; c < kColumns; ++c) {
      if (line.cells[c].empty()) continue;
      widths[c] = std::max({widths[c], display_width(line.cells[c]), display_width(head.cells[c])});
    }
  }
}

// The name column gives way to a narrow terminal.
Widths fitted(Widths widths, int terminal_width) {
  std::size_t total = 2;  // indentation
  for (const std::size_t width : widths) total += width == 0 ? 0 : width + kGap;
  const auto available = static_cast<std::size_t>(std::max(terminal_width, 0)) + kGap;
  if (terminal_width <= 0 || total <= available) return widths;
  const std::size_t excess = total - available;
  const std::size_t narrowest = std::min(kNarrowestName, widths[kPlace]);
  widths[kPlace] = std::max(narrowest, widths[kPlace] > excess ? widths[kPlace] - excess : 0);
  return widths;
}

void trim_end(std::string& text) { text.erase(text.find_last_not_of(' ') + 1); }

// A text behind a mark of two columns, over as many lines as a terminal of that width needs; 0: one
// line.
std::string note_lines(const std::string& note, std::size_t indent, int terminal_width,
                       const char* mark = "└ ") {
  constexpr std::size_t kNarrowest = 30;  // fewer columns hold no sentence
  const auto width = static_cast<std::size_t>(std::max(terminal_width, 0));
  const std::string start = std::string(indent, ' ') + mark;
  if (width < indent + 2 + kNarrowest) return start + note + "\n";
  std::string text = start;
  std::size_t used = indent + 2;
  bool is_first = true;
  for (std::size_t from = 0; from <= note.size();) {
    const std::size_t end = std::min(note.find(' ', from), note.size());
    const std::string word = note.substr(from, end - from);
    const std::size_t columns = display_width(word);
    if (!is_first && used + 1 + columns > width) {
      text += "\n" + std::string(indent + 2, ' ');
      used = indent + 2;
      is_first = true;
    }
    text += (is_first ? "" : " ") + word;
    used += (is_first ? 0 : 1) + columns;
    is_first = false;
    from = end + 1;
  }
  return text + "\n";
}

std::string render_line(const TableLine& line, const Widths& widths, const TextOptions& options) {
  std::string text = "  ";
  if (!line.note.empty()) {
    return note_lines(line.note, text.size() + widths[kVerdict] + kGap, options.width);
  }
  for (std::size_t c = 0; c < kColumns; ++c) {
    if (widths[c] == 0) continue;
    const std::string shown = c == kPlace ? shorten_start(line.cells[c], widths[c]) : line.cells[c];
    // What does not decide stands back, all of it.
    const bool is_whole = line.colour == kDim;
    const bool is_coloured = options.colour && !line.colour.empty() && (c == kVerdict || is_whole);
    if (is_coloured) text += line.colour;
    text += padded(shown, widths[c], is_number_column(c));
    if (is_coloured) text += kReset;
    text.append(kGap, ' ');
  }
  trim_end(text);
  return text + "\n";
}

// Rows of workplaces of which the same is to be said, as one: "a, b and 6 more".
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

// of_rooms: what the overview and the reasons below it leave to say: planes of which nothing is
// asked, and what is judged of all rooms together.
std::vector<TableLine> project_lines(const Texts& t, const ProjectPart& project, bool lists_passes,
                                     bool of_rooms) {
  std::vector<TableLine> lines;
  for (const SpacePart& space : project.spaces) {
    if (of_rooms) {
      for (const PlanePart& plane : space.planes) {
        if (plane.findings.empty()) add_plane(t, space, plane, lines);
      }
      continue;
    }
    add_planes(t, space, lists_passes, lines);
    for (const calc::Message& note : space.notes)
      lines.emplace_back().note = printable(sentence(t, note));
    for (const rules::RowCoverage& row : together(t, space.coverage)) {
      lines.emplace_back().note = coverage_words(t, row);
    }
  }
  for (const rules::AggregateFinding& finding : project.aggregates)
    add_aggregate(t, project, finding, lines);
  number_repeated_notes(lines);
  if (!lines.empty()) lines.insert(lines.begin(), heading(t));
  return lines;
}

std::string project_title(const ProjectPart& project, bool colour) {
  std::string title = printable_path(project.path);
  if (!project.name.empty()) title += ": " + printable(project.name);
  return colour ? kBold + title + kReset + "\n" : title + "\n";
}

std::string messages(const ProjectPart& project) {
  std::string text;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    text += "  " + printable(calc::format_diagnostic(diagnostic)) + "\n";
  }
  return text;
}

// "" = nobody has asked, or everything is met.
std::string advice_text(const Texts& t, const ProjectPart& project) {
  if (!has_advice(project)) return {};
  std::string text = std::string("  ") + t[Text::advice_title] + "\n";
  if (project.advice->empty()) text += std::string("  ") + t[Text::advice_nothing] + "\n";
  for (const LevelAdvice& advice : *project.advice) {
    text += "  " + advice_scene(t, advice) + t[Text::colon] + advice_outcome(t, advice) + "\n";
    const std::vector<AdviceRow> rows = advice_rows(t, advice);
    std::size_t width = 0;
    for (const AdviceRow& row : rows) width = std::max(width, display_width(row.group));
    for (const AdviceRow& row : rows) {
      text +=
          fmt::format("    {}  {} → {}\n", padded(row.group, width, false), row.now, row.advised);
    }
    for (const AdviceList& list : advice_lists(t, project, advice)) {
      text += "    " + list.title + "\n";
      for (const std::string& item : list.items) text += "      " + item + "\n";
    }
  }
  return text;
}

const char* row_colour(const std::string& symbol) {
  if (symbol.starts_with("✗") || symbol.starts_with("▼")) {
    return outcome_colour(rules::Outcome::fail);
  }
  if (symbol.starts_with("?") || symbol.starts_with("↔")) {
    return outcome_colour(rules::Outcome::undecided);
  }
  return "";
}

std::string render_table(const Texts& t, const RevisionTable& table, bool colour) {
  std::vector<std::size_t> widths(table.head.size(), 0);
  const auto widen = [&widths](const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      widths[c] = std::max(widths[c], display_width(printable(cells[c])));
    }
  };
  widen(table.head);
  for (const std::vector<std::string>& row : table.rows) widen(row);
  const auto line = [&](const std::vector<std::string>& cells, const char* start) {
    std::string text = "  ";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const bool is_coloured = colour && *start != '\0' && (c == 0 || start == kDim);
      const std::string cell = padded(printable(cells[c]), widths[c], false);
      text += is_coloured ? start + cell + kReset : cell;
      text.append(kGap, ' ');
    }
    trim_end(text);
    return text + "\n";
  };
  std::string text = (colour ? kBold + table.title + kReset : table.title) + "\n";
  text += line(table.head, kDim);
  for (const std::vector<std::string>& row : table.rows) text += line(row, row_colour(row[0]));
  if (table.left_out > 0) text += "  " + t.say<Text::more_left_out>(table.left_out) + "\n";
  return text + "\n";
}

// Names of rooms by what they came to, for the end of the report.
class RoomsToName {
 public:
  // path: of the project, where there are several; else "".
  void add(const ProjectPart& project, const std::string& path) {
    const auto add_name = [&](rules::Outcome outcome, std::string_view name) {
      ++rooms_;
      const auto list = lists_.find(outcome);
      if (list == lists_.end()) return;
      const std::string room = printable(name);
      ++list->second.count;
      if (list->second.names.size() < kMostNamed) {
        list->second.names.push_back(path.empty()   ? room
                                     : room.empty() ? path
                                                    : fmt::format("{}: {}", path, room));
      }
    };
    if (!project.is_judged) add_name(rules::Outcome::not_judged, path.empty() ? project.path : "");
    for (const RoomSummary& room : room_summaries(project)) {
      add_name(room.outcome, title_of(room.space->name, room.space->id));
    }
  }

  // A line for each list; nothing where a single room is all there is.
  std::string text(const Texts& t, int terminal_width) const {
    if (rooms_ < 2) return {};
    std::string text;
    for (const auto& [outcome, list] : lists_) {
      if (list.count == 0) continue;
      std::string names = fmt::format("{}", fmt::join(list.names, ", "));
      if (list.count > list.names.size()) {
        names = t.say<Text::names_and_more>(names, list.count - list.names.size());
      }
      const std::string line = outcome == rules::Outcome::fail ? t.say<Text::rooms_fail>(names)
                               : outcome == rules::Outcome::undecided
                                   ? t.say<Text::rooms_undecided>(names)
                                   : t.say<Text::rooms_not_judged>(names);
      text += note_lines(line, 0, terminal_width, "");
    }
    return text;
  }

 private:
  static constexpr std::size_t kMostNamed = 12;
  struct List {
    std::vector<std::string> names;  // the first ones
    std::size_t count = 0;
  };
  std::size_t rooms_ = 0;
  std::map<rules::Outcome, List> lists_{{rules::Outcome::not_judged, {}},
                                        {rules::Outcome::fail, {}},
                                        {rules::Outcome::undecided, {}}};
};

std::vector<std::size_t> column_widths(const RoomOverview& table) {
  std::vector<std::size_t> widths;
  for (const std::string& head : table.head) widths.push_back(display_width(head));
  for (const RoomOverview::Row& row : table.rows) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      widths[c] = std::max(widths[c], display_width(printable(row.cells[c])));
    }
  }
  return widths;
}

// "" = of a single room. On a narrow terminal names of rooms give way first, then power, and then
// how many requirements are met; values stay.
std::string overview_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  constexpr std::size_t kRoom = 1;
  RoomOverview table = room_overview(t, project);
  if (table.rows.empty()) return {};
  std::vector<std::size_t> widths;
  const auto excess = [&] {
    std::size_t total = 0;
    for (const std::size_t width : widths) total += width + kGap;
    const auto available = static_cast<std::size_t>(std::max(options.width, 0));
    return options.width > 0 && total > available ? total - available : 0;
  };
  const auto fit = [&] {
    widths = column_widths(table);
    const std::size_t narrowest = std::min(kNarrowestName, widths[kRoom]);
    const std::size_t too_much = std::min(excess(), widths[kRoom] - narrowest);
    widths[kRoom] -= too_much;
    return excess() == 0;
  };
  for (const auto column : {RoomOverview::Column::power, RoomOverview::Column::met}) {
    if (fit()) break;
    table.drop(column);
  }
  fit();
  const auto line = [&](const std::vector<std::string>& cells, std::string_view colour) {
    std::string text = "  ";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string cell =
          padded(shorten_end(printable(cells[c]), widths[c]), widths[c], c > kRoom);
      const bool is_coloured = options.colour && (c == 0 || colour == kDim);
      text += is_coloured ? std::string(colour) + cell + kReset : cell;
      text.append(kGap, ' ');
    }
    trim_end(text);
    return text + "\n";
  };
  std::string text = line(table.head, kDim);
  for (RoomOverview::Row& row : table.rows) {
    if (row.outcome == rules::Outcome::fail) {
      row.cells.front() = verdict_cell(t, rules::Verdict::fail);
    }
    text += line(row.cells, outcome_colour(row.outcome));
  }
  return text + "\n";
}

const char* causes_title(const Texts& t, rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::fail:
      return t[Text::causes_fail];
    case rules::Outcome::undecided:
      return t[Text::causes_undecided];
    case rules::Outcome::waived:
      return t[Text::causes_waived];
    default:
      return t[Text::causes_not_judged];
  }
}

// What keeps rooms from passing, room by room; rooms with the same reasons together.
std::string causes_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  struct Entry {
    std::vector<std::string> rooms;
    std::string reasons;
  };
  std::map<rules::Outcome, std::vector<Entry>> blocks;
  for (const RoomSummary& room : room_summaries(project)) {
    std::map<rules::Outcome, std::string> reasons;
    for (std::size_t c = 0; c < room.causes.size(); ++c) {
      const RoomCause& cause = room.causes[c];
      const CauseWords words = cause_words(t, room, cause);
      std::string& text = reasons[cause.outcome];
      text += note_lines(printable(words.what), 2, options.width, "  ");
      // What several in a row have in common stands below the last one.
      const bool is_said_below = c + 1 < room.causes.size() &&
                                 room.causes[c + 1].outcome == cause.outcome &&
                                 cause_words(t, room, room.causes[c + 1]).more == words.more;
      if (is_said_below) continue;
      for (const std::string& more : words.more) {
        text += note_lines(printable(more), 4, options.width);
      }
    }
    const std::string name = printable(title_of(room.space->name, room.space->id));
    for (const auto& [outcome, text] : reasons) {
      std::vector<Entry>& entries = blocks[outcome];
      const auto known =
          std::find_if(entries.begin(), entries.end(),
                       [&, &own = text](const Entry& one) { return one.reasons == own; });
      if (known == entries.end()) {
        entries.push_back({{name}, text});
      } else {
        known->rooms.push_back(name);
      }
    }
  }
  std::string text;
  for (const auto& [outcome, entries] : blocks) {
    const std::string title = causes_title(t, outcome);
    text += (options.colour ? outcome_colour(outcome) + title + kReset : title) + "\n";
    for (const Entry& entry : entries) {
      const std::string rooms = fmt::format("{}", fmt::join(entry.rooms, ", "));
      text += note_lines(rooms, 0, options.width, "  ");
      text += entry.reasons;
    }
    text += "\n";
  }
  return text;
}

// Texts that must be read, each once, with the places of which it is true.
class NotesOnce {
 public:
  void add(const std::string& place, const std::string& note) {
    if (note.empty()) return;
    const auto [known, is_new] = number_.try_emplace(note, notes_.size());
    if (is_new) notes_.push_back({note, {}});
    std::vector<std::string>& places = notes_[known->second].places;
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  std::string text(const Texts& t, const TextOptions& options) const {
    std::string text;
    for (const Note& note : notes_) {
      text += note_lines(some_names(t, note.places) + t[Text::colon] + note.words, 0, options.width,
                         "· ");
    }
    return text;
  }

 private:
  struct Note {
    std::string words;
    std::vector<std::string> places;
  };
  std::vector<Note> notes_;
  std::map<std::string, std::size_t> number_;
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
void add_finding_notes(const Texts& t, const std::string& place, const PlanePart& plane,
                       rules::Finding finding, NotesOnce& notes) {
  const bool is_in_causes = rules::outcome_of(finding) != rules::Outcome::nothing_asked &&
                            finding.verdict != rules::Verdict::pass;
  if (!is_in_causes) notes.add(place, printable(sentence(t, finding.reason)));
  if (finding.requirement.severity == rules::Severity::advice) {
    notes.add(place, printable(recommendation_words(t, plane, finding)));
  }
  if (rules::source_of(finding.requirement) == rules::LimitSource::pack) {
    finding.requirement.mask.id.clear();
  }
  finding.requirement.severity = rules::Severity::shall;
  notes.add(place, printable(foreign_clause_words(t, finding.requirement)));
  notes.add(place, printable(note_words(t, finding)));
  if (finding.is_close) notes.add(place, close_words(t, finding));
}

// Of all rooms.
std::string notes_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  NotesOnce notes;
  for (const SpacePart& space : project.spaces) {
    const std::string room = printable(title_of(space.name, space.id));
    for (const PlanePart& plane : space.planes) {
      const std::string place = room + " / " + printable(plane_in_room(t, space, plane));
      for (const rules::Finding& finding : plane.findings) {
        add_finding_notes(t, place, plane, finding, notes);
      }
    }
    for (const Notice& notice : notices_of(space)) {
      // Of planes of which nothing is asked the table below tells; rows follow.
      const bool is_told = notice.plane != nullptr && notice.plane->findings.empty();
      if (notice.row != nullptr || is_told) continue;
      const std::string place =
          notice.plane == nullptr
              ? room
              : room + " / " + printable(plane_in_room(t, space, *notice.plane));
      const bool is_change = notice.kind == NoticeKind::changed;
      notes.add(place, is_change ? printable(t.say<Text::made_and_changed>(
                                       sentence(t, notice.plane->made_by),
                                       sentence(t, notice.plane->changed)))
                                 : notice_words(t, notice));
    }
    for (const rules::RowCoverage& row : together(t, space.coverage)) {
      notes.add(room, coverage_words(t, row));
    }
  }
  const std::string text = notes.text(t, options);
  return text.empty() ? text : t[Text::notes_once] + ("\n" + text) + "\n";
}

// A gate for regressions is about what has changed; --passes shows the rest.
bool shows_all(const DocumentFrame& frame, bool lists_passes) {
  return lists_passes || frame.revised == nullptr ||
         frame.revised->revision->gate.mode != GateMode::regression;
}

// The lines of all projects wait for the widths of the columns.
class TextWriter : public FormatWriter {
 public:
  TextWriter(const DocumentFrame& frame, const SpillPlace& place, const TextOptions& options,
             const Texts& t)
      : frame_(frame), options_(options), t_(t), waiting_(place) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  void add_line(const TableLine& line);

  const DocumentFrame& frame_;
  TextOptions options_;
  Texts t_;
  Widths widths_{};
  RoomsToName rooms_;
  bool has_overview_ = false;
  TextList waiting_;  // finished text, and lines after an empty one
};

void TextWriter::add_line(const TableLine& line) {
  waiting_.add("");
  for (const std::string& cell : line.cells) waiting_.add(cell);
  waiting_.add(line.note);
  waiting_.add(line.colour);
}

void TextWriter::add(const ProjectPart& project) {
  // Of several rooms the table of all requirements tells nobody what to do.
  const std::string overview = options_.lists_passes ? "" : overview_text(t_, project, options_);
  const bool of_rooms = !overview.empty();
  const std::vector<TableLine> lines = project_lines(t_, project, options_.lists_passes, of_rooms);
  widen(t_, lines, widths_);
  const bool is_shown = shows_all(frame_, options_.lists_passes);
  const bool has_messages = options_.has_messages && !project.diagnostics.empty();
  if (is_shown) rooms_.add(project, frame_.paths.size() > 1 ? printable_path(project.path) : "");
  if (project.is_judged && !has_messages && !is_shown) return;
  std::string text = project_title(project, options_.colour);
  if (!project.is_judged) {
    const std::string words = std::string("– ") + t_[Text::not_judged_see_errors];
    text += std::string("  ") +
            (options_.colour ? verdict_colour(rules::Verdict::not_judged) : "") + words +
            (options_.colour ? kReset : "") + "\n";
  }
  if (const std::string about = about_line(t_, project.about); !about.empty()) {
    text += "  " + about + "\n";
  }
  if (is_shown && options_.lists_passes) text += overview_text(t_, project, options_);
  if (is_shown && of_rooms) {
    has_overview_ = true;
    text += overview + causes_text(t_, project, options_) + notes_text(t_, project, options_);
  }
  if (of_rooms && lines.empty() && text.ends_with("\n\n")) text.pop_back();
  waiting_.add(text);
  if (is_shown) {
    for (const TableLine& line : lines) add_line(line);
  }
  waiting_.add((is_shown ? advice_text(t_, project) : "") +
               (options_.has_messages ? messages(project) : "") + "\n");
}

void TextWriter::finish(const DocumentEnd& end, Sink& sink) {
  const Widths widths = fitted(widths_, options_.width);
  for (TextListReader reader(waiting_); !reader.is_at_end();) {
    const std::string text = reader.next();
    if (!text.empty()) {
      sink.write(text);
      continue;
    }
    TableLine line;
    for (std::string& cell : line.cells) cell = reader.next();
    line.note = reader.next();
    const std::string colour = reader.next();
    line.colour = colour;
    sink.write(render_line(line, widths, options_));
  }
  std::string text;
  if (frame_.revised != nullptr) text += render_revision_text(t_, *frame_.revised, options_.colour);
  if (has_overview_) text += t_[Text::list_each] + std::string("\n");
  text += rooms_.text(t_, options_.width);
  std::string summary = summary_words(t_, end.totals);
  if (options_.colour) summary = outcome_colour(end.totals.outcome) + summary + kReset;
  text += summary + "\n";
  if (const std::string words = provenance_remarks(end.provenance, t_); !words.empty())
    text += words + "\n";
  for (const calc::Diagnostic& error : document_errors(end)) {
    text += calc::format_diagnostic(error) + "\n";
  }
  sink.write(text);
}

}  // namespace

std::string render_revision_text(const Texts& t, const Document& document, bool colour) {
  constexpr std::size_t kMostRows = 200;
  std::string text;
  for (const RevisionTable& table : revision_tables(document, t, kMostRows)) {
    text += render_table(t, table, colour);
  }
  for (const std::string& remark : revision_remarks(document, t)) text += printable(remark) + "\n";
  return text;
}

std::unique_ptr<FormatWriter> text_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const TextOptions& options, const Texts& t) {
  return std::make_unique<TextWriter>(frame, place, options, t);
}

}  // namespace report
