#include "report/formats/console_rooms.h"

#include "report/text/plain_text.h"
#include "tests/support/rendered.h"
#include "tests/support/room_documents.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace report::terminal_rooms_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string on_terminal(const Document& document, int width) {
  FormatStyle style;
  style.terminal.width = width;
  style.terminal.has_messages = false;
  return rendered("text", document, style);
}

// What was rendered is left beside the test where it differs from the file.
void expect_sample(const std::string& name, const std::string& text) {
  std::ifstream file(std::string(LUXGATE_FORMAT_SAMPLES) + "/terminal/" + name, std::ios::binary);
  std::ostringstream expected;
  expected << file.rdbuf();
  if (text == expected.str()) return;
  std::ofstream(testing::TempDir() + name, std::ios::binary) << text;
  EXPECT_EQ(text, expected.str()) << "see " << testing::TempDir() << name;
}

TEST(TerminalRooms, LookLikeTheFiles) {
  for (const std::size_t rooms : {1U, 8U, 21U, 200U}) {
    const Document document = many_rooms_document(rooms);
    for (const int width : {80, 120, 200}) {
      expect_sample(fmt::format("{}-rooms-{}-columns.txt", rooms, width),
                    on_terminal(document, width));
    }
  }
}

void expect_fits(const std::string& text, int width) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    ASSERT_LE(display_width(line), static_cast<std::size_t>(width)) << line;
  }
}

TEST(TerminalRooms, NoLineIsWiderThanTheTerminal) {
  std::vector<Document> documents;
  for (const std::size_t rooms : {1U, 8U, 21U}) documents.push_back(many_rooms_document(rooms));
  documents.push_back(small_document());
  documents.push_back(sample_document());
  documents[2].projects[0].path = "/home/someone/" + std::string(150, 'x') + "/office.xml";
  for (const bool lists_passes : {false, true}) {
    for (const bool shows_notes : {false, true}) {
      FormatStyle style;
      style.terminal.lists_passes = lists_passes;
      style.terminal.shows_notes = shows_notes;
      for (int width = 40; width <= 200; width += 7) {
        style.terminal.width = width;
        for (const Document& document : documents) {
          expect_fits(rendered("text", document, style), width);
        }
      }
    }
  }
}

// Thirty rooms on a screen, beyond the causes.
TEST(TerminalRooms, NotesOnMethodAreCountedAndDoubtsAreShownOnce) {
  const Document document = many_rooms_document(21);
  const std::string text = on_terminal(document, 0);
  EXPECT_THAT(text, HasSubstr("the plane has only 0.029 m²\n"));
  EXPECT_THAT(text, HasSubstr("Numbers of 4 rows rest on one public source: EN 12464-1:2021 "));
  EXPECT_EQ(text.find("one public source"), text.rfind("one public source"));
  EXPECT_THAT(text, Not(HasSubstr("Guth")));
  EXPECT_THAT(text, HasSubstr("\n22 notes on method and limits (--notes shows them)\n"));
  EXPECT_THAT(text, Not(HasSubstr("--notes shows each")));
  FormatStyle style;
  style.terminal.shows_notes = true;
  const std::string all = rendered("text", document, style);
  EXPECT_THAT(all, HasSubstr("one public source"));
  EXPECT_THAT(all, HasSubstr("Guth"));
  EXPECT_THAT(all, Not(HasSubstr("notes on method")));
}

TEST(TerminalRooms, DoubtsOfAKindAreOne) {
  Document document = many_rooms_document(8);
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  spaces[0].planes[0].remarks = {calc::say<calc::Sentence::speck>(0.031)};
  spaces[1].planes[0].remarks = {calc::say<calc::Sentence::speck>(0.027)};
  const std::string text = on_terminal(document, 0);
  EXPECT_THAT(text, HasSubstr(": the plane has only 0.031 m² (and 2 more like it)\n"));
  EXPECT_THAT(text, Not(HasSubstr("0.027")));
  FormatStyle style;
  style.terminal.shows_notes = true;
  EXPECT_THAT(rendered("text", document, style), HasSubstr("0.027"));
}

TEST(TerminalRooms, DoubtsOfAKindAreOneOnlyWhereTheirSentencesAre) {
  using enum calc::Sentence;
  const auto of = [](const calc::Message& what) {
    return calc::say<of_workplace>("w", calc::Message::words("EN 1"), what);
  };
  const auto text_of = [&](const calc::Message& first, const calc::Message& second) {
    Document document = many_rooms_document(8);
    document.projects[0].spaces[0].notes = {first};
    document.projects[0].spaces[1].notes = {second};
    return on_terminal(document, 0);
  };
  const auto front = calc::say<front_wall>(2), other_front = calc::say<front_wall>(4);
  const std::string alike = text_of(of(front), of(other_front));
  EXPECT_THAT(alike, Not(HasSubstr("wall 4")));
  EXPECT_THAT(alike, HasSubstr("(--notes shows each)\n"));
  EXPECT_THAT(text_of(of(front), of(other_front + "; " + calc::say<speck>(0.5))),
              HasSubstr("wall 4"));
  EXPECT_THAT(text_of(of(front), of(other_front + "; " + calc::Message::words("glass"))),
              HasSubstr("glass"));
  EXPECT_THAT(text_of(of(calc::say<left_out>(calc::Message::words("wall"))),
                      of(calc::say<left_out>(calc::Message::words("ceiling")))),
              HasSubstr("omitted: ceiling"));
}

