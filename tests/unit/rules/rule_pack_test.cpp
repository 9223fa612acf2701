#include "rules/rule_pack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kHead = "<rule-pack id='own' edition='2024' title='Own rules' version='3'>\n";
const std::string kGoodRow =
    "<row ref='1.1' name='shop' trust='our contract'>"
    "<limit quantity='average' at-least='300' modified='500'/></row>\n";

std::string pack_with(const std::string& rows) { return kHead + rows + "</rule-pack>\n"; }

std::vector<std::string> messages_of(const std::string& xml) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(parse_rule_pack(xml, "own.xml", diagnostics).has_value());
  std::vector<std::string> messages;
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    messages.push_back(format_diagnostic(diagnostic));
  }
  return messages;
}

TEST(RulePack, ReadsEverything) {
  calc::Diagnostics diagnostics;
  const auto pack =
      parse_rule_pack(pack_with("<source id='s' note='signed copy'/>\n" + kGoodRow +
                                "<row ref='1.2' name='store' trust='s'>\n"
                                "<limit quantity='Ud' at-least='0.025' clause='7.3'/>\n"
                                "<limit quantity='maximum' at-most='2000'/>\n"
                                "<limit quantity='maximum' at-least='100'/></row>\n"),
                      "own.xml", diagnostics);
  EXPECT_THAT(diagnostics.all(), IsEmpty());
  ASSERT_TRUE(pack.has_value());
  EXPECT_EQ(pack->id, "own");
  EXPECT_EQ(pack->full_id(), "own:2024");
  EXPECT_EQ(pack->title, "Own rules");
  EXPECT_EQ(pack->version, "3");
  EXPECT_EQ(pack->file, "own.xml");
  ASSERT_EQ(pack->sources.size(), 1u);
  EXPECT_EQ(pack->sources[0].note, "signed copy");

  const RuleRow* shop = pack->find_row("1.1");
  ASSERT_NE(shop, nullptr);
  EXPECT_TRUE(shop->has_modified_level());
  EXPECT_EQ(shop->name, "shop");
  EXPECT_EQ(shop->trust, "our contract");
  EXPECT_EQ(shop->limits.at(0).at_level(RowLevel::required), 300);
  EXPECT_EQ(shop->limits.at(0).at_level(RowLevel::modified), 500);
  EXPECT_EQ(pack->clause_text(shop->limits[0], RowLevel::modified),
            "Own rules:2024 1.1 (modified)");

  const RuleRow* store = pack->find_row("1.2");
  ASSERT_NE(store, nullptr);
  EXPECT_FALSE(store->has_modified_level());
  ASSERT_EQ(store->limits.size(), 3u);
  EXPECT_EQ(store->limits[0].metric, Metric::uniformity_min_max);
  EXPECT_EQ(store->limits[0].required, 0.025);
  EXPECT_EQ(pack->clause_text(store->limits[0], RowLevel::required), "Own rules:2024 7.3");
  EXPECT_EQ(store->limits[1].comparison, Comparison::at_most);
  EXPECT_EQ(pack->find_row("1.3"), nullptr);
}

TEST(RulePackMessage, OtherRootElement) {
  EXPECT_THAT(messages_of("<rules/>"),
              ElementsAre("own.xml:1:1: error[wrong-root-element]: the root element is <rules>; "
                          "expected <rule-pack>"));
}

TEST(RulePackMessage, NotXml) { EXPECT_EQ(messages_of("<rule-pack").size(), 1u); }

TEST(RulePackMessage, NoRows) {
  EXPECT_THAT(
      messages_of(pack_with("")),
      ElementsAre("own.xml:1:1: error[missing-form]: <rule-pack> needs at least one <row>"));
}

TEST(RulePackMessage, RowWithoutLimits) {
  EXPECT_THAT(messages_of(pack_with("<row ref='1' name='a' trust='b'/>")),
              ElementsAre("own.xml:2:1: error[missing-form]: <row> needs at least one <limit>"));
}

TEST(RulePackMessage, RepeatedRow) {
  EXPECT_THAT(messages_of(pack_with(kGoodRow + kGoodRow)),
              ElementsAre("own.xml:3:6: error[duplicate-id]: the row '1.1' is given twice, also "
                          "in line 2"));
}

