// What is asked of the rooms of a building together, by hand.

#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge_buildings.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::buildings_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// 100 cd in all directions, so many watts.
std::string lamp(const std::string& watts) {
  return "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 " +
         watts + "\n0 90 180\n0\n100 100 100\n";
}

std::string room(const std::string& id, const std::string& size, const std::string& type,
                 const std::string& inside = "", const std::string& origin = "0 50 0") {
  return "<room id='" + id + "' origin='" + origin + "' size='" + size +
         " 3' floor='m' ceiling='m' walls='m'>" + inside + "<luminaire id='L' type='" + type +
         "' position='1 1 2.5'/></room>";
}

struct Judged {
  std::vector<AggregateFinding> findings;
  std::vector<std::string> messages;
};

// Rooms small (12 m2, 24 W) and large (48 m2, 36 W): 1 W/m2.
Judged judge(const std::string& buildings, const std::string& more = "",
             const std::string& origin_of_large = "0 9 0") {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='1'><material id='m' reflectance='0.5'/>"
      "<luminaire-type id='a' photometry='24.ies'/><luminaire-type id='b' photometry='36.ies'/>"
      "<luminaire-type id='none' photometry='0.ies'/>" +
      room("small", "4 3", "a", "", "0 0 0") + room("large", "8 6", "b", "", origin_of_large) +
      more + buildings + "</luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files(
      {{"p.xml", xml}, {"24.ies", lamp("24")}, {"36.ies", lamp("36")}, {"0.ies", lamp("0")}});
  Judged judged;
  const auto loaded = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const auto& d : diagnostics.all()) judged.messages.push_back(format_diagnostic(d));
  if (loaded) judged.findings = judge_buildings(loaded->project, loaded->buildings, "2026-11-26");
  return judged;
}

AggregateFinding one(const std::string& require, const std::string& more = "",
                     const std::string& rooms = "") {
  const Judged judged = judge("<building id='B' " + rooms + ">" + require + "</building>", more);
  EXPECT_THAT(judged.findings, SizeIs(1)) << (judged.messages.empty() ? "" : judged.messages[0]);
  return judged.findings.empty() ? AggregateFinding{} : judged.findings[0];
}

std::string power(const std::string& at_most, const std::string& more = "") {
  return "<require quantity='power-density' at-most='" + at_most + "' " + more + "/>";
}

TEST(Buildings, PowerIsThatOfAllRoomsOverAllFloors) {
  const AggregateFinding finding = one(power("1"));
  EXPECT_EQ(finding.verdict, Verdict::pass);
  ASSERT_TRUE(finding.sum);
  EXPECT_DOUBLE_EQ(finding.sum->measured.value, 1.0);  // 60 W / 60 m2, not (2 + 0.75) / 2
  EXPECT_EQ(finding.sum->measured.low, finding.sum->measured.high);
  EXPECT_EQ(finding.id, "B/power-density");
  ASSERT_THAT(finding.members, SizeIs(2));
  EXPECT_EQ(finding.members[0].verdict, Verdict::fail);  // 2 W/m2 by itself
  EXPECT_EQ(finding.members[1].verdict, Verdict::pass);
  EXPECT_EQ(one(power("0.999")).verdict, Verdict::fail);
  EXPECT_DOUBLE_EQ(one(power("0.8")).sum->margin, -0.25);
  EXPECT_EQ(one(power("0.76"), "", "rooms='l*'").verdict, Verdict::pass);
}

constexpr const char* kEnergy =
    "<energy day-hours='1000' night-hours='500' parasitic-kwh-m2='0.5'/>";

TEST(Buildings, EnergyIsThatOfAllRoomsOverAllFloors) {
  // 60 W 1500 h = 90 kWh; / 60 m2 = 1.5, and 0.5.
  const AggregateFinding finding = one("<require quantity='LENI' at-most='2'/>", kEnergy);
  EXPECT_EQ(finding.verdict, Verdict::pass);
  EXPECT_DOUBLE_EQ(finding.sum->measured.value, 2.0);
  EXPECT_THAT(finding.note.english(), HasSubstr("1000 h by day, 500 h by night"));
  EXPECT_THAT(finding.members[0].stated.english(), HasSubstr("1000 h by day"));
  // A room with hours of its own: 24 W 100 h = 2.4 kWh, 0 parasitic; 36 W 1500 h = 54 kWh, 0.5 48 =
  // 24 kWh; 80.4 kWh / 60 m2 without the third room, whose 12 m2 and 2.4 kWh make 82.8 / 72.
  const AggregateFinding both =
      one("<require quantity='LENI' at-most='1.15'/>",
          kEnergy + room("own", "4 3", "a",
                         "<energy day-hours='100' night-hours='0' parasitic-kwh-m2='0'/>"),
          "rooms='large own'");
  EXPECT_NEAR(both.sum->measured.value, (54.0 + 24.0 + 2.4) / 60.0, 1e-12);
  EXPECT_EQ(both.verdict, Verdict::fail);
  EXPECT_THAT(both.note.english(), HasSubstr("100 h by day"));
  EXPECT_THAT(both.note.english(), HasSubstr("1000 h by day"));
}

