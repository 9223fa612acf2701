#pragma once
// Notes to be read with the results of several rooms, each text once, or once as a doubt and once
// as method: the same for every format.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct RoomNote {
  // True: a note about the method or about every result of this kind, which is not needed to trust
  // a verdict. False: a doubt, an exception or an unmet recommendation.
  bool is_method = false;
  std::string words;                // printable()
  std::vector<std::string> places;  // "Office / wall 2", "Office"; each once, printable()
  // Number of omitted notes that differ only in their numbers and names; their places are here.
  std::size_t alike = 0;
};

// Returns the notes in document order. folds: doubts of one kind are one note.
std::vector<RoomNote> room_notes(const Texts& t, const ProjectPart& project, bool folds);

// Returns "Office / wall 2, Hall and 3 more: the plane has only 0.029 m2 (and 2 more like it)".
std::string note_line(const Texts& t, const RoomNote& note);

// Joins rows of workplaces with the same remark into one: "a, b and 6 more".
std::vector<rules::RowCoverage> together(const Texts& t, std::vector<rules::RowCoverage> rows);

}  // namespace report
