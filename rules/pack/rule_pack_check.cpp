#include "rules/pack/rule_pack_check.h"

#include "calc/base/diagnostic_ids.h"
#include "rules/pack/pack_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace rules {
namespace {

using calc::DiagnosticId;

template <class Item>
calc::Names ids_of(const std::vector<Item>& items) {
  calc::Names names;
  for (const Item& item : items) names.push_back(item.id);
  return names;
}

// Checks one formula: its names are defined, and its units fit.
class FormulaCheck {
 public:
  FormulaCheck(const RulePack& pack, const RuleCheck& check, calc::Diagnostics& diagnostics)
      : pack_(pack), check_(check), diagnostics_(diagnostics) {}

  void run() {
    const std::optional<Dimension> found = dimension_of(check_.limit);
    if (!found || *found == check_.dimension()) return;
    report_units(fmt::format("the check limits {}, but the formula gives {}",
                             dimension_name(check_.dimension()), dimension_name(*found)));
  }

 private:
  // Returns the dimension; empty after an error.
  std::optional<Dimension> dimension_of(const Expression& expression) {
    std::vector<Dimension> operands;
    for (const Expression& operand : expression.operands) {
      const std::optional<Dimension> dimension = dimension_of(operand);
      if (!dimension) return std::nullopt;
      operands.push_back(*dimension);
    }
    switch (expression.kind) {
      case ExpressionKind::number:
        return expression.dimension;
      case ExpressionKind::row_value:
        return of_name(pack_.find_parameter(expression.name), expression, "parameter",
                       ids_of(pack_.parameters));
      case ExpressionKind::fact:
        return of_name(pack_.find_fact(expression.name), expression, "fact", ids_of(pack_.facts));
      case ExpressionKind::limit_of:
      case ExpressionKind::result_of:
        return of_check(expression);
      case ExpressionKind::table:
        return of_table(expression, operands.front());
      case ExpressionKind::step:
        return of_step(expression, operands.front());
      case ExpressionKind::multiply:
        return of_product(operands);
      case ExpressionKind::divide:
        return of_quotient(operands);
      case ExpressionKind::add:
      case ExpressionKind::minimum:
      case ExpressionKind::maximum:
        break;
    }
    return same(operands);
  }

  std::optional<Dimension> of_name(const RuleName* name, const Expression& expression,
                                   std::string_view kind, const calc::Names& names) {
    if (name != nullptr) return name->unit.dimension;
    report_name(kind, expression.name, names);
    return std::nullopt;
  }

  std::optional<Dimension> of_check(const Expression& expression) {
    if (const RuleCheck* other = pack_.find_check(expression.name)) return other->dimension();
    report_name("check", expression.name, ids_of(pack_.checks));
    return std::nullopt;
  }

  std::optional<Dimension> of_table(const Expression& expression, Dimension key) {
    const RuleTable* table = pack_.find_table(expression.name);
    if (table == nullptr) {
      report_name("table", expression.name, ids_of(pack_.tables));
      return std::nullopt;
    }
    if (table->key_unit.dimension != key) {
      report_units(fmt::format("the key of table '{}' is {}, not {}", table->id,
                               dimension_name(table->key_unit.dimension), dimension_name(key)));
      return std::nullopt;
    }
    return table->value_unit.dimension;
  }

  std::optional<Dimension> of_step(const Expression& expression, Dimension start) {
    const RuleScale* scale = pack_.find_scale(expression.name);
    if (scale == nullptr) {
      report_name("scale", expression.name, ids_of(pack_.scales));
      return std::nullopt;
    }
    if (scale->unit.dimension != start) {
      report_units(fmt::format("a value of scale '{}' is {}, not {}", scale->id,
                               dimension_name(scale->unit.dimension), dimension_name(start)));
      return std::nullopt;
    }
    return start;
  }

  std::optional<Dimension> of_product(const std::vector<Dimension>& operands) {
    if (operands[0] == Dimension::plain) return operands[1];
    if (operands[1] == Dimension::plain) return operands[0];
    report_units(fmt::format("{} times {} has no unit that luxgate knows",
                             dimension_name(operands[0]), dimension_name(operands[1])));
    return std::nullopt;
  }

