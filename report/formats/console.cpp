#include "report/formats/console.h"

#include "report/formats/console_lines.h"
#include "report/formats/console_rooms.h"
#include "report/formats/folded_passes.h"
#include "report/revision/revision_tables.h"
#include "report/stream/text_list.h"
#include "report/text/about_words.h"
#include "report/text/advice_words.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/decides.h"
#include "report/text/folded_warnings.h"
#include "report/text/one_source_note.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/room_causes.h"
#include "report/text/room_notes.h"
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

constexpr std::size_t kNarrowestName = 12;

// A table row, or (cells empty) a note below one.
struct TableLine {
  std::array<std::string, kColumns> cells;
  std::string note;
  std::string_view colour = "";
  bool is_heading = false;
};

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
    line.cells[kMeasured] = measured_words(t, finding);
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
    return t.say<Text::brief_extremes>(value_words(t, plane, plane.minimum),
                                       value_words(t, plane, plane.maximum));
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
      measured_words(t, nearest), format_required(t, threshold, unit)));
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

// With their indentation; 0: nobody has anything.
std::size_t total_of(const Widths& widths) {
  std::size_t total = 0;
  for (const std::size_t width : widths) total += width == 0 ? 0 : width + kGap;
  return total;
}

// The name column gives way to a narrow terminal.
Widths fitted(Widths widths, int terminal_width) {
  const std::size_t total = total_of(widths);
  const auto available = static_cast<std::size_t>(std::max(terminal_width, 0));
  if (terminal_width <= 0 || total <= available) return widths;
  const std::size_t excess = total - available;
  const std::size_t narrowest = std::min(kNarrowestName, widths[kPlace]);
  widths[kPlace] = std::max(narrowest, widths[kPlace] > excess ? widths[kPlace] - excess : 0);
  return widths;
}

