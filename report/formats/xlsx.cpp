#include "report/formats/xlsx.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/luminaire_schedule.h"
#include "report/document/luminaire_totals.h"
#include "report/document/room_summary.h"
#include "report/formats/ci_finding.h"
#include "report/formats/kept_rows.h"
#include "report/formats/table.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/about_words.h"
#include "report/text/notices.h"
#include "report/text/number_format.h"
#include "report/text/one_source_note.h"
#include "report/text/plane_names.h"
#include "report/text/room_causes.h"
#include "report/text/room_overview.h"
#include "report/text/room_titles.h"
#include "report/text/schedule_words.h"
#include "report/text/sentences.h"
#include "report/text/shown_decimals.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace report {
namespace {

// A column of a sheet: one of a table by its name there, or one of those that are worked out here.
struct SheetField {
  std::string_view name;
  std::optional<Text> head;  // none: as the table has it, in every language
  int width;
  int decimals = kOfColumn;
  bool is_wrapped = false;
  ColumnRole role = ColumnRole::other;
};

// What tables do not have: names as people wrote them. Not the names of any column.
constexpr std::string_view kRoom = "@room", kPlane = "@plane";

constexpr std::array kRequirementFields{
    SheetField{"shown", Text::verdict, 13, kOfColumn, true, ColumnRole::verdict},
    SheetField{kRoom, Text::xlsx_room, 20, kOfColumn, true},
    SheetField{kPlane, Text::plane, 18, kOfColumn, true},
    SheetField{"what", Text::quantity, 20, kOfColumn, true},
    SheetField{"required", Text::required, 11, kOfColumn, true},
    SheetField{"value", Text::xlsx_calculated, 11},
    SheetField{"low", Text::xlsx_low, 9},
    SheetField{"high", Text::xlsx_high, 9},
    SheetField{"unit", Text::xlsx_unit, 8},
    SheetField{"margin", Text::xlsx_margin, 11},
    SheetField{"counts", Text::xlsx_counts, 9, kOfColumn, true, ColumnRole::counts},
    SheetField{"reason", Text::xlsx_reason, 28, kOfColumn, true},
    SheetField{"clause", Text::xlsx_clause, 17, kOfColumn, true},
    SheetField{"waiver", Text::xlsx_waived_by, 14, kOfColumn, true},
    SheetField{"close", Text::xlsx_close, 14, kOfColumn, true},
    SheetField{"note", Text::xlsx_notes, 26, kOfColumn, true}};

constexpr std::array kPointFields{SheetField{kRoom, Text::xlsx_room, 20},
                                  SheetField{kPlane, Text::plane, 18},
                                  SheetField{"x_m", {}, 9, 3},
                                  SheetField{"y_m", {}, 9, 3},
                                  SheetField{"z_m", {}, 9, 3},
                                  SheetField{"illuminance_lx", Text::xlsx_illuminance, 13, 2},
                                  SheetField{"low_lx", Text::xlsx_low_lx, 10, 2},
                                  SheetField{"high_lx", Text::xlsx_high_lx, 10, 2},
                                  SheetField{"direct_lx", Text::xlsx_direct_lx, 10, 2},
                                  SheetField{"indirect_lx", Text::xlsx_reflected_lx, 11, 2},
                                  SheetField{"rating", Text::xlsx_rating, 10, 3},
                                  SheetField{"rating_low", Text::xlsx_low, 9, 3},
                                  SheetField{"rating_high", Text::xlsx_high, 9, 3}};

constexpr std::array kPositionFields{
    SheetField{kRoom, Text::xlsx_room, 20, kOfColumn, true},
    SheetField{"mark", Text::luminaire_mark, 9},
    SheetField{"position", Text::schedule_position, 6},
    SheetField{"id", Text::luminaire_id, 12, kOfColumn, true},
    SheetField{"type", Text::type, 16, kOfColumn, true},
    SheetField{"maker", Text::xlsx_maker, 16, kOfColumn, true},
    SheetField{"product", Text::sheet_product, 18, kOfColumn, true},
    SheetField{"article", Text::xlsx_article, 16, kOfColumn, true},
    SheetField{"group", Text::xlsx_group, 11, kOfColumn, true},
    SheetField{"x_m", {}, 9, 3},
    SheetField{"y_m", {}, 9, 3},
    SheetField{"z_m", {}, 9, 3},
    SheetField{"height_m", Text::xlsx_height, 11, 3},
    SheetField{"tilt_deg", Text::xlsx_tilt, 9, 1},
    SheetField{"heading_deg", Text::xlsx_heading, 9, 1},
    SheetField{"turn_deg", Text::xlsx_turn, 9, 1},
    SheetField{"flux_lm", Text::xlsx_flux_one, 11},
    SheetField{"power_w", Text::xlsx_power_one, 10},
    SheetField{"maintenance_factor", Text::xlsx_maintenance_factor, 12}};

// Titles of rooms and planes by their ids.
struct PlaceNames {
  std::map<std::string, std::string> rooms, planes;

  PlaceNames() = default;
  PlaceNames(const Texts& t, const ProjectPart& project) {
    const std::vector<std::string> titles = room_titles(project);
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const SpacePart& space = project.spaces[i];
      rooms.emplace(space.id, titles[i]);
      for (const PlanePart& plane : space.planes)
        planes.emplace(plane.id, plane_name(t, space, plane));
    }
  }
};

