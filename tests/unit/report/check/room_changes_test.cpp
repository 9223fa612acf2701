#include "report/check/room_changes.h"

#include "calc/base/xml_document.h"
#include "report/check/text_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace room_changes_test {
namespace {

using ::testing::HasSubstr;

const std::string kText =
    "<luxgate version=\"1\" units=\"cm\"><material id=\"m\" reflectance=\"0.5\"/>\n"
    "<material id=\"lighter\" reflectance=\"0.9\"/>\n"
    "<room id=\"other\" size=\"1 1 1\" floor=\"m\" ceiling=\"m\" walls=\"m\"/>\n"
    "<room id=\"r\" origin=\"100 200 300\" size=\"600 400 280\" floor=\"m\" ceiling=\"m\" "
    "walls=\"m\">\n"
    "<luminaire-line id=\"L\" type=\"t\" from=\"0 1 2\"\n  to=\"6 1 2\" count=\"3\"/>\n"
    "<luminaire id=\"a\" type=\"t\" position=\"1 1 1\"> <!-- </ > --> </luminaire>\n"
    "<box id=\"b\" size=\"1 1 1\" material=\"m\"/></room></luxgate>\n";

check::AddedLuminaire one(const std::string& group) {
  return {"new & 1", "t", {2.0, 4.0, 5.79}, {0, 1, 0}, {0, 0, -1}, group};
}

// Of the text before and after the change.
std::string with(const std::string& before, const std::string& after) {
  std::string text = kText;
  const std::size_t at = text.find(before);
  EXPECT_NE(at, text.npos) << before;
  return text.replace(at, before.size(), after);
}

// In the room's coordinates and the project's unit.
TEST(RoomChanges, AddsLuminaires) {
  const check::ChangedText changed =
      check::with_luminaires(kText, "p.xml", "r", {one(""), one("g")});
  ASSERT_TRUE(changed.text) << changed.problem;
  const std::string element =
      "<luminaire id=\"new &amp; 1\" type=\"t\" position=\"100 200 279\" axis=\"0 0 -1\" "
      "c0=\"0 1 0\"";
  EXPECT_EQ(*changed.text,
            with("walls=\"m\">\n", "walls=\"m\">" + element + "/>" + element + " group=\"g\"/>\n"));
}

// Lines behind keep their numbers.
TEST(RoomChanges, ReplacesElements) {
  const auto changed = [](std::vector<calc::SourceLocation> elements) {
    return check::with_luminaires_instead(kText, "p.xml", "r", elements, {});
  };
  const check::ChangedText line = changed({{"p.xml", 5, 1}});
  ASSERT_TRUE(line.text) << line.problem;
  EXPECT_EQ(*line.text, with("<luminaire-line id=\"L\" type=\"t\" from=\"0 1 2\"\n  to=\"6 1 2\" "
                             "count=\"3\"/>",
                             "\n"));
  const check::ChangedText both = changed({{"p.xml", 7, 1}, {"p.xml", 5, 1}});
  ASSERT_TRUE(both.text) << both.problem;
  EXPECT_THAT(*both.text, Not(HasSubstr("luminaire")));
  EXPECT_THAT(*both.text, HasSubstr("\n\n\n\n<box id=\"b\""));
  EXPECT_THAT(changed({{"p.xml", 8, 1}}).problem, HasSubstr("assembly"));  // a box
  EXPECT_THAT(changed({{"p.xml", 5, 2}}).problem, HasSubstr("assembly"));
}

// What comes in and what goes may begin at the same place.
TEST(RoomChanges, ReplacesTheFirstElementWithoutABlankBefore) {
  const std::string text =
      "<luxgate version=\"1\"><room id=\"r\"><luminaire id=\"x\" type=\"t\" position=\"1 1 1\"/>"
      "</room></luxgate>";
  calc::Diagnostics diagnostics;
  const auto root = calc::parse_xml(text, "p.xml", diagnostics);
  ASSERT_TRUE(root);
  check::TextChange change(text);
  const calc::XmlElement& room = root->children[0];
  change.remove(room.children[0]);
  change.add_children(room, "<new/>");
  EXPECT_EQ(change.apply(), "<luxgate version=\"1\"><room id=\"r\"><new/></room></luxgate>");
}

TEST(RoomChanges, MakesOneSurfaceLighter) {
  const check::ChangedText changed = check::with_reflectance(kText, "p.xml", "r", "ceiling", 0.6);
  ASSERT_TRUE(changed.text) << changed.problem;
  std::string wanted =
      with("units=\"cm\">", "units=\"cm\"><material id=\"lighter-2\" reflectance=\"0.6\"/>");
  const std::size_t room = wanted.find("<room id=\"r\"");
  wanted.replace(wanted.find("ceiling=\"m\"", room), 11, "ceiling=\"lighter-2\"");
  EXPECT_EQ(*changed.text, wanted);
}

TEST(RoomChanges, SaysWhatItCannotChange) {
  EXPECT_THAT(check::with_luminaires(kText, "p.xml", "nowhere", {one("")}).problem,
              HasSubstr("nowhere"));
  EXPECT_FALSE(check::with_luminaires(kText, "p.xml", "nowhere", {one("")}).text);
  EXPECT_THAT(
      check::with_reflectance(with("count", "count = "), "p.xml", "r", "floor", 0.6).problem,
      Not(testing::IsEmpty()));
  const std::string of_file = with("origin=", "file=\"a.obj\" origin=");
  EXPECT_THAT(check::with_reflectance(of_file, "p.xml", "r", "floor", 0.6).problem,
              HasSubstr("'r'"));
  const std::string walls = with("origin=", "wall-materials=\"m m m m\" origin=");
  EXPECT_THAT(check::with_reflectance(walls, "p.xml", "r", "walls", 0.6).problem,
              HasSubstr("walls"));
  EXPECT_EQ(check::with_reflectance(walls, "p.xml", "r", "floor", 0.6).problem, "");
}

}  // namespace
}  // namespace room_changes_test
