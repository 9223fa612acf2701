#include "report/text/room_overview.h"

#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

// Whether the value stays on its side of the limit in so few digits.
bool reads_alike(double value, double limit) {
  const double shown = std::round(100.0 * value) / 100.0;
  return (shown < limit) == (value < limit) && (shown > limit) == (value > limit);
}

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
  const EstimateText text = format_estimate(measured, "", threshold);
  if (!tells_the_same || text.spread.empty()) return format_measured(t, measured, "", threshold);
  return t.number(fmt::format("{} ±{}", text.value, text.spread));
}

std::string power_cell(const Texts& t, const SpacePart& space) {
  const calc::InstalledPower& power = space.power;
  if (!(power.power_w > 0.0) || !(power.area_m2 > 0.0) || power.without_power > 0) return "";
  return format_fixed(t, power.power_w / power.area_m2, 2);
}

std::vector<std::string> cells_of(const Texts& t, const RoomSummary& room) {
  return {std::string(outcome_symbol(room.outcome)) + " " + outcome_words(t, room.outcome),
          std::string(title_of(room.space->name, room.space->id)),
          t.say<Text::overview_of>(room.met, room.required),
          overview_cell(t, room.average),
          overview_cell(t, room.uniformity),
          overview_cell(t, room.glare),
          power_cell(t, *room.space)};
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
  const double value = finding.measured.value;
  if (with_interval && is_near_limit(finding)) return value_and_interval(t, finding, threshold);
  if (rules::is_ratio(requirement.metric) && reads_alike(value, requirement.limit))
    return format_fixed(t, value, kRatioDigits);
  return format_cell(t, value, threshold);
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

RoomOverview room_overview(const Texts& t, const ProjectPart& project) {
  RoomOverview table;
  const std::vector<RoomSummary> rooms = room_summaries(project);
  if (rooms.size() < 2) return table;
  using enum RoomOverview::Column;
  table.columns = {verdict, room, met, average, uniformity, glare, power};
  table.head = {t[Text::head_verdict],
                t[Text::overview_room],
                t[Text::overview_met],
                t[Text::overview_average] + std::string(" lx"),
                "Uo",
                "UGR",
                "W/m²"};
  for (const RoomSummary& one : rooms) {
    const auto place = static_cast<std::size_t>(one.space - project.spaces.data());
    table.rows.push_back({one.outcome, place, cells_of(t, one)});
  }
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [](const auto& a, const auto& b) { return a.outcome < b.outcome; });
  drop_empty_columns(table);
  return table;
}

}  // namespace report