// A table as a sheet: the fields for people, and after them, under the names of the CSV file, all
// other columns that this has.
class SheetOrder {
 public:
  SheetOrder(const Texts& t, std::span<const TableColumn> columns,
             std::span<const SheetField> fields, bool has_projects) {
    space_ = column_of(columns, "space");
    const auto plane = std::find_if(columns.begin(), columns.end(), [](const TableColumn& column) {
      return column.name == "plane";
    });
    plane_ = static_cast<std::size_t>(plane - columns.begin());
    if (has_projects) {
      places_.push_back(column_of(columns, "project"));
      head_.push_back({t[Text::xlsx_project], 20, kOfColumn, true});
    }
    for (const SheetField& field : fields) {
      places_.push_back(field.name == kRoom    ? kRoomPlace
                        : field.name == kPlane ? kPlanePlace
                                               : column_of(columns, field.name));
      head_.push_back({field.head ? t[*field.head] : std::string(columns[places_.back()].heading),
                       field.width, field.decimals, field.is_wrapped, field.role});
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const TableColumn& column = columns[i];
      if (!column.is_in_csv || std::find(places_.begin(), places_.end(), i) != places_.end())
        continue;
      places_.push_back(i);
      head_.push_back({std::string(column.name), std::min(column.width, kWidestName),
                       column.decimals, false, ColumnRole::other, false});
    }
    row_.resize(places_.size());
  }

  const std::vector<SheetColumn>& head() const { return head_; }
  // Valid until the next call.
  std::span<const TableCell> row(const PlaceNames& names, std::span<const TableCell> cells) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      row_[i] = places_[i] == kRoomPlace    ? title(names.rooms, cells[space_])
                : places_[i] == kPlanePlace ? title(names.planes, cells[plane_])
                                            : cells[places_[i]];
    }
    return row_;
  }

 private:
  static constexpr std::size_t kRoomPlace = static_cast<std::size_t>(-1),
                               kPlanePlace = static_cast<std::size_t>(-2);
  static constexpr int kWidestName = 18;

  // The id where there is no title, such as of a building.
  static TableCell title(const std::map<std::string, std::string>& titles, const TableCell& id) {
    const auto* text = std::get_if<std::string>(&id);
    if (text == nullptr) return id;
    const auto found = titles.find(*text);
    return found == titles.end() ? *text : found->second;
  }

  std::size_t space_ = 0, plane_ = 0;
  std::vector<std::size_t> places_;
  std::vector<SheetColumn> head_;
  std::vector<TableCell> row_;
};

TableCell count_cell(std::int64_t count) { return count; }

// The project is in front where there are several, else at the end, for programs.
template <class T>
std::vector<T> with_project(std::vector<T> row, T project, bool has_projects) {
  row.insert(has_projects ? row.begin() : row.end(), std::move(project));
  return row;
}

SheetColumn project_column(const Texts& t, bool has_projects) {
  return has_projects ? SheetColumn{t[Text::xlsx_project], 18, kOfColumn, true}
                      : SheetColumn{"project", 18, kOfColumn, false, ColumnRole::other, false};
}

// --- Projects, of several ------------------------------------------------------------------------

std::vector<SheetColumn> project_columns(const Texts& t) {
  return {{t[Text::verdict], 15, kOfColumn, false, ColumnRole::verdict},
          {t[Text::xlsx_project], 30, kOfColumn, true},
          {t[Text::xlsx_name], 24, kOfColumn, true},
          {t[Text::xlsx_pass], 9},
          {t[Text::xlsx_fail], 9},
          {t[Text::xlsx_undecided], 11},
          {t[Text::xlsx_not_judged], 11},
          {t[Text::xlsx_waived], 9},
          {t[Text::xlsx_deviating], 13},
          {t[Text::xlsx_warnings], 10},
          {t[Text::xlsx_warnings_count], 10},
          {t[Text::about_client], 40, kOfColumn, true}};
}

std::vector<TableCell> project_row(const Texts& t, const ProjectPart& project) {
  const VerdictCounts counts = count_verdicts(project);
  const WarningCounts warnings = count_warnings(project);
  return {std::string(outcome_words(t, outcome_of(project))),
          project.path,
          project.name,
          count_cell(counts.pass),
          count_cell(counts.fail),
          count_cell(counts.undecided),
          count_cell(counts.not_judged),
          count_cell(counts.waived),
          count_cell(counts.deviating),
          count_cell(warnings.all),
          count_cell(warnings.strict),
          about_line(t, project.about)};
}

// --- Rooms of the overview -----------------------------------------------------------------------

// Which columns of the overview are there: a value also where no room has one but its limit, which
// is in the column after it.
enum class Kept { always, where_used, with_limit };

struct RoomField {
  SheetColumn column;
  Kept kept = Kept::where_used;
};