// What the method of UGR leaves open may be the verdict.
TEST(TerminalRooms, TheMethodOfGlareIsADoubtNearItsLimit) {
  for (const double rating : {17.9, 18.1, 19.9, 20.1}) {
    Document document = many_rooms_document(8);
    SpacePart& space = document.projects[0].spaces[4];
    space.planes[1] = observer_plane(space.id, kRoomKinds[0], rating);
    const bool is_near = rating > 18 && rating < 20;
    EXPECT_EQ(on_terminal(document, 0).find("Guth") != std::string::npos, is_near) << rating;
    if (is_near) {
      EXPECT_THAT(on_terminal(document, 0), HasSubstr("· Copies / observer 1: "));
    }
  }
}

TEST(TerminalRooms, WarningsAreFoldedOnATerminalAlone) {
  const Document document = many_rooms_document(21);
  EXPECT_THAT(rendered("text", document), HasSubstr("'G[18,0]'"));
  FormatStyle style;
  style.terminal.width = 120;
  const std::string text = rendered("text", document, style);
  EXPECT_THAT(text, HasSubstr("7 times, first: "));
  EXPECT_THAT(text, Not(HasSubstr("'G[18,0]'")));
}

TEST(TerminalRooms, MarkdownOfSeveralProjectsHasTheCausesOfEach) {
  Document document = many_rooms_document(8);
  document.projects.push_back(document.projects[0]);
  document.projects[1].path = "second.xml";
  const std::string text = rendered("markdown", document);
  const std::string second = text.substr(text.find("\n#### second.xml\n"));
  EXPECT_THAT(text, HasSubstr("\n#### office.xml\n"));
  for (const std::string& one : {text, second}) {
    EXPECT_THAT(one, HasSubstr("\n**Not met**\n\n- 1.04 Reception\n"));
    EXPECT_THAT(one, HasSubstr(": the plane has only 0.029 m²\n"));
  }
}

TEST(TerminalRooms, LastLinesNameTheRooms) {
  Document document = many_rooms_document(8);
  EXPECT_TRUE(on_terminal(document, 0)
                  .ends_with("\n1 room fails: 1.04 Reception · 1 room not judged: 1.06 Corridor\n"))
      << on_terminal(document, 0);
}

TEST(TerminalRooms, OfOneNameHaveTheirIds) {
  const std::string text = on_terminal(many_rooms_document(21), 200);
  EXPECT_THAT(text, HasSubstr("Copies (room-5)"));
  EXPECT_THAT(text, HasSubstr("Copies (room-10)"));
}

TEST(TerminalRooms, LongNamesLoseTheirMiddleAndNoneItsStart) {
  const std::string text = on_terminal(many_rooms_document(8), 80);
  EXPECT_THAT(text, HasSubstr("  1.03 Stor"));
  EXPECT_THAT(text, Not(HasSubstr("  …")));
}

TEST(TerminalRooms, GlareBelowItsScaleHasNoNumber) {
  const Document document = many_rooms_document(8);
  for (const char* format : {"text", "markdown"}) {
    const std::string text = rendered(format, document);
    EXPECT_THAT(text, Not(HasSubstr("20.28"))) << format;
    EXPECT_THAT(text, Not(HasSubstr("20.3"))) << format;
  }
  EXPECT_THAT(rendered("text", document), HasSubstr("< 10 ≤ 28"));
  EXPECT_THAT(rendered("html", document), HasSubstr("&lt; 10"));
  EXPECT_THAT(rendered("json", document), HasSubstr("-20.28"));
}

TEST(TerminalRooms, UsesAreInTheReadersLanguage) {
  const Document document = many_rooms_document(8);
  EXPECT_THAT(rendered("text", document), HasSubstr("34.2 office desk work"));
  EXPECT_THAT(rendered("text", document), HasSubstr("use (EN 12464-1:2021)"));
  FormatStyle style;
  style.texts = Texts(Language::german, true);
  EXPECT_THAT(rendered("text", document, style), HasSubstr("34.2 Schreibtischarbeit"));
}

TEST(TerminalRooms, WallsAreCounted) {
  const std::string text = on_terminal(many_rooms_document(8), 200);
  EXPECT_THAT(text, HasSubstr("1 of 2"));
  EXPECT_THAT(text, HasSubstr("  ok  "));
}

}  // namespace
}  // namespace report::terminal_rooms_test
