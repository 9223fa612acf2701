#pragma once
// What must be read with the results of several rooms, each text once, or once as a doubt and once
// as of method: the same for every format.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct RoomNote {
  // How something was calculated, what every result of that kind says, what the reader need not
  // know to trust a verdict. False: a doubt, an exception or a recommendation that is not met.
  bool is_method = false;
  std::string words;                // printable()
  std::vector<std::string> places;  // "Office / wall 2", "Office"; each once, printable()
  // So many others differ from it in their numbers and names alone, and are not in the list; their
  // places are here.
  std::size_t alike = 0;
};

// In document order. folds: doubts of one kind are one note.
std::vector<RoomNote> room_notes(const Texts& t, const ProjectPart& project, bool folds);

// "Office / wall 2, Hall and 3 more: the plane has only 0.029 m2 (and 2 more like it)"
std::string note_line(const Texts& t, const RoomNote& note);

// Rows of workplaces of which the same is to be said, as one: "a, b and 6 more".
std::vector<rules::RowCoverage> together(const Texts& t, std::vector<rules::RowCoverage> rows);

}  // namespace report
