#include "rules/pack/import_rows.h"

#include "rules/pack/builtin_packs.h"
#include "rules/pack/limit.h"
#include "rules/pack/rule_pack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rules::import_rows_test {
namespace {

using testing::ElementsAre;

const std::string kHeader =
    "final_ref,final_ref_confidence,group,activity,Em_required_lx,Em_modified_lx,Uo_min,Ra_min,"
    "RUGL_max,Ez_m_lx,Em_wall_lx,Em_ceiling_lx,notes,trust,confirmed_fields,sources\n";
const std::string kNoPlane =
    "rows.csv:1: warning[rule-import-doubtful]: column plane is missing; every row is read as a "
    "horizontal task at desk height, also corridors and shelves";

struct Imported {
  std::optional<ImportedPack> pack;
  std::vector<std::string> messages;  // but kNoPlane
};

Imported imported(const std::string& csv) {
  std::string like;
  for (const std::string_view text : builtin_pack_texts()) {
    if (text.find("id=\"en12464-1\" edition=\"2021\"") != std::string_view::npos) like = text;
  }
  calc::Diagnostics diagnostics;
  Imported result{import_rows(csv, "rows.csv", like, "mine", diagnostics), {}};
  for (const calc::Diagnostic& d : diagnostics.all()) {
    const std::string message = format_diagnostic(d);
    if (message != kNoPlane) result.messages.push_back(message);
  }
  return result;
}

RulePack pack_of(const std::string& csv) {
  const Imported result = imported(csv);
  EXPECT_THAT(result.messages, ElementsAre());
  calc::Diagnostics diagnostics;
  const std::string text = result.pack ? result.pack->text : "";
  return parse_rule_pack(text, "mine.xml", diagnostics).value_or(RulePack{});
}

// A table of few columns: every one that is a warning to miss.
const std::string kShort = "ref,name,plane,Em,Em mod,Uo,Ra,UGR,Ez,E wall,E ceiling,notes\n";

std::vector<std::string> messages_of(const std::string& row) {
  return imported(kShort + row + "\n").messages;
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

// Of a row that only the shipped pack has.
TEST(ImportRows, NumbersForRowsThatTheTableLacksAreLeftOut) {
  const std::string desk = "desk,,500,,0.6,80,19,,,,\n";
  const RulePack without = pack_of(kShort + "5," + desk), with = pack_of(kShort + "34.2," + desk);
  EXPECT_TRUE(without.find_check("wall.Em")->specials.empty());
  EXPECT_EQ(without.find_check("task.Uo")->specials.size(), 1u);
  EXPECT_NE(with.find_check("wall.Em")->find_special(calc::SpecialPlace::other_wall,
                                                     with.find_row("34.2")),
            nullptr);
}

TEST(ImportRows, LeavesOutWhatIsNotInTheStandard) {
  const Imported result = imported(kHeader +
                                   "1.1,derived,G,a,500,,0.6,80,19,,,,,A,,\n"
                                   ",derived,G,b,500,,0.6,80,19,,,,,A,,\n"
                                   "1.3,dropped_in_final,G,c,500,,0.6,80,19,,,,,A,,\n");
  EXPECT_TRUE(result.pack.has_value());
  EXPECT_EQ(result.pack->rows, 1);
  EXPECT_EQ(result.pack->left_out, 2);
  EXPECT_THAT(result.messages,
              ElementsAre("rows.csv:3: warning[rule-import-skipped]: row 'b' was left out: the row "
                          "has no final_ref",
                          "rows.csv:4: warning[rule-import-skipped]: row '1.3' was left out: the "
                          "row is not in the published edition"));
}

TEST(ImportRowsMessage, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(imported("").messages, ElementsAre("rows.csv: error[rule-import]: the file needs a "
                                                 "line of column names and at least one row"));
  EXPECT_THAT(imported("final_ref,activity\n1,a\n").messages,
              ElementsAre("rows.csv:1: error[rule-import]: column 'Em_lx' is missing; 'luxgate "
                          "rules import --help' lists its allowed names"));
  EXPECT_THAT(
      imported(kHeader + "1,a\n").messages,
      ElementsAre("rows.csv:2: error[rule-import]: the row has 2 fields, the first line has 16"));
  EXPECT_THAT(imported(kHeader + "1,d,G,a,5oo,,0.6,80,19,,,,,A,,\n").messages,
              ElementsAre("rows.csv:2: error[rule-import]: column 'Em_required_lx': '5oo' is not "
                          "a number"));
  EXPECT_THAT(imported(kHeader + "1,d,G,\"a\n").messages,
              ElementsAre("rows.csv:2:7: error[rule-import]: a quote is not closed"));
  EXPECT_THAT(
      imported("trust," + kHeader + "A,1,d,G,a,500,,0.6,80,19,,,,,A,,\n").messages,
      ElementsAre(
          "rows.csv:1: error[rule-import]: column 'trust' is given twice, also as 'trust'"));
  const Imported twice =
      imported(kHeader + "1,d,G,a,50,,0.6,80,19,,,,,A,,\n1,d,G,b,50,,0.6,80,19,,,,,A,,\n");
  EXPECT_FALSE(twice.pack.has_value());
  EXPECT_THAT(twice.messages, ElementsAre("rows.csv:3: error[rule-import]: the pack has two <row> "
                                          "with the name '1'; names must be unique"));
  EXPECT_THAT(
      imported(kHeader + "1,d,G,a,50,,0.6,80,19,,,,,A,,\n2,d,G,b,-5,,0.6,80,19,,,,,A,,\n").messages,
      ElementsAre(testing::StartsWith("rows.csv:3: error[rule-import]: ")));
}

TEST(ImportRows, KeepsWhereTheTaskIs) {
  const Imported result = imported(kShort +
                                   "1,aisle,Floor,100,,0.4,40,25,,,,\n"
                                   "2,desk,horizontal task plane,500,,0.6,80,19,,,,\n"
                                   "3,bench,1.1 m,500,,0.6,80,19,,,,\n"
                                   "4,shelf,shelf 0.3 to 2 m,200,300,0.5,80,25,50,,,\n"
                                   "5,board,vertical,500,,0.7,80,19,,,,\n");
  EXPECT_THAT(result.messages, ElementsAre());
  ASSERT_TRUE(result.pack.has_value());
  EXPECT_EQ(result.pack->floor_rows, 1);
  EXPECT_EQ(result.pack->upright_rows, 2);
  calc::Diagnostics diagnostics;
  const RulePack pack = parse_rule_pack(result.pack->text, "mine.xml", diagnostics).value();
  const RulePlane& task = *pack.find_plane("task");
  const auto heights = [&](const char* ref, const RulePlane& plane) {
    const RuleRow::Heights found = heights_of(plane, pack.find_row(ref)).value();
    return std::pair(found.lowest_m, found.highest_m);
  };
  EXPECT_EQ(heights("1", task), std::pair(0.0, 0.2));
  EXPECT_EQ(heights("2", task), std::pair(0.72, 0.85));
  EXPECT_EQ(heights("3", task), std::pair(1.1, 1.1));
  EXPECT_EQ(heights("4", task), std::pair(0.3, 2.0));
  EXPECT_FALSE(heights_of(task, pack.find_row("5")).has_value());
  const auto orientation = [&](const char* ref) {
    return orientation_of(task, pack.find_row(ref));
  };
  EXPECT_EQ(orientation("3"), "horizontal-up");
  EXPECT_EQ(orientation("4"), "vertical");
  EXPECT_EQ(orientation("5"), "vertical");
}

TEST(ImportRows, HoldsAnUprightTaskAgainstUprightPlanesOnly) {
  const RulePack pack =
      pack_of(kShort + "4,shelf,shelf,200,300,0.5,80,25,50,,,\n5,desk,,500,,0.6,80,19,,,,\n");
  const auto orientation = [&](const char* ref, const char* role) {
    return orientation_of(*pack.find_plane(role), pack.find_row(ref));
  };
  for (const char* role : {"task", "surround"}) {
    EXPECT_EQ(orientation("4", role), "vertical") << role;
    EXPECT_EQ(orientation("5", role), "horizontal-up") << role;
  }
  for (const char* role : {"background", "cylinder"}) {
    EXPECT_EQ(orientation("4", role), "horizontal-up") << role;
  }
  EXPECT_EQ(pack.find_row("4")->find_value("Em")->modified, 300.0);
  EXPECT_EQ(pack.find_row("4")->find_value("Ez")->required, 50.0);
}

TEST(ImportRowsMessage, RefusesNumbersThatMeanNothing) {
  EXPECT_THAT(messages_of("1,a,,0,,0.6,80,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: row '1', column 'Em': 0 lx requires "
                          "nothing: every plane passes"));
  EXPECT_THAT(messages_of("1,a,shelf,0,,0.6,80,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: row '1', column 'Em': 0 lx requires "
                          "nothing: every plane passes"));
  EXPECT_THAT(
      messages_of("1,a,,,,0.6,80,19,,,,"),
      ElementsAre("rows.csv:2: error[rule-import]: column 'Em' is empty; state in 'notes' why "
                  "the row requires no illuminance of its task, or delete the row"));
  EXPECT_THAT(messages_of("1,a,,,,,80,,,,,see the museum's own rules"), ElementsAre());
  EXPECT_THAT(
      messages_of("1,a,,,500,0.6,80,19,,,,why not"),
      ElementsAre("rows.csv:2: error[rule-import]: column 'Em' is empty, but column 'Em mod' "
                  "is not"));
  EXPECT_THAT(messages_of("1,a,,500,300,0.6,80,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: row '1', column 'Em mod': 300 lx at the "
                          "level 'modified' is below the required 500 lx"));
  EXPECT_THAT(messages_of("1,a,,500,,6,80,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: row '1', column 'Uo': 6 is out of "
                          "range; allowed: 0 to 1"));
  EXPECT_THAT(messages_of("1,a,,500,,0.6,800,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: row '1', column 'Ra': 800 is out of "
                          "range; allowed: 0 to 100"));
  EXPECT_THAT(messages_of("1,a,on the moon,500,,0.6,80,19,,,,"),
              ElementsAre(testing::StartsWith("rows.csv:2: error[rule-import]: column 'plane': "
                                              "unknown place 'on the moon'; allowed: ")));
}

// 1.000 of a German table is a thousand, and a row of 1 lx would pass nearly everywhere.
TEST(ImportRowsMessage, RefusesPointsThatMayStandBetweenThousands) {
  EXPECT_THAT(messages_of("1,a,desk,1.000,,0.7,80,19,,,,"),
              ElementsAre("rows.csv:2: error[rule-import]: column 'Em': '1.000' is ambiguous, 1 or "
                          "1000; write it without three digits after a point"));
  EXPECT_THAT(
      messages_of("1,a,desk,500,1.500,0.7,80,19,,,,"),
      ElementsAre(testing::HasSubstr("column 'Em mod': '1.500' is ambiguous, 1.5 or 1500")));
  EXPECT_THAT(messages_of("1,a,desk,500,,1.000,80,19,,,,"),
              ElementsAre(testing::HasSubstr("column 'Uo': '1.000' is ambiguous, 1 or 1000")));
  EXPECT_THAT(messages_of("1,a,desk,500.0,,0.700,80,19.00,,,,"), ElementsAre());
}

TEST(ImportRowsMessage, WarnsOfUnusualNumbers) {
  EXPECT_THAT(messages_of("1,a,,510,,0.6,80,19,,,,"),
              ElementsAre("rows.csv:2: warning[rule-import-doubtful]: row '1', column 'Em': 510 lx "
                          "is not a step of the scale 'steps'; nearest: 500 lx and 750 lx"));
  EXPECT_THAT(messages_of("1,a,,500,8000,0.6,80,19,,,,"),
              ElementsAre("rows.csv:2: warning[rule-import-doubtful]: row '1', column 'Em mod': "
                          "8000 lx is not a step of the scale 'steps'; nearest: 7500 lx"));
  EXPECT_THAT(
      messages_of("1,a,,500,,0.6,80,190,,,,"),
      ElementsAre("rows.csv:2: warning[rule-import-doubtful]: row '1', column 'UGR': 190 is "
                  "unusual; usual are 10 to 30"));
}

TEST(ImportRowsMessage, NamesColumnsThatAreUnknownOrMissing) {
  EXPECT_THAT(
      imported("ref,name,plane,Em,Uo,Ra,RUGL,Ez,E wall,unifromity,colour\n"
               "1,a,,500,0.6,80,19,,,0.6,red\n")
          .messages,
      ElementsAre("rows.csv:1: warning[rule-import-doubtful]: unknown column 'unifromity' is "
                  "ignored; did you mean 'Uo'?",
                  "rows.csv:1: warning[rule-import-doubtful]: unknown column 'colour' is ignored",
                  "rows.csv:1: warning[rule-import-doubtful]: column Eceiling_lx is missing; no "
                  "row requires its value"));
  EXPECT_THAT(
      imported("ref,name,Em,E_m\n1,a,500,500\n").messages,
      ElementsAre("rows.csv:1: error[rule-import]: column 'E_m' is given twice, also as 'Em_lx'"));
}

}  // namespace
}  // namespace rules::import_rows_test
