#include "rules/pack/rule_lint.h"

#include "calc/base/diagnostic_ids.h"
#include "rules/pack/row_values.h"

#include <algorithm>
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

bool has_number(const Expression& expression) {
  return expression.kind == ExpressionKind::number ||
         std::any_of(expression.operands.begin(), expression.operands.end(), has_number);
}

bool has_result(const Expression& expression) {
  return expression.kind == ExpressionKind::result_of ||
         std::any_of(expression.operands.begin(), expression.operands.end(), has_result);
}

void lint_results(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RuleCheck& check : pack.checks) {
    if (!has_result(check.limit)) continue;
    diagnostics.report(calc::DiagnosticId::rule_of_result, check.where, pack.full_id(), check.id);
  }
}

void report_no_trust(const RulePack& pack, const calc::SourceLocation& where, const char* word,
                     const std::string& id, calc::Diagnostics& diagnostics) {
  diagnostics.report(calc::DiagnosticId::rule_without_trust, where, pack.full_id(), word, id);
}

// Warns of numbers without trust; only contracts and company rules are their own source.
void lint_trust(const RulePack& pack, calc::Diagnostics& diagnostics) {
  if (pack.kind == "contract" || pack.kind == "company") return;
  for (const RuleTable& table : pack.tables) {
    if (!table.has_trust) report_no_trust(pack, table.where, "table", table.id, diagnostics);
  }
  for (const RuleCheck& check : pack.checks) {
    if (check.has_trust || !has_number(check.limit)) continue;
    report_no_trust(pack, check.where, "check", check.id, diagnostics);
  }
}

void lint_rows(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RowValueProblem& problem : row_value_problems(pack)) {
    const std::string what =
        problem.value->parameter + (problem.is_of_modified ? " (modified)" : "");
    diagnostics.report(problem.is_error ? calc::DiagnosticId::rule_value_meaningless
                                        : calc::DiagnosticId::rule_value_unusual,
                       problem.value->where, problem.row->ref, what, problem.words);
  }
  for (const RuleRow* row : rows_without_requirement(pack)) {
    diagnostics.report(calc::DiagnosticId::rule_row_empty, row->where, row->ref, pack.role);
  }
}

}  // namespace

void lint_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics) {
  Used used;
  for (const RuleCheck& check : pack.checks) collect(check.limit, used);
  report_unused(pack, pack.parameters, ExpressionKind::row_value, "parameter", used, diagnostics);
  report_unused(pack, pack.facts, ExpressionKind::fact, "fact", used, diagnostics);
  report_unused(pack, pack.tables, ExpressionKind::table, "table", used, diagnostics);
  lint_results(pack, diagnostics);
  lint_trust(pack, diagnostics);
  lint_rows(pack, diagnostics);
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
