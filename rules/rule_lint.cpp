#include "rules/rule_lint.h"

#include <set>
#include <string>
#include <utility>

namespace rules {
namespace {

using Used = std::set<std::pair<ExpressionKind, std::string>>;

void collect(const Expression& expression, Used& used) {
  if (!expression.name.empty()) used.emplace(expression.kind, expression.name);
  for (const Expression& operand : expression.operands) collect(operand, used);
}

template <class Item>
void report_unused(const RulePack& pack, const std::vector<Item>& items, ExpressionKind kind,
                   const char* word, const Used& used, calc::Diagnostics& diagnostics) {
  for (const Item& item : items) {
    if (used.contains({kind, item.id})) continue;
    diagnostics.report(calc::DiagnosticId::rule_unused, item.where, pack.full_id(), word, item.id);
  }
}

}  // namespace

void lint_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics) {
  Used used;
  for (const RuleCheck& check : pack.checks) collect(check.limit, used);
  report_unused(pack, pack.parameters, ExpressionKind::row_value, "parameter", used, diagnostics);
  report_unused(pack, pack.facts, ExpressionKind::fact, "fact", used, diagnostics);
  report_unused(pack, pack.tables, ExpressionKind::table, "table", used, diagnostics);
  std::size_t unverified = 0, all = pack.checks.size();
  for (const RuleCheck& check : pack.checks) {
    if (check.trust == Trust::unverified) ++unverified;
  }
  for (const RuleRow& row : pack.rows) {
    for (const RuleValue& value : row.values) {
      ++all;
      if (value.trust == Trust::unverified) ++unverified;
    }
  }
  if (unverified > 0) {
    diagnostics.report(calc::DiagnosticId::rule_pack_unverified, {pack.file, 0, 0}, pack.full_id(),
                       unverified, all);
  }
}

}  // namespace rules
