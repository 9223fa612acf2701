#include "rules/pack/pack_parts.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "rules/pack/pack_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

int read_digits(ElementReader& reader, std::string_view name, int fallback) {
  return static_cast<int>(
      reader.choice_or(name, kDigitsType.words, static_cast<std::size_t>(fallback)));
}

int read_steps(ElementReader& reader, std::string_view name) {
  return static_cast<int>(reader.choice_or(name, kStepsType.words, 0));
}

// Reads the parameter that a project may move along the scale.
void read_use_of_scale(ElementReader& reader, RuleScale& scale) {
  for (const char* name : {"down", "up", "trust"}) {
    if (!reader.has(name) || reader.has("of")) continue;
    reader.report(DiagnosticId::missing_partner, reader.where(name), "scale", name, "of");
  }
  if (!reader.has("of")) return;
  scale.parameter = reader.id("of");
  scale.most_down = read_steps(reader, "down");
  scale.most_up = read_steps(reader, "up");
  scale.trust = read_trust(reader);
  if (scale.most_down > 0 || scale.most_up > 0) return;
  reader.report(DiagnosticId::missing_form, reader.where("of"), "scale",
                "'down' or 'up' of at least 1 beside 'of'");
}

RuleValue read_value(const calc::XmlElement& element, const RuleRow& row, const RulePack& pack,
                     calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kValueElement);
  RuleValue value;
  value.where = element.where;
  value.parameter = reader.id("of");
  value.trust = reader.has("trust") ? read_trust(reader) : row.trust;
  const RuleName* parameter = pack.find_parameter(value.parameter);
  if (parameter == nullptr && !value.parameter.empty()) {
    calc::Names names;
    for (const RuleName& candidate : pack.parameters) names.push_back(candidate.id);
    report_unknown_name(diagnostics, reader.where("of"), "of", "value", "parameter",
                        value.parameter, names);
  }
  const double factor = parameter == nullptr ? 1.0 : parameter->unit.factor;
  if (!reader.exclude("required", "none")) return value;
  if (reader.has("none")) {
    value.why = reader.value<NoValue>("none");
    if (reader.has("modified")) {
      reader.report(DiagnosticId::attribute_without_meaning, reader.where("modified"), "value",
                    "modified", "none");
    }
    return value;
  }
  value.required = factor * reader.number("required", calc::kNonNegative);
  if (reader.has("modified")) {
    value.modified = factor * reader.number("modified", calc::kNonNegative);
  }
  return value;
}

void read_key_or_number(const calc::XmlElement& element, RuleTable& table,
                        calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kEntryElement);
  RuleTable::Entry entry;
  entry.key = table.key_unit.factor * reader.number("key", calc::kNonNegative);
  const calc::XmlAttribute* value = element.find("value");
  if (value == nullptr || value->value != "key") {
    entry.value = table.value_unit.factor * reader.number("value", calc::kNonNegative);
  }
  if (!table.entries.empty() && !(entry.key > table.entries.back().key)) {
    reader.report(DiagnosticId::rule_not_ascending, reader.where("key"), "key", "entry",
                  "the entry before");
  }
  table.entries.push_back(entry);
}

}  // namespace

void report_unknown_name(calc::Diagnostics& diagnostics, const calc::SourceLocation& where,
                         std::string_view attribute, std::string_view element,
                         std::string_view kind, std::string_view found,
                         const calc::Names& choices) {
  constexpr std::size_t kMostShown = 20;  // a whole standard would not fit on a line
  const std::size_t shown = std::min(choices.size(), kMostShown);
  std::string allowed =
      shown == 0 ? fmt::format("no {} is defined", kind)
                 : "allowed: " +
                       calc::join_choices(calc::Names(
                           choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(shown)));
  if (shown < choices.size()) allowed += " " + calc::and_more(choices.size() - shown);
  diagnostics.report(DiagnosticId::unknown_reference, where, attribute, element, kind, found,
                     allowed, calc::suggestion(found, choices));
}

Unit read_unit(ElementReader& reader, std::string_view attribute) {
  return *unit_from_name(unit_names()[reader.choice(attribute, unit_names())]);
}

Trust read_trust(ElementReader& reader) { return reader.value_or("trust", Trust::confirmed); }

