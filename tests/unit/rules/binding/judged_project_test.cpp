#include "rules/binding/judged_project.h"
#include "calc/base/diagnostic_ids.h"
#include "tests/support/memory_file_reader.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace rules::judged_project_test {
namespace {

using calc::tests::in_project;
using calc::tests::in_room;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Judged {
  std::optional<JudgedProject> project;
  std::vector<std::string> messages;
};

Judged load(const std::string& xml) {
  calc::Diagnostics diagnostics;
  Judged judged;
  judged.project = load_judged_project(calc::tests::files_for_messages(xml), "dir/p.xml",
                                       builtin_rule_packs(), diagnostics);
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    judged.messages.push_back(format_diagnostic(diagnostic));
  }
  return judged;
}

// "line error-id" of each message.
std::vector<std::string> places(const Judged& judged) {
  std::vector<std::string> found;
  for (const std::string& message : judged.messages) {
    const std::size_t line = message.find(':') + 1;
    const std::size_t id = message.find('[') + 1;
    found.push_back(message.substr(line, message.find(':', line) - line) + " " +
                    message.substr(id, message.find(']') - id));
  }
  EXPECT_FALSE(judged.project);
  return found;
}

// The readers, on the files that xmllint checks against the schema.
TEST(LoadJudgedProject, AgreesWithTheSchemaOnTheCorpus) {
  const std::filesystem::path corpus =
      std::filesystem::path(LUXGATE_SOURCE_DIR) / "tests/schema/corpus";
  std::size_t valid = 0, invalid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    const std::string name = entry.path().filename().string();
    const calc::FileContent file = calc::DiskFileReader().read(entry.path().string());
    ASSERT_TRUE(file.ok()) << name << ": " << file.error;
    const Judged judged = load(file.bytes);
    const bool should_be_valid = name.starts_with("valid-");
    ASSERT_TRUE(should_be_valid || name.starts_with("invalid-")) << name;
    EXPECT_EQ(judged.project.has_value(), should_be_valid)
        << name << '\n'
        << testing::PrintToString(judged.messages);
    ++(should_be_valid ? valid : invalid);
  }
  EXPECT_GE(valid, 5u);
  EXPECT_GE(invalid, 15u);
}

TEST(LoadJudgedProject, ErrorsOfShapesAndOfRequirementsComeTogetherInTheOrderOfLines) {
  EXPECT_THAT(places(load(in_room("<plane id='p' height='1'>\n"
                                  "<require quantity='averge' at-leest='1'/>\n"
                                  "<require pack='en12464' row='34.2' level='higher'/></plane>\n"
                                  "<box id='b' size='1 1' material='white'/>\n"
                                  "<plane id='q' height='9'>\n"
                                  "<require quantity='minimum' at-least='lots'/></plane>"))),
              ElementsAre("6 unknown-attribute", "6 unknown-value", "7 unknown-reference",
                          "7 unknown-value", "8 wrong-number-count", "9 number-out-of-range",
                          "10 not-a-number"));
}

TEST(LoadJudgedProject, MessagesAboutOtherFilesKeepTheirPlaces) {
  EXPECT_THAT(load(in_project("<luminaire-type id='t' photometry='broken.ies'/>\n"
                              "<plane id='p' origin='0 0 1' u='1 0 0' v='0 1 0'>"
                              "<require quantity='averge' at-least='1'/></plane>\n"
                              "<material id='m' reflectance='2'/>"))
                  .messages,
              ElementsAre(HasSubstr("p.xml:5"), HasSubstr("broken.ies"), HasSubstr("p.xml:6")));
}

TEST(LoadJudgedProject, WhatAWrongQuantityLeavesOpenIsReadAllTheSame) {
  EXPECT_THAT(load(in_room("<plane id='p' height='1'><require quantity='averge' at-least='lots' "
                           "unit='candela' state='old' percent='101'/></plane>"))
                  .messages,
              ElementsAre(HasSubstr("unknown value 'averge'"), HasSubstr("'lots' is not a finite"),
                          HasSubstr("unknown value 'candela'"), HasSubstr("101 is not allowed"),
                          HasSubstr("unknown value 'old'")));
}

TEST(LoadJudgedProject, NothingFollowsFromAnUnknownQuantityOfAPlane) {
  EXPECT_THAT(places(load(in_room("<plane id='p' height='1' quantity='cylindric'>\n"
                                  "<require pack='en12464-1' row='34.2' role='cylinder'/>\n"
                                  "<require quantity='average' at-least='1'/></plane>"))),
              ElementsAre("5 unknown-value"));
}

TEST(LoadJudgedProject, ScenesWithErrorsMayBeRequiredIn) {
  EXPECT_THAT(places(load(in_project("<scene id='night'><dim group='g' level='2'/></scene>\n"
                                     "<plane id='p' origin='0 0 1' u='1 0 0' v='0 1 0'>"
                                     "<require quantity='average' at-least='1' scene='night'/>"
                                     "</plane><luminaire id='l' type='spot' position='0 0 2' "
                                     "group='g'/>"))),
              ElementsAre("4 number-out-of-range"));
}