TEST(RulePackMessage, RepeatedLimit) {
  const std::string limit = "<limit quantity='Uo' at-least='0.4'/>\n";
  EXPECT_THAT(
      messages_of(pack_with("<row ref='1' name='a' trust='b'>\n" + limit + limit + "</row>")),
      ElementsAre("own.xml:4:1: error[repeated-row-limit]: row '1' already has a limit 'at-least' "
                  "for 'Uo'"));
}

TEST(RulePackMessage, UnknownThings) {
  EXPECT_THAT(messages_of(pack_with("<row ref='1' nam='a' name='a' trust='b'><limits/>\n"
                                    "<limit quantity='Uo' at-least='0.4' unit='lx'/></row>")),
              ElementsAre("own.xml:2:14: error[unknown-attribute]: unknown attribute 'nam' of "
                          "<row>; allowed: ref, name or trust; did you mean 'name'?",
                          "own.xml:2:41: error[unknown-element]: unknown element <limits> in "
                          "<row>; allowed: limit; did you mean 'limit'?",
                          "own.xml:3:37: error[unknown-attribute]: unknown attribute 'unit' of "
                          "<limit>; allowed: quantity, at-least, at-most, modified or clause"));
}

TEST(RulePackMessage, QuantityThatNeedsMoreThanARow) {
  EXPECT_THAT(messages_of(pack_with("<row ref='1' name='a' trust='b'>\n"
                                    "<limit quantity='percentile' at-least='4'/></row>")),
              ElementsAre("own.xml:3:8: error[unknown-value]: attribute 'quantity' of <limit>: "
                          "unknown value 'percentile'; allowed: average, minimum, maximum, Uo or "
                          "Ud"));
}

TEST(RulePackMessage, LimitsOutOfRange) {
  EXPECT_THAT(messages_of(pack_with("<row ref='1' name='a' trust='b'>\n"
                                    "<limit quantity='Uo' at-least='40' modified='50'/></row>")),
              ElementsAre("own.xml:3:22: error[number-out-of-range]: attribute 'at-least' of "
                          "<limit>: 40 is not allowed; expected a ratio from 0 to 1",
                          "own.xml:3:36: error[number-out-of-range]: attribute 'modified' of "
                          "<limit>: 50 is not allowed; expected a ratio from 0 to 1"));
}

TEST(RulePackMessage, NoLimitValue) {
  EXPECT_THAT(messages_of(pack_with("<row ref='1' name='a' trust='b'>\n"
                                    "<limit quantity='Uo' modified='0.5'/></row>")),
              ElementsAre("own.xml:3:1: error[missing-form]: <limit> needs 'at-least' or "
                          "'at-most'"));
}

// Ref, required and modified average, Uo: the whole of the shipped pack.
TEST(BuiltinRulePacks, HaveTheConfirmedRows) {
  const std::vector<RulePack> packs = builtin_rule_packs();
  ASSERT_EQ(packs.size(), 1u);
  EXPECT_EQ(packs[0].full_id(), "en12464-1:2021");
  EXPECT_EQ(packs[0].file, "built in");
  struct Row {
    const char* ref;
    double required, modified, uo;
  };
  const std::vector<Row> expected{{"9.4", 200, 300, 0.4},   {"10.4", 200, 300, 0.4},
                                  {"10.6", 500, 750, 0.6},  {"10.7", 500, 1000, 0.6},
                                  {"14.1", 200, 300, 0.4},  {"15.2", 500, 750, 0.7},
                                  {"34.2", 500, 1000, 0.6}, {"34.7", 200, 300, 0.4}};
  ASSERT_EQ(packs[0].rows.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const RuleRow& row = packs[0].rows[i];
    SCOPED_TRACE(row.ref);
    EXPECT_EQ(row.ref, expected[i].ref);
    ASSERT_EQ(row.limits.size(), 2u);
    EXPECT_EQ(row.limits[0].metric, Metric::average);
    EXPECT_EQ(row.limits[0].comparison, Comparison::at_least);
    EXPECT_EQ(row.limits[0].required, expected[i].required);
    EXPECT_EQ(row.limits[0].modified, expected[i].modified);
    EXPECT_EQ(row.limits[1].metric, Metric::uniformity_min_avg);
    EXPECT_EQ(row.limits[1].required, expected[i].uo);
    EXPECT_FALSE(row.limits[1].modified.has_value());
  }
}

}  // namespace
}  // namespace rules
