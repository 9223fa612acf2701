#include "rules/pack/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rules::expression_test {
namespace {

// As nested calls: "(add 1 (row Em))".
std::string shape(const Expression& e) {
  std::string text;
  switch (e.kind) {
    case ExpressionKind::number:
      return std::to_string(e.number).substr(0, 6) + base_unit(e.dimension);
    case ExpressionKind::add:
      text = "add";
      break;
    case ExpressionKind::multiply:
      text = "mul";
      break;
    case ExpressionKind::divide:
      text = "div";
      break;
    case ExpressionKind::row_value:
      text = "row";
      break;
    case ExpressionKind::table:
      text = "table";
      break;
    case ExpressionKind::limit_of:
      text = "limit";
      break;
    case ExpressionKind::result_of:
      text = "result";
      break;
    case ExpressionKind::fact:
      text = "fact";
      break;
    case ExpressionKind::step:
      text = "step";
      break;
    case ExpressionKind::minimum:
      text = "min";
      break;
    case ExpressionKind::maximum:
      text = "max";
  }
  if (!e.name.empty()) text += " " + e.name;
  if (e.kind == ExpressionKind::step) text += " " + std::to_string(e.steps);
  for (const Expression& operand : e.operands) text += " " + shape(operand);
  return "(" + text + ")";
}

std::string parsed(const std::string& text) {
  const ParsedExpression result = parse_expression(text);
  if (!result.expression) return std::to_string(result.position) + ": " + result.error;
  return shape(*result.expression);
}

TEST(Expression, NumbersHaveUnits) {
  EXPECT_EQ(parsed("15 lx"), "15.000lx");
  EXPECT_EQ(parsed("15lx"), "15.000lx");
  EXPECT_EQ(parsed("1 fc"), "10.763lx");
  EXPECT_EQ(parsed("0.61 W/ft2"), "6.5659W/m2");
  EXPECT_EQ(parsed("10 ft"), "3.0480m");
  EXPECT_EQ(parsed(" 0.4 "), "0.4000");
}

TEST(Expression, ProductsBindCloserThanSums) {
  EXPECT_EQ(parsed("1 + 2 * 3 + 4"), "(add (add 1.0000 (mul 2.0000 3.0000)) 4.0000)");
  EXPECT_EQ(parsed("(1 + 2) * 3"), "(mul (add 1.0000 2.0000) 3.0000)");
  EXPECT_EQ(parsed("8 / 4 / 2"), "(div (div 8.0000 4.0000) 2.0000)");
  EXPECT_EQ(parsed("10 W / 2 m"), "(div 10.000W 2.0000m)");
}

TEST(Expression, FunctionsTakeNamesAndFormulas) {
  EXPECT_EQ(parsed("row(Em)"), "(row Em)");
  EXPECT_EQ(parsed("limit(1838.2024.min)"), "(limit 1838.2024.min)");
  EXPECT_EQ(parsed("result(pa-Em)"), "(result pa-Em)");
  EXPECT_EQ(parsed("table(surround, row(Em))"), "(table surround (row Em))");
  EXPECT_EQ(parsed("step(row(Em), +1, steps)"), "(step steps 1 (row Em))");
  EXPECT_EQ(parsed("step(row(Em), -2, steps)"), "(step steps -2 (row Em))");
  EXPECT_EQ(parsed("max(15 lx, 0.1 * fact(task))"), "(max 15.000lx (mul 0.1000 (fact task)))");
  EXPECT_EQ(parsed("min(1, 2, 3)"), "(min 1.0000 2.0000 3.0000)");
}

TEST(ExpressionMessage, SaysWhereAndWhatIsAllowed) {
  EXPECT_EQ(parsed(""), "0: expected a number, a function or '('");
  EXPECT_EQ(parsed("1 +"), "3: expected a number, a function or '('");
  EXPECT_EQ(parsed("1 2"), "2: expected '+', '*', '/' or the end");
  EXPECT_EQ(parsed("1.2.3"), "0: expected a decimal number from 0 to 1e9");
  EXPECT_EQ(parsed("9999999999"), "0: expected a decimal number from 0 to 1e9");
  EXPECT_EQ(parsed("row()"), "4: expected a name");
  EXPECT_EQ(parsed("row(Em"), "6: expected ')'");
  EXPECT_EQ(parsed("rwo(Em)"),
            "0: unknown function 'rwo'; allowed: row, table, limit, result, fact, step, min or "
            "max");
  EXPECT_EQ(parsed("step(1, one, s)"),
            "8: expected a number of steps such as +1 or -1, at most 100");
  EXPECT_EQ(parsed("step(1, 101, s)"),
            "8: expected a number of steps such as +1 or -1, at most 100");
  EXPECT_EQ(parsed("1 lux"), "2: expected '+', '*', '/' or the end");
}

TEST(ExpressionMessage, HasBounds) {
  const std::string deep(40, '(');
  EXPECT_THAT(parsed(deep + "1" + std::string(40, ')')),
              testing::HasSubstr("brackets are nested more than 32 deep"));
  EXPECT_EQ(parsed(std::string(1001, ' ')), "0: the formula has more than 1000 characters");
}

}  // namespace
}  // namespace rules::expression_test
