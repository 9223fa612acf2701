#include "report/text/room_overview.h"

#include "report/document/storeys.h"
#include "report/text/aggregate_words.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/room_titles.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"
#include "rules/pack/row_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace report {
namespace {

// Whether the limit is so near that the interval must be seen.
bool is_near_limit(const rules::Finding& finding) {
  constexpr double kHalfWidths = 4.0;  // towards the limit
  const calc::Estimate& measured = finding.measured;
  const double limit = finding.requirement.limit;
  const double half_width =
      measured.value > limit ? measured.value - measured.low : measured.high - measured.value;
  const double distance = std::abs(measured.value - limit);
  return finding.verdict == rules::Verdict::undecided || !(distance > kHalfWidths * half_width);
}

constexpr int kRatioDigits = 2;

// "503.0 ±9.0": by the wider side, where that does not reach beyond a limit which the interval
// itself does not reach; else both ends.
std::string value_and_interval(const Texts& t, const rules::Finding& finding,
                               const Threshold& threshold) {
  const calc::Estimate& measured = finding.measured;
  const double wider = std::max(measured.high - measured.value, measured.value - measured.low);
  const auto holds_limit = [&](double low, double high) {
    return low < threshold.limit && threshold.limit < high;
  };
  const bool tells_the_same =
      std::isfinite(wider) && holds_limit(measured.low, measured.high) ==
                                  holds_limit(measured.value - wider, measured.value + wider);
  const EstimateText text =
      format_estimate(measured, rules::unit_of(finding.requirement), threshold);
  if (!tells_the_same || text.spread.empty()) return format_measured(t, measured, "", threshold);
  return t.number(fmt::format("{} ±{}", text.value, text.spread));
}

std::string power_cell(const Texts& t, const SpacePart& space) {
  const calc::InstalledPower& power = space.power;
  if (!(power.power_w > 0.0) || !(power.area_m2 > 0.0) || power.without_power > 0) return "";
  return format_fixed(t, power.power_w / power.area_m2, 2);
}

std::string leni_cell(const Texts& t, const SpacePart& space) {
  if (!space.energy || !space.energy->problem.empty()) return "";
  return format_fixed(t, space.energy->leni_kwh_m2, 1);
}

std::string walls_cell(const Texts& t, const WallCounts& walls) {
  if (walls.asked == 0) return "";
  if (walls.not_judged == walls.asked) return "–";
  return walls.met == walls.asked ? std::string("ok")
                                  : t.say<Text::overview_of>(walls.met, walls.asked);
}

// A row's name is in the language of its pack, and of some in German.
std::string row_words(const Texts& t, const AskedRow& row) {
  const rules::RowName* name =
      row.is_user_supplied ? nullptr : rules::builtin_row_name(row.pack, row.row);
  if (name == nullptr || t.language() == Language::french) return row.row;
  const std::string& words = t.language() == Language::german ? name->name_de : name->name;
  return words.empty() ? row.row : row.row + " " + words;
}

std::string use_cell(const Texts& t, const std::vector<AskedRow>& rows,
                     const std::vector<const rules::AggregateFinding*>& classes) {
  std::string text;
  for (const AskedRow& row : rows) {
    const auto of_row =
        std::find_if(classes.begin(), classes.end(),
                     [&](const rules::AggregateFinding* one) { return one->asked == row.row; });
    text += (text.empty() ? "" : ", ") +
            (of_row == classes.end()
                 ? row_words(t, row)
                 : fmt::format("{} ({})", row.row, aggregate_measured(t, **of_row)));
  }
  return text;
}

// "use (EN 12464-1:2021)" where all rows are of one pack.
std::string use_head(const Texts& t, const std::vector<RoomSummary>& rooms) {
  std::set<std::string> titles;
  for (const RoomSummary& room : rooms) {
    for (const AskedRow& row : room.rows) {
      const rules::RowName* name =
          row.is_user_supplied ? nullptr : rules::builtin_row_name(row.pack, row.row);
      titles.insert(name == nullptr ? "" : name->title);
    }
  }
  const bool is_one = titles.size() == 1 && !titles.begin()->empty();
  return is_one ? fmt::format("{} ({})", t[Text::overview_use], *titles.begin())
                : std::string(t[Text::overview_use]);
}

// The column is of illuminances: "L 0.76 ≥ 0.75" says that a road's is of luminances.
std::string average_cell(const Texts& t, const rules::Finding* average) {
  const std::string cell = overview_cell(t, average);
  if (average == nullptr || average->requirement.metric == rules::Metric::average) return cell;
  return std::string(average_symbol(*average)) + " " + cell;
}

std::string verdict_cell(const Texts& t, rules::Outcome outcome) {
  return std::string(outcome_symbol(outcome)) + " " + outcome_words(t, outcome);
}

// Walls, power and energy are of rooms alone.
std::vector<std::string> cells_of(const Texts& t, const KeyValues& values, std::string title,
                                  std::string use) {
  return {verdict_cell(t, values.outcome),
          std::move(title),
          std::move(use),
          t.say<Text::overview_of>(values.met, values.required),
          average_cell(t, values.average),
          overview_cell(t, values.minimum),
          overview_cell(t, values.uniformity),
          overview_cell(t, values.glare),
          "",
          overview_cell(t, values.cylindrical),
          "",
          ""};
}

// Without what is of a task that has a line of its own.
KeyValues values_of_line(const RoomSummary& room) {
  KeyValues values = room;
  for (const rules::Finding** value :
       {&values.average, &values.minimum, &values.uniformity, &values.glare, &values.cylindrical}) {
    const bool is_of_area = std::any_of(room.areas.begin(), room.areas.end(),
                                        [&](const RoomArea& area) { return area.has(*value); });
    if (is_of_area) *value = nullptr;
  }
  return values;
}

std::vector<std::string> cells_of_room(const Texts& t, const RoomSummary& room, std::string title,
                                       AreaLines areas) {
  std::vector<std::string> cells =
      cells_of(t, areas == AreaLines::shown ? values_of_line(room) : KeyValues(room),
               std::move(title), use_cell(t, room.rows, room.classes));
  const auto set = [&](RoomOverview::Column column, std::string cell) {
    cells[static_cast<std::size_t>(column)] = std::move(cell);
  };
  set(RoomOverview::Column::walls, walls_cell(t, room.walls));
  set(RoomOverview::Column::power, power_cell(t, *room.space));
  set(RoomOverview::Column::leni, leni_cell(t, *room.space));
  return cells;
}

void add_area_rows(const Texts& t, const RoomSummary& room, std::size_t space,
                   std::vector<RoomOverview::Row>& rows) {
  const std::vector<std::string> titles = area_titles(t, room);
  const std::size_t shown = shown_areas(room);
  for (std::size_t k = 0; k < shown; ++k) {
    const RoomArea& area = room.areas[k];
    rows.push_back({area.outcome, space,
                    cells_of(t, area, titles[k], use_cell(t, area.rows, area.classes)), true});
  }
  const FurtherAreas further = further_areas(room);
  if (further.count == 0) return;
  RoomOverview::Row& row = rows.emplace_back();
  row.outcome = further.outcome;
  row.space = space;
  row.cells.resize(rows.front().cells.size());
  row.cells[0] = verdict_cell(t, further.outcome);
  row.cells[1] = t.say<Text::overview_more_areas>(further.count);
  row.is_area = true;
}

// By room: the place of its storey, from below; what has none is behind all others.
std::vector<std::size_t> storey_of_rooms(const ProjectPart& project) {
  const std::vector<Storey> storeys = storeys_of(project).list;
  std::vector<std::size_t> places(project.spaces.size(), storeys.size());
  for (std::size_t k = 0; k < storeys.size(); ++k) {
    for (const std::size_t room : storeys[k].rooms) places[room] = k;
  }
  return places;
}

void sort_rows(const ProjectPart& project, std::vector<RoomOverview::Row>& rows) {
  const std::vector<std::size_t> storeys = storey_of_rooms(project);
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    if (a.outcome != b.outcome) return a.outcome < b.outcome;
    if (storeys[a.space] != storeys[b.space]) return storeys[a.space] < storeys[b.space];
    return comes_before(a.cells[1], b.cells[1]);
  });
}