  std::optional<Dimension> of_quotient(const std::vector<Dimension>& operands) {
    if (operands[1] == Dimension::plain) return operands[0];
    if (operands[0] == operands[1]) return Dimension::plain;
    report_units(fmt::format("{} divided by {} has no unit that luxgate knows",
                             dimension_name(operands[0]), dimension_name(operands[1])));
    return std::nullopt;
  }

  std::optional<Dimension> same(const std::vector<Dimension>& operands) {
    for (const Dimension operand : operands) {
      if (operand == operands.front()) continue;
      report_units(fmt::format("{} and {} cannot be added or compared",
                               dimension_name(operands.front()), dimension_name(operand)));
      return std::nullopt;
    }
    return operands.front();
  }

  void report_name(std::string_view kind, const std::string& name, const calc::Names& names) {
    report_unknown_name(diagnostics_, check_.limit_where, comparison_name(check_.comparison),
                        "check", kind, name, names);
  }
  void report_units(const std::string& problem) {
    diagnostics_.report(DiagnosticId::rule_units, check_.limit_where,
                        comparison_name(check_.comparison), "check", check_.limit_text, problem);
  }

  const RulePack& pack_;
  const RuleCheck& check_;
  calc::Diagnostics& diagnostics_;
};

// Follows checks that depend on each other: finds cycles, and formulas that would be too long when
// written out. Each check is reported at most once.
class DependencyCheck {
 public:
  DependencyCheck(const RulePack& pack, calc::Diagnostics& diagnostics)
      : pack_(pack), diagnostics_(diagnostics) {}

  void run() {
    for (const RuleCheck& check : pack_.checks) {
      path_.clear();
      terms_of(check);
    }
  }

 private:
  static constexpr std::size_t kMostTerms = 1000;
  static constexpr std::size_t kLongestPath = 50;

  // Returns the terms of the formula with every limit and result written out, at most kMostTerms +
  // 1.
  std::size_t terms_of(const RuleCheck& check) {
    if (const auto known = terms_.find(&check); known != terms_.end()) return known->second;
    const auto first = std::find(path_.begin(), path_.end(), &check);
    if (first != path_.end()) {
      std::string circle;
      for (auto it = first; it != path_.end(); ++it) circle += (*it)->id + " -> ";
      diagnostics_.report(DiagnosticId::rule_circle, check.limit_where, check.id,
                          circle + check.id);
      return 1;
    }
    path_.push_back(&check);
    const std::size_t terms = path_.size() > kLongestPath ? kMostTerms + 1 : terms_of(check.limit);
    path_.pop_back();
    if (terms > kMostTerms) {
      diagnostics_.report(DiagnosticId::rule_too_long, check.limit_where, check.id, kMostTerms,
                          kLongestPath);
      return terms_[&check] = 1;
    }
    return terms_[&check] = terms;
  }

  std::size_t terms_of(const Expression& expression) {
    std::size_t terms = 1;
    if (expression.kind == ExpressionKind::limit_of ||
        expression.kind == ExpressionKind::result_of) {
      if (const RuleCheck* other = pack_.find_check(expression.name)) terms += terms_of(*other);
    }
    for (const Expression& operand : expression.operands) {
      terms = std::min(terms + terms_of(operand), kMostTerms + 1);
    }
    return std::min(terms, kMostTerms + 1);
  }

