#include "rules/pack/pack_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

namespace rules {
namespace {

constexpr const char* kNotStated = "not stated";

std::string number_text(double number) { return fmt::format("{:.12g}", number); }

std::string with_unit(double number, std::string_view unit) {
  return unit.empty() || unit == "none" ? number_text(number)
                                        : fmt::format("{} {}", number_text(number), unit);
}

PackField words(std::string name, std::string_view text) {
  return {std::move(name), std::string(text), std::nullopt};
}

PackField number(std::string name, double value, std::string_view base_unit = "") {
  return {std::move(name), with_unit(value, base_unit), value};
}

// Returns a field with an amount. base: in base units.
PackField amount(std::string name, double base, const Unit& unit) {
  PackField field{std::move(name), with_unit(base / unit.factor, unit.name), base};
  field.meaning = with_unit(base, base_unit(unit.dimension));
  return field;
}

// Returns a field only if it has a meaning.
PackField number_if(bool is_there, std::string name, double value, std::string_view unit = "") {
  return is_there ? number(std::move(name), value, unit) : words(std::move(name), "");
}

std::string heights_text(double lowest_m, double highest_m) {
  return lowest_m == highest_m
             ? fmt::format("{} m", number_text(lowest_m))
             : fmt::format("{} to {} m", number_text(lowest_m), number_text(highest_m));
}

std::string list_text(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& item : list) text += (text.empty() ? "" : ", ") + item;
  return text;
}

std::string set_text(std::vector<std::string> list) {
  std::sort(list.begin(), list.end());
  return list_text(list);
}

std::string named(const RowNames& rows, const std::string& ref) {
  const auto found = rows.find(ref);
  return found == rows.end() ? ref : found->second;
}

std::string trust_text(Trust trust, bool is_stated) {
  return is_stated ? std::string(calc::name_of(trust)) : kNotStated;
}

// Returns equal texts for formulas that differ only in blanks, brackets and the form of numbers.
std::string meaning_of(const Expression& expression) {
  if (expression.kind == ExpressionKind::number) {
    return with_unit(expression.number, base_unit(expression.dimension));
  }
  std::string text = fmt::format("{}:{}{:+}(", static_cast<int>(expression.kind), expression.name,
                                 expression.steps);
  for (const Expression& operand : expression.operands) text += meaning_of(operand) + ";";
  return text + ")";
}

std::vector<PackField> of_head(const RulePack& pack) {
  return {words("id", pack.id),
          words("edition", pack.edition),
          words("title", pack.title),
          words("version", pack.version),
          words("kind", pack.kind),
          words("status", pack.status),
          words("jurisdiction", pack.jurisdiction),
          words("licence", pack.licence),
          words("licence-note", pack.licence_note),
          words("role", pack.role)};
}

std::vector<PackField> of_policy(const DecisionPolicy& policy) {
  return {words("compare", policy.compares_rounded ? "rounded" : "raw"),
          words("rounding", calc::name_of(policy.rounding)),
          number("digits-illuminance", policy.illuminance_digits),
          number("digits-ratio", policy.ratio_digits),
          number("digits-other", policy.other_digits),
          number("tolerance", policy.tolerance),
          words("tolerance-reason", policy.tolerance_reason),
          number("guard", policy.guard)};
}

std::vector<PackField> of_name(const RuleName& name) {
  return {words("unit", name.unit.name), words("meaning", name.meaning)};
}

std::vector<PackField> of_table(const RuleTable& table) {
  std::vector<PackField> fields{words("key-unit", table.key_unit.name),
                                words("value-unit", table.value_unit.name),
                                words("match", calc::name_of(table.match)),
                                words("trust", trust_text(table.trust, table.has_trust))};
  for (const RuleTable::Entry& entry : table.entries) {
    const std::string name = key_field(table, entry);
    fields.push_back(entry.value ? amount(name, *entry.value, table.value_unit)
                                 : words(name, "the key"));
  }
  return fields;
}

std::vector<PackField> of_scale(const RuleScale& scale) {
  std::vector<std::string> values, meanings;
  for (const double value : scale.values) {
    values.push_back(number_text(value / scale.unit.factor));
    meanings.push_back(number_text(value));
  }
  PackField list = words("values", list_text(values));
  list.meaning = list_text(meanings);
  return {words("unit", scale.unit.name), std::move(list),
          words("of", scale.parameter),   number("down", scale.most_down),
          number("up", scale.most_up),    words("trust", calc::name_of(scale.trust))};
}

// Returns the operations of a mask in any order: points must be in the result of every one.
std::vector<PackField> of_mask(const Mask& mask) {
  std::vector<std::string> operations;
  for (const MaskOperation& operation : mask.operations) {
    operations.push_back(mask_words({"", {operation}}).english());
  }
  return {words("points", set_text(std::move(operations)))};
}

std::vector<PackField> of_grid(const RuleGrid& grid) {
  RuleGrid as_confirmed = grid;
  as_confirmed.trust = Trust::confirmed;
  return {words("points", grid_text(as_confirmed)), words("trust", calc::name_of(grid.trust)),
          words("note", grid.note)};
}

std::string_view area_name(ZoneArea area) {
  switch (area) {
    case ZoneArea::none:
      break;
    case ZoneArea::task:
      return "task";
    case ZoneArea::band:
      return "band";
    case ZoneArea::task_and_band:
      return "task-and-band";
    case ZoneArea::walls:
      return "walls";
    case ZoneArea::ceiling:
      return "ceiling";
  }
  return {};
}

std::vector<PackField> of_plane(const RulePlane& plane) {
  const bool has_area = plane.area != ZoneArea::none;
  const bool has_width = !plane.around.empty() || plane.area == ZoneArea::task_and_band;
  return {words("orientation", plane.orientation),
          words("heights",
                plane.has_heights ? heights_text(plane.lowest_m, plane.highest_m) : std::string()),
          words("heights-are", !plane.has_heights        ? ""
                               : plane.are_heights_usual ? "usual"
                                                         : "required"),
          words("grid", plane.grid),
          words("mask", plane.mask),
          number("missing", plane.missing_share),
          words("note", plane.note),
          words("area", area_name(plane.area)),
          words("around", plane.around),
          words("holds", plane.holds),
          number_if(has_width, "width", plane.width_m, "m"),
          number_if(plane.height_m.has_value(), "height", plane.height_m.value_or(0.0), "m"),
          number_if(has_area, "margin", plane.margin_m, "m"),
          number_if(plane.narrow_m > 0.0, "narrow-below", plane.narrow_m, "m"),
          number_if(plane.narrow_m > 0.0, "narrow-share", plane.narrow_share)};
}

void add_value(std::vector<PackField>& fields, const RuleValue& value, const Unit& unit) {
  const std::string& name = value.parameter;
  fields.push_back(value.required ? amount(name, *value.required, unit)
                                  : words(name, calc::name_of(value.why)));
  if (value.modified) fields.push_back(amount(modified_field(name), *value.modified, unit));
  fields.push_back(words(trust_field(name), calc::name_of(value.trust)));
}

std::vector<PackField> of_row(const RuleRow& row, const RulePack& pack) {
  std::vector<PackField> fields{words("ref", row.ref),
                                words("name", row.name),
                                words("name-de", row.name_de),
                                words("trust", calc::name_of(row.trust)),
                                words("sources", set_text(row.sources)),
                                words("note", row.note),
                                words("task-orientation", row.task_orientation)};
  fields.push_back(words(
      "task-heights",
      row.task_heights_m ? heights_text(row.task_heights_m->lowest_m, row.task_heights_m->highest_m)
                         : std::string()));
  for (const RuleName& parameter : pack.parameters) {  // in their order, whatever that of the row
    const RuleValue* value = row.find_value(parameter.id);
    if (value != nullptr) add_value(fields, *value, parameter.unit);
  }
  return fields;
}

// Adds the limits for special places.
void add_specials(std::vector<PackField>& fields, const RuleCheck& check, const RowNames& rows) {
  const char* unit = base_unit(check.dimension());
  for (const RuleSpecial& special : check.specials) {
    const std::string name = fmt::format("special {}", calc::name_of(special.place));
    fields.push_back(number(name, special.limit, unit));
    std::vector<std::string> meanings;
    for (const std::string& row : special.rows) meanings.push_back(named(rows, row));
    PackField for_rows = words(name + " rows", set_text(special.rows));
    for_rows.meaning = set_text(std::move(meanings));
    fields.push_back(std::move(for_rows));
    fields.push_back(words(name + " trust", calc::name_of(special.trust)));
    fields.push_back(words(name + " note", special.note));
  }
}

std::vector<PackField> of_check(const RuleCheck& check, const RowNames& rows) {
  const bool has_range = check.metric == Metric::share || check.has_mounting_heights();
  const char* unit =
      base_unit(check.has_mounting_heights() ? Dimension::length : check.quantity->dimension);
  PackField limit =
      words("limit", fmt::format("{} {}", comparison_name(check.comparison), check.limit_text));
  limit.meaning = fmt::format("{} {}", comparison_name(check.comparison), meaning_of(check.limit));
  if (check.limit.kind == ExpressionKind::number) limit.value = check.limit.number;
  std::vector<PackField> fields{
      words("role", check.role),
      words("clause", check.clause),
      words("severity", calc::name_of(check.severity)),
      words("quantity", check.quantity->name),
      words("statistic", calc::name_of(check.metric)),
      number_if(check.metric == Metric::percentile, "percent", check.percent),
      number_if(has_range && check.range.from > 0.0, "from", check.range.from, unit),
      number_if(has_range && std::isfinite(check.range.to), "to", check.range.to, unit),
      words("mask", check.mask.id),
      words("state", calc::name_of(check.state)),
      words("sources", calc::name_of(check.sources)),
      words("light", check.direct_only ? "direct" : "all"),
      words("outage", check.any_one_unit_out ? "any-one-unit" : "none"),
      words("ways", check.is_level_only ? "level" : "all"),
      std::move(limit),
      words("instead-of", check.instead_of),
      words("trust", trust_text(check.trust, check.has_trust)),
      words("note", check.note)};
  add_specials(fields, check, rows);
  return fields;
}

std::vector<PackField> of_aggregate(const RuleAggregate& aggregate) {
  const bool is_share = aggregate.rule == AggregateRule::share;
  return {words("rule", calc::name_of(aggregate.rule)),
          number_if(aggregate.rule == AggregateRule::at_least, "count", aggregate.count),
          number_if(is_share, "share", aggregate.share),
          words("by", !is_share           ? ""
                      : aggregate.by_area ? "area"
                                          : "count"),
          words("of", set_text(aggregate.checks)),
          words("over", calc::name_of(aggregate.over)),
          words("severity", calc::name_of(aggregate.severity)),
          words("clause", aggregate.clause),
          words("trust", calc::name_of(aggregate.trust)),
          words("note", aggregate.note)};
}

std::vector<PackField> of_class(const RuleClass& item, const RowNames& rows) {
  std::vector<std::string> names, meanings;
  for (const std::string& row : item.rows) {
    names.push_back(row);
    meanings.push_back(named(rows, row));
  }
  PackField list = words("rows", list_text(names));  // the best first
  list.meaning = list_text(meanings);
  return {std::move(list), words("of", set_text(item.checks))};
}

}  // namespace