std::vector<std::string> read_ids(ElementReader& reader, std::string_view attribute) {
  std::vector<std::string> ids;
  const std::string text = reader.text(attribute);
  for (const std::string_view word : calc::split_words(text)) {
    if (calc::is_id(word)) {
      ids.emplace_back(word);
    } else {
      reader.report(DiagnosticId::not_an_id, reader.where(attribute), attribute,
                    reader.element().name, word);
    }
  }
  return ids;
}

RuleSource read_source(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kSourceElement);
  return {reader.id(), reader.text("note"), reader.text_or("address", "")};
}

RuleName read_name(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kNameElement);
  return {reader.id(), read_unit(reader, "unit"), reader.text("meaning"), element.where};
}

std::optional<std::pair<double, double>> read_heights(ElementReader& reader,
                                                      std::string_view name) {
  if (!reader.has(name)) return std::nullopt;
  const std::vector<double> heights =
      reader.numbers(name, 2, "2 numbers (lowest highest) in metres", calc::kNonNegative);
  if (heights[1] < heights[0]) {
    reader.report(DiagnosticId::rule_not_ascending, reader.where(name), name, reader.element().name,
                  "the lowest height, or equal to it");
  }
  return std::pair(heights[0], heights[1]);
}

DecisionPolicy read_policy(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kPolicyElement);
  DecisionPolicy policy;
  policy.compares_rounded = reader.choice_or("compare", kComparedAsType.words, 0) == 1;
  policy.rounding = reader.value_or("rounding", Rounding::half_up);
  policy.illuminance_digits = read_digits(reader, "digits-illuminance", policy.illuminance_digits);
  policy.ratio_digits = read_digits(reader, "digits-ratio", policy.ratio_digits);
  policy.other_digits = read_digits(reader, "digits-other", policy.other_digits);
  policy.tolerance = reader.number_or("tolerance", kSmallShare, 0.0);
  policy.tolerance_reason = reader.text_or("tolerance-reason", "");
  policy.guard = reader.number_or("guard", kSmallShare, 0.0);
  reader.require_together("tolerance", "tolerance-reason");
  return policy;
}

RuleRow read_row(const calc::XmlElement& element, const RulePack& pack,
                 calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kRowElement);
  RuleRow row;
  row.where = element.where;
  row.ref = reader.id("ref");
  row.name = reader.text("name");
  if (reader.has("name-de")) row.name_de = reader.text("name-de");
  if (!reader.has("trust")) reader.text("trust");  // required: reports its absence
  row.trust = read_trust(reader);
  row.note = reader.text_or("note", "");
  if (const auto heights = read_heights(reader, "task-heights")) {
    row.task_heights_m = {heights->first, heights->second};
  }
  if (reader.has("task-orientation")) {
    row.task_orientation =
        kOrientationType.words[reader.choice("task-orientation", kOrientationType.words)];
  }
  if (reader.has("sources")) row.sources = read_ids(reader, "sources");
  for (const std::string& id : row.sources) {
    calc::Names names;
    for (const RuleSource& source : pack.sources) names.push_back(source.id);
    if (std::find(names.begin(), names.end(), id) != names.end()) continue;
    report_unknown_name(diagnostics, reader.where("sources"), "sources", "row", "source", id,
                        names);
  }
  for (const calc::XmlElement& child : element.children) {
    if (child.name != "value") continue;
    RuleValue value = read_value(child, row, pack, diagnostics);
    if (!value.parameter.empty() && row.find_value(value.parameter) != nullptr) {
      reader.report(DiagnosticId::rule_value_twice, child.where, row.ref, value.parameter);
    }
    row.values.push_back(std::move(value));
  }
  return row;
}

RuleTable read_table(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kTableElement);
  RuleTable table;
  table.where = element.where;
  table.id = reader.id();
  table.key_unit = read_unit(reader, "key-unit");
  table.value_unit = read_unit(reader, "value-unit");
  table.match = reader.value<TableMatch>("match");
  table.trust = read_trust(reader);
  table.has_trust = reader.has("trust");
  for (const calc::XmlElement& child : element.children) {
    if (child.name == "entry") read_key_or_number(child, table, diagnostics);
  }
  if (table.entries.empty()) {
    reader.report(DiagnosticId::missing_form, element.where, "table", "at least one <entry>");
  }
  return table;
}

