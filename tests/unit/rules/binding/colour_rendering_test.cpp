// Ra of a room's luminaires, as their makers state it: judged where all do, and nowhere else.
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rules::colour_rendering_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string ies(const std::string& rendering) {
  return "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n" +
         (rendering.empty() ? "" : "[CRI] " + rendering + "\n") +
         "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 100\n0 90\n0\n1000 0\n";
}

struct Bound {
  std::vector<Requirement> rendering;  // of that metric
  std::vector<std::string> messages;
};

// Luminaires 'a' and 'b' of files that state these; 'b' is dark in the scene 'day'. flux_lm: of
// 'b', where the project states another than the file.
Bound bound_of(const std::string& a, const std::string& b, const std::string& asks,
               const std::string& flux_lm = "") {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><material id='m' reflectance='0.5'/>"
      "<luminaire-type id='A' photometry='a.ies'/><luminaire-type id='B' photometry='b.ies'" +
      (flux_lm.empty() ? "" : " flux-lm='" + flux_lm + "'") +
      "/>"
      "<scene id='day'><dim group='night' level='0'/></scene>"
      "<room id='r' size='10 8 3' ceiling='m' walls='m' floor='m'>"
      "<luminaire id='a' type='A' position='3 3 2.9'/>"
      "<luminaire id='b' type='B' position='6 3 2.9' group='night'/>" +
      asks + "</room></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"a.ies", ies(a)}, {"b.ies", ies(b)}});
  Bound bound;
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const auto& d : diagnostics.all()) bound.messages.push_back(format_diagnostic(d));
  if (!judged) return bound;
  for (Requirement& requirement : judged->requirements) {
    if (requirement.metric == Metric::colour_rendering)
      bound.rendering.push_back(std::move(requirement));
  }
  return bound;
}

std::string plane(const std::string& require) {
  return "<plane id='p' origin='1 1 0.75' u='2 0 0' v='0 2 0'>" + require + "</plane>";
}
const std::string kRow = "<require pack='en12464-1:2021' row='34.2'/>";  // Ra 80

TEST(ColourRendering, IsAskedAlongWithTheTaskWhereAllStateIt) {
  for (const std::string& asks :
       {plane(kRow), std::string("<workplace id='w' pack='en12464-1:2021' row='34.2'/>")}) {
    const Bound bound = bound_of("80", "90", asks);
    EXPECT_THAT(bound.messages, IsEmpty());
    ASSERT_EQ(bound.rendering.size(), 1u) << asks;
    const Requirement& asked = bound.rendering[0];
    EXPECT_EQ(asked.limit, 80.0);
    EXPECT_EQ(asked.of_space.value, 80.0);
    EXPECT_EQ(asked.id, "Ra");
    EXPECT_FALSE(asked.origin.is_of_own_role);
    EXPECT_THAT(asked.problem.english(), IsEmpty());
    EXPECT_THAT(asked.note.english(), HasSubstr("manufacturers' value, not calculated"));
    EXPECT_THAT(asked.stated_words.english(), HasSubstr("luminaire type 'A': '80'"));
  }
}

TEST(ColourRendering, TheLeastOfAllDecides) {
  ASSERT_EQ(bound_of("1A", "2A", plane(kRow)).rendering.size(), 1u);
  const calc::Estimate least = bound_of("1A", "2A", plane(kRow)).rendering[0].of_space;
  EXPECT_EQ(least.low, 70.0);
  EXPECT_EQ(least.high, 79.0);
  EXPECT_EQ(bound_of(">70", "1B", plane(kRow)).rendering.size(), 0u);  // 70 to 89 holds the limit
}

TEST(ColourRendering, IsNotJudgedWhereOneStatesNoneOrTooLittle) {
  for (const char* other : {"", "good", "8", "70-90"}) {
    EXPECT_THAT(bound_of("90", other, plane(kRow)).rendering, IsEmpty()) << other;
  }
}

TEST(ColourRendering, OneThatIsTooLowFailsWhateverTheOthersAre) {
  for (const char* other : {"", "good", "70-90"}) {
    const Bound bound = bound_of("60", other, plane(kRow));
    ASSERT_EQ(bound.rendering.size(), 1u) << other;
    EXPECT_LT(bound.rendering[0].of_space.high, 80.0) << other;
    EXPECT_THAT(bound.rendering[0].problem.english(), IsEmpty()) << other;
  }
}

TEST(ColourRendering, ARangeThatHoldsTheLimitDecidesNothing) {
  const std::string own = plane("<require quantity='Ra' at-least='85'/>");
  EXPECT_THAT(bound_of("80-89", "90", own).rendering.at(0).problem.english(), HasSubstr("80-89"));
}

TEST(ColourRendering, AFluxOfTheProjectsOwnIsAnotherLight) {
  const Bound bound = bound_of("90", "90", plane("<require quantity='Ra' at-least='80'/>"), "900");
  EXPECT_THAT(bound.rendering.at(0).problem.english(),
              HasSubstr("changes the flux of luminaire type 'B'"));
  EXPECT_THAT(bound_of("90", "90", plane(kRow), "900").rendering, IsEmpty());
}

TEST(ColourRendering, WhoAsksByNameIsToldWhyNot) {
  const std::string own = plane("<require quantity='Ra' at-least='80'/>");
  EXPECT_EQ(bound_of("80", "85", own).rendering.at(0).of_space.value, 80.0);
  EXPECT_EQ(bound_of("80", "", own).rendering.at(0).problem.english(),
            "the photometry file of luminaire type 'B' states no Ra");
  EXPECT_EQ(bound_of("80", "70-90", own).rendering.at(0).problem.english(),
            "the photometry file of luminaire type 'B' states the colour rendering '70-90', "
            "which does not decide the requirement");
  const std::string role = plane("<require pack='en12464-1:2021' row='34.2' role='lamp'/>");
  EXPECT_EQ(bound_of("80", "", role).rendering.size(), 1u);
  EXPECT_THAT(bound_of("80", "", role).rendering.at(0).problem.english(), HasSubstr("type 'B'"));
}

TEST(ColourRendering, WhatAScenePutsOutDoesNotCount) {
  const std::string asks = plane("<require pack='en12464-1:2021' row='34.2' scene='day'/>");
  EXPECT_EQ(bound_of("90", "", asks).rendering.at(0).of_space.value, 90.0);
}

TEST(ColourRendering, IsWaivedByItsCheck) {
  const Bound bound =
      bound_of("70", "90",
               plane("<require pack='en12464-1:2021' row='34.2'><waiver checks='colour' "
                     "because='stock' by='A. Meier' until='2099-12-31'/></require>"));
  EXPECT_THAT(bound.messages, IsEmpty());
  EXPECT_TRUE(bound.rendering.at(0).waiver);
}

}  // namespace
}  // namespace rules::colour_rendering_test
