#include "report/formats/console_rooms.h"

#include "report/document/room_summary.h"
#include "report/formats/console_lines.h"
#include "report/text/plain_text.h"
#include "report/text/room_causes.h"
#include "report/text/room_notes.h"
#include "report/text/room_overview.h"
#include "report/text/room_titles.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace report {
namespace {

constexpr const char* kTaskIndent = "  ";  // of a task below its room

using OverviewColumn = RoomOverview::Column;

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

// Columns to which names may be shortened, the use of a room first.
struct LeastWidths {
  std::size_t use = 0, room = 0;
};

// Widths that fit; empty: there are none.
std::vector<std::size_t> fitted_widths(const RoomOverview& table, int terminal_width,
                                       const LeastWidths& least) {
  std::vector<std::size_t> widths = column_widths(table);
  if (terminal_width <= 0) return widths;
  std::size_t total = 0;  // with the indentation in place of the last gap
  for (const std::size_t width : widths) total += width + kGap;
  const auto available = static_cast<std::size_t>(terminal_width);
  std::size_t excess = total > available ? total - available : 0;
  const auto shrink = [&](OverviewColumn column, std::size_t narrowest) {
    const auto at = std::find(table.columns.begin(), table.columns.end(), column);
    if (at == table.columns.end()) return;
    std::size_t& width = widths[static_cast<std::size_t>(at - table.columns.begin())];
    const std::size_t less = std::min(excess, width - std::min(width, narrowest));
    width -= less;
    excess -= less;
  };
  shrink(OverviewColumn::use, least.use);
  shrink(OverviewColumn::room, least.room);
  return excess == 0 ? widths : std::vector<std::size_t>();
}

// Whether some line has a minimum only, as of an escape route: without it the line says nothing.
bool is_of_minima_alone(const RoomOverview& table) {
  const auto place = [&](OverviewColumn column) {
    return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                    table.columns.begin());
  };
  const std::size_t minimum = place(OverviewColumn::minimum),
                    average = place(OverviewColumn::average);
  if (minimum == table.columns.size()) return false;
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const RoomOverview::Row& row) {
    return !row.cells[minimum].empty() &&
           (average == table.columns.size() || row.cells[average].empty());
  });
}

// What does not fit is left out of the table.
std::vector<std::size_t> fit(RoomOverview& table, int terminal_width) {
  struct Step {
    LeastWidths least;
    std::vector<OverviewColumn> dropped;  // one after the other until the rest fits
  };
  std::array steps{
      Step{{18, 18},
           {OverviewColumn::met, OverviewColumn::leni, OverviewColumn::cylindrical,
            OverviewColumn::power, OverviewColumn::minimum, OverviewColumn::walls}},
      Step{{10, 12}, {OverviewColumn::use, OverviewColumn::glare, OverviewColumn::uniformity}},
      Step{{10, 4}, {OverviewColumn::average}}};
  if (is_of_minima_alone(table)) {
    std::erase(steps[0].dropped, OverviewColumn::minimum);
    steps[1].dropped.push_back(OverviewColumn::minimum);
  }
  std::vector<std::size_t> widths;
  for (const Step& step : steps) {
    widths = fitted_widths(table, terminal_width, step.least);
    for (const OverviewColumn column : step.dropped) {
      if (!widths.empty()) return widths;
      table.drop(column);
      widths = fitted_widths(table, terminal_width, step.least);
    }
  }
  return widths.empty() ? column_widths(table) : widths;
}

std::vector<std::string> dropped_heads(const RoomOverview& whole, const RoomOverview& rest) {
  std::vector<std::string> heads;
  for (std::size_t c = 0; c < whole.columns.size(); ++c) {
    const bool is_there =
        std::find(rest.columns.begin(), rest.columns.end(), whole.columns[c]) != rest.columns.end();
    if (!is_there) heads.push_back(whole.head[c]);
  }
  return heads;
}

}  // namespace

std::string overview_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  RoomOverview table = room_overview(t, project);
  if (table.rows.empty()) return {};
  for (RoomOverview::Row& row : table.rows) {
    // A failure stands out in a log without colours, too: it alone is in capitals.
    if (row.outcome == rules::Outcome::fail) {
      row.cells.front() =
          fmt::format("{} {}", outcome_symbol(row.outcome), t[Text::fail_in_capitals]);
    }
    if (row.is_area) row.cells[1].insert(0, kTaskIndent);
  }
  const RoomOverview whole = table;
  const std::vector<std::size_t> widths = fit(table, options.width);
  const auto line = [&](const std::vector<std::string>& cells, std::string_view colour) {
    std::string text = "  ";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string cell =
          padded(shorten_name(printable(cells[c]), widths[c]), widths[c], table.is_number(c));
      const bool is_coloured = options.colour && (c == 0 || colour == kDim);
      text += is_coloured ? std::string(colour) + cell + kReset : cell;
      text.append(kGap, ' ');
    }
    trim_end(text);
    return text + "\n";
  };
  std::string text = line(table.head, kDim);
  for (const RoomOverview::Row& row : table.rows)
    text += line(row.cells, outcome_colour(row.outcome));
  if (const std::vector<std::string> heads = dropped_heads(whole, table); !heads.empty()) {
    text += note_lines(t.say<Text::columns_left_out>(fmt::format("{}", fmt::join(heads, ", "))), 0,
                       options.width, "  ");
  }
  return text + "\n";
}

