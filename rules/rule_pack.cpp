#include "rules/rule_pack.h"

#include "calc/xml_document.h"
#include "calc/xml_reader.h"
#include "rules/builtin_packs.h"
#include "rules/limit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

calc::Names row_metrics() { return {"average", "minimum", "maximum", "Uo", "Ud"}; }

std::optional<RowLimit> read_row_limit(const calc::XmlElement& element, const std::string& row_ref,
                                       calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow_attributes({"quantity", "at-least", "at-most", "modified", "clause"});
  reader.allow_children({});
  RowLimit limit;
  limit.clause = reader.has("clause") ? reader.text("clause") : row_ref;
  const std::optional<Metric> metric = read_metric(reader, row_metrics());
  const std::optional<Comparison> comparison = read_comparison(reader);
  if (!metric || !comparison) return std::nullopt;
  limit.metric = *metric;
  limit.comparison = *comparison;
  limit.required = read_limit(reader, comparison_name(*comparison), *metric, LimitUnit::lux);
  if (reader.has("modified")) {
    limit.modified = read_limit(reader, "modified", *metric, LimitUnit::lux);
  }
  return limit;
}

void add_row_limit(const calc::XmlElement& element, RuleRow& row, calc::Diagnostics& diagnostics) {
  std::optional<RowLimit> limit = read_row_limit(element, row.ref, diagnostics);
  if (!limit) return;
  const bool is_repeated =
      std::any_of(row.limits.begin(), row.limits.end(), [&](const RowLimit& other) {
        return other.metric == limit->metric && other.comparison == limit->comparison;
      });
  if (is_repeated) {
    diagnostics.report(DiagnosticId::repeated_row_limit, element.where, row.ref,
                       comparison_name(limit->comparison), metric_name(limit->metric));
  }
  row.limits.push_back(std::move(*limit));
}

void add_row(const calc::XmlElement& element, RulePack& pack, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow_attributes({"ref", "name", "trust"});
  reader.allow_children({"limit"});
  RuleRow row;
  row.where = element.where;
  row.ref = reader.id("ref");
  row.name = reader.text("name");
  row.trust = reader.text("trust");
  if (const RuleRow* first = pack.find_row(row.ref); first != nullptr && !row.ref.empty()) {
    reader.report(DiagnosticId::duplicate_id, reader.where("ref"), "row", row.ref,
                  first->where.line);
  }
  if (element.children.empty()) {
    reader.report(DiagnosticId::missing_form, element.where, "row", "at least one <limit>");
  }
  for (const calc::XmlElement& child : element.children) {
    if (child.name == "limit") add_row_limit(child, row, diagnostics);
  }
  pack.rows.push_back(std::move(row));
}

void add_source(const calc::XmlElement& element, RulePack& pack, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow_attributes({"id", "note"});
  reader.allow_children({});
  pack.sources.push_back({reader.id(), reader.text("note")});
}

RulePack read_pack(const calc::XmlElement& root, const std::string& file,
                   calc::Diagnostics& diagnostics) {
  ElementReader reader(root, diagnostics);
  reader.allow_attributes({"id", "edition", "title", "version"});
  reader.allow_children({"source", "row"});
  RulePack pack;
  pack.file = file;
  pack.id = reader.id();
  pack.edition = reader.id("edition");
  pack.title = reader.text("title");
  pack.version = reader.id("version");
  for (const calc::XmlElement& child : root.children) {
    if (child.name == "source") add_source(child, pack, diagnostics);
    if (child.name == "row") add_row(child, pack, diagnostics);
  }
  if (pack.rows.empty()) {
    reader.report(DiagnosticId::missing_form, root.where, "rule-pack", "at least one <row>");
  }
  return pack;
}

}  // namespace

bool RuleRow::has_modified_level() const {
  return std::any_of(limits.begin(), limits.end(),
                     [](const RowLimit& limit) { return limit.modified.has_value(); });
}

const RuleRow* RulePack::find_row(std::string_view ref) const {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const RuleRow& row) { return row.ref == ref; });
  return found == rows.end() ? nullptr : &*found;
}

std::string RulePack::clause_text(const RowLimit& limit, RowLevel level) const {
  const bool is_modified = level == RowLevel::modified && limit.modified.has_value();
  return fmt::format("{}:{} {}{}", title, edition, limit.clause, is_modified ? " (modified)" : "");
}

std::optional<RulePack> parse_rule_pack(std::string_view xml, const std::string& file,
                                        calc::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const std::optional<calc::XmlElement> root = calc::parse_xml(std::string(xml), file, diagnostics);
  if (!root) return std::nullopt;
  if (root->name != "rule-pack") {
    diagnostics.report(DiagnosticId::wrong_root_element, root->where, root->name, "rule-pack");
    return std::nullopt;
  }
  RulePack pack = read_pack(*root, file, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return pack;
}

std::vector<RulePack> builtin_rule_packs() {
  std::vector<RulePack> packs;
  for (const std::string_view text : builtin_pack_texts()) {
    calc::Diagnostics diagnostics;
    std::optional<RulePack> pack = parse_rule_pack(text, "built in", diagnostics);
    // Our own file: a test reads every one of them.
    if (!pack) throw std::logic_error(calc::format_diagnostic(diagnostics.all().front()));
    packs.push_back(std::move(*pack));
  }
  return packs;
}

}  // namespace rules
