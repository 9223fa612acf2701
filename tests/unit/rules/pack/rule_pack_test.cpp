#include "rules/pack/rule_pack.h"

#include "calc/base/diagnostic_ids.h"
#include "rules/pack/builtin_packs.h"
#include "rules/pack/limit.h"
#include "rules/pack/row_values.h"
#include "rules/pack/rule_lint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace rules::rule_pack_test {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kHead =
    "<rule-pack id='own' edition='2024' title='Own rules' version='3' kind='company' "
    "status='published' licence='internal' role='desk'>\n";
const std::string kParameter = "<parameter id='E' unit='lx' meaning='average'/>\n";
const std::string kCheck =
    "<check id='desk.E' role='desk' quantity='planar' statistic='average' at-least='row(E)'/>\n";

std::string pack_with(const std::string& parts) { return kHead + parts + "</rule-pack>\n"; }

// A check with this limit for an average, after the parts.
std::string pack_with_limit(const std::string& limit, const std::string& parts = "") {
  return pack_with(parts + "\n<check id='x' role='desk' quantity='planar' statistic='average'\n" +
                   "at-least='" + limit + "'/>");
}

std::vector<std::string> messages_of(const std::string& xml) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(parse_rule_pack(xml, "own.xml", diagnostics).has_value());
  std::vector<std::string> messages;
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    messages.push_back(format_diagnostic(diagnostic));
  }
  return messages;
}