std::vector<RoomField> room_fields(const Texts& t) {
  using enum Kept;
  return {{{t[Text::verdict], 14, kOfColumn, true, ColumnRole::verdict}, always},
          {{t[Text::xlsx_room], 24, kOfColumn, true}, always},
          {{t[Text::xlsx_use], 20, kOfColumn, true}, always},
          {{t[Text::xlsx_values_of], 18, kOfColumn, true}},
          {{t[Text::xlsx_met], 9}, always},
          {{t[Text::xlsx_asked], 9}, always},
          {{t[Text::xlsx_average], 10}, with_limit},
          {{t[Text::xlsx_average_limit], 11}},
          {{t[Text::xlsx_minimum], 10}, with_limit},
          {{t[Text::xlsx_minimum_limit], 10}},
          {{"Uo", 8}, with_limit},
          {{t[Text::xlsx_uo_limit], 9}},
          {{"UGR", 8}, with_limit},
          {{t[Text::xlsx_ugr_limit], 9}},
          {{t[Text::xlsx_walls_met], 8}, with_limit},
          {{t[Text::xlsx_walls_asked], 9}},
          {{"Ez (lx)", 8}, with_limit},
          {{t[Text::xlsx_ez_limit], 9}},
          {{t[Text::xlsx_power_density], 10, 2}},
          {{"LENI (kWh/m²)", 9, 1}},
          {{t[Text::xlsx_why], 0, kOfColumn, true}, always},  // see set_width_of_reasons()
          {{"space", 14, kOfColumn, false, ColumnRole::other, false}, always}};
}

// The reasons have what the other columns leave of a page, so that its letters stay legible.
void set_width_of_reasons(std::vector<SheetColumn>& columns) {
  constexpr int kOfPage = 255, kLeast = 30, kMost = 56;  // characters
  int others = 0;
  for (const SheetColumn& column : columns) others += column.is_printed ? column.width + 1 : 0;
  for (SheetColumn& column : columns) {
    if (column.width == 0) column.width = std::clamp(kOfPage - others, kLeast, kMost);
  }
}

// The columns of the overview that rooms have something in, with their places among all.
struct OverviewColumns {
  std::vector<SheetColumn> list;
  std::vector<std::size_t> places;
};

OverviewColumns overview_columns(const Texts& t, bool has_projects, const KeptRows& rooms) {
  const std::vector<RoomField> fields = with_project(
      room_fields(t), RoomField{project_column(t, has_projects), Kept::always}, has_projects);
  OverviewColumns columns;
  for (std::size_t c = 0; c < fields.size(); ++c) {
    const Kept how = fields[c].kept;
    if (how != Kept::always && !rooms.is_used(c) &&
        !(how == Kept::with_limit && rooms.is_used(c + 1)))
      continue;
    columns.list.push_back(fields[c].column);
    columns.places.push_back(c);
  }
  set_width_of_reasons(columns.list);
  return columns;
}

// A value and its limit; nothing where it is not asked.
void add_value(const Texts& t, const rules::Finding* finding, std::vector<TableCell>& row) {
  if (finding == nullptr) {
    row.insert(row.end(), 2, TableCell());
    return;
  }
  const rules::Requirement& requirement = finding->requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  if (finding->verdict == rules::Verdict::not_judged) {
    row.emplace_back();
  } else if (calc::is_nothing(finding->measured)) {
    row.emplace_back(std::string(t[Text::none]));
  } else if (is_below_scale(*finding)) {
    row.emplace_back(measured_words(t, *finding));
  } else {
    const int decimals =
        interval_decimals(finding->measured, rules::unit_of(requirement), threshold);
    row.emplace_back(TableNumber{finding->measured.value, decimals});
  }
  const bool is_of_road =
      requirement.metric == rules::Metric::road_luminance;  // no lx, as the head
  row.emplace_back(format_required(t, threshold, is_of_road ? rules::unit_of(requirement) : ""));
}

// How many walls are met, of how many; nothing of the first where none is judged.
void add_walls(const WallCounts& walls, std::vector<TableCell>& row) {
  const bool is_judged = walls.not_judged < walls.asked;
  row.push_back(is_judged ? count_cell(walls.met) : TableCell());
  row.push_back(walls.asked > 0 ? count_cell(walls.asked) : TableCell());
}

// Nothing where the project states no use of the room, or where it cannot be known.
TableCell leni_cell(const SpacePart& space) {
  if (!space.energy || !space.energy->problem.empty()) return {};
  return TableNumber{space.energy->leni_kwh_m2};
}

// "EN 12464-1:2021 34.2", each once.
std::string uses_of(const Texts& t, const SpacePart& space) {
  std::string uses;
  std::set<std::string> known;
  for (const rules::RowCoverage& row : space.coverage) {
    const std::string use = sentence(t, row.clause);
    if (known.insert(use).second) uses += (uses.empty() ? "" : "; ") + use;
  }
  return uses;
}

// The same of a task: of its workplace, or of what is asked of its plane.
std::string uses_of(const Texts& t, const SpacePart& space, const RoomArea& area) {
  std::set<std::pair<std::string_view, std::string_view>> names;  // plane, requirement
  for (const RoomArea::Part& part : area.parts)
    names.emplace(part.plane->id, part.finding->requirement.id);
  const auto is_of_area = [&](const rules::RowCoverage& row) {
    return row.workplace == area.workplace &&
           std::any_of(row.roles.begin(), row.roles.end(), [&](const auto& role) {
             return std::any_of(role.of.begin(), role.of.end(), [&](const auto& name) {
               return names.contains({name.plane_id, name.id});
             });
           });
  };
  std::string uses;
  std::set<std::string> known;
  for (const rules::RowCoverage& row : space.coverage) {
    if (!is_of_area(row)) continue;
    const std::string use = sentence(t, row.clause);
    if (known.insert(use).second) uses += (uses.empty() ? "" : "; ") + use;
  }
  return uses;
}

