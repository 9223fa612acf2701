// Reads one <check> of a rule pack.

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "rules/catalogue/limit_text.h"
#include "rules/pack/pack_elements.h"
#include "rules/pack/pack_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

constexpr std::array kComparisons{Comparison::at_least, Comparison::at_most, Comparison::more_than,
                                  Comparison::less_than};

// Reads exactly one of at-least, at-most, more-than and less-than: a formula.
void read_limit(ElementReader& reader, RuleCheck& check) {
  std::optional<Comparison> found;
  for (const Comparison comparison : kComparisons) {
    if (!reader.has(comparison_name(comparison))) continue;
    if (found && !reader.exclude(comparison_name(*found), comparison_name(comparison))) return;
    found = comparison;
  }
  if (!found) {
    reader.report(DiagnosticId::missing_form, reader.where(), "check",
                  "'at-least', 'at-most', 'more-than' or 'less-than'");
    return;
  }
  check.comparison = *found;
  const char* name = comparison_name(*found);
  check.limit_text = reader.text(name);
  check.limit_where = reader.where(name);
  if (check.limit_text.empty()) return;
  ParsedExpression parsed = parse_expression(check.limit_text);
  if (!parsed.expression) {
    reader.report(DiagnosticId::rule_formula, check.limit_where, name, "check", check.limit_text,
                  parsed.position + 1, parsed.error);
    return;
  }
  check.limit = std::move(*parsed.expression);
}

// Reads an end of the range: a number with the unit of the quantity, or a height.
double read_end(ElementReader& reader, const char* name, const RuleCheck& check) {
  const Dimension dimension =
      check.has_mounting_heights() ? Dimension::length : check.quantity->dimension;
  const std::string text = reader.text(name);
  const ParsedExpression parsed = parse_expression(text);
  const bool is_number = parsed.expression && parsed.expression->kind == ExpressionKind::number &&
                         parsed.expression->dimension == dimension;
  if (is_number) return parsed.expression->number;
  reader.report(DiagnosticId::rule_units, reader.where(name), name, "check", text,
                fmt::format("expected {}", dimension_name(dimension)));
  return 0.0;
}

void read_range(ElementReader& reader, RuleCheck& check) {
  if (!reader.has("from") && !reader.has("to") && !check.has_mounting_heights()) {
    reader.report(DiagnosticId::missing_form, reader.where(), "check", "'from' or 'to', or both");
  }
  if (reader.has("from")) check.range.from = read_end(reader, "from", check);
  if (reader.has("to")) check.range.to = read_end(reader, "to", check);
  const bool is_empty = check.range.to < check.range.from ||
                        (check.has_mounting_heights() && check.range.to == check.range.from);
  if (is_empty && reader.ok()) {
    reader.report(DiagnosticId::rule_not_ascending, reader.where("to"), "to", "check", "'from'");
  }
}

Severity severity_at(std::size_t choice) {
  if (choice == 0) return Severity::shall;
  return choice == 4 ? Severity::in_aggregate : Severity::advice;
}

RuleSpecial read_special(const calc::XmlElement& element, const RuleCheck& check,
                         calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kSpecialElement);
  RuleSpecial special;
  special.where = element.where;
  const std::string_view place =
      kSpecialPlaceType.words[reader.choice("place", kSpecialPlaceType.words)];
  special.place = *calc::find_value<calc::SpecialPlace>(place);
  if (reader.has("rows")) special.rows = read_ids(reader, "rows");
  if (!reader.has("trust")) reader.text("trust");  // reports its absence
  special.trust = read_trust(reader);
  special.note = reader.text_or("note", "");
  const std::string text = reader.text("limit");
  if (text.empty()) return special;
  const ParsedExpression parsed = parse_expression(text);
  const bool is_number = parsed.expression && parsed.expression->kind == ExpressionKind::number &&
                         parsed.expression->dimension == check.dimension();
  if (is_number) {
    special.limit = parsed.expression->number;
  } else {
    reader.report(DiagnosticId::rule_units, reader.where("limit"), "limit", "special", text,
                  fmt::format("expected {}", dimension_name(check.dimension())));
  }
  return special;
}

// Reads special limits, at most one for a place, because two would be ambiguous.
void read_specials(const calc::XmlElement& element, RuleCheck& check,
                   calc::Diagnostics& diagnostics) {
  for (const calc::XmlElement& child : element.children) {
    if (child.name != "special") continue;
    RuleSpecial special = read_special(child, check, diagnostics);
    const bool is_twice =
        std::any_of(check.specials.begin(), check.specials.end(),
                    [&](const RuleSpecial& other) { return other.place == special.place; });
    if (is_twice) {
      diagnostics.report(DiagnosticId::rule_name_twice, child.where, "special",
                         calc::name_of(special.place));
    }
    check.specials.push_back(std::move(special));
  }
}

// Reads the attribute "mask"; without it all points count.
Mask read_mask_name(ElementReader& reader, const RulePack& pack) {
  if (!reader.has("mask")) return {};
  const std::string id = reader.id("mask");
  calc::Names names;
  for (const Mask& mask : pack.masks) {
    if (mask.id == id) return mask;
    names.push_back(mask.id);
  }
  if (!id.empty()) {
    report_unknown_name(reader.diagnostics(), reader.where("mask"), "mask", "check", "mask", id,
                        names);
  }
  return {};
}

}  // namespace

RuleCheck read_check(const calc::XmlElement& element, const RulePack& pack,
                     calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kCheckElement);
  RuleCheck check;
  check.where = element.where;
  check.id = reader.id();
  check.role = reader.id("role");
  check.clause = reader.text_or("clause", "");
  check.severity = severity_at(reader.choice_or("severity", kCheckSeverityType.words, 0));
  check.quantity =
      quantity_from_name(quantity_names()[reader.choice("quantity", quantity_names())]);
  check.metric =
      *calc::find_value<Metric>(metric_names()[reader.choice("statistic", metric_names())]);
  if (check.metric == Metric::percentile) {
    check.percent = reader.number("percent", kPercent);
  } else if (reader.has("percent")) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where("percent"), "check",
                  "percent", fmt::format("statistic=\"{}\"", calc::name_of(check.metric)));
  }
  if (check.metric == Metric::share || check.has_mounting_heights()) {
    read_range(reader, check);
  } else {
    for (const char* end : {"from", "to"}) {
      if (!reader.has(end)) continue;
      reader.report(DiagnosticId::attribute_without_meaning, reader.where(end), "check", end,
                    fmt::format("statistic=\"{}\"", calc::name_of(check.metric)));
    }
  }
  check.mask = read_mask_name(reader, pack);
  check.state = reader.value_or("state", LightState::maintained);
  check.sources = reader.value_or("sources", LightSources::all);
  check.direct_only = reader.choice_or("light", kCountedLightType.words, 0) == 1;
  check.is_level_only = reader.choice_or("ways", kWaysType.words, 0) == 1;
  check.any_one_unit_out = reader.choice_or("outage", kOutageType.words, 0) == 1;
  check.trust = read_trust(reader);
  check.has_trust = reader.has("trust");
  check.note = reader.text_or("note", "");
  if (reader.has("instead-of")) check.instead_of = reader.id("instead-of");
  read_limit(reader, check);
  read_specials(element, check, diagnostics);
  return check;
}

}  // namespace rules