RuleScale read_scale(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kScaleElement);
  RuleScale scale;
  scale.where = element.where;
  scale.id = reader.id();
  scale.unit = read_unit(reader, "unit");
  scale.values =
      reader.number_groups("values", 1, 2, 1000, "at least 2 numbers", calc::kNonNegative);
  if (!std::is_sorted(scale.values.begin(), scale.values.end(), std::less_equal<>())) {
    reader.report(DiagnosticId::rule_not_ascending, reader.where("values"), "values", "scale",
                  "the number before");
  }
  for (double& value : scale.values) value *= scale.unit.factor;
  read_use_of_scale(reader, scale);
  return scale;
}

Mask read_mask(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kMaskElement);
  Mask mask;
  mask.id = reader.id();
  for (const calc::XmlElement& child : element.children) {
    ElementReader step(child, diagnostics);
    MaskOperation operation;
    const auto allow = [&](const calc::ElementRow& row) {
      step.allow_children(row);
      step.allow_attributes(row);
    };
    if (child.name == "centre-line") {
      allow(kCentreLineElement);
      operation.step = MaskStep::centre_line;
      operation.up_to_width_m = step.number_or("up-to-width", calc::kPositive, 0.0);
    } else if (child.name == "walls" || child.name == "border") {
      allow(kMaskWallsElement);
      operation.step = child.name == "walls" ? MaskStep::walls : MaskStep::border;
      operation.metres = step.number("metres", calc::kNonNegative);
    } else {
      allow(kStripElement);
      operation.step = child.name == "across" ? MaskStep::across : MaskStep::inset;
      operation.metres = step.number("metres", calc::kNonNegative);
      step.require_together("share", "up-to-width");
      operation.share = step.number_or("share", kStripShare, 0.0);
      operation.up_to_width_m = step.number_or("up-to-width", calc::kPositive, 0.0);
    }
    mask.operations.push_back(operation);
  }
  if (mask.operations.empty()) {
    reader.report(DiagnosticId::missing_form, element.where, "mask",
                  "<inset>, <walls>, <border>, <across> or <centre-line>");
  }
  return mask;
}

RuleAggregate read_aggregate(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kAggregateElement);
  RuleAggregate aggregate;
  aggregate.where = element.where;
  aggregate.id = reader.id();
  aggregate.rule =
      calc::EnumNames<AggregateRule>::list[reader.choice("rule", kAggregateRuleType.words)].value;
  const auto read_for = [&](std::string_view attribute, AggregateRule owner, const auto& read) {
    if (aggregate.rule == owner) {
      read();
    } else if (reader.has(attribute)) {
      reader.report(DiagnosticId::attribute_without_meaning, reader.where(attribute), "aggregate",
                    attribute, "rule");
    }
  };
  read_for("count", AggregateRule::at_least, [&] { aggregate.count = reader.integer("count", 1); });
  read_for("share", AggregateRule::share,
           [&] { aggregate.share = reader.number("share", calc::kPositiveFraction); });
  aggregate.over = reader.value_or("over", AggregateOver::checks);
  aggregate.by_area = reader.choice_or("by", kAggregateByType.words, 0) == 1;
  const bool has_areas =
      aggregate.rule == AggregateRule::share && aggregate.over != AggregateOver::checks;
  if (reader.has("by") && !has_areas) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("by"), "aggregate", "by",
                  "rule=\"share\" over planes or rooms");
  }
  aggregate.severity = reader.choice_or("severity", kAggregateSeverityType.words, 0) == 0
                           ? Severity::shall
                           : Severity::advice;
  aggregate.clause = reader.text_or("clause", "");
  aggregate.trust = read_trust(reader);
  aggregate.note = reader.text_or("note", "");
  aggregate.checks = read_ids(reader, "of");
  return aggregate;
}

RuleClass read_class(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kClassElement);
  RuleClass result;
  result.where = element.where;
  result.id = reader.id();
  result.rows = read_ids(reader, "rows");
  result.checks = read_ids(reader, "of");
  return result;
}

}  // namespace rules
