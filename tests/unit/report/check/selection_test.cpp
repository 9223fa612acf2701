#include "report/check/selection.h"

#include "report/check/check_project.h"
#include "report/document/document.h"
#include "tests/support/memory_file_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace selection_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Two offices and a store; what the store's plane requires fails in any light, and so does the sum
// of the building.
constexpr const char* kProject = R"(<luxgate version="1" maintenance-factor="0.8">
  <material id="grey" reflectance="0.5"/>
  <luminaire-type id="ball" photometry="ball.ies" power-w="20"/>
  <building id="house" rooms="*"><require quantity="power-density" at-most="0.001"/></building>
  <room id="office-1" name="Accounts" size="4 4 3" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="L1" type="ball" position="2 2 2.5"/>
    <plane id="desk" height="0.8" count="2 2">
      <require id="mean" quantity="average" at-least="1"/>
      <require id="even" quantity="Uo" at-least="0.01"/>
    </plane>
    <plane id="board" tags="upright teaching" height="1" count="1 1"/>
  </room>
  <room id="office-2" name="Sales" tags="tenant-B teaching" size="4 4 3" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="L2" type="ball" position="2 2 2.5"/>
    <plane id="desk-2" height="0.8" count="2 2">
      <require id="mean" quantity="average" at-least="1"/>
    </plane>
  </room>
  <room id="store" size="4 4 3" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="L3" type="ball" position="2 2 2.5"/>
    <plane id="floor" height="0.1" count="2 2">
      <require id="mean" quantity="average" at-least="90000"/>
    </plane>
  </room>
</luxgate>
)";

constexpr const char* kBall =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
    "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 20\n0 180\n0\n100 100\n";

struct Chosen {
  std::vector<std::string> names;  // "office-1/desk/mean"; "office-1/board" of a plane by itself
  std::string messages;
};

Chosen chosen(const check::Selection& selection) {
  const calc::MemoryFileReader files({{"p.xml", kProject}, {"ball.ies", kBall}});
  calc::Diagnostics diagnostics;
  auto judged =
      rules::load_judged_project(files, "p.xml", rules::builtin_rule_packs(), diagnostics);
  Chosen result;
  if (!judged) {
    ADD_FAILURE() << diagnostics.all().size() << " errors";
    return result;
  }
  calc::Diagnostics own;
  check::select(selection, *judged, own);
  for (const calc::Space& space : judged->project.spaces) {
    for (const calc::CalcPlane& plane : space.planes) {
      bool is_asked = false;
      for (const rules::Requirement& requirement : judged->requirements) {
        if (requirement.plane_id != plane.id) continue;
        result.names.push_back(space.id + "/" + plane.id + "/" + requirement.id);
        is_asked = true;
      }
      if (!is_asked) result.names.push_back(space.id + "/" + plane.id);
    }
  }
  if (!selection.is_all()) {
    EXPECT_THAT(judged->buildings, IsEmpty());
  }
  for (const calc::Diagnostic& d : own.all()) result.messages += calc::format_diagnostic(d) + "\n";
  return result;
}

TEST(Selection, AllIsAllWithoutAWord) {
  const Chosen all = chosen({});
  EXPECT_THAT(all.names, ElementsAre("office-1/desk/mean", "office-1/desk/even", "office-1/board",
                                     "office-2/desk-2/mean", "store/floor/mean"));
  EXPECT_EQ(all.messages, "");
}

TEST(Selection, SpacesGoByIdAndName) {
  const Chosen offices = chosen({{"office-*"}, {}, {}});
  EXPECT_THAT(offices.names, ElementsAre("office-1/desk/mean", "office-1/desk/even",
                                         "office-1/board", "office-2/desk-2/mean"));
  EXPECT_THAT(offices.messages, HasSubstr("only 3 of 5 requirements were chosen, by --space "
                                          "'office-*'; the others are neither met nor missed"));
  EXPECT_THAT(chosen({{"Sales", "store"}, {}, {}}).names,
              ElementsAre("office-2/desk-2/mean", "store/floor/mean"));
}

