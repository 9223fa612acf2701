#pragma once
// Finds numbers of rows that are impossible or unlikely.

#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace rules {

struct RowValueProblem {
  const RuleRow* row = nullptr;      // of the pack
  const RuleValue* value = nullptr;  // of the row
  bool is_of_modified = false;       // the number of that level
  bool is_error = false;             // the requirement means nothing; else unusual
  std::string words;                 // "0 lx requires nothing: every plane passes"
};

// Returns problems of values that are themselves the limit of a check: 0, an easier level
// "modified", a number that the quantity cannot have or the pack's scale lacks. In file order.
std::vector<RowValueProblem> row_value_problems(const RulePack& pack);

// Returns rows that require nothing of the pack's own role, give no reason, and do not say that it
// makes no sense there.
std::vector<const RuleRow*> rows_without_requirement(const RulePack& pack);

}  // namespace rules
