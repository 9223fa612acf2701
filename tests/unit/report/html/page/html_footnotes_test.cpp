#include "report/html/page/html_footnotes.h"

#include "calc/base/sentences.h"
#include "report/text/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace report::html_footnotes_test {
namespace {

using calc::Message;
using calc::Sentence;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Message kRow = Message::words("EN 12464-1:2021 34.2");

PlanePart plane_with(std::vector<Message> notes) {
  PlanePart plane;
  plane.id = "desk";
  for (const Message& note : notes) {
    rules::Finding finding;
    finding.requirement.clause = calc::say<Sentence::unverified_of>(kRow);
    finding.requirement.note = note;
    plane.findings.push_back(finding);
  }
  return plane;
}

SpacePart room(const std::string& name) {
  SpacePart space;
  space.id = name;
  return space;
}

TEST(Footnotes, TellOnceWhatSeveralFindingsHaveToBeReadWith) {
  const SpacePart office = room("Office <1>");
  const Message often = calc::say<Sentence::unverified>() + "; " + Message::words("by table");
  const PlanePart plane = plane_with({often, often + "; " + Message::words("lane 2")});
  Footnotes footnotes{Texts()};
  footnotes.add({{&office, &plane}});
  const std::vector<NoteItem> items = note_items({}, plane.findings[1]);
  EXPECT_EQ(footnotes.inline_html(items), "lane 2");
  EXPECT_EQ(footnotes.marks(items),
            "<sup class=\"marks\"><a href=\"#note1\">1</a> <a href=\"#note2\">2</a></sup>");
  // The rows of the standard, and the rooms.
  EXPECT_THAT(footnotes.list(), AllOf(HasSubstr("Affected: EN 12464-1:2021 34.2."),
                                      HasSubstr("by table <span class=\"quiet\">(Office "
                                                "&lt;1&gt;)</span>"),
                                      Not(HasSubstr("lane 2"))));
}

// The report says of requirements once that a number rests on one public source, and not here; of
// grids it is told here.
TEST(Footnotes, TellOfOneSourceWhereItIsOfAGrid) {
  const SpacePart hall = room("Hall");
  PlanePart plane = plane_with({calc::say<Sentence::one_source>(), {}});
  for (rules::Finding& finding : plane.findings)
    finding.requirement.clause = calc::say<Sentence::one_source_of>(kRow);
  PlanePart other = plane;
  Footnotes footnotes{Texts()};
  footnotes.add({{&hall, &plane}, {&hall, &other}});
  EXPECT_EQ(footnotes.list(), "");
  EXPECT_EQ(footnotes.marks(note_items({}, plane.findings[0])), "");
  plane.grid.rule = other.grid.rule = calc::say<Sentence::one_source_of>(kRow);
  footnotes.add({{&hall, &plane}, {&hall, &other}});
  EXPECT_THAT(footnotes.list(), HasSubstr("Affected: EN 12464-1:2021 34.2 (grid)."));
}

TEST(Footnotes, LeaveWhatIsThereOnceWhereItIs) {
  const SpacePart office = room("Office");
  const PlanePart plane = plane_with({Message::words("by table")});
  Footnotes footnotes{Texts()};
  footnotes.add({{&office, &plane}});
  const std::vector<NoteItem> items = note_items({}, plane.findings[0]);
  EXPECT_EQ(footnotes.inline_html(items), "by table");
  EXPECT_EQ(footnotes.marks(items), "");
  EXPECT_EQ(footnotes.list(), "");
}

// A second project goes on with the numbers of the first.
TEST(Footnotes, KeepTheirNumbers) {
  const SpacePart office = room("Office"), hall = room("Hall");
  const PlanePart a = plane_with({Message::words("a"), Message::words("a")});
  const PlanePart b = plane_with({Message::words("b"), Message::words("b"), Message::words("a")});
  Footnotes footnotes{Texts()};
  footnotes.add({{&office, &a}});
  footnotes.add({{&hall, &b}});
  EXPECT_THAT(footnotes.marks(note_items({}, b.findings[2])), HasSubstr("#note1"));
  EXPECT_THAT(footnotes.marks(note_items({}, b.findings[0])), HasSubstr("#note2"));
  EXPECT_THAT(footnotes.list(), HasSubstr("(Office, Hall)"));
}

// How many points count is told by the plane.
TEST(Footnotes, SayAMaskWithoutItsPoints) {
  PlanePart plane = plane_with({{}, {}});
  for (std::size_t i = 0; i < 2; ++i) {
    plane.findings[i].requirement.mask.id = "edge";
    plane.findings[i].requirement.mask_words = calc::say<Sentence::mask_off_outline>(0.5);
    plane.findings[i].points_used = 90 + i;
  }
  const SpacePart office = room("Office");
  Footnotes footnotes{Texts()};
  footnotes.add({{&office, &plane}});
  EXPECT_THAT(footnotes.list(),
              AllOf(HasSubstr("mask edge: without a strip of 0.5 m along the outline"),
                    Not(HasSubstr("9"))));
}

TEST(Footnotes, TakeTheSourceFromBehindANameWhereverItIs) {
  const Message name = calc::say<Sentence::one_source_of>(kRow);
  EXPECT_EQ(without_source(name).english(), "EN 12464-1:2021 34.2");
  const Message within = calc::say<Sentence::not_made>(name);
  EXPECT_EQ(without_source(within).english(), "no plane for EN 12464-1:2021 34.2");
  ASSERT_EQ(source_items({}, within).size(), 1U);
  EXPECT_EQ(source_items({}, within)[0].source, Sentence::one_source);
  EXPECT_TRUE(source_items({}, kRow).empty());
}

}  // namespace
}  // namespace report::html_footnotes_test
