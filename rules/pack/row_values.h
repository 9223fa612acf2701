#pragma once
// Numbers of rows that cannot be meant, or hardly are.

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

// Of values that are the limit of a check by themselves: 0, a level "modified" that is easier, what
// the quantity cannot be, what is not on the pack's scale. In the order of the file.
std::vector<RowValueProblem> row_value_problems(const RulePack& pack);

// Rows that require nothing of the pack's own role, and neither give a reason nor say that it makes
// no sense there.
std::vector<const RuleRow*> rows_without_requirement(const RulePack& pack);

}  // namespace rules