TEST(Selection, PlanesAndRequirementsOfThem) {
  EXPECT_THAT(chosen({{}, {"board"}, {}}).names, ElementsAre("office-1/board"));
  EXPECT_THAT(chosen({{}, {"desk*"}, {"Uo"}}).names, ElementsAre("office-1/desk/even"));
  // A plane of which nothing is chosen is not calculated.
  EXPECT_THAT(chosen({{"office-1"}, {}, {"mean"}}).names, ElementsAre("office-1/desk/mean"));
}

TEST(Selection, TagsArePlanesOwnAndThoseOfTheirSpaces) {
  EXPECT_THAT(chosen({{}, {}, {}, {"teaching"}}).names,
              ElementsAre("office-1/board", "office-2/desk-2/mean"));
  EXPECT_THAT(chosen({{}, {}, {"mean"}, {"tenant-?"}}).names, ElementsAre("office-2/desk-2/mean"));
  EXPECT_THAT(chosen({{"office-1"}, {}, {}, {"teach*"}}).names, ElementsAre("office-1/board"));
  EXPECT_THAT(chosen({{"store"}, {}, {}, {"teaching"}}).messages, HasSubstr("there are no tags"));
  EXPECT_THAT(chosen({{}, {}, {}, {"teacher"}}).messages,
              HasSubstr("there are the tags upright, teaching, tenant-B"));
}

// What they asked counts as not judged once the last day is over: not known here, and not lost.
TEST(Selection, ZonesThatAreLeftOutStay) {
  const std::string text = R"(<luxgate version="1" maintenance-factor="0.8">
  <material id="grey" reflectance="0.5"/>
  <luminaire-type id="ball" photometry="ball.ies" power-w="20"/>
  <room id="office" size="6 5 3" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="L1" type="ball" position="2 2 2.5"/>
    <workplace id="w" pack="en12464-1:2021" row="34.2" origin="2 2" size="2 1" tags="quiet">
      <without role="ceiling" because="b" by="m" until="2020-01-01"/>
    </workplace>
  </room>
</luxgate>
)";
  const auto left_out = [&](const check::Selection& selection) {
    const calc::MemoryFileReader files({{"p.xml", text}, {"ball.ies", kBall}});
    calc::Diagnostics diagnostics, own;
    auto judged =
        rules::load_judged_project(files, "p.xml", rules::builtin_rule_packs(), diagnostics);
    std::vector<std::string> ids;
    if (!judged) return std::vector<std::string>{"not loaded"};
    check::select(selection, *judged, own);
    for (const calc::Space& space : judged->project.spaces) {
      for (const calc::LeftOutPlane& one : space.left_out) ids.push_back(one.plane.id);
    }
    return ids;
  };
  EXPECT_THAT(left_out({{}, {"w.ceiling"}, {}}), ElementsAre("w.ceiling"));
  EXPECT_THAT(left_out({{}, {}, {}, {"quiet"}}), ElementsAre("w.ceiling"));
  EXPECT_THAT(left_out({{}, {}, {"Uo"}}), ElementsAre("w.ceiling"));
  EXPECT_THAT(left_out({{}, {"w.task"}, {}}), IsEmpty());
  EXPECT_THAT(left_out({{}, {}, {}, {"loud"}}), IsEmpty());
  EXPECT_THAT(left_out({{}, {}, {"no-such"}}), IsEmpty());
}

TEST(Selection, NothingIsToldWithWhatThereIs) {
  const Chosen planes = chosen({{"office-*"}, {"dsk"}, {}});
  EXPECT_THAT(planes.names, IsEmpty());
  EXPECT_THAT(planes.messages,
              HasSubstr("chooses nothing here; there are the planes desk, board, desk-2"));
  EXPECT_THAT(chosen({{"attic"}, {}, {}}).messages,
              HasSubstr("there are the spaces office-1, office-2, store"));
  EXPECT_THAT(chosen({{}, {"desk"}, {"min"}}).messages,
              HasSubstr("there are the requirements mean, even"));
}

TEST(Selection, WordsAreThoseOfTheCommandLine) {
  EXPECT_EQ(check::selection_words({{"a b"}, {"desk-*", "x"}, {"Uo"}, {"t"}}),
            "--space 'a b' --plane 'desk-*' --plane x --require Uo --tag t");
  EXPECT_EQ(check::selection_words({}), "");
}

}  // namespace
}  // namespace selection_test
