#include "rules/pack/row_values.h"

#include "rules/pack/rule_lint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::row_values_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> lint_messages(const std::string& row) {
  calc::Diagnostics diagnostics;
  const std::optional<RulePack> pack = parse_rule_pack(
      "<rule-pack id='p' edition='1' title='P' version='1' kind='contract' status='published' "
      "licence='internal' role='task'>"
      "<parameter id='Em' unit='fc' meaning='average'/><parameter id='Ra' unit='none' meaning='a'/>"
      "<parameter id='R' unit='none' meaning='rating'/><parameter id='Uo' unit='none' meaning='u'/>"
      "<scale id='steps' unit='fc' values='10 20 50'/>\n" +
          row +
          "<check id='a' role='task' quantity='planar' statistic='average' at-least='row(Em)'/>"
          "<check id='u' role='task' quantity='planar' statistic='Uo' at-least='row(Uo)'/>"
          "<check id='g' role='eye' quantity='UGR' statistic='maximum' at-most='row(R)'/>"
          "<check id='c' role='lamp' quantity='Ra' statistic='value' at-least='row(Ra)'/>"
          "</rule-pack>",
      "p.xml", diagnostics);
  if (pack) lint_rule_pack(*pack, diagnostics);
  std::vector<std::string> messages;
  for (const calc::Diagnostic& d : diagnostics.all()) messages.push_back(format_diagnostic(d));
  return messages;
}

std::vector<std::string> of_value(const std::string& value) {
  return lint_messages("<row ref='1' name='n' trust='confirmed'>\n<value " + value +
                       "/><value of='Uo' required='0.4'/></row>");
}

TEST(RowValues, ThatAreMeantAreNotMentioned) {
  EXPECT_THAT(of_value("of='Em' required='20' modified='50'"), IsEmpty());
  EXPECT_THAT(of_value("of='Em' required='20' modified='20'"), IsEmpty());
  EXPECT_THAT(of_value("of='R' required='19'"), IsEmpty());
  EXPECT_THAT(of_value("of='R' required='22' modified='19'"), IsEmpty());
}

TEST(RowValues, ThatMeanNothingAreErrors) {
  EXPECT_THAT(of_value("of='Em' required='0'"),
              ElementsAre("p.xml:3:1: error[rule-value-meaningless]: row '1', Em: 0 fc requires "
                          "nothing: every plane passes"));
  EXPECT_THAT(of_value("of='Em' required='20' modified='10'"),
              ElementsAre("p.xml:3:1: error[rule-value-meaningless]: row '1', Em (modified): 10 fc "
                          "at the level 'modified' is below the required 20 fc"));
  EXPECT_THAT(of_value("of='Ra' required='101'"),
              ElementsAre("p.xml:3:1: error[rule-value-meaningless]: row '1', Ra: 101 is out of "
                          "range; allowed: 0 to 100"));
  EXPECT_THAT(lint_messages("<row ref='1' name='n' trust='confirmed'><value of='Em' "
                            "required='20'/>\n<value of='Uo' required='1.2'/></row>"),
              ElementsAre("p.xml:3:1: error[rule-value-meaningless]: row '1', Uo: 1.2 is out of "
                          "range; allowed: 0 to 1"));
}

TEST(RowValues, ThatAreUnusualAreWarnings) {
  EXPECT_THAT(of_value("of='Em' required='30'"),
              ElementsAre("p.xml:3:1: warning[rule-value-unusual]: row '1', Em: 30 fc is not a "
                          "step of the scale 'steps'; nearest: 20 fc and 50 fc"));
  EXPECT_THAT(of_value("of='Em' required='5' modified='60'"),
              ElementsAre("p.xml:3:1: warning[rule-value-unusual]: row '1', Em: 5 fc is not a step "
                          "of the scale 'steps'; nearest: 10 fc",
                          "p.xml:3:1: warning[rule-value-unusual]: row '1', Em (modified): 60 fc "
                          "is not a step of the scale 'steps'; nearest: 50 fc"));
  EXPECT_THAT(
      of_value("of='R' required='35'"),
      ElementsAre("p.xml:3:1: warning[rule-value-unusual]: row '1', R: 35 is unusual; usual "
                  "are 10 to 30"));
  EXPECT_THAT(
      of_value("of='Ra' required='0'"),
      ElementsAre("p.xml:3:1: warning[rule-value-unusual]: row '1', Ra: 0 requires nothing: "
                  "every plane passes"));
}

TEST(RowValues, RowsThatRequireNothingSayWhy) {
  const std::string message =
      "p.xml:2:1: warning[rule-row-empty]: row '1' requires nothing of the role 'task', and no "
      "note "
      "says why";
  EXPECT_THAT(lint_messages("<row ref='1' name='n' trust='confirmed'/>"), ElementsAre(message));
  EXPECT_THAT(lint_messages("<row ref='1' name='n' trust='confirmed'><value of='Em' "
                            "none='not-specified'/></row>"),
              ElementsAre(message));
  EXPECT_THAT(lint_messages("<row ref='1' name='n' trust='confirmed' note='the museum says'/>"),
              IsEmpty());
  EXPECT_THAT(lint_messages("<row ref='1' name='n' trust='confirmed'><value of='Em' "
                            "none='not-applicable'/></row>"),
              IsEmpty());
}

TEST(RowValues, OfTheShippedPacksAreMeant) {
  for (const RulePack& pack : builtin_rule_packs()) {
    for (const RowValueProblem& problem : row_value_problems(pack)) {
      ADD_FAILURE() << pack.full_id() << " " << problem.row->ref << ": " << problem.words;
    }
    for (const RuleRow* row : rows_without_requirement(pack)) {
      ADD_FAILURE() << pack.full_id() << " " << row->ref << " requires nothing";
    }
  }
}

}  // namespace
}  // namespace rules::row_values_test
