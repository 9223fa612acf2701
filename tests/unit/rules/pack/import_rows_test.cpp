#include "rules/pack/import_rows.h"

#include "rules/pack/builtin_packs.h"
#include "rules/pack/limit.h"
#include "rules/pack/rule_pack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules {
namespace {

using testing::ElementsAre;

const std::string kHeader =
    "final_ref,final_ref_confidence,group,activity,Em_required_lx,Em_modified_lx,Uo_min,Ra_min,"
    "RUGL_max,Ez_m_lx,Em_wall_lx,Em_ceiling_lx,notes,trust,confirmed_fields,sources\n";

struct Imported {
  std::optional<std::string> text;
  std::vector<std::string> messages;
};

Imported imported(const std::string& csv) {
  std::string like;
  for (const std::string_view text : builtin_pack_texts()) {
    if (text.find("id=\"en12464-1\" edition=\"2021\"") != std::string_view::npos) like = text;
  }
  calc::Diagnostics diagnostics;
  Imported result{import_rows(csv, "rows.csv", like, "mine", diagnostics), {}};
  for (const calc::Diagnostic& d : diagnostics.all()) {
    result.messages.push_back(format_diagnostic(d));
  }
  return result;
}

RulePack pack_of(const std::string& csv) {
  const Imported result = imported(csv);
  EXPECT_THAT(result.messages, ElementsAre());
  calc::Diagnostics diagnostics;
  return parse_rule_pack(result.text.value_or(""), "mine.xml", diagnostics).value_or(RulePack{});
}

TEST(ImportRows, MakesAPackWithTheChecksOfTheShippedOne) {
  const RulePack pack = pack_of(
      kHeader +
      "1.1,derived,\"Shops, small\",\"Till \"\"A\"\" & <B>\",500,1000,0.60,80,19,150,150,,,A,,S1\n"
      "1.2,derived,Shops,Store,100,,0.40,60,25,50,50,30,note,A-part,Em_required;Uo,S1 S2\n"
      "1.3,derived,Shops,Yard,100,,0.40,60,25,50,50,30,,M,,M\n");
  EXPECT_EQ(pack.full_id(), "mine:2021");
  EXPECT_EQ(pack.licence, "user-supplied");
  ASSERT_EQ(pack.rows.size(), 3u);
  EXPECT_EQ(pack.rows[0].name, "Shops, small: Till \"A\" & <B>");
  EXPECT_EQ(pack.rows[0].find_value("Em")->modified, 1000.0);
  EXPECT_EQ(pack.rows[0].find_value("Eceiling")->why, NoValue::not_specified);
  EXPECT_EQ(pack.rows[0].trust, Trust::confirmed);
  EXPECT_EQ(pack.rows[1].find_value("Em")->trust, Trust::confirmed);
  EXPECT_EQ(pack.rows[1].find_value("Ra")->trust, Trust::single_source);
  EXPECT_EQ(pack.rows[2].find_value("Em")->trust, Trust::unverified);
  const Limit surround = evaluate_limit(*pack.find_check("surround.Em"), {pack, &pack.rows[0]});
  EXPECT_EQ(surround.value.value, 300.0);
}

TEST(ImportRows, LeavesOutWhatIsNotInTheStandard) {
  const Imported result = imported(kHeader +
                                   "1.1,derived,G,a,500,,0.6,80,19,,,,,A,,\n"
                                   ",derived,G,b,500,,0.6,80,19,,,,,A,,\n"
                                   "1.3,dropped_in_final,G,c,500,,0.6,80,19,,,,,A,,\n");
  EXPECT_TRUE(result.text.has_value());
  EXPECT_THAT(result.messages,
              ElementsAre("rows.csv:3: warning[rule-import-skipped]: row 'b' was left out: it has "
                          "no final_ref",
                          "rows.csv:4: warning[rule-import-skipped]: row '1.3' was left out: it is "
                          "not in the published edition"));
}

TEST(ImportRowsMessage, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(imported("").messages,
              ElementsAre("rows.csv: error[rule-import]: a line with names of columns and at "
                          "least one row are needed"));
  EXPECT_THAT(imported("final_ref,activity\n1,a\n").messages,
              testing::Contains("rows.csv:1: error[rule-import]: there is no column 'Uo_min'"));
  EXPECT_THAT(imported(kHeader + "1,a\n").messages,
              ElementsAre("rows.csv:2: error[rule-import]: 2 fields, but the first line has 16"));
  EXPECT_THAT(imported(kHeader + "1,d,G,a,5oo,,0.6,80,19,,,,,A,,\n").messages,
              ElementsAre("rows.csv:2: error[rule-import]: Em_required_lx: '5oo' is not a number"));
  EXPECT_THAT(imported(kHeader + "1,d,G,\"a\n").messages,
              ElementsAre("rows.csv:2:7: error[rule-import]: a quote is not closed"));
  EXPECT_THAT(imported("trust," + kHeader + "A,1,d,G,a,500,,0.6,80,19,,,,,A,,\n").messages,
              ElementsAre("rows.csv:1: error[rule-import]: the column 'trust' is there twice"));
  const Imported twice =
      imported(kHeader + "1,d,G,a,5,,0.6,80,19,,,,,A,,\n1,d,G,b,5,,0.6,80,19,,,,,A,,\n");
  EXPECT_FALSE(twice.text.has_value());
  EXPECT_THAT(twice.messages, ElementsAre("rows.csv:3: error[rule-import]: the pack has two of "
                                          "<row> '1'; names are given once"));
  EXPECT_THAT(
      imported(kHeader + "1,d,G,a,5,,0.6,80,19,,,,,A,,\n2,d,G,b,-5,,0.6,80,19,,,,,A,,\n").messages,
      ElementsAre(testing::StartsWith("rows.csv:3: error[rule-import]: ")));
}

}  // namespace
}  // namespace rules
