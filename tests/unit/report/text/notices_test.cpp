#include "report/text/notices.h"

#include "calc/base/sentences.h"
#include "report/formats/format.h"
#include "tests/support/legible.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

namespace report::notices_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Document with_notices() {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.notes = {calc::Message::words("made-up note")};
  space.coverage = {{"desk",
                     calc::Message::words("EN 1:2021 2"),
                     {{"task", rules::RoleState::met, {}},
                      {"wall",
                       rules::RoleState::left_out,
                       {},
                       {},
                       {{"wall.2", {"glass", "A. Meier", "2099-12-31"}, false}}}}}};
  PlanePart& plane = space.planes[0];
  plane.made_by = calc::Message::words("workplace desk");
  plane.changed = calc::Message::words("made-up change");
  plane.remarks = {calc::Message::words("made-up remark")};
  plane.unseen_points = 1;
  return document;
}

TEST(Notices, AreOfEachRoomAndItsPlanesInOrder) {
  const Document document = with_notices();
  std::vector<NoticeKind> kinds;
  for (const Notice& notice : notices_of(document.projects[0].spaces[0]))
    kinds.push_back(notice.kind);
  EXPECT_THAT(kinds, ElementsAre(NoticeKind::note, NoticeKind::row, NoticeKind::left_out,
                                 NoticeKind::changed, NoticeKind::remark, NoticeKind::doubt));
}

// Formats that list problems alone, and tables of other things, have none. Of several rooms the
// terminal has another form.
TEST(Notices, AreInEveryFormatThatHasMoreThanProblems) {
  const std::set<std::string_view> without{"github", "gitlab"};
  for (const bool has_two_rooms : {false, true}) {
    Document document = with_notices();
    std::vector<SpacePart>& spaces = document.projects[0].spaces;
    if (has_two_rooms) spaces.push_back(small_document().projects[0].spaces[0]);
    for (const Format& format : formats()) {
      if (is_table(format) || without.contains(format.name)) continue;
      const std::string text = legible(format, document);
      for (const char* words : {"made-up note", "made-up change", "made-up remark"})
        EXPECT_THAT(text, HasSubstr(words)) << format.name;
      // For data the zone's id, for people its name.
      EXPECT_THAT(text, testing::AnyOf(HasSubstr("wall.2"), HasSubstr("wall 2"))) << format.name;
    }
  }
}

TEST(Notices, AreInTheReadersLanguageWithTheirPlace) {
  Document document = with_notices();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.remarks = {calc::say<calc::Sentence::four_planes>()};
  const Texts german(Language::german, true);
  for (const Notice& notice : notices_of(document.projects[0].spaces[0])) {
    if (notice.kind != NoticeKind::remark) continue;
    EXPECT_EQ(notice_line(german, notice),
              notice_place(german, notice) + ": Mittelwert aus vier senkrechten Ebenen");
  }
}

}  // namespace
}  // namespace report::notices_test