RulePack pack_of(const std::string& xml) {
  calc::Diagnostics diagnostics;
  std::optional<RulePack> pack = parse_rule_pack(xml, "own.xml", diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  return pack.value_or(RulePack{});
}

TEST(RulePack, GridsAreData) {
  const RulePack pack = pack_of(pack_with(
      "<grid id='a' method='formula-power' count='nearest'/>"
      "<grid id='b' method='formula-power' count='odd-up' factor='0.3' base='4' max-spacing='8' "
      "ratio='3' trust='unverified'/>"
      "<grid id='c' method='fixed-spacing' count='up' spacing='3 1.5'/>"
      "<grid id='d' method='fixed-count' count='given' cells='9 3'/>"
      "<grid id='e' method='project' count='given'/>" +
      kParameter + kCheck));
  ASSERT_EQ(pack.grids.size(), 5u);
  EXPECT_EQ(grid_text(pack.grids[0]),
            "p = 0.2 * 5^log10 d m, at most 10 m; d the longer side, the shorter one from a ratio "
            "of 2 on; counts rounded: nearest");
  EXPECT_EQ(grid_text(pack.grids[1]),
            "p = 0.3 * 4^log10 d m, at most 8 m; d the longer side, the shorter one from a ratio "
            "of 3 on; counts rounded: odd-up [unverified requirement]");
  EXPECT_EQ(grid_text(pack.grids[2]),
            "at most 3 m along the longer and 1.5 m along the shorter side");
  EXPECT_EQ(grid_text(pack.grids[3]), "9 cells along the longer and 3 along the shorter side");
  EXPECT_EQ(grid_text(pack.grids[4]), "as the project says");
}

TEST(RulePack, ANumberThatTheMethodOfAGridDoesNotUseIsRefused) {
  const auto message = [](const std::string& attributes) {
    return messages_of(pack_with("\n<grid id='a' " + attributes + "/>" + kParameter + kCheck));
  };
  EXPECT_THAT(message("method='fixed-spacing' count='up' spacing='3' base='5'"),
              ElementsAre(HasSubstr("'base' has no meaning together with 'method'")));
  EXPECT_THAT(message("method='formula-power' count='given'"),
              ElementsAre(HasSubstr("'count' has no meaning together with 'method'")));
  EXPECT_THAT(message("method='fixed-spacing' count='nearest' spacing='3'"),
              ElementsAre(HasSubstr("'count' has no meaning together with 'method'")));
  EXPECT_THAT(message("method='formula-power' count='up' base='1'"),
              ElementsAre(HasSubstr("expected a number above 1, up to 100")));
  EXPECT_THAT(message("method='fixed-count' count='given'"),
              ElementsAre(HasSubstr("needs the attribute 'cells'")));
}

TEST(RulePack, ReadsItsHeadSourcesAndPolicy) {
  const RulePack pack = pack_of(
      pack_with("<source id='s' note='signed copy' address='https://example.org'/>"
                "<policy compare='rounded' rounding='down' digits-illuminance='1' tolerance='0.01' "
                "tolerance-reason='contract 4' guard='0.05'/>" +
                kParameter + kCheck));
  EXPECT_EQ(pack.full_id(), "own:2024");
  EXPECT_EQ(pack.title, "Own rules");
  EXPECT_EQ(pack.version, "3");
  EXPECT_EQ(pack.kind, "company");
  EXPECT_EQ(pack.status, "published");
  EXPECT_EQ(pack.licence, "internal");
  EXPECT_EQ(pack.file, "own.xml");
  ASSERT_EQ(pack.sources.size(), 1u);
  EXPECT_EQ(pack.sources[0].note, "signed copy");
  EXPECT_EQ(pack.sources[0].address, "https://example.org");
  EXPECT_TRUE(pack.policy.compares_rounded);
  EXPECT_EQ(pack.policy.rounding, Rounding::down);
  EXPECT_EQ(pack.policy.illuminance_digits, 1);
  EXPECT_EQ(pack.policy.ratio_digits, 2);
  EXPECT_EQ(pack.policy.tolerance, 0.01);
  EXPECT_EQ(pack.policy.guard, 0.05);
}

TEST(RulePack, ReadsRowsInTheUnitsOfTheirParameters) {
  const RulePack pack = pack_of(
      pack_with("<row ref='1.1' name='shop' trust='single-source'>"
                "<value of='E' required='2' modified='3'/><value of='U' none='unknown'/></row>"
                "<parameter id='E' unit='fc' meaning='average'/>"
                "<parameter id='U' unit='none' meaning='uniformity'/>" +
                kCheck));
  const RuleRow* row = pack.find_row("1.1");
  ASSERT_NE(row, nullptr);
  EXPECT_TRUE(row->has_modified_level());
  EXPECT_DOUBLE_EQ(row->find_value("E")->required.value(), 21.527820833419444);
  EXPECT_DOUBLE_EQ(row->find_value("E")->modified.value(), 32.291731250129166);
  EXPECT_EQ(row->find_value("E")->trust, Trust::single_source);
  EXPECT_FALSE(row->find_value("U")->required.has_value());
  EXPECT_EQ(row->find_value("U")->why, NoValue::unknown);
  EXPECT_EQ(row->find_value("X"), nullptr);
  EXPECT_EQ(pack.find_row("1.2"), nullptr);
}

TEST(RulePack, ReadsMasks) {
  const RulePack pack = pack_of(pack_with(
      "<mask id='m'><across metres='0.5' share='0.25' up-to-width='2'/><centre-line/></mask>" +
      kParameter +
      "<check id='c' role='desk' quantity='planar' statistic='minimum' mask='m' at-least='1 "
      "lx'/>"));
  ASSERT_EQ(pack.checks.at(0).mask.operations.size(), 2u);
  EXPECT_EQ(pack.checks[0].mask.operations[0].step, MaskStep::across);
  EXPECT_EQ(pack.checks[0].mask.operations[0].share, 0.25);
  EXPECT_EQ(pack.checks[0].mask.operations[0].up_to_width_m, 2.0);
  EXPECT_EQ(pack.checks[0].mask.operations[1].step, MaskStep::centre_line);
}

TEST(RulePack, ReadsTheRangeOfAShare) {
  const std::string check = "<check id='c' role='desk' quantity='planar' statistic='share' ";
  const RulePack pack = pack_of(pack_with(check + "from='1 fc' to='500 lx' at-least='0.9'/>"));
  EXPECT_DOUBLE_EQ(pack.checks.at(0).range.from, 10.763910416709722);
  EXPECT_EQ(pack.checks[0].range.to, 500.0);
  EXPECT_EQ(pack.checks[0].dimension(), Dimension::plain);
  EXPECT_THAT(messages_of(pack_with(check + "at-least='0.9'/>")),
              ElementsAre(HasSubstr("<check> needs 'from' or 'to', or both")));
  EXPECT_THAT(messages_of(pack_with(check + "from='0.3' at-least='0.9'/>")),
              ElementsAre(HasSubstr("the units of '0.3' do not fit: expected an illuminance")));
}

std::string pack_with_special(const std::string& specials) {
  return pack_with(kParameter +
                   "<row ref='1' name='n' trust='confirmed'><value of='E' required='5'/></row>"
                   "<row ref='2' name='n' trust='confirmed'><value of='E' required='5'/></row>"
                   "<check id='c' role='desk' quantity='planar' statistic='average' "
                   "at-least='row(E)'>" +
                   specials + "</check>");
}

TEST(RulePack, SpecialPlacesHaveNumbersOfTheirOwn) {
  const RulePack pack =
      pack_of(pack_with_special("<special place='unknown-task' limit='2 fc' trust='unverified'/>"
                                "<special place='other-wall' limit='3 lx' rows='2' "
                                "trust='single-source' note='n'/>"));
  const RuleCheck& check = pack.checks.at(0);
  using enum calc::SpecialPlace;
  const RuleRow *one = pack.find_row("1"), *two = pack.find_row("2");
  ASSERT_NE(check.find_special(unknown_task, one), nullptr);
  EXPECT_NEAR(check.find_special(unknown_task, one)->limit, 21.5278, 1e-4);
  EXPECT_EQ(check.find_special(unknown_task, nullptr)->trust, Trust::unverified);
  EXPECT_EQ(check.find_special(other_wall, one), nullptr);
  EXPECT_EQ(check.find_special(other_wall, nullptr), nullptr);
  EXPECT_EQ(check.find_special(other_wall, two)->note, "n");
  EXPECT_EQ(check.find_special(none, two), nullptr);
  // One in place of the row's 5 lx, the other where it is easier.
  EXPECT_NEAR(evaluate_limit(check, {pack, one, {}, {}, {}, unknown_task}).value.value, 21.5278,
              1e-4);
  EXPECT_EQ(evaluate_limit(check, {pack, one, {}, {}, {}, other_wall}).value.value, 5.0);
  EXPECT_EQ(evaluate_limit(check, {pack, two, {}, {}, {}, other_wall}).value.value, 3.0);
  EXPECT_EQ(evaluate_limit(check, {pack, two, {}, {}, {}, other_wall}).trust, Trust::single_source);
  EXPECT_EQ(evaluate_limit(check, {pack, two}).value.value, 5.0);
  const RulePack harder = pack_of(
      pack_with_special("<special place='other-wall' limit='7 lx' trust='single-source'/>"));
  EXPECT_EQ(evaluate_limit(harder.checks.at(0), {harder, &harder.rows[0], {}, {}, {}, other_wall})
                .value.value,
            5.0);
}

TEST(RulePackMessage, SpecialPlaces) {
  const auto said = [](const std::string& attributes) {
    return messages_of(pack_with_special("\n<special " + attributes + "/>"));
  };
  EXPECT_THAT(said("place='roof' limit='3 lx' trust='confirmed'"),
              ElementsAre(HasSubstr("attribute 'place' of <special>: unknown value 'roof'")));
  EXPECT_THAT(said("place='other-wall' limit='0.4' trust='confirmed'"),
              ElementsAre(HasSubstr("attribute 'limit' of <special>: the units of '0.4' do not "
                                    "fit: expected ")));
  EXPECT_THAT(said("place='other-wall' limit='row(E)' trust='confirmed'"),
              ElementsAre(HasSubstr("attribute 'limit' of <special>")));
  EXPECT_THAT(said("place='other-wall' limit='3 lx'"),
              ElementsAre(HasSubstr("<special> needs the attribute 'trust'")));
  EXPECT_THAT(said("place='other-wall' limit='3 lx' rows='3' trust='confirmed'"),
              ElementsAre(HasSubstr("attribute 'rows' of <special>: there is no row '3'")));
  EXPECT_THAT(said("place='other-wall' limit='3 lx' trust='confirmed'/>"
                   "<special place='other-wall' limit='2 lx' trust='confirmed'"),
              ElementsAre(HasSubstr("the pack has two <special> with the name 'other-wall'")));
}

TEST(RulePackMessage, OtherRootElement) {
  EXPECT_THAT(messages_of("<rules/>"),
              ElementsAre("own.xml:1:1: error[wrong-root-element]: the root element is <rules>; "
                          "expected <rule-pack>"));
}

TEST(RulePackMessage, NotXml) { EXPECT_EQ(messages_of("<rule-pack").size(), 1u); }

TEST(RulePackMessage, NoChecks) {
  EXPECT_THAT(
      messages_of(pack_with("")),
      ElementsAre("own.xml:1:1: error[missing-form]: <rule-pack> needs at least one <check>"));
}

TEST(RulePackMessage, RepeatedNames) {
  EXPECT_THAT(messages_of(pack_with(kParameter + kCheck + kCheck)),
              ElementsAre("own.xml:4:8: error[rule-name-twice]: the pack has two <check> with the "
                          "name 'desk.E'; names must be unique"));
  EXPECT_THAT(messages_of(pack_with(kParameter +
                                    "<row ref='1' name='a' trust='confirmed'>\n"
                                    "<value of='E' required='4'/><value of='E' required='5'/>"
                                    "</row>" +
                                    kCheck)),
              ElementsAre("own.xml:4:29: error[rule-value-twice]: row '1' has two values of 'E'"));
}

TEST(RulePackMessage, UnknownThings) {
  EXPECT_THAT(
      messages_of(pack_with(kParameter + kCheck +
                            "<row ref='1' nam='a' name='a' trust='confirmed'>"
                            "<value of='F' required='1'/></row>")),
      ElementsAre("own.xml:4:14: error[unknown-attribute]: unknown attribute 'nam' of <row>; "
                  "allowed: ref, name, name-de, trust, sources, note, task-heights or "
                  "task-orientation; did you mean 'name'?",
                  "own.xml:4:56: error[unknown-reference]: attribute 'of' of <value>: there is no "
                  "parameter 'F'; allowed: E; did you mean 'E'?"));
}

TEST(RulePackMessage, CheckWithoutOrWithTwoLimits) {
  const std::string check = "<check id='c' role='desk' quantity='planar' statistic='minimum' ";
  EXPECT_THAT(messages_of(pack_with(check + "/>")),
              ElementsAre("own.xml:2:1: error[missing-form]: <check> needs 'at-least', 'at-most', "
                          "'more-than' or 'less-than'"));
  EXPECT_THAT(messages_of(pack_with(check + "at-least='1 lx' at-most='2 lx'/>")),
              ElementsAre(HasSubstr("<check> has both 'at-least' and 'at-most'")));
}

TEST(RulePackMessage, ToleranceWithoutReason) {
  EXPECT_THAT(messages_of(pack_with("<policy tolerance='0.05'/>" + kParameter + kCheck)),
              ElementsAre(HasSubstr("<policy> has 'tolerance' without 'tolerance-reason'")));
}

TEST(RulePackMessage, FormulaThatIsNone) {
  EXPECT_THAT(messages_of(pack_with_limit("2 * (3 lx")),
              ElementsAre("own.xml:4:1: error[rule-formula]: attribute 'at-least' of <check>: "
                          "'2 * (3 lx', at character 10: expected ')'"));
}

TEST(RulePackMessage, FormulaWithUnknownNames) {
  EXPECT_THAT(messages_of(pack_with_limit("row(Ee)", kParameter)),
              ElementsAre("own.xml:5:1: error[unknown-reference]: attribute 'at-least' of <check>: "
                          "there is no parameter 'Ee'; allowed: E; did you mean 'E'?"));
  EXPECT_THAT(messages_of(pack_with_limit("limit(y)")),
              ElementsAre(HasSubstr("there is no check 'y'; allowed: x")));
  EXPECT_THAT(messages_of(pack_with_limit("fact(y)")),
              ElementsAre(HasSubstr("there is no fact 'y'; no fact is defined")));
  EXPECT_THAT(messages_of(pack_with_limit("table(t, 3 lx)")),
              ElementsAre(HasSubstr("there is no table 't'; no table is defined")));
  EXPECT_THAT(messages_of(pack_with_limit("step(20 lx, +1, s)")),
              ElementsAre(HasSubstr("there is no scale 's'; no scale is defined")));
}

TEST(RulePackMessage, FormulaWithUnitsThatDoNotFit) {
  const auto problem = [](const std::string& limit) {
    const std::vector<std::string> messages = messages_of(pack_with_limit(
        limit,
        "<scale id='s' unit='none' values='1 2'/>"
        "<table id='t' key-unit='m' value-unit='lx' match='exact'><entry key='1' value='2'/>"
        "</table>"));
    if (messages.size() != 1) return std::string("no single message");
    const std::size_t at = messages[0].find("do not fit: ");
    return at == std::string::npos ? messages[0] : messages[0].substr(at + 12);
  };
  EXPECT_EQ(problem("0.5"),
            "the check limits an illuminance (lx, fc), but the formula gives a plain "
            "number");
  EXPECT_EQ(problem("1 lx + 2"),
            "an illuminance (lx, fc) and a plain number cannot be added or "
            "compared");
  EXPECT_EQ(problem("max(1 lx, 2 m)"),
            "an illuminance (lx, fc) and a length (m, ft) cannot be added or compared");
  EXPECT_EQ(problem("1 lx * 2 lx"),
            "an illuminance (lx, fc) times an illuminance (lx, fc) has no "
            "unit that luxgate knows");
  EXPECT_EQ(problem("1 lx / 2 m"),
            "an illuminance (lx, fc) divided by a length (m, ft) has no "
            "unit that luxgate knows");
  EXPECT_EQ(problem("table(t, 1 lx)"),
            "the key of table 't' is a length (m, ft), not an illuminance (lx, fc)");
  EXPECT_EQ(problem("step(1 lx, +1, s)"),
            "a value of scale 's' is a plain number, not an illuminance (lx, fc)");
}

std::string check_named(const std::string& id, const std::string& limit) {
  return "<check id='" + id + "' role='desk' quantity='planar' statistic='average' at-least='" +
         limit + "'/>\n";
}

TEST(RulePackMessage, Circles) {
  const auto circle = [](const std::string& checks) { return messages_of(pack_with(checks)); };
  EXPECT_THAT(circle(check_named("a", "limit(b)") + check_named("b", "2 * result(c)") +
                     check_named("c", "limit(a) + 1 lx")),
              ElementsAre(HasSubstr("own.xml:2:65: error[rule-circle]: check 'a' depends on its "
                                    "own limit or result: a -> b -> c -> a; ")));
  EXPECT_THAT(circle(check_named("a", "limit(a)")), ElementsAre(HasSubstr("a -> a")));
}

// instead-of: another check, of another role, that counts alike.
TEST(RulePackMessage, AnotherWayToAskTheSame) {
  const auto check = [](const std::string& id, const std::string& role, const std::string& more) {
    return "<check id='" + id + "' role='" + role +
           "' quantity='planar' statistic='average' at-least='1 lx' trust='confirmed' " + more +
           "/>\n";
  };
  const auto messages = [&](const std::string& other, const std::string& more) {
    return messages_of(pack_with(check("a", "desk", "") + other + check("c", "eyes", more)));
  };
  calc::Diagnostics diagnostics;
  EXPECT_TRUE(
      parse_rule_pack(pack_with(check("a", "desk", "") + check("c", "eyes", "instead-of='a'")),
                      "own.xml", diagnostics));
  EXPECT_THAT(messages("", "instead-of='x'"), ElementsAre(HasSubstr("'x'")));
  const auto refused =
      ElementsAre(HasSubstr("<check> needs in 'instead-of' a check of another role"));
  EXPECT_THAT(messages("", "instead-of='c'"), refused);
  EXPECT_THAT(messages("", "instead-of='a' severity='should'"), refused);
  EXPECT_THAT(messages(check("b", "eyes", ""), "instead-of='b'"), refused);
  EXPECT_THAT(messages(check("b", "wall", "instead-of='a'"), "instead-of='b'"), refused);
}

// Written out, every check is twice as long as the one before.
TEST(RulePackMessage, FormulaThatGrowsBeyondAllBounds) {
  std::string checks = check_named("c0", "1 lx");
  for (int i = 1; i < 40; ++i) {
    const std::string before = "limit(c" + std::to_string(i - 1) + ")";
    checks += check_named("c" + std::to_string(i), before + " + " + before);
  }
  EXPECT_THAT(messages_of(pack_with(checks)),
              testing::Contains(HasSubstr("error[rule-too-long]: the formula of check 'c")));
}

TEST(RulePackMessage, ScaleAndTableOutOfOrder) {
  EXPECT_THAT(
      messages_of(pack_with("<scale id='s' unit='lx' values='1 3 3'/>" + kParameter + kCheck)),
      ElementsAre(HasSubstr("attribute 'values' of <scale>: must be larger than the number "
                            "before")));
  EXPECT_THAT(messages_of(pack_with("<table id='t' key-unit='lx' value-unit='lx' match='exact'>"
                                    "<entry key='2' value='2'/><entry key='1' value='2'/></table>" +
                                    kParameter + kCheck)),
              ElementsAre(HasSubstr("attribute 'key' of <entry>: must be larger than the entry "
                                    "before")));
}

TEST(RulePackMessage, ScaleOfAParameter) {
  const auto messages = [](const std::string& attributes, const std::string& more = "") {
    return messages_of(pack_with(kParameter + "<scale id='s' unit='lx' values='1 3' " + attributes +
                                 "/>" + more + kCheck));
  };
  EXPECT_THAT(messages("of='E'"),
              ElementsAre(HasSubstr("<scale> needs 'down' or 'up' of at least 1 beside 'of'")));
  EXPECT_THAT(messages("up='1'"),
              ElementsAre(HasSubstr("error[missing-partner]: <scale> has 'up' without 'of'")));
  EXPECT_THAT(messages("of='X' up='1'"), ElementsAre(HasSubstr("there is no parameter 'X'")));
  EXPECT_THAT(messages("of='E' up='4'"), testing::Contains(HasSubstr("unknown value '4'")));
  EXPECT_THAT(messages("of='E' up='1'", "<scale id='r' unit='lx' values='1 3' of='E' up='1'/>"),
              ElementsAre(HasSubstr("<scale> needs another parameter in 'of'")));
  EXPECT_THAT(messages("", "<scale id='r' unit='m' values='1 3' of='E' up='1'/>"),
              ElementsAre(HasSubstr("<scale> needs a parameter of a length (m, ft) in 'of'")));
}

// Whatever number a shipped pack says itself, it says how well the number is known.
TEST(BuiltinPacks, StateTheTrustOfTheirNumbers) {
  for (const RulePack& pack : builtin_rule_packs()) {
    calc::Diagnostics diagnostics;
    lint_rule_pack(pack, diagnostics);
    for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
      EXPECT_NE(diagnostic.id, calc::DiagnosticId::rule_without_trust) << diagnostic.message;
    }
  }
}