std::vector<TableCell> values_row(const Texts& t, const KeyValues& values, const std::string& title,
                                  const std::string& uses, const TableCell& owners,
                                  const WallCounts& walls) {
  std::vector<TableCell> row{std::string(outcome_words(t, values.outcome)),
                             title,
                             uses,
                             owners,
                             count_cell(values.met),
                             count_cell(values.required)};
  for (const rules::Finding* value :
       {values.average, values.minimum, values.uniformity, values.glare})
    add_value(t, value, row);
  add_walls(walls, row);
  add_value(t, values.cylindrical, row);
  return row;
}

// Without the project. Causes: " | " between them, since each may have several parts.
std::vector<TableCell> room_row(const Texts& t, const RoomSummary& room, const std::string& title) {
  const std::string owners = owners_of_values(t, room);
  std::vector<TableCell> row =
      values_row(t, room, title, uses_of(t, *room.space),
                 owners.empty() ? TableCell() : TableCell(owners), room.walls);
  const std::optional<double> power_w_m2 = room.space->power.density_w_m2();
  row.push_back(power_w_m2 ? TableCell(TableNumber{*power_w_m2}) : TableCell());
  row.push_back(leni_cell(*room.space));
  std::string why;
  for (const RoomCause& cause : room.causes) {
    const CauseWords words = cause_words(t, room, cause);
    why += (why.empty() ? "" : " | ") + words.what;
    for (const std::string& more : words.more) why += "; " + more;
  }
  row.emplace_back(why);
  row.emplace_back(room.space->id);
  return row;
}

// Of its tasks, below it. cells: of room_row().
std::vector<std::vector<TableCell>> area_rows(const Texts& t, const RoomSummary& room,
                                              std::size_t cells) {
  constexpr const char* kIndent = "    ";
  std::vector<std::vector<TableCell>> rows;
  if (room.areas.empty()) return rows;
  const std::vector<std::string> titles = area_titles(t, room);
  for (std::size_t k = 0; k < shown_areas(room); ++k) {
    const RoomArea& area = room.areas[k];
    rows.push_back(values_row(t, area, kIndent + titles[k], uses_of(t, *room.space, area), {}, {}));
  }
  if (const FurtherAreas further = further_areas(room); further.count > 0) {
    rows.push_back({std::string(outcome_words(t, further.outcome)),
                    kIndent + t.say<Text::overview_more_areas>(further.count)});
  }
  for (std::vector<TableCell>& row : rows) {
    row.resize(cells);
    row.back() = room.space->id;
  }
  return rows;
}

// --- Types ---------------------------------------------------------------------------------------

constexpr std::size_t kTypeColumn = 1, kCountColumn = 11, kFluxColumn = 14, kPowerColumn = 15;

// What a tender lists; what nobody buys by is for programs, without the project.
std::vector<SheetColumn> type_fields(const Texts& t) {
  const auto of_data = [](const char* heading, int width, int decimals = kOfColumn) {
    return SheetColumn{heading, width, decimals, false, ColumnRole::other, false};
  };
  return {{t[Text::schedule_position], 6},
          {t[Text::type], 16, kOfColumn, true},
          {t[Text::xlsx_maker], 16, kOfColumn, true},
          {t[Text::sheet_product], 24, kOfColumn, true},
          {t[Text::xlsx_article], 16, kOfColumn, true},
          {t[Text::xlsx_flux_of_one], 13},
          {t[Text::xlsx_power_of_one], 11},
          {t[Text::xlsx_efficacy], 11, 0},
          {t[Text::xlsx_colour_temperature], 12, kOfColumn, true},
          {"Ra", 7, kOfColumn, true},
          {t[Text::mounting], 16, kOfColumn, true},
          {t[Text::count], 8},
          {t[Text::rooms], 28, kOfColumn, true},
          {t[Text::xlsx_maintenance_factor], 12},
          {t[Text::xlsx_flux_of_all], 13},
          {t[Text::xlsx_power_of_all], 11},
          {t[Text::xlsx_lamp], 16, kOfColumn, true},
          of_data("Highest intensity (cd)", 12, 0),
          of_data("Material of the housing", 16),
          of_data("Depth of the housing (m)", 12, 3),
          of_data("Photometry file", 24),
          of_data("Format", 14),
          of_data("SHA-256 of the file", 20)};
}

std::vector<SheetColumn> type_columns(const Texts& t, bool has_projects) {
  return with_project(type_fields(t), project_column(t, has_projects), has_projects);
}

TableCell stated(double value, bool is_stated) {
  return is_stated ? TableCell(TableNumber{value}) : TableCell();
}