void drop_empty_columns(RoomOverview& table) {
  for (std::size_t c = table.head.size(); c-- > 0;) {
    const bool has_any = std::any_of(table.rows.begin(), table.rows.end(),
                                     [c](const auto& row) { return !row.cells[c].empty(); });
    if (!has_any) table.drop(table.columns[c]);
  }
}

}  // namespace

std::string overview_value(const Texts& t, const rules::Finding& finding, bool with_interval) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  if (finding.verdict == rules::Verdict::not_judged) return "–";
  const bool is_open = finding.measured.low < finding.measured.high;
  if (calc::is_nothing(finding.measured) && !is_open) return t[Text::none];
  if (is_below_scale(finding)) return measured_words(t, finding);
  const double value = finding.measured.value;
  if (with_interval && is_near_limit(finding)) return value_and_interval(t, finding, threshold);
  if (rules::is_ratio(requirement.metric) && reads_alike(value, kRatioDigits, threshold))
    return format_fixed(t, value, kRatioDigits);
  return format_cell(t, value, threshold);
}

const char* average_symbol(const rules::Finding& average) {
  return average.requirement.metric == rules::Metric::road_luminance ? "L" : "Em";
}

std::string overview_cell(const Texts& t, const rules::Finding* finding) {
  if (finding == nullptr) return "";
  const rules::Requirement& requirement = finding->requirement;
  return overview_value(t, *finding) + " " +
         format_required(t, {requirement.limit, requirement.comparison}, "");
}

void RoomOverview::drop(Column column) {
  const auto at = std::find(columns.begin(), columns.end(), column) - columns.begin();
  if (at == static_cast<std::ptrdiff_t>(columns.size())) return;
  columns.erase(columns.begin() + at);
  head.erase(head.begin() + at);
  for (Row& row : rows) row.cells.erase(row.cells.begin() + at);
}

bool has_overview(const ProjectPart& project) { return room_summaries(project).size() >= 2; }