TEST(LoadJudgedProject, ElementsInARequirementAreRefused) {
  EXPECT_THAT(places(load(in_room("<plane id='p' height='1'>\n<require quantity='average' "
                                  "at-least='1'>\n<limit/></require></plane>"))),
              ElementsAre("7 unknown-element"));
}

TEST(LoadJudgedProject, WorkplacesAreCheckedBesideOtherErrors) {
  EXPECT_THAT(
      places(load(in_room(
          "<box id='b' size='1 1' material='white'/>\n"
          "<workplace id='v' row='34.2' levl='modified'/>\n"
          "<workplace id='w' pack='en12464-1'/>\n"
          "<workplace id='x' pack='en12464-1' row='34.2' height='-1'>\n"
          "<without role='wal.2' because='glass' by='A. Meier' until='2099-12-31'/></workplace>\n"
          "<workplace id='y' pack='en12464-1' row='34.22' scene='night'/>"))),
      ElementsAre("5 wrong-number-count", "6 unknown-attribute", "6 missing-attribute",
                  "7 missing-attribute", "8 number-out-of-range", "9 unknown-reference",
                  "10 unknown-reference", "10 unknown-reference"));
}

TEST(LoadJudgedProject, WorkplaceInARoomWithoutAShapeIsCheckedAgainstItsPack) {
  EXPECT_THAT(places(load(in_project("<room id='r' size='4 3' ceiling='white' walls='white' "
                                     "floor='white'>\n<workplace id='w' pack='en12464-1' "
                                     "row='34.2' level='higher'/></room>"))),
              ElementsAre("4 wrong-number-count", "5 unknown-value"));
}

TEST(LoadJudgedProject, WorkplaceNeedsPackAndRow) {
  EXPECT_THAT(load(in_room("<workplace id='w'/>")).messages,
              ElementsAre("dir/p.xml:5:1: error[missing-attribute]: <workplace> needs the "
                          "attribute 'row'",
                          "dir/p.xml:5:1: error[missing-attribute]: <workplace> needs the "
                          "attribute 'pack'"));
}

TEST(LoadJudgedProject, GivesTheProjectAndWhatIsRequired) {
  const Judged judged = load(
      in_room("<plane id='p' height='1'><require quantity='average' at-least='1' "
              "state='initial'/></plane>"
              "<workplace id='w' pack='en12464-1:2021' row='34.2' name='Desk' height='0.75'/>"));
  EXPECT_THAT(judged.messages, IsEmpty());
  ASSERT_TRUE(judged.project);
  EXPECT_EQ(judged.project->requirements.front().plane_id, "p");
  // Of planes that a workplace has made, too.
  EXPECT_EQ(judged.project->requirements.back().plane_id.substr(0, 2), "w.");
  EXPECT_EQ(judged.project->requirements.back().where.line, 5);
}

// What is asked without a scene is of all luminaires at full output, also of those that are lit in
// emergencies alone.
TEST(LoadJudgedProject, LightOfEmergenciesInNormalUseIsToldOf) {
  const auto messages = [](const std::string& scene_of_task, const std::string& dims) {
    const std::string xml =
        "<luxgate version='1' maintenance-factor='0.8'><material id='m' reflectance='0.5'/>"
        "<luminaire-type id='spot' photometry='spot.ies'/><scene id='battery'>" +
        dims +
        "</scene><scene id='normal'><dim group='e' level='0'/></scene>"
        "<room id='r' size='8 6 3' floor='m' walls='m' ceiling='m'>"
        "<luminaire id='a' type='spot' position='2 3 2.9' group='g'/>"
        "<luminaire id='b' type='spot' position='6 3 2.9' group='e'/>"
        "<plane id='t' height='0.75' margin='0.5'><require pack='en12464-1:2021' row='34.2'" +
        scene_of_task +
        "/></plane><plane id='o' height='0' margin='0.5'><require pack='en1838:2024' "
        "role='open-area' scene='battery'/></plane></room></luxgate>";
    const calc::MemoryFileReader files(
        {{"p.xml", xml},
         {"spot.ies",
          "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
          "TILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n"}});
    calc::Diagnostics diagnostics;
    load_judged_project(files, "p.xml", builtin_rule_packs(), diagnostics);
    std::vector<std::string> found;
    for (const auto& one : diagnostics.all()) {
      if (one.id == calc::DiagnosticId::emergency_light_counts) found.push_back(one.message);
    }
    return found;
  };
  const std::string battery = "<dim group='g' level='0'/><dim group='e' level='0.3'/>";
  EXPECT_THAT(
      messages("", battery),
      ElementsAre(HasSubstr("'r': requirements without a scene count all luminaires at full "
                            "output, also group 'e' of the emergency scene 'battery'")));
  EXPECT_THAT(messages(" scene='normal'", battery), IsEmpty());
  EXPECT_THAT(messages("", "<dim group='g' level='1'/><dim group='e' level='0.3'/>"), IsEmpty());
}

}  // namespace
}  // namespace rules::judged_project_test