std::vector<TableCell> type_row(const Texts& t, const ScheduleRow& of) {
  const LuminaireRow& row = *of.type;
  const bool has_power = row.power_w > 0.0;
  return {of.position,
          row.type_id,
          row.maker,
          row.name,
          row.article(),
          TableNumber{row.told_lm()},
          stated(row.power_w, has_power),
          stated(row.told_lm() / row.power_w, has_power),
          colour_temperature_words(t, row),
          colour_rendering_words(t, row),
          mounting_words(t, of),
          count_cell(row.count),
          rooms_words(t, of),
          TableNumber{row.maintenance_factor},
          TableNumber{row.count * row.told_lm()},
          stated(row.count * row.power_w, has_power),
          row.lamp,
          TableNumber{row.max_intensity_cd},
          row.housing_material,
          stated(row.housing_depth_m, !row.housing_material.empty()),
          row.photometry_file,
          row.format,
          row.sha256};
}

// A line of words under the types that they are about.
std::vector<TableCell> type_remark(const std::string& words, std::size_t columns) {
  std::vector<TableCell> row(columns);
  row[kTypeColumn] = words;
  return row;
}

std::vector<TableCell> type_totals(const Texts& t, const LuminaireTotals& totals,
                                   std::size_t columns) {
  std::vector<TableCell> row = type_remark(t[Text::all_luminaires], columns);
  row[kCountColumn] = count_cell(totals.count);
  row[kFluxColumn] = TableNumber{totals.flux_lm};
  row[kPowerColumn] = stated(totals.power_w, totals.is_power_known);
  return row;
}

// The types that are used, what they add up to and what must be read with it.
void add_types(const Texts& t, const ProjectPart& project, bool has_projects, SheetSeries& sheet) {
  if (project.luminaires.empty()) return;
  const auto whole = [&](std::vector<TableCell> row) {
    return with_project<TableCell>(std::move(row), project.path, has_projects);
  };
  const std::size_t columns = type_fields(t).size();
  const LuminaireSchedule schedule = schedule_of(project);
  for (const ScheduleRow& row : schedule.used) sheet.add(whole(type_row(t, row)));
  sheet.add(whole(type_totals(t, schedule.totals, columns)));
  // Sentences, which are longer than any column is wide.
  for (const std::string& words : schedule_remarks(t, schedule))
    sheet.add(whole(type_remark(words, columns)), TextLook::plain);
}

// --- Notes ---------------------------------------------------------------------------------------

std::vector<SheetColumn> note_columns(const Texts& t) {
  return {{t[Text::xlsx_kind], 18, kOfColumn, true, ColumnRole::verdict},
          {t[Text::where], 34, kOfColumn, true},
          {t[Text::xlsx_message], 90, kOfColumn, true},
          {"id", 24, kOfColumn, false, ColumnRole::other, false},
          {"project", 24, kOfColumn, false, ColumnRole::other, false}};
}

// What must be read with the verdicts.
struct Remark {
  std::string kind, where, words, id = {};
};

std::string place_text(const calc::SourceLocation& where) {
  std::string text = where.file;
  if (where.line > 0) text += fmt::format(":{}", where.line);
  if (where.column > 0) text += fmt::format(":{}", where.column);
  return text;
}

// room: its title.
void add_plane_remarks(const Texts& t, const std::string& room, const SpacePart& space,
                       const PlanePart& plane, std::vector<Remark>& remarks) {
  const std::string where = fmt::format("{} / {}", room, plane_in_room(t, space, plane));
  if (!plane.is_computed)
    remarks.push_back({t[Text::not_computed], where, sentence(t, plane.reason)});
  for (const rules::Finding& finding : plane.findings) {
    const std::string place = where + " / " + quantity_words(t, finding.requirement, plane.kernel);
    if (finding.is_close)
      remarks.push_back({t[Text::xlsx_kind_close], place, close_words(t, finding)});
    if (finding.is_waived)
      remarks.push_back(
          {t[Text::waived], place, sentence(t, rules::waiver_words(*finding.requirement.waiver))});
  }
}

std::vector<Remark> remarks_of(const Texts& t, const ProjectPart& project) {
  std::vector<Remark> remarks;
  for (const calc::Diagnostic& message : project.diagnostics) {
    const char* kind = !is_warning(message)                  ? t[Text::error]
                       : is_strict_warning(project, message) ? t[Text::xlsx_strict_warning]
                                                             : t[Text::warning];
    remarks.push_back({kind, place_text(message.where), message.message,
                       std::string(calc::diagnostic_name(message.id))});
  }
  const std::vector<std::string> titles = room_titles(project);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const SpacePart& space = project.spaces[i];
    for (const Notice& notice : notices_of(space)) {
      if (notice.kind == NoticeKind::row || notice.kind == NoticeKind::left_out) continue;
      remarks.push_back(
          {notice_kind_words(t, notice.kind), notice_place(t, notice), notice_words(t, notice)});
    }
    for (const PlanePart& plane : space.planes)
      add_plane_remarks(t, titles[i], space, plane, remarks);
  }
  for (const std::string& words : ci_left_out(project, t))
    remarks.push_back({t[Text::xlsx_kind_left_out], "", words});
  return remarks;
}

// --- Overview and About --------------------------------------------------------------------------