// Nothing is said of all rooms where one is not known, and never is it a pass.
TEST(Buildings, WithAnUnknownRoomAreNotJudged) {
  const AggregateFinding power_of = one(power("1000"), room("dark", "4 3", "none"));
  EXPECT_EQ(power_of.verdict, Verdict::not_judged);
  EXPECT_THAT(power_of.reason.english(), HasSubstr("not judged: dark ("));
  EXPECT_EQ(power_of.members.at(2).verdict, Verdict::not_judged);
  const AggregateFinding energy = one("<require quantity='LENI' at-most='1000'/>");
  EXPECT_EQ(energy.verdict, Verdict::not_judged);
  EXPECT_THAT(energy.reason.english(), HasSubstr("small ("));
  EXPECT_THAT(energy.reason.english(), HasSubstr("large ("));
}

// Their common floor would count twice. Rooms of judge() begin at the origin, both of them.
TEST(Buildings, OfRoomsThatOverlapAreNotJudged) {
  const Judged judged = judge("<building id='B'>" + power("1000") + "</building>", "", "0 0 0");
  ASSERT_THAT(judged.findings, SizeIs(1));
  EXPECT_EQ(judged.findings[0].verdict, Verdict::not_judged);
  EXPECT_THAT(judged.findings[0].reason.english(), HasSubstr("rooms 'small' and 'large' overlap"));
}

TEST(Buildings, SayThatLightOutsideOfRoomsDoesNotCount) {
  const AggregateFinding finding =
      one(power("1"), "<luminaire id='yard' type='a' position='0 -9 3'/>");
  EXPECT_DOUBLE_EQ(finding.sum->measured.value, 1.0);
  EXPECT_THAT(finding.note.english(), HasSubstr("luminaires outside rooms do not count: 1"));
  EXPECT_THAT(one(power("1")).note.english(), IsEmpty());
}

TEST(Buildings, AreWaivedForATime) {
  const std::string waiver = "waived-because='w' waived-by='A. Meier' waived-until=";
  EXPECT_TRUE(one(power("0.5", waiver + "'2026-11-26'")).is_waived);
  EXPECT_EQ(one(power("0.5", waiver + "'2026-11-26'")).verdict, Verdict::fail);
  EXPECT_FALSE(one(power("0.5", waiver + "'2026-11-25'")).is_waived);
  EXPECT_THAT(one(power("0.5", waiver + "'2026-11-25'")).reason.english(), HasSubstr("2026-11-25"));
}

// 0.15 W/ft2 = 1.6146 W/m2.
TEST(Buildings, AreAskedRowsOfPacks) {
  const AggregateFinding finding = one("<require pack='ashrae90-1' row='parking'/>");
  EXPECT_EQ(finding.verdict, Verdict::pass);
  EXPECT_NEAR(finding.sum->requirement.limit, 1.6146, 1e-4);
  EXPECT_THAT(finding.clause.english(), HasSubstr("ASHRAE 90.1:2019 parking"));
  EXPECT_THAT(finding.note.english(), HasSubstr("one public source"));
}

TEST(Buildings, RefuseWhatRoomsDoNotHaveTogether) {
  for (const char* wrong : {"<require quantity='average' at-least='1'/>",
                            "<require quantity='UGR-table' at-most='19'/>",
                            "<require quantity='power-per-100-lx' at-most='2'/>",
                            "<require pack='en12464-1:2021' row='34.2'/>"}) {
    const Judged judged = judge("<building id='B'>" + std::string(wrong) + "</building>");
    EXPECT_THAT(judged.findings, IsEmpty()) << wrong;
    EXPECT_THAT(judged.messages, Contains(HasSubstr("allowed: power-density, LENI"))) << wrong;
  }
  EXPECT_THAT(
      judge("<building id='B'>" + power("1", "id='x'") + power("2", "id='x'") + "</building>")
          .messages,
      Contains(HasSubstr("the requirement id 'x' is given twice")));
}

TEST(Buildings, RefuseWhatMeansNothingOfThem) {
  EXPECT_THAT(judge("<building id='B'/>").messages, Contains(HasSubstr("a <require> that all")));
  EXPECT_THAT(judge("<building id='B'><require pack='ashrae90-1' row='parking'><deviation "
                    "in='height' because='b' by='c' until='2999-12-31'/></require></building>")
                  .messages,
              Contains(HasSubstr("a <building> has no points and cannot have a <deviation>")));
}

TEST(Buildings, NumberRequirementsThatHaveNoId) {
  const Judged judged = judge("<building id='B'>" + power("1") + power("2") +
                              "</building><building id='C'>" + power("1") + "</building>");
  std::vector<std::string> ids;
  for (const AggregateFinding& finding : judged.findings) ids.push_back(finding.id);
  EXPECT_THAT(ids, ElementsAre("B/power-density", "B/power-density-2", "C/power-density"));
}

}  // namespace
}  // namespace rules::buildings_test
