#pragma once
// Why rooms do not pass, in words: the same for every format.

#include "report/document/room_summary.h"
#include "report/text/plane_names.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct CauseWords {
  std::string what;               // "task: average 136 lx (135 to 137 lx), required ≥ 200 lx"
  std::vector<std::string> more;  // why, and what would help; may be empty
};

// room: it is one of its causes.
CauseWords cause_words(const Texts& t, const RoomSummary& room, const RoomCause& cause);

// "a, b, c and 3 more", in the report's language.
std::string some_names(const Texts& t, std::vector<std::string> names);

}  // namespace report