const char* same_bits_text(const Texts& t, SameBits same_bits) {
  switch (same_bits) {
    case SameBits::any_processor:
      return t[Text::repeatable];
    case SameBits::same_device:
      return t[Text::repeatable_on_device];
    case SameBits::nowhere:
      break;
  }
  return t[Text::not_repeatable];
}

// "2027-01-31T12:00:00Z" alone is a date for the properties of a file.
bool is_moment(std::string_view text) {
  constexpr std::string_view kLike = "0000-00-00T00:00:00Z";
  if (text.size() != kLike.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (kLike[i] == '0' ? !is_digit : text[i] != kLike[i]) return false;
  }
  return true;
}

// What a revision changed, as the other formats for people tell it.
std::unique_ptr<SheetSeries> revision_sheet(const Texts& t, const Document& revised,
                                            const WorkbookLook& workbook, const SpillPlace& place) {
  constexpr int kWidth = 30;
  const std::vector<RevisionTable> tables = revision_tables(revised, t, kMostSheetRows / 4);
  std::size_t columns = 2;
  for (const RevisionTable& table : tables) columns = std::max(columns, table.head.size());
  auto sheet = std::make_unique<SheetSeries>(
      t[Text::xlsx_sheet_revision],
      std::vector<SheetColumn>(columns, {"", kWidth, kOfColumn, true}), workbook, place,
      kMostSheetRows, SheetHead::without);
  const auto add = [&](const std::vector<std::string>& words, TextLook look) {
    std::vector<TableCell> row(columns);
    std::copy(words.begin(), words.end(), row.begin());
    sheet->add(row, look);
  };
  for (const RevisionTable& table : tables) {
    add({table.title}, TextLook::title);
    add(table.head, TextLook::head);
    for (const std::vector<std::string>& row : table.rows) add(row, TextLook::wrapped);
    if (table.left_out > 0) add({t.say<Text::more_left_out>(table.left_out)}, TextLook::wrapped);
  }
  for (const std::string& remark : revision_remarks(revised, t)) add({remark}, TextLook::plain);
  return sheet;
}

// Words of verdicts, and of what is beside them, with their colours.
WorkbookLook workbook_look(const Texts& t, Paper paper) {
  using enum CellColour;
  WorkbookLook look;
  look.is_letter = paper == Paper::letter;
  look.words = {{t[Text::verdict_pass], good},          {t[Text::verdict_fail], bad},
                {t[Text::xlsx_strict_warning], bad},    {t[Text::outcome_warned], bad},
                {t[Text::xlsx_kind_worse], bad},        {t[Text::xlsx_kind_weaker], bad},
                {t[Text::verdict_undecided], unsure},   {t[Text::warning], unsure},
                {t[Text::xlsx_kind_in_part], unsure},   {t[Text::xlsx_kind_left_out], unsure},
                {t[Text::verdict_not_judged], unjudged}};
  look.cut_mark = std::string(" [") + t[Text::xlsx_cut_mark] + "]";
  look.uncounted = {t[Text::xlsx_counts_waived], t[Text::xlsx_counts_advice]};
  return look;
}

class XlsxWriter : public FormatWriter {
 public:
  XlsxWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t, Paper paper,
             std::size_t most_rows)
      : frame_(frame),
        place_(place),
        t_(t),
        look_(workbook_look(t, paper)),
        results_order_(t, results_table().columns, kRequirementFields, has_projects()),
        points_order_(t, points_table().columns, kPointFields, has_projects()),
        positions_order_(t, luminaires_table().columns, kPositionFields, has_projects()),
        projects_(t[Text::xlsx_sheet_projects], project_columns(t), look_, place, most_rows),
        requirements_(t[Text::xlsx_sheet_requirements], results_order_.head(), look_, place,
                      most_rows, SheetHead::with, {false, 3}),
        types_(t[Text::xlsx_sheet_luminaires], type_columns(t, has_projects()), look_, place,
               most_rows, SheetHead::with, {false, 2}),
        positions_(t[Text::xlsx_sheet_positions], positions_order_.head(), look_, place, most_rows,
                   SheetHead::with, {false, 2}),
        points_(t[Text::xlsx_sheet_points], points_order_.head(), look_, place, most_rows,
                SheetHead::with, {true, 2}),
        notes_(t[Text::xlsx_sheet_notes], note_columns(t), look_, place, most_rows) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  bool has_projects() const { return frame_.paths.size() > 1; }
  // At the head of all pages.
  void set_titles(const std::string& title);
  void write_what(SheetSeries& overview) const;
  void write_outcome(SheetSeries& overview, const DocumentEnd& end) const;
  void write_counts(SheetSeries& about, const DocumentEnd& end) const;
  void write_provenance(SheetSeries& about, const Provenance& provenance) const;
  void write_reading(SheetSeries& about, const Provenance& provenance) const;
  void write_sizes(SheetSeries& about) const;
  std::vector<SheetSeries*> tables() {
    std::vector<SheetSeries*> list{&requirements_, &types_, &positions_, &points_, &notes_};
    if (has_projects()) list.insert(list.begin(), &projects_);
    return list;
  }

  const DocumentFrame& frame_;
  SpillPlace place_;
  Texts t_;
  WorkbookLook look_;
  SheetOrder results_order_, points_order_, positions_order_;
  SheetSeries projects_, requirements_, types_, positions_, points_, notes_;
  // Of the overview, which begins with what comes last; with every column until the end.
  KeptRows rooms_;
  std::string title_;  // of the only project
  std::string page_title_;
  std::vector<AboutWords> about_;
};