  const RulePack& pack_;
  calc::Diagnostics& diagnostics_;
  std::vector<const RuleCheck*> path_;
  std::map<const RuleCheck*, std::size_t> terms_;
};

void check_ids(const std::vector<std::string>& ids, const calc::Names& known,
               std::string_view attribute, std::string_view element, std::string_view kind,
               const calc::SourceLocation& where, calc::Diagnostics& diagnostics) {
  for (const std::string& id : ids) {
    if (std::find(known.begin(), known.end(), id) != known.end()) continue;
    report_unknown_name(diagnostics, where, attribute, element, kind, id, known);
  }
}

void check_members(const RuleAggregate& aggregate, calc::Diagnostics& diagnostics) {
  const auto report = [&](std::string_view needed) {
    diagnostics.report(DiagnosticId::missing_form, aggregate.where, "aggregate", needed);
  };
  const std::set<std::string> different(aggregate.checks.begin(), aggregate.checks.end());
  if (different.size() < aggregate.checks.size()) report("each check in 'of' only once");
  const bool is_too_many = aggregate.rule == AggregateRule::at_least &&
                           aggregate.over == AggregateOver::checks &&
                           static_cast<std::size_t>(aggregate.count) > different.size();
  if (is_too_many) report("at least as many checks in 'of' as its 'count'");
}

// Checks that a check that only counts in aggregates is in one that counts.
void check_parts(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RuleCheck& check : pack.checks) {
    if (check.severity != Severity::in_aggregate) continue;
    const bool counts = std::any_of(
        pack.aggregates.begin(), pack.aggregates.end(), [&](const RuleAggregate& aggregate) {
          return aggregate.severity == Severity::shall &&
                 std::find(aggregate.checks.begin(), aggregate.checks.end(), check.id) !=
                     aggregate.checks.end();
        });
    if (counts) continue;
    diagnostics.report(DiagnosticId::missing_form, check.where, "check",
                       "an <aggregate> of severity=\"shall\" that names it in 'of', because the "
                       "check has severity=\"in-aggregate\"");
  }
}

// Checks alternatives: they are about different parts of the room, and compared alike.
void check_alternatives(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RuleCheck& check : pack.checks) {
    if (check.instead_of.empty()) continue;
    check_ids({check.instead_of}, ids_of(pack.checks), "instead-of", "check", "check", check.where,
              diagnostics);
    const RuleCheck* other = pack.find_check(check.instead_of);
    const bool is_fit =
        other == nullptr || (other->role != check.role && other->instead_of.empty() &&
                             other->severity == check.severity);
    if (is_fit) continue;
    diagnostics.report(
        DiagnosticId::missing_form, check.where, "check",
        "in 'instead-of' a check of another role, with the same severity and without "
        "its own 'instead-of'");
  }
}

// Checks that a parameter has at most one scale, of its own unit.
void check_scales(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RuleScale& scale : pack.scales) {
    if (scale.parameter.empty()) continue;
    check_ids({scale.parameter}, ids_of(pack.parameters), "of", "scale", "parameter", scale.where,
              diagnostics);
    const RuleName* parameter = pack.find_parameter(scale.parameter);
    if (parameter == nullptr) continue;
    const auto refuse = [&](const std::string& needed) {
      diagnostics.report(DiagnosticId::missing_form, scale.where, "scale", needed);
    };
    if (parameter->unit.dimension != scale.unit.dimension) {
      refuse(fmt::format("a parameter of {} in 'of'", dimension_name(scale.unit.dimension)));
    }
    if (pack.find_scale_of(scale.parameter) != &scale) {
      refuse("another parameter in 'of'; this parameter has a scale already");
    }
  }
}

}  // namespace

void check_rule_pack(const RulePack& pack, calc::Diagnostics& diagnostics) {
  for (const RuleCheck& check : pack.checks) FormulaCheck(pack, check, diagnostics).run();
  DependencyCheck(pack, diagnostics).run();
  check_scales(pack, diagnostics);
  const calc::Names checks = ids_of(pack.checks);
  for (const RuleAggregate& aggregate : pack.aggregates) {
    check_ids(aggregate.checks, checks, "of", "aggregate", "check", aggregate.where, diagnostics);
  }
  for (const RuleAggregate& aggregate : pack.aggregates) check_members(aggregate, diagnostics);
  check_parts(pack, diagnostics);
  check_alternatives(pack, diagnostics);
  calc::Names rows;
  for (const RuleRow& row : pack.rows) rows.push_back(row.ref);
  for (const RuleCheck& check : pack.checks) {
    for (const RuleSpecial& special : check.specials) {
      check_ids(special.rows, rows, "rows", "special", "row", special.where, diagnostics);
    }
  }
  for (const RuleClass& item : pack.classes) {
    check_ids(item.rows, rows, "rows", "class", "row", item.where, diagnostics);
    check_ids(item.checks, checks, "of", "class", "check", item.where, diagnostics);
  }
}

}  // namespace rules