std::string causes_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  std::string text;
  for (const CauseBlock& block : cause_blocks(t, project)) {
    text += options.colour
                ? fmt::format("{}{}{}\n", outcome_colour(block.outcome), block.title, kReset)
                : std::string(block.title) + "\n";
    for (const CauseEntry& entry : block.entries) {
      text += note_lines(printable(fmt::format("{}", fmt::join(entry.rooms, ", "))), 0,
                         options.width, "  ");
      for (const CauseWords& cause : entry.causes) {
        text += note_lines(printable(cause.what), 2, options.width, "  ");
        for (const std::string& more : cause.more) {
          text += note_lines(printable(more), 4, options.width);
        }
      }
    }
    text += "\n";
  }
  return text;
}

RoomNotesText notes_text(const Texts& t, const ProjectPart& project, const TextOptions& options) {
  RoomNotesText notes;
  for (const RoomNote& note : room_notes(t, project, !options.shows_notes)) {
    if (note.is_method && !options.shows_notes) {
      ++notes.hidden;
    } else {
      notes.text += note_lines(note_line(t, note), 0, options.width, "· ");
      notes.is_folded = notes.is_folded || note.alike > 0;
    }
  }
  if (!notes.text.empty()) notes.text = t[Text::notes_once] + ("\n" + notes.text) + "\n";
  return notes;
}

void RoomsToName::add_name(const std::string& name, List& list) {
  constexpr std::size_t kMostNamed = 12;
  ++list.count;
  if (list.names.size() < kMostNamed) list.names.push_back(name);
}

std::string RoomsToName::names(const Texts& t, const List& list) {
  const std::string names = fmt::format("{}", fmt::join(list.names, ", "));
  const std::size_t more = list.count - list.names.size();
  return more == 0 ? names : t.say<Text::names_and_more>(names, more);
}

void RoomsToName::add(const ProjectPart& project, const std::string& path) {
  if (!project.is_judged) {
    ++rooms_;
    add_name(path.empty() ? printable_path(project.path) : path, unread_);
  }
  const std::vector<std::string> titles = room_titles(project);
  for (const RoomSummary& room : room_summaries(project)) {
    const std::string title =
        printable(titles[static_cast<std::size_t>(room.space - project.spaces.data())]);
    const std::string name = path.empty() ? title : fmt::format("{}: {}", path, title);
    ++rooms_;
    add_name(name, lists_[room.outcome]);
    // What was not judged is graver, but what fails is to be mended as well.
    const bool has_failed =
        std::any_of(room.causes.begin(), room.causes.end(),
                    [](const RoomCause& one) { return one.outcome == rules::Outcome::fail; });
    if (has_failed && room.outcome != rules::Outcome::fail)
      add_name(name, lists_[rules::Outcome::fail]);
  }
}

std::string RoomsToName::text(const Texts& t, int terminal_width) const {
  if (rooms_ < 2) return {};
  std::vector<std::string> parts;
  for (const rules::Outcome outcome :
       {rules::Outcome::fail, rules::Outcome::not_judged, rules::Outcome::undecided}) {
    const auto list = lists_.find(outcome);
    if (list == lists_.end()) continue;
    const std::size_t count = list->second.count;
    const std::string who = names(t, list->second);
    const bool is_one = count == 1;
    if (outcome == rules::Outcome::fail) {
      parts.push_back(is_one ? t.say<Text::one_room_fails>(count, who)
                             : t.say<Text::rooms_fail>(count, who));
    } else if (outcome == rules::Outcome::not_judged) {
      parts.push_back(is_one ? t.say<Text::one_room_not_judged>(count, who)
                             : t.say<Text::rooms_not_judged>(count, who));
    } else {
      parts.push_back(is_one ? t.say<Text::one_room_undecided>(count, who)
                             : t.say<Text::rooms_undecided>(count, who));
    }
  }
  if (unread_.count > 0) {
    const std::string who = names(t, unread_);
    parts.push_back(unread_.count == 1
                        ? t.say<Text::one_project_not_judged_named>(unread_.count, who)
                        : t.say<Text::projects_not_judged_named>(unread_.count, who));
  }
  if (parts.empty()) return {};
  const std::string line = fmt::format("{}", fmt::join(parts, " · "));
  const auto width = static_cast<std::size_t>(std::max(terminal_width, 0));
  if (width == 0 || display_width(line) <= width) return line + "\n";
  std::string text;
  for (const std::string& part : parts) text += wrapped_lines("", part, 2, terminal_width);
  return text;
}

}  // namespace report