bool is_same(const PackField& a, const PackField& b) {
  const auto meaning = [](const PackField& field) -> const std::string& {
    return field.meaning.empty() ? field.text : field.meaning;
  };
  return meaning(a) == meaning(b);
}

std::string trust_field(const std::string& parameter) { return parameter + " trust"; }

std::string modified_field(const std::string& parameter) { return parameter + " modified"; }

std::string key_field(const RuleTable& table, const RuleTable::Entry& entry) {
  return "key " + with_unit(entry.key / table.key_unit.factor, table.key_unit.name);
}

std::vector<PartFields> fields_of(const RulePack& pack, const RowNames& rows) {
  std::vector<PartFields> parts;
  const auto add = [&](PackPart part, std::string id, std::vector<PackField> fields) {
    std::erase_if(fields, [](const PackField& field) { return field.text.empty(); });
    parts.push_back({part, std::move(id), std::move(fields)});
  };
  add(PackPart::pack, "", of_head(pack));
  add(PackPart::policy, "", of_policy(pack.policy));
  for (const RuleSource& source : pack.sources) {
    add(PackPart::source, source.id,
        {words("note", source.note), words("address", source.address)});
  }
  for (const RuleName& name : pack.parameters) add(PackPart::parameter, name.id, of_name(name));
  for (const RuleName& name : pack.facts) add(PackPart::fact, name.id, of_name(name));
  for (const RuleTable& table : pack.tables) add(PackPart::table, table.id, of_table(table));
  for (const RuleScale& scale : pack.scales) add(PackPart::scale, scale.id, of_scale(scale));
  for (const Mask& mask : pack.masks) add(PackPart::mask, mask.id, of_mask(mask));
  for (const RuleGrid& grid : pack.grids) add(PackPart::grid, grid.id, of_grid(grid));
  std::map<std::string, int> planes_of_role;
  for (const RulePlane& plane : pack.planes) {
    const int place = ++planes_of_role[plane.role];
    add(PackPart::plane, place == 1 ? plane.role : fmt::format("{}-{}", plane.role, place),
        of_plane(plane));
  }
  for (const RuleRow& row : pack.rows) add(PackPart::row, row.ref, of_row(row, pack));
  for (const RuleCheck& check : pack.checks) add(PackPart::check, check.id, of_check(check, rows));
  for (const RuleAggregate& aggregate : pack.aggregates) {
    add(PackPart::aggregate, aggregate.id, of_aggregate(aggregate));
  }
  for (const RuleClass& item : pack.classes) {
    add(PackPart::row_class, item.id, of_class(item, rows));
  }
  return parts;
}

}  // namespace rules
