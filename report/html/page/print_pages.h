#pragma once
// The page on paper, beyond the style sheet: its size, its head and foot, and the rooms that share
// pages. Texts from files go through css_string(), always.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

enum class Paper { a4, letter };

// Returns a string of a style sheet, with its quotes. Nothing in it ends the string, the style
// sheet or the element around it, and it is the same in HTML and XML.
std::string css_string(std::string_view text);

// The words at the edges of every page; "" = nothing.
struct PageWords {
  std::string head, room, foot;
};
// Returns the page rules. has_cover: the edges of the first page are empty.
std::string page_rules(const Texts& t, Paper paper, const PageWords& words, bool has_cover = false);

// Returns the project data in the foot: its name, number, revision and date.
std::string foot_words(const Texts& t, const ProjectPart& project);

// Returns the words in the head: the report is the company's, or luxgate's if none is named.
std::string head_words(const Texts& t, const calc::AboutProject& about);

// Consecutive rooms: each room of many planes has its own pages, with its name at their head. Other
// rooms share pages, so that none is half empty; such pages have no head, and the planes name their
// room.
struct RoomRun {
  std::string page;  // its name in style sheets; "" of several rooms
  std::string head;  // name of the only room; "" of several
  std::size_t first = 0, rooms = 0;
  bool is_all = false;  // of the project, which goes on there
};
// Returns the runs. index: of the project.
std::vector<RoomRun> room_runs(const ProjectPart& project, std::size_t index);
// Returns the head of these pages; "" for several rooms.
std::string run_rule(const RoomRun& run);

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::Paper> {
  static constexpr EnumName<report::Paper> list[] = {{report::Paper::a4, "a4"},
                                                     {report::Paper::letter, "letter"}};
};

}  // namespace calc