void XlsxWriter::set_titles(const std::string& title) {
  page_title_ = title;
  for (SheetSeries* table : tables()) table->set_title(title);
}

void XlsxWriter::add(const ProjectPart& project) {
  if (!has_projects()) {
    title_ = project.name;
    about_ = about_words(t_, project.about);
    set_titles(std::string(report::title_of(project.name, project.path)));
  } else {
    set_titles(t_.say<Text::project_count>(frame_.paths.size()));
  }
  const PlaceNames names(t_, project);
  for (const RoomSummary& room : room_summaries(project)) {
    const std::vector<TableCell> of_room = room_row(t_, room, names.rooms.at(room.space->id));
    rooms_.add(with_project<TableCell>(of_room, project.path, has_projects()));
    for (const std::vector<TableCell>& row : area_rows(t_, room, of_room.size()))
      rooms_.add(with_project<TableCell>(row, project.path, has_projects()));
  }
  projects_.add(project_row(t_, project));
  results_in(t_, project, [&](std::span<const TableCell> row) {
    requirements_.add(results_order_.row(names, row));
  });
  points_table().rows(
      project, [&](std::span<const TableCell> row) { points_.add(points_order_.row(names, row)); });
  luminaires_table().rows(project, [&](std::span<const TableCell> row) {
    positions_.add(positions_order_.row(names, row));
  });
  add_types(t_, project, has_projects(), types_);
  for (const Remark& remark : remarks_of(t_, project)) {
    notes_.add(
        std::array<TableCell, 5>{remark.kind, remark.where, remark.words, remark.id, project.path});
  }
}

void XlsxWriter::write_what(SheetSeries& overview) const {
  overview.add_pair(
      title_.empty() ? std::string("luxgate: ") + t_[Text::compliance_report] : title_, {},
      TextLook::title);
  if (has_projects()) {
    overview.add_pair(t_[Text::xlsx_sheet_projects],
                      static_cast<std::int64_t>(frame_.paths.size()));
    return;
  }
  for (const AboutWords& one : about_) overview.add_pair(one.name, one.words);
  if (!frame_.paths.empty()) overview.add_pair(t_[Text::xlsx_project_file], frame_.paths.front());
}

void XlsxWriter::write_outcome(SheetSeries& overview, const DocumentEnd& end) const {
  const bool is_revised = frame_.revised != nullptr;
  const rules::Outcome outcome = is_revised ? gate_outcome(*frame_.revised) : end.totals.outcome;
  overview.add_pair(t_[Text::verdict], std::string(outcome_words(t_, outcome)));
  if (is_revised) {
    for (const std::string& remark : revision_remarks(*frame_.revised, t_))
      overview.add_pair(t_[Text::xlsx_against], remark);
  }
  overview.add_pair(t_[Text::xlsx_in_words], summary_words(t_, end.totals));
  const std::string selection = selection_words(end.provenance, t_);
  if (!selection.empty()) overview.add_pair(t_[Text::xlsx_only_a_part], selection);
  for (const calc::Diagnostic& error : document_errors(end))
    overview.add_pair(t_[Text::xlsx_error], calc::format_diagnostic(error));
  if (notes_.rows() > 0) {
    overview.add_pair(t_[Text::xlsx_notes],
                      t_.say<Text::xlsx_see_notes>(notes_.rows(), notes_.name()));
  }
}

void XlsxWriter::write_counts(SheetSeries& about, const DocumentEnd& end) const {
  const Totals& totals = end.totals;
  for (const auto& [head, count] :
       {std::pair(Text::xlsx_pass, totals.verdicts.pass),
        std::pair(Text::xlsx_fail, totals.verdicts.fail),
        std::pair(Text::xlsx_undecided, totals.verdicts.undecided),
        std::pair(Text::xlsx_not_judged, totals.verdicts.not_judged),
        std::pair(Text::xlsx_waived, totals.verdicts.waived),
        std::pair(Text::xlsx_deviating, totals.verdicts.deviating),
        std::pair(Text::xlsx_rows_in_part, totals.rows_in_part),
        std::pair(Text::xlsx_projects_not_judged, totals.projects_not_judged),
        std::pair(Text::xlsx_warnings, totals.warnings.all),
        std::pair(Text::xlsx_warnings_count, totals.warnings.strict)})
    about.add_pair(t_[head], count_cell(count));
}

