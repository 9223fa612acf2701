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

// Rooms, one behind the other, that share pages: each of many planes begins a page, others do not
// leave pages half empty.
struct RoomRun {
  std::string page;  // its name in style sheets
  std::string head;  // names of its rooms
  std::size_t first = 0, rooms = 0;
  bool is_all = false;  // of a small project, which goes on there
};
// index: of the project.
std::vector<RoomRun> room_runs(const ProjectPart& project, std::size_t index);
// What runs along at the head of these pages.
std::string run_rule(const RoomRun& run);

}  // namespace report

namespace calc {

template <>
struct EnumNames<report::Paper> {
  static constexpr EnumName<report::Paper> list[] = {{report::Paper::a4, "a4"},
                                                     {report::Paper::letter, "letter"}};
};

}  // namespace calc
