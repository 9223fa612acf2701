#pragma once
// Limits of rule packs as small finite formulas: a tree without loops or names of its own.
//
//   15 lx   0.4   1 / 40              numbers, with a unit where they have one
//   row(Em)                           a value of the row that was chosen
//   table(surround, row(Em))          looked up
//   limit(task.Em)  result(pa.Em)     the limit or the measured value of another check
//   fact(task-illuminance)            stated by the project
//   step(row(Em), +1, steps)          so many steps up a scale of preferred values
//   + * /  min(a, b, ...)  max(a, b, ...)  ( )

#include "rules/catalogue/unit.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

enum class ExpressionKind {
  number,
  row_value,
  table,
  limit_of,
  result_of,
  fact,
  step,
  add,
  multiply,
  divide,
  minimum,
  maximum,
};

struct Expression {
  ExpressionKind kind = ExpressionKind::number;
  double number = 0.0;                     // of a number, in base units; >= 0
  Dimension dimension = Dimension::plain;  // of a number
  std::string name;                        // of a row value, table, check, fact or scale
  int steps = 0;                           // of a step: up, or down if negative
  std::vector<Expression> operands;        // of a table: its key; of a step: where it starts
};

struct ParsedExpression {
  std::optional<Expression> expression;
  std::string error;         // in words, with what is allowed
  std::size_t position = 0;  // of the error in the text, in bytes from 0
};

// Parses a formula without looking up names or checking units: see rule_pack_check.h.
ParsedExpression parse_expression(std::string_view text);

}  // namespace rules