void XlsxWriter::write_provenance(SheetSeries& about, const Provenance& provenance) const {
  const auto add_words = [&](Text label, const std::string& words) {
    if (!words.empty()) about.add_pair(t_[label], words);
  };
  about.add_pair(t_[Text::xlsx_where_from], {}, TextLook::title);
  about.add_pair(t_[Text::program], "luxgate " + provenance.program_version);
  about.add_pair(t_[Text::numbers_version], count_cell(provenance.numbers_version));
  about.add_pair(t_[Text::xlsx_command], provenance.command_line);
  add_words(Text::made, provenance.timestamp);
  add_words(Text::xlsx_judged_on, provenance.judged_on);
  add_words(Text::policy, policy_words(provenance, t_));
  add_words(Text::xlsx_policy_hash, provenance.policy_sha256);
  add_words(Text::xlsx_redacted, redaction_words(provenance, t_));
  about.add_pair(t_[Text::backend], provenance.backend);
  add_words(Text::method, provenance.method);
  about.add_pair(t_[Text::seed], fmt::format("{}", provenance.seed));
  about.add_pair(t_[Text::confidence], format_percent(t_, provenance.confidence));
  about.add_pair(t_[Text::goal], std::string(calc::name_of(provenance.goal)));
  about.add_pair(t_[Text::aimed_half_width], format_percent(t_, provenance.tolerance));
  about.add_pair(t_[Text::most_paths], static_cast<std::int64_t>(provenance.max_paths));
  about.add_pair(t_[Text::replicates], count_cell(provenance.replicates));
  about.add_pair(t_[Text::xlsx_again], std::string(same_bits_text(t_, provenance.same_bits)));
}

void XlsxWriter::write_reading(SheetSeries& about, const Provenance& provenance) const {
  about.add_pair(t_[Text::xlsx_how_to_read], {}, TextLook::title);
  about.add_pair(t_[Text::xlsx_low_and_high],
                 t_.say<Text::xlsx_low_and_high_is>(format_percent(t_, provenance.confidence)));
  about.add_pair(t_[Text::xlsx_empty_cells], std::string(t_[Text::xlsx_empty_cells_are]));
  about.add_pair(points_.name(), std::string(t_[Text::xlsx_points_are]));
  about.add_pair(t_[Text::xlsx_grey_heads], std::string(t_[Text::xlsx_grey_heads_are]));
}

void XlsxWriter::write_sizes(SheetSeries& about) const {
  std::size_t cut = about.cut_texts();
  for (const SheetSeries* table :
       {&projects_, &requirements_, &types_, &positions_, &points_, &notes_}) {
    cut += table->cut_texts();
    if (table == &projects_ && !has_projects()) continue;
    const std::string rows =
        table->sheets() == 1
            ? t_.say<Text::xlsx_rows>(table->rows())
            : t_.say<Text::xlsx_rows_in_sheets>(table->rows(), table->sheets(), table->name(),
                                                table->name(), table->sheets());
    about.add_pair(t_.say<Text::xlsx_sheet>(table->name()), rows);
  }
  if (cut > 0) {
    about.add_pair(t_[Text::xlsx_cut_texts],
                   t_.say<Text::xlsx_cut_texts_are>(cut, kMostCellCharacters));
  }
}

void XlsxWriter::finish(const DocumentEnd& end, Sink& sink) {
  const OverviewColumns columns = overview_columns(t_, has_projects(), rooms_);
  SheetSeries overview(t_[Text::xlsx_sheet_overview], columns.list, look_, place_, kMostSheetRows,
                       SheetHead::without);
  SheetSeries about(t_[Text::xlsx_sheet_about], {{"", 46}, {"", 100, kOfColumn, true}}, look_,
                    place_, kMostSheetRows, SheetHead::without);
  std::unique_ptr<SheetSeries> revision;
  const auto visit = [&](std::span<const TableCell> row) {
    requirements_.add(results_order_.row({}, row));
  };
  if (const std::string note = one_source_note(t_, end.totals.one_source_rows); !note.empty()) {
    const std::string id = calc::diagnostic_name(calc::DiagnosticId::one_source), none;
    notes_.add(
        std::array<TableCell, 5>{std::string(t_[Text::xlsx_kind_note]), none, note, id, none});
  }
  results_of_errors(t_, end, visit);
  if (frame_.revised != nullptr) {
    results_of_revision(t_, *frame_.revised, visit);
    revision = revision_sheet(t_, *frame_.revised, look_, place_);
  }
  overview.set_title(page_title_);
  about.set_title(page_title_);
  if (revision) revision->set_title(page_title_);
  write_what(overview);
  write_outcome(overview, end);
  overview.add_pair("", {});
  overview.add_head();
  rooms_.for_each([&](std::vector<TableCell> row) {
    for (std::size_t i = 0; i < columns.places.size(); ++i) {
      if (columns.places[i] != i) row[i] = std::move(row[columns.places[i]]);
    }
    row.resize(columns.places.size());
    overview.add(row);
  });
  write_counts(about, end);
  write_provenance(about, end.provenance);
  write_reading(about, end.provenance);
  write_sizes(about);

  Workbook book;
  book.add(overview);
  for (SheetSeries* table : tables()) book.add(*table);
  if (revision) book.add(*revision);
  book.add(about);
  const Provenance& provenance = end.provenance;
  book.write({title_.empty() ? "luxgate" : title_, "luxgate " + provenance.program_version,
              is_moment(provenance.timestamp) ? provenance.timestamp : ""},
             place_, sink);
}

}  // namespace

std::unique_ptr<FormatWriter> xlsx_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const Texts& t, Paper paper, std::size_t most_rows) {
  return std::make_unique<XlsxWriter>(frame, place, t, paper, most_rows);
}

}  // namespace report
