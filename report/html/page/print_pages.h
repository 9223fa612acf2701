#pragma once
// What the page is on paper, beyond the style sheet: its size, what runs along at head and foot,
// and which rooms share pages. Texts from files go through css_string(), always.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace report {

enum class Paper { a4, letter };

// A string of a style sheet, with its quotes. Nothing in it ends the string, the style sheet or the
// element around that, and it is the same in HTML and XML.
std::string css_string(std::string_view text);

// What stands at the edges of every page; "" = nothing.
struct PageWords {
  std::string head, room, foot;
};
// has_cover: nothing stands at the edges of the first page.
std::string page_rules(const Texts& t, Paper paper, const PageWords& words, bool has_cover = false);

// What the foot says of a project: its name, number, revision and date.
std::string foot_words(const Texts& t, const ProjectPart& project);

// What the head says: whose report it is, the company's if the project names one.
std::string head_words(const Texts& t, const calc::AboutProject& about);

// Rooms, one behind the other: each of many planes has pages of its own, with its name at their
// head. Others share pages, so that none is left half empty; a page may then have parts of several
// rooms or of one, so that nothing stands at its head, and the planes say of which room they are.
struct RoomRun {
  std::string page;  // its name in style sheets; "" of several rooms
  std::string head;  // name of the only room; "" of several
  std::size_t first = 0, rooms = 0;
  bool is_all = false;  // of the project, which goes on there
};
// index: of the project.
std::vector<RoomRun> room_runs(const ProjectPart& project, std::size_t index);
// What runs along at the head of these pages; "" of several rooms.
std::string run_rule(const RoomRun& run);

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::Paper> {
  static constexpr EnumName<report::Paper> list[] = {{report::Paper::a4, "a4"},
                                                     {report::Paper::letter, "letter"}};
};

}  // namespace calc