// The reader and the published schema agree about these files; xmllint checks the other half.
TEST(RulePackSchema, HasACorpusThatTheReaderAgreesWith) {
  int valid = 0, invalid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LUXGATE_RULE_PACK_FILES)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const bool is_valid = entry.path().filename().string().starts_with("valid-");
    calc::Diagnostics diagnostics;
    EXPECT_EQ(parse_rule_pack(bytes, "pack.xml", diagnostics).has_value(), is_valid)
        << entry.path();
    ++(is_valid ? valid : invalid);
  }
  EXPECT_GE(valid, 3);
  EXPECT_GE(invalid, 15);
}

TEST(BuiltinRulePacks, AreTheseAndEverySourceIsNamed) {
  std::vector<std::string> ids;
  for (const RulePack& pack : builtin_rule_packs()) {
    ids.push_back(pack.full_id());
    EXPECT_EQ(pack.file, "built in");
    EXPECT_FALSE(pack.sources.empty()) << pack.full_id();
    for (const RuleRow& row : pack.rows) {
      EXPECT_FALSE(row.sources.empty()) << pack.full_id() << " " << row.ref;
      // "confirmed" needs two sources, unless it is law.
      if (row.trust == Trust::confirmed && pack.kind != "law") {
        EXPECT_GE(row.sources.size(), 2u) << pack.full_id() << " " << row.ref;
      }
    }
  }
  EXPECT_THAT(ids, ElementsAre("ashrae90-1:2019", "asr-a3-4:undated", "egress-us:undated",
                               "en12193:2018", "en12464-1:2011", "en12464-1:2021", "en12464-2:2014",
                               "en13201-2:2015", "en1838:2013", "en1838:2024", "iso8995-1:2002",
                               "lai:2012", "leed-interior-lighting:4.1", "osha-1926-56:1926.56",
                               "rp-20:1998", "rp-8:2014", "well:v1"));
}

