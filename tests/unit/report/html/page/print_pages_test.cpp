#include "report/html/page/print_pages.h"

#include "report/html/page/html.h"
#include "tests/support/hostile_document.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace report::print_pages_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CssString, NothingEndsIt) {
  EXPECT_EQ(css_string("Room 2.01, A-b"), "\"Room 2.01, A-b\"");
  EXPECT_EQ(css_string("ä…"), "\"ä…\"");
  EXPECT_EQ(css_string("\"'\\"), "\"\\22 \\27 \\5c \"");
  EXPECT_EQ(css_string("a\nb\r\f"), "\"a b  \"");
  EXPECT_EQ(css_string("</style>"), "\"\\3c \\2f style\\3e \"");
  EXPECT_EQ(css_string("&x;{}"), "\"\\26 x\\3b \\7b \\7d \"");
  EXPECT_EQ(css_string("\xFF"), "\"\xEF\xBF\xBD\"");
  EXPECT_EQ(css_string(hostile_name()).find_first_of("<>&'\n{};", 1), std::string::npos);
}

TEST(PageRules, SayPaperHeadAndFoot) {
  const std::string a4 = page_rules({}, Paper::a4, {"head", "room", "foot"});
  EXPECT_EQ(a4,
            "@page {\n@top-left { content: \"head\"; }\n@top-right { content: \"room\"; }\n"
            "@bottom-left { content: \"foot\"; }\n@bottom-right { content: \"Page \" counter(page) "
            "\" / \" counter(pages); }\n}\n");
  EXPECT_THAT(page_rules({}, Paper::letter, {}), HasSubstr("size: letter;"));
  EXPECT_THAT(page_rules({}, Paper::letter, {}), Not(HasSubstr("top-left")));
  EXPECT_THAT(page_rules({Language::german, true}, Paper::a4, {}), HasSubstr("\"Seite \""));
  EXPECT_LT(page_rules({}, Paper::a4, {std::string(9999, 'x'), "", ""}).size(), 400U);
}

TEST(FootWords, NameNumberRevisionAndDate) {
  ProjectPart project;
  project.path = "a/p.xml";
  EXPECT_EQ(foot_words({}, project), "a/p.xml");
  project.name = "Town hall";
  project.about.number = "4711";
  project.about.revision = "b";
  project.about.date = "2026-03-31";
  EXPECT_EQ(foot_words({}, project), "Town hall · 4711 · Revision b · 2026-03-31");
  project.name = std::string(999, 'x');
  EXPECT_THAT(foot_words({}, project), HasSubstr(" · 4711 · Revision b"));
}

// Rooms by their numbers of planes.
std::vector<std::string> runs_of(const std::vector<std::size_t>& planes) {
  ProjectPart project;
  for (std::size_t s = 0; s < planes.size(); ++s) {
    SpacePart space;
    space.id = std::string(1, static_cast<char>('a' + s));
    space.planes.resize(planes[s]);
    project.spaces.push_back(space);
  }
  std::vector<std::string> heads;
  for (const RoomRun& run : room_runs(project, 0)) heads.push_back(run.head);
  return heads;
}

// A page of several rooms names none of them, since it may have another one only.
TEST(RoomRuns, SmallRoomsSharePages) {
  using Heads = std::vector<std::string>;
  EXPECT_EQ(runs_of({}), Heads());
  EXPECT_EQ(runs_of({25, 24, 60}), (Heads{"a", "b", "c"}));
  EXPECT_EQ(runs_of({8, 8, 8, 8, 8}), (Heads{""}));
  EXPECT_EQ(runs_of({1, 0, 25, 24, 2}), (Heads{"", "c", "d", "e"}));
}

TEST(RoomRuns, ASmallProjectGoesOnThere) {
  ProjectPart project;
  project.spaces.resize(2);
  EXPECT_TRUE(room_runs(project, 0).front().is_all);
  EXPECT_EQ(room_runs(project, 0).front().head, "");
  EXPECT_EQ(run_rule(room_runs(project, 0).front()), "");
  project.spaces[1].planes.resize(24);
  for (const RoomRun& run : room_runs(project, 0)) EXPECT_FALSE(run.is_all);
}

TEST(PrintedPage, HeadNamesTheCompany) {
  EXPECT_EQ(head_words({}, {}), "luxgate · lighting compliance report");
  calc::AboutProject about;
  about.company = "Example Lighting";
  EXPECT_EQ(head_words({}, about), "Example Lighting · lighting compliance report");
}

TEST(PrintedPage, RoomsHavePagesOfTheirOwn) {
  const Document document = small_document();
  const std::string html = render_html(document);
  const std::vector<RoomRun> runs = room_runs(document.projects[0], 0);
  ASSERT_FALSE(runs.empty());
  for (const RoomRun& run : runs) {
    EXPECT_THAT(html, HasSubstr(run_rule(run)));
    EXPECT_THAT(html, HasSubstr("style=\"page: " + run.page + "\""));
  }
  EXPECT_THAT(html, HasSubstr("<li class=\"on-paper\"><a href=\"#p1s1\">"));
  EXPECT_THAT(html, HasSubstr("<h3 id=\"p1s1\">"));
}

}  // namespace
}  // namespace report::print_pages_test
