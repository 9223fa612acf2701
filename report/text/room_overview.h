#pragma once
// The lines of room_summary.h in words: the same table for every format.

#include "report/document/room_summary.h"
#include "report/text/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

struct RoomOverview {
  enum class Column {
    verdict,
    room,
    use,  // "34.2 office desk work"; of roads the class and what is reached
    met,  // "12 of 14"
    average,
    minimum,
    uniformity,
    glare,
    walls,  // "ok", "2 of 4" are met, "–": none is judged
    cylindrical,
    power,
    leni
  };
  std::vector<Column> columns;
  std::vector<std::string> head;
  struct Row {
    rules::Outcome outcome = rules::Outcome::nothing_asked;
    std::size_t space = 0;           // of the project
    std::vector<std::string> cells;  // as many as head; verdict and room first
    // Of a task of the room above, or of all further ones together.
    bool is_area = false;
  };
  std::vector<Row> rows;  // gravest room first

  // Nothing where it has none.
  void drop(Column column);
  // Of numbers: to be aligned to the right.
  bool is_number(std::size_t column) const { return columns[column] > Column::use; }
};

// Whether a project has two rooms or more of which something is asked.
bool has_overview(const ProjectPart& project);

// Whether a room of several tasks has a line for each below its own, which then has no value that
// is of a task; or one line, with the worst values of all.
enum class AreaLines { shown, folded };

// Nothing where a project has fewer than `least` rooms of which something is asked. Columns that no
// room has anything in are left out.
RoomOverview room_overview(const Texts& t, const ProjectPart& project, std::size_t least = 2,
                           AreaLines areas = AreaLines::shown);

// The areas of a room that have lines of their own, which are its worst, and what all others are.
inline constexpr std::size_t kMostAreaLines = 6;
struct FurtherAreas {
  std::size_t count = 0;                                   // 0: there are no more
  rules::Outcome outcome = rules::Outcome::nothing_asked;  // the gravest
};
FurtherAreas further_areas(const RoomSummary& room);

// Of all areas of a room, in their order: their names, with what tells them from others of the same
// name: the row that is asked, or an id. Not printable().
std::vector<std::string> area_titles(const Texts& t, const RoomSummary& room);

// Whose the values of the room's line are: "Board", or "average Board, Uo Tables". "" where all are
// of the room, or it has one task.
std::string owners_of_values(const Texts& t, const RoomSummary& room);

// What a room came to: "412", or "503.0 ±9.0" near the limit; "–" where it is not judged.
// with_interval: false where there is no room for it.
std::string overview_value(const Texts& t, const rules::Finding& finding,
                           bool with_interval = true);
// What an average is called beside its value: "Em", or "L" of a carriageway's luminance.
const char* average_symbol(const rules::Finding& average);
// With what is required: "412 ≥ 500". "" without a finding.
std::string overview_cell(const Texts& t, const rules::Finding* finding);

}  // namespace report