const RulePack& indoor_pack() {
  static const std::vector<RulePack> kPacks = builtin_rule_packs();
  return *std::find_if(kPacks.begin(), kPacks.end(),
                       [](const RulePack& pack) { return pack.full_id() == "en12464-1:2021"; });
}

// The numbers that the table of rules/README.md has.
TEST(IndoorRows, AreAllThatASourceStates) {
  std::size_t of_one_source = 0, in_part = 0, in_full = 0, without_number = 0;
  for (const RuleRow& row : indoor_pack().rows) {
    const auto count = [&row](const auto& is_meant) {
      return std::count_if(row.values.begin(), row.values.end(), is_meant);
    };
    const auto numbers = count([](const RuleValue& value) { return value.required.has_value(); });
    const auto confirmed = count([](const RuleValue& value) {
      return value.required.has_value() && value.trust == Trust::confirmed;
    });
    EXPECT_EQ(row.values.size(), indoor_pack().parameters.size()) << row.ref;
    EXPECT_FALSE(row.name.empty() || row.name_de.empty()) << row.ref;
    if (numbers == 0) {
      ++without_number;
    } else if (confirmed == numbers) {
      ++in_full;
    } else if (row.sources.size() > 1 && row.ref != "12.2") {  // there the other one contradicts
      ++in_part;
    } else {
      EXPECT_EQ(confirmed, 0) << row.ref;
      ++of_one_source;
    }
  }
  EXPECT_EQ(indoor_pack().rows.size(), 325U);
  EXPECT_EQ(in_full, 8U);
  EXPECT_EQ(in_part, 31U);
  EXPECT_EQ(of_one_source, 283U);
  EXPECT_EQ(without_number, 3U);
}

