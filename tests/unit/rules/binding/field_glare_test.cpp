// GR as it is asked for: with the field's reflectance, on the area that it is about.
#include "calc/glare/field_glare.h"
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace rules::field_glare_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFlood =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 -1 1 3 1 1 2 0.4 0.4 0\n1 1 1000\n0 60 90\n0\n20000 30000 500\n";

struct Field {
  std::vector<Requirement> requirements;
  std::vector<std::string> messages;
};

Field bind_field(const std::string& require,
                 const std::string& plane = "origin='0 0 0' u='40 0 0' v='0 20 0'",
                 const std::string& beside = "") {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='flood' "
      "photometry='flood.ies'/><scene id='half'><dim group='g' level='0.5'/></scene>"
      "<luminaire-grid id='m' type='flood' origin='-10 -10 12' size='60 40' columns='2' rows='2' "
      "group='g'/>" +
      beside + "<plane id='p' " + plane + ">" + require + "</plane></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"flood.ies", kFlood}});
  Field field;
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  for (const auto& d : diagnostics.all()) field.messages.push_back(format_diagnostic(d));
  if (judged) field.requirements = std::move(judged->requirements);
  return field;
}

const std::string kTask = "<require pack='en12464-2' row='5.9-medium'/>";

TEST(FieldGlareRequirement, HasTheVeilAndSaysHow) {
  const Field field = bind_field(
      "<require quantity='GR' at-most='50' reflectance='0.2'/><require id='dim' quantity='GR' "
      "at-most='50' reflectance='0.2' scene='half'/>");
  EXPECT_THAT(field.messages, IsEmpty());
  ASSERT_EQ(field.requirements.size(), 2u);
  const Requirement& full = field.requirements[0];
  EXPECT_EQ(full.problem, "");
  EXPECT_EQ(full.metric, Metric::glare_rating);
  EXPECT_EQ(full.state, LightState::initial);
  const auto& lit = std::get<LitField>(full.arguments);
  const auto& dimmed = std::get<LitField>(field.requirements[1].arguments);
  EXPECT_EQ(lit.reflectance, 0.2);
  EXPECT_GT(lit.veiling_cd_m2.value, 0.0);
  EXPECT_NEAR(dimmed.veiling_cd_m2.value, 0.5 * lit.veiling_cd_m2.value, 1e-12);
  EXPECT_THAT(full.note.english(), HasSubstr("field reflectance 0.2, stated, not calculated"));
  EXPECT_STREQ(unit_of(full), "");
}

// It passed: nobody is dazzled by what is not there.
TEST(FieldGlareRequirement, IsNotOfAFieldWithoutLuminaires) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><plane id='p' origin='0 0 0' u='40 0 0' v='0 "
      "20 0'><require quantity='GR' at-most='50' reflectance='0.2'/></plane></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}});
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  ASSERT_TRUE(judged.has_value());
  EXPECT_THAT(judged->requirements.at(0).problem.english(),
              HasSubstr("the space has no luminaire"));
}

TEST(FieldGlareRequirement, NeedsAReflectance) {
  const Field own = bind_field("<require quantity='GR' at-most='50'/>");
  EXPECT_THAT(own.messages, ElementsAre(HasSubstr("needs the attribute 'reflectance'")));
  const Field row =
      bind_field(kTask + "<require pack='en12464-2' row='5.9-medium' role='observer'/>");
  ASSERT_EQ(row.requirements.size(), 3u) << testing::PrintToString(row.messages);
  EXPECT_THAT(row.requirements[2].problem.english(),
              HasSubstr("the reflectance of the field is not stated"));
  for (const std::string wrong : {"0", "1.1", "-0.2"}) {
    EXPECT_THAT(
        bind_field("<require quantity='GR' at-most='50' reflectance='" + wrong + "'/>").messages,
        ElementsAre(HasSubstr("attribute 'reflectance'")));
  }
  EXPECT_THAT(bind_field("<require quantity='average' at-least='5' reflectance='0.2'/>").messages,
              ElementsAre(HasSubstr("'reflectance' has no meaning")));
  EXPECT_THAT(bind_field("<require pack='en12464-2' row='5.9-medium' reflectance='0.2'/>").messages,
              ElementsAre(HasSubstr("'reflectance' has no meaning")));
}

TEST(FieldGlareRequirement, OfARowIsOnTheAreaOfTheRow) {
  const std::string glare =
      "<require pack='en12464-2' row='5.9-medium' role='observer' reflectance='0.2'/>";
  const Field with = bind_field(kTask + glare);
  ASSERT_EQ(with.requirements.size(), 3u) << testing::PrintToString(with.messages);
  EXPECT_EQ(with.requirements[2].problem, "");
  EXPECT_EQ(with.requirements[2].limit, 50.0);
  const Field before = bind_field(glare + kTask);
  EXPECT_EQ(before.requirements.at(0).problem, "");
  const Field without = bind_field(glare);
  EXPECT_THAT(without.requirements.at(0).problem.english(),
              HasSubstr("require the row of this plane as well"));
  const Field other = bind_field("<require pack='en12464-2' row='5.9-heavy'/>" + glare);
  EXPECT_THAT(other.requirements.at(2).problem.english(),
              HasSubstr("require the row of this plane as well"));
}

// A road's luminaires go on, and GR counts all that are in view.
TEST(FieldGlareRequirement, IsNotOfRoads) {
  const std::string xml =
      "<luxgate version='1' maintenance-factor='0.8'><luminaire-type id='flood' "
      "photometry='flood.ies'/><road id='a' width='7' lanes='2' spacing='40' surface='R3'>"
      "<luminaire-row id='r' type='flood' side='right' height='8'/><require quantity='GR' "
      "at-most='55' reflectance='0.1'/></road></luxgate>";
  calc::Diagnostics diagnostics;
  const calc::MemoryFileReader files({{"p.xml", xml}, {"flood.ies", kFlood}});
  auto judged = load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
  ASSERT_TRUE(judged.has_value());
  EXPECT_THAT(judged->requirements.at(0).problem.english(), HasSubstr("a road does not qualify"));
}

// Before anything is judged, nobody can stop it.
TEST(FieldGlareRequirement, EndsWhereItWouldTakeMinutes) {
  const std::string require = "<require quantity='GR' at-most='50' reflectance='0.2'/>";
  const std::string area = "origin='0 0 0' u='40 0 0' v='0 20 0' ";
  EXPECT_EQ(bind_field(require, area + "count='100 100'").requirements.at(0).problem, "");
  EXPECT_THAT(bind_field("<require quantity='GR' at-most='50' reflectance='0.2'/>",
                         area + "count='1000 1000'",
                         "<luminaire-grid id='n' type='flood' origin='0 0 9' size='9 9' "
                         "columns='2' rows='2'/>")
                  .requirements.at(0)
                  .problem.english(),
              HasSubstr("are too many: at most"));
}

TEST(FieldGlareRequirement, IsOfLevelAreas) {
  const std::string require = "<require quantity='GR' at-most='50' reflectance='0.2'/>";
  for (const std::string plane :
       {"origin='0 0 0' u='40 0 0' v='0 0 4'", "origin='0 0 0' u='0 20 0' v='40 0 0'",
        "origin='0 0 0' u='40 0 0' v='0 20 0' quantity='hemispherical'"}) {
    const Field field = bind_field(require, plane);
    ASSERT_EQ(field.requirements.size(), 1u) << testing::PrintToString(field.messages);
    EXPECT_THAT(field.requirements[0].problem.english(), HasSubstr("GR needs a level area"))
        << plane;
  }
}

}  // namespace
}  // namespace rules::field_glare_test