RoomOverview room_overview(const Texts& t, const ProjectPart& project, std::size_t least,
                           AreaLines areas) {
  RoomOverview table;
  const std::vector<RoomSummary> rooms = room_summaries(project);
  if (rooms.empty() || rooms.size() < least) return table;
  using enum RoomOverview::Column;
  table.columns = {verdict,    room,  use,   met,         average, minimum,
                   uniformity, glare, walls, cylindrical, power,   leni};
  table.head = {t[Text::head_verdict],
                t[Text::overview_room],
                use_head(t, rooms),
                t[Text::overview_met],
                t[Text::overview_average] + std::string(" lx"),
                t[Text::minimum] + std::string(" lx"),
                "Uo",
                "UGR",
                t[Text::overview_walls],
                "Ez lx",
                "W/m²",
                "LENI"};
  const std::vector<std::string> titles = room_titles(project);
  std::vector<RoomOverview::Row> of_rooms;
  std::map<std::size_t, const RoomSummary*> by_space;
  for (const RoomSummary& one : rooms) {
    const auto place = static_cast<std::size_t>(one.space - project.spaces.data());
    of_rooms.push_back({one.outcome, place, cells_of_room(t, one, titles[place], areas)});
    by_space[place] = &one;
  }
  sort_rows(project, of_rooms);
  for (RoomOverview::Row& row : of_rooms) {
    const RoomSummary& room = *by_space.at(row.space);
    table.rows.push_back(std::move(row));
    if (areas == AreaLines::shown && !room.areas.empty())
      add_area_rows(t, room, table.rows.back().space, table.rows);
  }
  drop_empty_columns(table);
  return table;
}

std::size_t shown_areas(const RoomSummary& room) {
  constexpr std::size_t kMost = 6, kMostOfPasses = 3;
  const auto passes = [](const RoomArea& area) { return area.outcome == rules::Outcome::pass; };
  const auto others = static_cast<std::size_t>(
      std::find_if(room.areas.begin(), room.areas.end(), passes) - room.areas.begin());
  const std::size_t shown = std::clamp(others, kMostOfPasses, kMost);
  return room.areas.size() <= shown + 1 ? room.areas.size() : shown;
}

FurtherAreas further_areas(const RoomSummary& room) {
  FurtherAreas further;
  for (std::size_t k = shown_areas(room); k < room.areas.size(); ++k) {
    ++further.count;
    further.outcome = graver(further.outcome, room.areas[k].outcome);
  }
  return further;
}

std::vector<std::string> area_titles(const Texts& t, const RoomSummary& room) {
  // Names of projects, each with the places that have it.
  std::map<std::string, std::set<std::string_view>> places;
  std::map<std::string, int> count;
  const auto id_of = [](const RoomArea& area) -> const std::string& {
    return area.workplace.empty() ? area.task->id : area.workplace;
  };
  for (const RoomArea& area : room.areas) places[area_name(t, *area.task)].insert(id_of(area));
  const auto row_of_use = [](const RoomArea& area) {
    return area.is_one_of_uses && !area.rows.empty() ? area.rows.front().row : std::string();
  };
  const auto titled = [&](const RoomArea& area, const std::string& row) {
    const std::string name = area_name(t, *area.task),
                      id = places[name].size() > 1 && name != id_of(area) ? id_of(area) : "";
    if (id.empty() && row.empty()) return name;
    return fmt::format("{} ({}{}{})", name, id, id.empty() || row.empty() ? "" : ", ", row);
  };
  std::vector<std::string> titles;
  for (const RoomArea& area : room.areas) {
    titles.push_back(titled(area, row_of_use(area)));
    ++count[titles.back()];
  }
  // Rows of several packs may have one name.
  for (std::size_t k = 0; k < titles.size(); ++k) {
    const RoomArea& area = room.areas[k];
    if (count[titles[k]] > 1 && !row_of_use(area).empty())
      titles[k] = titled(area, area.rows.front().pack + " " + area.rows.front().row);
  }
  return titles;
}

std::string owners_of_values(const Texts& t, const RoomSummary& room) {
  if (room.areas.empty()) return {};
  const std::vector<std::string> titles = area_titles(t, room);
  std::string names, only;
  bool is_of_one = true;
  for (const auto& [value, what] :
       {std::pair(room.average, t[Text::overview_average]),
        std::pair(room.minimum, t[Text::minimum]), std::pair(room.uniformity, "Uo"),
        std::pair(room.glare, "UGR"), std::pair(room.cylindrical, "Ez")}) {
    if (value == nullptr) continue;
    std::vector<std::size_t> owners;
    for (std::size_t k = 0; k < room.areas.size(); ++k) {
      if (room.areas[k].has(value)) owners.push_back(k);
    }
    // What tasks share, or what is of none, is the room's.
    if (owners.size() != 1) {
      is_of_one = false;
      continue;
    }
    const std::string& title = titles[owners.front()];
    is_of_one = is_of_one && (only.empty() || only == title);
    only = title;
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", what, title);
  }
  return is_of_one ? only : names;
}

}  // namespace report