// Where not even the shortest names fit, lines stand one below the other.
std::string render_line(const TableLine& line, const Widths& widths, const TextOptions& options) {
  std::string text = "  ";
  if (!line.note.empty()) {
    return note_lines(line.note, text.size() + widths[kVerdict] + kGap, options.width);
  }
  if (options.width > 0 && total_of(widths) > static_cast<std::size_t>(options.width)) {
    if (line.is_heading) return {};
    const bool is_coloured = options.colour && !line.colour.empty();
    return stacked_cells({line.cells.begin(), line.cells.end()},
                         is_coloured ? std::string(line.colour) : "", options.width);
  }
  for (std::size_t c = 0; c < kColumns; ++c) {
    if (widths[c] == 0) continue;
    const std::string shown =
        c == kPlace ? shorten_middle(line.cells[c], widths[c]) : line.cells[c];
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

// of_rooms: what the overview and the reasons below it leave to say: planes of which nothing is
// asked, and what is judged of several rooms together.
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
  for (const rules::AggregateFinding& finding : project.aggregates) {
    if (!of_rooms || finding.space_id.empty()) add_aggregate(t, project, finding, lines);
  }
  number_repeated_notes(lines);
  if (!lines.empty()) lines.insert(lines.begin(), heading(t));
  return lines;
}

// text: of lines, each with its end.
std::string painted(const std::string& text, const char* colour, bool is_coloured) {
  return is_coloured ? colour + text.substr(0, text.size() - 1) + kReset + "\n" : text;
}

std::string project_title(const ProjectPart& project, const TextOptions& options) {
  std::string title = printable_path(project.path);
  if (!project.name.empty()) title += ": " + printable(project.name);
  return painted(wrapped_lines("", title, 2, options.width), kBold, options.colour);
}

std::string messages(const ProjectPart& project, const TextOptions& options, bool folds) {
  std::vector<std::string> lines;
  if (folds) {
    lines = folded_warnings(project, options.width);
  } else {
    for (const calc::Diagnostic& diagnostic : project.diagnostics) {
      lines.push_back(calc::format_diagnostic(diagnostic));
    }
  }
  std::string text;
  for (const std::string& line : lines) {
    text += wrapped_lines("  ", printable(line), 4, options.width);
  }
  return text;
}

// "" = nobody has asked, or everything is met.
std::string advice_text(const Texts& t, const ProjectPart& project, int width_of_terminal) {
  if (!has_advice(project)) return {};
  const auto line = [&](std::size_t indent, const std::string& words) {
    return wrapped_lines(std::string(indent, ' '), words, indent + 2, width_of_terminal);
  };
  std::string text = line(2, t[Text::advice_title]);
  if (project.advice->empty()) text += line(2, t[Text::advice_nothing]);
  for (const LevelAdvice& advice : *project.advice) {
    text += line(2, advice_scene(t, advice) + t[Text::colon] + advice_outcome(t, advice));
    const std::vector<AdviceRow> rows = advice_rows(t, advice);
    std::size_t width = 0;
    for (const AdviceRow& row : rows) width = std::max(width, display_width(row.group));
    for (const AdviceRow& row : rows) {
      text += line(
          4, fmt::format("{}  {} → {}", padded(row.group, width, false), row.now, row.advised));
    }
    for (const AdviceList& list : advice_lists(t, project, advice)) {
      text += line(4, list.title);
      for (const std::string& item : list.items) text += line(6, item);
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

std::string render_table(const Texts& t, const RevisionTable& table, bool colour,
                         int terminal_width) {
  std::vector<std::size_t> widths(table.head.size(), 0);
  const auto widen = [&widths](const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      widths[c] = std::max(widths[c], display_width(printable(cells[c])));
    }
  };
  widen(table.head);
  for (const std::vector<std::string>& row : table.rows) widen(row);
  std::size_t total = 0;
  for (const std::size_t width : widths) total += width + kGap;
  const bool is_too_wide = terminal_width > 0 && total > static_cast<std::size_t>(terminal_width);
  const auto line = [&](const std::vector<std::string>& cells, const char* start) {
    std::string text = "  ";
    if (is_too_wide) {
      std::vector<std::string> shown;
      for (const std::string& cell : cells) shown.push_back(printable(cell));
      return stacked_cells(shown, colour ? start : "", terminal_width);
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const bool is_coloured = colour && *start != '\0' && (c == 0 || start == kDim);
      const std::string cell = padded(printable(cells[c]), widths[c], false);
      text += is_coloured ? start + cell + kReset : cell;
      text.append(kGap, ' ');
    }
    trim_end(text);
    return text + "\n";
  };
  std::string text = painted(wrapped_lines("", table.title, 2, terminal_width), kBold, colour);
  if (!is_too_wide) text += line(table.head, kDim);
  for (const std::vector<std::string>& row : table.rows) text += line(row, row_colour(row[0]));
  if (table.left_out > 0)
    text += wrapped_lines("  ", t.say<Text::more_left_out>(table.left_out), 2, terminal_width);
  return text + "\n";
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
  bool has_overview_ = false, has_folded_notes_ = false;
  std::size_t hidden_notes_ = 0;
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
  std::string text = project_title(project, options_);
  if (!project.is_judged) {
    text += painted(wrapped_lines("  – ", t_[Text::not_judged_see_errors], 4, options_.width),
                    verdict_colour(rules::Verdict::not_judged), options_.colour);
    // Its messages may be many screens above. Of another file than the project's it says which.
    const auto error =
        std::find_if(project.diagnostics.begin(), project.diagnostics.end(),
                     [](const auto& one) { return one.severity() == calc::Severity::error; });
    if (error != project.diagnostics.end()) {
      const std::string& file = error->where.file;
      const std::string at = file.empty() || file == project.path ? "" : file + ": ";
      text += wrapped_lines("    ", printable(at + error->message), 4, options_.width);
    }
  }
  if (const std::string about = about_line(t_, project.about); !about.empty()) {
    text += wrapped_lines("  ", about, 4, options_.width);
  }
  if (is_shown && options_.lists_passes) text += overview_text(t_, project, options_);
  if (is_shown && of_rooms) {
    has_overview_ = true;
    const RoomNotesText notes = notes_text(t_, project, options_);
    text += overview + causes_text(t_, project, options_) + notes.text;
    hidden_notes_ += notes.hidden;
    has_folded_notes_ = has_folded_notes_ || notes.is_folded;
  }
  if (of_rooms && lines.empty() && text.ends_with("\n\n")) text.pop_back();
  waiting_.add(text);
  if (is_shown) {
    for (const TableLine& line : lines) add_line(line);
  }
  // Files and pipes are logs, which have them all.
  const bool folds = of_rooms && !options_.shows_notes && options_.width > 0;
  waiting_.add((is_shown ? advice_text(t_, project, options_.width) : "") +
               (options_.has_messages ? messages(project, options_, folds) : "") + "\n");
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
  if (frame_.revised != nullptr)
    text += render_revision_text(t_, *frame_.revised, options_.colour, options_.width);
  const auto line = [&](const std::string& words) {
    return wrapped_lines("", words, 2, options_.width);
  };
  if (has_overview_) text += line(t_[Text::list_each]);
  if (hidden_notes_ > 0) {
    text += line(hidden_notes_ == 1 ? t_.say<Text::one_method_note>(hidden_notes_)
                                    : t_.say<Text::method_notes>(hidden_notes_));
  }
  if (has_folded_notes_) text += line(t_[Text::notes_of_a_kind]);
  if (const std::string note = one_source_note(t_, end.totals.one_source_rows); !note.empty())
    text += line(note);
  text += painted(line(summary_words(t_, end.totals)), outcome_colour(end.totals.outcome),
                  options_.colour);
  if (const std::string words = provenance_remarks(end.provenance, t_); !words.empty())
    text += line(words);
  for (const calc::Diagnostic& error : document_errors(end)) {
    text += line(calc::format_diagnostic(error));
  }
  // Last of all: whoever sees one screen sees these names.
  text += rooms_.text(t_, options_.width);
  sink.write(text);
}

}  // namespace

std::string render_revision_text(const Texts& t, const Document& document, bool colour,
                                 int terminal_width) {
  constexpr std::size_t kMostRows = 200;
  std::string text;
  for (const RevisionTable& table : revision_tables(document, t, kMostRows)) {
    text += render_table(t, table, colour, terminal_width);
  }
  for (const std::string& remark : revision_remarks(document, t)) {
    text += wrapped_lines("", printable(remark), 2, terminal_width);
  }
  return text;
}

std::unique_ptr<FormatWriter> text_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const TextOptions& options, const Texts& t) {
  return std::make_unique<TextWriter>(frame, place, options, t);
}

}  // namespace report