// Those that one source has without doubt about them are on the scales of the standard.
TEST(IndoorRows, HaveNumbersThatTheStandardUses) {
  std::vector<std::string> off_scale;
  for (const RowValueProblem& problem : row_value_problems(indoor_pack())) {
    EXPECT_FALSE(problem.is_error) << problem.row->ref << ": " << problem.words;
    EXPECT_EQ(problem.value->trust, Trust::unverified) << problem.row->ref;
    off_scale.push_back(problem.row->ref + " " + problem.value->parameter);
  }
  EXPECT_THAT(off_scale, IsEmpty());
  EXPECT_THAT(rows_without_requirement(indoor_pack()), IsEmpty());
  for (const RuleRow& row : indoor_pack().rows) {
    SCOPED_TRACE(row.ref);
    for (const RuleValue& value : row.values) {
      if (!value.required) continue;
      if (value.modified) {
        EXPECT_EQ(value.parameter, "Em");
        EXPECT_GT(*value.modified, *value.required);
      }
      if (value.parameter == "Uo") {
        EXPECT_THAT(*value.required, AnyOf(0.3, 0.4, 0.5, 0.6, 0.7));
      } else if (value.parameter == "RUGL") {
        EXPECT_THAT(*value.required, AnyOf(16, 19, 22, 25, 28));
      } else if (value.parameter == "Ra") {
        EXPECT_THAT(*value.required, AnyOf(20, 40, 60, 80, 90));
      }
    }
  }
}

TEST(IndoorRows, SayWhyANumberIsUnverified) {
  std::vector<std::string> unverified;
  for (const RuleRow& row : indoor_pack().rows) {
    for (const RuleValue& value : row.values) {
      if (!value.required || value.trust != Trust::unverified) continue;
      unverified.push_back(row.ref + " " + value.parameter);
      EXPECT_THAT(row.note, HasSubstr("; ")) << row.ref << ": the reason follows the number's";
    }
  }
  EXPECT_THAT(unverified, ElementsAre("12.2 Uo", "12.2 Ra", "26.9 Ra", "61.8 RUGL"));
}

// 9.10 comes after 9.9, not after 9.1.
TEST(IndoorRows, AreInTheOrderOfTheirNumbers) {
  std::vector<std::vector<int>> numbers;
  for (const RuleRow& row : indoor_pack().rows) {
    std::vector<int>& parts = numbers.emplace_back();
    std::istringstream ref(row.ref);
    for (std::string part; std::getline(ref, part, '.');) parts.push_back(std::stoi(part));
  }
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
}

}  // namespace
}  // namespace rules::rule_pack_test
