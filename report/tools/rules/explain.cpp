#include "report/tools/rules/explain.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/edit_distance.h"
#include "calc/base/text.h"
#include "report/formats/console_lines.h"
#include "report/tools/rules/pack_words.h"
#include "rules/binding/rule_reference.h"
#include "rules/pack/limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace cli {
namespace {

using rules::RuleCheck;
using rules::RulePack;
using rules::RuleRow;

std::string with_unit(double value, const char* unit) {
  const std::string number = fmt::format("{:.6g}", value);
  return *unit == '\0' ? number : number + " " + unit;
}

std::string trusted(const std::string& text, rules::Trust trust) {
  return with_trust(calc::Message::words(text), trust).english();
}

std::string value_text(const RulePack& pack, const rules::RuleValue& value) {
  const rules::Unit unit = pack.find_parameter(value.parameter)->unit;
  const char* name = unit.dimension == rules::Dimension::plain ? "" : unit.name.data();
  if (!value.required) return fmt::format("{} {}", value.parameter, calc::name_of(value.why));
  std::string text =
      fmt::format("{} {}", value.parameter, with_unit(*value.required / unit.factor, name));
  if (value.modified) {
    text += fmt::format(" (modified {})", with_unit(*value.modified / unit.factor, name));
  }
  return trusted(text, value.trust);
}

std::string row_text(const RulePack& pack, const RuleRow& row) {
  const std::string german = row.name_de.empty() ? "" : " / " + row.name_de;
  std::string text =
      fmt::format("{}  {}{} ({})\n    ", row.ref, row.name, german, calc::name_of(row.trust));
  for (const rules::RuleValue& value : row.values) {
    text += (&value == &row.values.front() ? "" : ", ") + value_text(pack, value);
  }
  text += "\n";
  if (row.task_heights_m) {
    text += row.task_heights_m->lowest_m == row.task_heights_m->highest_m
                ? fmt::format("    task {:g} m above the floor\n", row.task_heights_m->lowest_m)
                : fmt::format("    task {:g} to {:g} m above the floor\n",
                              row.task_heights_m->lowest_m, row.task_heights_m->highest_m);
  }
  if (!row.task_orientation.empty()) {
    text += fmt::format("    task {}\n", row.task_orientation);
  }
  if (!row.note.empty()) text += "    " + row.note + "\n";
  return text;
}

std::string light_text(const RuleCheck& check) {
  constexpr std::array kSources{"", ", electric light", ", emergency luminaires alone",
                                ", daylight"};
  std::string text(calc::name_of(check.state));
  text += kSources[static_cast<std::size_t>(check.sources)];
  if (check.direct_only) text += ", direct light only";
  if (check.any_one_unit_out) text += ", any one unit out";
  return text;
}

// Where it is measured, of quantities that are more than an illuminance.
std::string measured_on(const rules::Quantity& quantity) {
  if (quantity.of_space == rules::Metric::power_density) {
    return "on any plane of the room: installed power of its luminaires by its floor area";
  }
  if (quantity.of_space == rules::Metric::leni) {
    return "on any plane of the room: energy of its luminaires in a year by its floor area, of the "
           "hours and factors that <energy> of the room or the project states";
  }
  if (quantity.of_space == rules::Metric::colour_rendering) {
    return "together with the row's own role: the least of the room's luminaires, where the files "
           "of all state it; not calculated";
  }
  if (quantity.of_space == rules::Metric::ugr_table) {
    return "on any plane of the room: by the tabular method, for a rectangular room with "
           "luminaires "
           "in even rows";
  }
  if (quantity.of_space == rules::Metric::glare_rating) {
    return "on the plane that the row is asked of, of eyes above its points; reflectance=\"...\" "
           "states that of the field";
  }
  if (quantity.of_space == rules::Metric::upward_share) {
    return "on any plane of the space: of all its luminaires together, as they are mounted";
  }
  if (quantity.of_space == rules::Metric::intensity) {
    return "on a plane whose points are where people look from: the greatest intensity of one "
           "luminaire towards one of them";
  }
  if (quantity.of_space == rules::Metric::glare_intensity) {
    return "on any plane of the space: of each luminaire, 60 to 90 degrees from the vertical, in "
           "all directions";
  }
  if (quantity.of_space == rules::Metric::peak_intensity) {
    return "on any plane of the space: of each luminaire, in any direction";
  }
  if (quantity.of_space == rules::Metric::luminaire_distance) {
    return "on the plane of the item: in plan, from each of its points to the nearest luminaire "
           "that is on";
  }
  if (quantity.of_space && rules::is_of_road(*quantity.of_space)) {
    return "on a <road>: by EN 13201-3, for the road and its rows of luminaires alone";
  }
  if (!quantity.kernel || quantity.derived == calc::DerivedQuantity::none) return {};
  return fmt::format("on a plane with quantity=\"{}\"{}",
                     calc::quantity_name(*quantity.kernel, quantity.derived),
                     calc::has_look(*quantity.kernel, quantity.derived)
                         ? " and the direction that is looked in, direction=\"x y z\""
                         : "");
}

std::string check_text(const RulePack& pack, const RuleCheck& check) {
  std::string text =
      fmt::format("{}  {} of {}, role {}: {} {}\n    {}", check.id, calc::name_of(check.metric),
                  check.quantity->name, check.role, comparison_name(check.comparison),
                  check.limit_text, light_text(check));
  if (check.has_mounting_heights()) {
    text += fmt::format(", of luminaires from {:g} m above the floor", check.range.from);
    if (std::isfinite(check.range.to)) text += fmt::format(" to below {:g} m", check.range.to);
  }
  if (!check.mask.id.empty()) text += ", mask " + check.mask.id;
  if (check.severity == rules::Severity::advice) text += ", advice";
  if (check.severity == rules::Severity::in_aggregate) text += ", counts only in its aggregates";
  text = trusted(text, check.trust);
  if (const std::string where = measured_on(*check.quantity); !where.empty()) {
    text += "\n    " + where;
  }
  if (!check.clause.empty()) text += fmt::format("\n    {}: {}", pack.title, check.clause);
  if (!check.note.empty()) text += "\n    " + check.note;
  return text + "\n";
}

// What a <workplace> makes of it, at such a height.
std::string zone_text(const rules::RulePlane& plane, std::optional<double> height_m) {
  std::string text = "; workplaces: ";
  switch (plane.area) {
    case rules::ZoneArea::none:
      return {};
    case rules::ZoneArea::task:
      text += "the task area";
      break;
    case rules::ZoneArea::band:
      text += fmt::format("a band of {:g} m around the {}", plane.width_m, plane.around);
      break;
    case rules::ZoneArea::task_and_band:
      text += fmt::format("the task area with {:g} m around it", plane.width_m);
      break;
    case rules::ZoneArea::walls:
      text += "every wall";
      break;
    case rules::ZoneArea::ceiling:
      text += "the ceiling";
      break;
  }
  if (height_m) text += fmt::format(" at {:g} m", *height_m);
  if (plane.margin_m > 0.0) text += fmt::format(", less {:g} m along walls", plane.margin_m);
  return text;
}

// row: whose planes are meant; nullptr = any.
std::string plane_text(const rules::RulePlane& plane, const RuleRow* row) {
  const std::string orientation = orientation_of(plane, row);
  std::string text = fmt::format("plane for role {}: {}", plane.role, orientation);
  const std::optional<RuleRow::Heights> heights = heights_of(plane, row);
  if (heights) {
    text += heights->lowest_m == heights->highest_m
                ? fmt::format(", {:g} m above the floor", heights->lowest_m)
                : fmt::format(", {:g} to {:g} m above the floor", heights->lowest_m,
                              heights->highest_m);
    const bool is_of_row = !plane.has_heights || heights->lowest_m != plane.lowest_m ||
                           heights->highest_m != plane.highest_m;
    if (is_of_row) {
      text += " in this row";
    } else if (plane.are_heights_usual) {
      text += " usually";
    }
  }
  if (!plane.grid.empty()) text += ", grid " + plane.grid;
  if (!plane.mask.empty()) text += ", mask " + plane.mask;
  const bool has_own_height = heights && plane.area == rules::ZoneArea::task && row != nullptr &&
                              row->task_heights_m.has_value();
  const bool has_no_height = orientation != plane.orientation;  // it is where the project says
  if (has_no_height) {
    text += "; workplaces: " + std::string(plane.area == rules::ZoneArea::task
                                               ? "the wall or the face that they name"
                                               : "the band around it in its plane");
    return text + "\n";
  }
  text += zone_text(plane, has_own_height ? heights->lowest_m : plane.height_m);
  if (!plane.note.empty()) text += " (" + plane.note + ")";
  return text + "\n";
}

std::string mask_text(const rules::Mask& mask) {
  return fmt::format("mask {}: {}\n", mask.id, rules::mask_words(mask).english());
}

std::string grids_text(const RulePack& pack) {
  std::string text;
  for (const rules::RuleGrid& grid : pack.grids) {
    text += fmt::format("grid {}: {}\n", grid.id, grid_text(grid));
    if (!grid.note.empty()) text += "    " + grid.note + "\n";
  }
  return text;
}

std::string head_text(const RulePack& pack) {
  std::string text = fmt::format("{}  {}:{}, {} ({})", pack.full_id(), pack.title, pack.edition,
                                 pack.kind, pack.status);
  if (!pack.jurisdiction.empty()) text += ", " + pack.jurisdiction;
  text += fmt::format("; version {} of the pack, {}\n", pack.version, pack.file);
  text += fmt::format("licence: {}{}{}\n", pack.licence, pack.licence_note.empty() ? "" : "; ",
                      pack.licence_note);
  return text + "decision: " + policy_text(pack.policy) + "\n";
}

std::string sources_text(const RulePack& pack, const std::vector<std::string>& ids) {
  std::string text;
  for (const rules::RuleSource& source : pack.sources) {
    if (!ids.empty() && std::find(ids.begin(), ids.end(), source.id) == ids.end()) continue;
    text += fmt::format("source {}: {}{}\n", source.id, source.note,
                        source.address.empty() ? "" : ", " + source.address);
  }
  return text;
}

// The limit of a check for a row, at the levels that differ.
std::string limits_text(const RulePack& pack, const RuleCheck& check, const RuleRow* row) {
  const auto limit_at = [&](const rules::RowLevel& level) {
    const rules::Limit limit = evaluate_limit(check, {pack, row, level});
    if (limit.status != rules::LimitStatus::known) return limit.reason.english();
    std::string text = with_unit(limit.value.value, base_unit(check.dimension()));
    return trusted(text, limit.trust);
  };
  const std::string required = limit_at(rules::RowLevel::required);
  std::string text = "    here: " + required;
  for (const auto& name : row == nullptr ? calc::Names() : pack.levels_of(*row)) {
    const std::string other = limit_at(rules::level_named(name));
    if (other != required) text += fmt::format("; level {}: {}", name, other);
  }
  for (const rules::RuleSpecial& special : check.specials) {
    if (check.find_special(special.place, row) != &special) continue;
    const bool is_task = special.place == calc::SpecialPlace::unknown_task;
    const std::string limit = with_unit(special.limit, base_unit(check.dimension()));
    text += fmt::format("; {}: {}", is_task ? "place of the task unknown" : "wall not in front",
                        trusted(limit, special.trust));
  }
  return text + "\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string aggregate_text(const rules::RuleAggregate& aggregate) {
  std::string text = fmt::format("aggregate {}: ", aggregate.id);
  const std::string members = fmt::format("the {}", calc::name_of(aggregate.over));
  switch (aggregate.rule) {
    case rules::AggregateRule::all:
      text += "all of " + members;
      break;
    case rules::AggregateRule::any:
      text += "any of " + members;
      break;
    case rules::AggregateRule::at_least:
      text += fmt::format("at least {} of {}", aggregate.count, members);
      break;
    case rules::AggregateRule::sum:
      break;
    case rules::AggregateRule::share:
      text += fmt::format("at least {:g} % of {}{}", 100.0 * aggregate.share, members,
                          aggregate.by_area ? " by area" : "");
      break;
  }
  text += aggregate.over == rules::AggregateOver::checks ? " " : " judged by ";
  text += joined(aggregate.checks);
  if (aggregate.severity != rules::Severity::shall) text += ", advice";
  text = trusted(text, aggregate.trust);
  if (!aggregate.clause.empty()) text += "\n    " + aggregate.clause;
  if (!aggregate.note.empty()) text += "\n    " + aggregate.note;
  return text + "\n";
}

std::string class_text(const rules::RuleClass& item) {
  return fmt::format(
      "class {}: {}, best first, each by {}; reports say which is reached beside the row asked "
      "for\n",
      item.id, joined(item.rows), joined(item.checks));
}

bool is_among(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Aggregates and classes in which one of the checks takes part; row: of classes, "" = any.
std::string shared_text(const RulePack& pack, const std::vector<std::string>& checks,
                        const std::string& row) {
  const auto shares = [&](const std::vector<std::string>& of) {
    return std::any_of(checks.begin(), checks.end(),
                       [&](const std::string& check) { return is_among(of, check); });
  };
  std::string text;
  for (const rules::RuleAggregate& aggregate : pack.aggregates) {
    if (shares(aggregate.checks)) text += aggregate_text(aggregate);
  }
  for (const rules::RuleClass& item : pack.classes) {
    if (shares(item.checks) && (row.empty() || is_among(item.rows, row))) text += class_text(item);
  }
  return text;
}

// Checks that the row requires something of.
std::vector<std::string> checks_of_row(const RulePack& pack, const RuleRow& row) {
  std::vector<std::string> ids;
  for (const RuleCheck& check : pack.checks) {
    const rules::Limit limit = evaluate_limit(check, {pack, &row, rules::RowLevel::required});
    if (limit.status != rules::LimitStatus::not_applicable) ids.push_back(check.id);
  }
  return ids;
}

// What a row says of a role.
enum class RowAndRole {
  has_values,  // its own, or all that there is holds for every row
  shares,      // none of its own, but something holds for every row
  nothing
};

// As workplaces see it: where a row has no value of its own they make no plane.
RowAndRole row_and_role(const RulePack& pack, const std::string& role,
                        const std::vector<std::string>& checks_of_row) {
  bool hangs_on_row = false, has_own = false, has_any = false;
  for (const RuleCheck& check : pack.checks) {
    if (check.role != role) continue;
    const bool is_required = is_among(checks_of_row, check.id);
    has_any = has_any || is_required;
    if (!needs_row(check, pack)) continue;
    hangs_on_row = true;
    has_own = has_own || is_required;
  }
  if (!has_any) return RowAndRole::nothing;
  return has_own || !hangs_on_row ? RowAndRole::has_values : RowAndRole::shares;
}

std::string explain_row(const RulePack& pack, const RuleRow& row) {
  std::string text = head_text(pack) + "\n" + row_text(pack, row);
  const std::vector<std::string> of_row = checks_of_row(pack, row);
  std::vector<std::string> silent, sharing;
  for (const std::string& role : pack.roles()) {
    const RowAndRole kind = row_and_role(pack, role, of_row);
    if (kind == RowAndRole::nothing) silent.push_back(role);
    if (kind == RowAndRole::shares) sharing.push_back(role);
    if (kind != RowAndRole::has_values) continue;
    text += fmt::format("\nrole {}\n", role);
    for (const rules::RulePlane& plane : pack.planes) {
      if (plane.role == role) text += plane_text(plane, &row);
    }
    std::vector<std::string> masks;
    for (const RuleCheck& check : pack.checks) {
      if (check.role != role) continue;
      text += check_text(pack, check) + limits_text(pack, check, &row);
      if (check.mask.id.empty() || is_among(masks, check.mask.id)) continue;
      masks.push_back(check.mask.id);
      text += "    " + mask_text(check.mask);
    }
  }
  if (!sharing.empty()) {
    text += fmt::format(
        "\nThe row has no value for the roles: {}\n    workplaces make no planes of them; a plane "
        "that names one is held against what all rows share\n",
        joined(sharing));
  }
  if (!silent.empty()) {
    text += fmt::format("\nThe row requires nothing of the roles: {}\n", joined(silent));
  }
  text += "\n" + shared_text(pack, of_row, row.ref);
  return text + grids_text(pack) + sources_text(pack, row.sources);
}

std::string explain_checks(const RulePack& pack, const std::vector<const RuleCheck*>& checks) {
  std::string text = head_text(pack) + "\n";
  for (const rules::RulePlane& plane : pack.planes) {
    if (plane.role == checks.front()->role) text += plane_text(plane, nullptr);
  }
  for (const RuleCheck* check : checks) {
    text += check_text(pack, *check) + limits_text(pack, *check, nullptr);
    if (!check->mask.id.empty()) text += "    " + mask_text(check->mask);
  }
  std::vector<std::string> ids;
  for (const RuleCheck* check : checks) ids.push_back(check->id);
  return text + "\n" + shared_text(pack, ids, "") + sources_text(pack, {});
}

constexpr calc::DiagnosticId kMessages[] = {
#define LUXGATE_DIAGNOSTIC(id, severity, text) calc::DiagnosticId::id,
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC
};

}  // namespace

std::string list_rule_packs(const std::vector<RulePack>& packs) {
  std::string text;
  for (const RulePack& pack : packs) {
    text += fmt::format("{:24} {:28} {:11} {:3} rows {:3} checks  {}\n", pack.full_id(), pack.title,
                        pack.status, pack.rows.size(), pack.checks.size(), pack.file);
  }
  return text;
}

std::string show_rule_pack(const RulePack& pack) {
  std::string text = head_text(pack) + sources_text(pack, {}) + "\n";
  for (const rules::RuleName& name : pack.parameters) {
    text += fmt::format("{} ({}): {}\n", name.id, name.unit.name, name.meaning);
  }
  for (const rules::RuleName& name : pack.facts) {
    text += fmt::format("fact {} ({}): {}\n", name.id, name.unit.name, name.meaning);
  }
  for (const rules::RulePlane& plane : pack.planes) text += plane_text(plane, nullptr);
  text += grids_text(pack);
  for (const rules::Mask& mask : pack.masks) text += mask_text(mask);
  text += "\n";
  for (const RuleRow& row : pack.rows) text += row_text(pack, row);
  text += pack.rows.empty() ? "" : "\n";
  for (const RuleCheck& check : pack.checks) text += check_text(pack, check);
  for (const rules::RuleAggregate& aggregate : pack.aggregates) text += aggregate_text(aggregate);
  for (const rules::RuleClass& item : pack.classes) text += class_text(item);
  return text;
}

std::optional<std::string> explain_rule(const RulePack& pack, const std::string& name) {
  if (const RuleRow* row = pack.find_row(name)) return explain_row(pack, *row);
  std::vector<const RuleCheck*> checks;
  for (const RuleCheck& check : pack.checks) {
    if (check.role == name || check.id == name) checks.push_back(&check);
  }
  if (checks.empty()) return std::nullopt;
  return explain_checks(pack, checks);
}

namespace {

// The meaning of messages whose text is nothing but what was found, and of messages that change the
// exit code otherwise than most. "" = the template and the usual effect say enough.
constexpr std::string_view meaning_of(calc::DiagnosticId id) {
  switch (id) {
    case calc::DiagnosticId::file_of_other_kind:
      return "A file is of another kind than the one that is needed, by its contents or by its "
             "name: photometry where a mesh is needed, for example. The message says what the "
             "file is and what to do with it. The file is not read, and the exit code is 2.";
    case calc::DiagnosticId::csv_quotes:
      return "A table (CSV) has a quoted cell without an end, or text after the end of a quoted "
             "cell. The message names the place where the cell begins. The exit code is 2.";
    case calc::DiagnosticId::csv_separator:
      return "The cells of a table (CSV) are separated by semicolons or tabs, as spreadsheets of "
             "some languages write them. Commas between cells and decimal points in numbers are "
             "needed. The table is not read, and the exit code is 2.";
    case calc::DiagnosticId::luminaire_list_line:
      return "A line of a table of luminaires cannot be used. A cell is not a number or out of "
             "range, or the project has no luminaire type of that name. Correct the line. The exit "
             "code is 2.";
    case calc::DiagnosticId::policy_not_met:
      return "The project does not meet a condition of the policy (--policy). The message names "
             "the condition. Change the project, or ask the owner of the policy. This warning "
             "always counts, with or without --strict: the exit code is 2.";
    case calc::DiagnosticId::messages_left_out:
      return "A file has very many messages with the same id, and only the first ones are shown. "
             "Errors that are not shown count, too. Correct those that are shown, and run luxgate "
             "again.";
    case calc::DiagnosticId::rule_import:
      return "'luxgate rules' cannot do what was asked, or it cannot use a line of a table to "
             "import. The exit code is 2.";
    case calc::DiagnosticId::rule_import_doubtful:
      return "A cell of a table to import was read, but its value is unlikely. Compare it with the "
             "standard. The exit code does not change.";
    case calc::DiagnosticId::output_not_possible:
      return "A file or folder of results cannot be written. Reasons are a missing permission, a "
             "full disk, a folder with that name, or an input of the same run. Where luxgate can "
             "know it in advance, it says so before it calculates. The exit code is 2.";
    case calc::DiagnosticId::rule_needs_scene:
      return "Emergency lighting is judged with emergency luminaires only, at the light that their "
             "batteries give. Give each luminaire of the room a group. Add a scene with the level "
             "of each group:\n\n"
             "  <scene id=\"emergency\"><dim group=\"battery\" level=\"0.6\"/><dim group=\"mains\" "
             "level=\"0\"/></scene>\n"
             "  <luminaire id=\"E1\" group=\"battery\" .../> <luminaire id=\"L1\" group=\"mains\" "
             ".../>\n"
             "  <require pack=\"en1838\" scene=\"emergency\"/>\n\n"
             "Level 1 is the full flux of the photometry. Use it where a file describes emergency "
             "operation. 'examples/13-escape-route' is a whole project. The exit code is 2.";
    case calc::DiagnosticId::will_not_be_judged:
      return "'luxgate validate' warns of requirements that 'luxgate check' will not judge. The "
             "message names the plane, the requirements and the reason. If they count, the exit "
             "code of 'check' will be 2. That of 'validate' changes only with --strict.";
    case calc::DiagnosticId::building_not_judged:
      return "'luxgate validate' warns of a requirement of a building that 'luxgate check' will "
             "not judge. The message gives the reason. If it counts, the exit code of 'check' will "
             "be 2. That of 'validate' changes only with --strict.";
    case calc::DiagnosticId::one_source:
      return "Requirements are judged by numbers of a standard that one public source has, and no "
             "second one confirms. Compare the named rows with your copy of the standard. Reports "
             "say the same in a note. There is a warning only where --strict=one-source or a "
             "policy "
             "names its id. It then counts: the exit code is 2. --strict without ids does not "
             "count it.";
    case calc::DiagnosticId::part_selected:
      return "--space, --plane, --tag or --require chose a part of what a project requires. The "
             "rest was neither calculated nor judged, and does not count as met. The exit code is "
             "that of the part. The warning itself changes it only with --strict.";
    case calc::DiagnosticId::nothing_selected:
      return "--space, --plane, --tag or --require chose nothing of this project. None of it was "
             "calculated or judged. If that is so for all projects, the exit code is 2.";
    case calc::DiagnosticId::internal_error:
      return "luxgate found a mistake of its own. The message is for its developers: report it, "
             "with the project if you can. The exit code is 2.";
    case calc::DiagnosticId::converge_not_possible:
      return "'luxgate converge' cannot measure this. It compares illuminances of one plane that "
             "are calculated in several ways. The exit code is 2.";
    default:
      return {};
  }
}

// Not a test, since the texts are here already.
#define LUXGATE_DIAGNOSTIC(id, severity, text)                                                 \
  static_assert(std::string_view(text) != "{}" || !meaning_of(calc::DiagnosticId::id).empty(), \
                "a message without words needs its meaning in words");
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC

constexpr std::string_view kEffectOfErrors =
    "luxgate judges nothing that depends on it, and the exit code is 2.";
constexpr std::string_view kEffectOfWarnings =
    "The results count all the same. The exit code changes only with --strict, or where a policy "
    "says so.";
constexpr std::string_view kEffectOfRemarks = "It changes no result and no exit code.";

// Warnings about a run, a rule pack or a table to import. --strict counts warnings of projects.
constexpr bool is_remark(calc::DiagnosticId id) {
  switch (id) {
    case calc::DiagnosticId::rule_import_skipped:
    case calc::DiagnosticId::rule_value_unusual:
    case calc::DiagnosticId::rule_row_empty:
    case calc::DiagnosticId::rule_pack_unverified:
    case calc::DiagnosticId::rule_without_trust:
    case calc::DiagnosticId::rule_of_result:
    case calc::DiagnosticId::rule_unused:
    case calc::DiagnosticId::store_entry_unusable:
    case calc::DiagnosticId::store_not_written:
    case calc::DiagnosticId::config_of_revision:
    case calc::DiagnosticId::output_written_meanwhile:
    case calc::DiagnosticId::backend_is_software:
    case calc::DiagnosticId::picture_device_failed:
    case calc::DiagnosticId::reference_is_rough:
      return true;
    default:
      return false;
  }
}

std::string_view usual_effect(calc::DiagnosticId id) {
  if (calc::diagnostic_severity(id) == calc::Severity::error) return kEffectOfErrors;
  return is_remark(id) ? kEffectOfRemarks : kEffectOfWarnings;
}

// Its paragraphs in lines of kTextColumns. Indented lines are examples and stay as they are.
std::string in_lines(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line(text.substr(0, end));
    lines +=
        line.rfind("  ", 0) == 0 ? line + "\n" : report::wrapped_lines("", line, 0, kTextColumns);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

const char* severity_name(calc::DiagnosticId id) {
  return calc::diagnostic_severity(id) == calc::Severity::error ? "error" : "warning";
}

}  // namespace

std::string near_names(const rules::RulePack& pack, std::string_view name) {
  constexpr std::size_t kMostNear = 8;
  std::vector<std::string> names;
  for (const rules::RuleRow& row : pack.rows) names.push_back(row.ref);
  for (std::string& role : pack.roles()) names.push_back(std::move(role));
  for (const rules::RuleCheck& check : pack.checks) names.push_back(check.id);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& known : names) {
    const std::optional<std::size_t> distance = calc::distance_if_near(name, known);
    if (distance) near.emplace_back(*distance, known);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> told;
  for (auto& [distance, known] : near) {
    if (told.size() < kMostNear) told.push_back(std::move(known));
  }
  return calc::list_names(told.empty() ? names : told, kMostNear);
}

std::vector<std::string> messages_with_word(std::string_view word) {
  std::vector<std::string> ids;
  if (word.empty()) return ids;
  const std::string start = "-" + calc::ascii_lowered(word);
  for (const calc::DiagnosticId id : kMessages) {
    std::string name = calc::diagnostic_name(id);
    if (("-" + name).find(start) != std::string::npos) ids.push_back(std::move(name));
  }
  return ids;
}

std::vector<std::string> near_messages(std::string_view name) {
  constexpr std::size_t kMostNear = 3;
  const std::string form = calc::ascii_lowered(name);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const calc::DiagnosticId id : kMessages) {
    std::string known = calc::diagnostic_name(id);
    const std::optional<std::size_t> distance = calc::distance_if_near(form, known);
    if (distance) near.emplace_back(*distance, std::move(known));
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> ids;
  for (auto& [distance, known] : near) {
    if (ids.size() < kMostNear) ids.push_back(std::move(known));
  }
  return ids;
}

std::optional<std::string> explain_message(const std::string& name) {
  for (const calc::DiagnosticId id : kMessages) {
    if (calc::diagnostic_name(id) != name) continue;
    const std::string head = fmt::format("{}: {}\n\n", name, severity_name(id));
    if (const std::string_view meaning = meaning_of(id); !meaning.empty()) {
      return head + in_lines(meaning);
    }
    const std::string message(calc::diagnostic_template(id));
    return head + report::wrapped_lines("    ", message, 4, kTextColumns) + "\n" +
           in_lines(fmt::format("{{}} stands for what was found. {}", usual_effect(id)));
  }
  return std::nullopt;
}

}  // namespace cli
