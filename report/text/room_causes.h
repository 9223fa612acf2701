#pragma once
// Words for why rooms do not pass: the same for every format.

#include "report/document/room_summary.h"
#include "report/text/plane_names.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct CauseWords {
  std::string what;               // "task: average 136 lx (135 to 137 lx), required ≥ 200 lx"
  std::vector<std::string> more;  // why, and what would help; may be empty

  bool operator==(const CauseWords&) const = default;
};

// Returns the words of a cause of this room.
CauseWords cause_words(const Texts& t, const RoomSummary& room, const RoomCause& cause);

// Rooms that do not pass for the same reasons.
struct CauseEntry {
  std::vector<std::string> rooms;
  // The causes. What several in a row share is in the last of them.
  std::vector<CauseWords> causes;
};
struct CauseBlock {
  rules::Outcome outcome = rules::Outcome::fail;  // as of RoomCause
  const char* title = "";                         // "Not met"
  std::vector<CauseEntry> entries;                // in document order
};
// Returns the causes that keep rooms from passing, gravest first.
std::vector<CauseBlock> cause_blocks(const Texts& t, const ProjectPart& project);

// Returns "a, b, c and 3 more", in the report's language.
std::string some_names(const Texts& t, std::vector<std::string> names);

}  // namespace report
