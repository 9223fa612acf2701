#pragma once
// The lines of room_summary.h in words: the same table for every format.

#include "report/document/room_summary.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

struct RoomOverview {
  enum class Column { verdict, room, met, average, uniformity, glare, power };
  std::vector<Column> columns;
  std::vector<std::string> head;
  struct Row {
    rules::Outcome outcome = rules::Outcome::nothing_asked;
    std::size_t space = 0;           // of the project
    std::vector<std::string> cells;  // as many as head; verdict and room first, then numbers
  };
  std::vector<Row> rows;  // gravest first

  // Nothing where it has none.
  void drop(Column column);
};

// Nothing where a project has fewer than two rooms of which something is asked. Columns that no
// room has anything in are left out.
RoomOverview room_overview(const Texts& t, const ProjectPart& project);

}  // namespace report
