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
    // The line is a task of the room above, or all further tasks together.
    bool is_area = false;
  };
  std::vector<Row> rows;  // gravest room first

  // Removes a column; does nothing if it is not there.
  void drop(Column column);
  // Returns whether the column has numbers, which are aligned to the right.
  bool is_number(std::size_t column) const { return columns[column] > Column::use; }
};

// Returns whether a project has two or more rooms with requirements.
bool has_overview(const ProjectPart& project);

// shown: tasks of a room have their own lines, and the room's line has no values of tasks. folded:
// one line with the worst values of all.
enum class AreaLines { shown, folded };

// Returns the overview; empty if a project has fewer than `least` rooms with requirements. Columns
// that are empty in all rooms are omitted.
RoomOverview room_overview(const Texts& t, const ProjectPart& project, std::size_t least = 2,
                           AreaLines areas = AreaLines::shown);

// Returns how many areas of a room, worst first, have their own lines: at most 6, or 3 if all that
// follow pass. A line is not spent on a single area that is left.
std::size_t shown_areas(const RoomSummary& room);

// All areas without a line of their own.
struct FurtherAreas {
  std::size_t count = 0;                                   // 0: there are no more
  rules::Outcome outcome = rules::Outcome::nothing_asked;  // the gravest
};
FurtherAreas further_areas(const RoomSummary& room);

// Returns the names of all areas of a room, in their order; equal names are followed by the row or
// an id that distinguishes them. Not printable().
std::vector<std::string> area_titles(const Texts& t, const RoomSummary& room);

// Returns the areas that the values of the room's line come from: "Board", or "average Board, Uo
// Tables". "" if all are the room's, or it has one task.
std::string owners_of_values(const Texts& t, const RoomSummary& room);

// Returns a room's value: "412", or "503.0 ±9.0" near the limit; "–" if it is not judged.
// with_interval: false if there is no space for it.
std::string overview_value(const Texts& t, const rules::Finding& finding,
                           bool with_interval = true);
// Returns the symbol of an average: "Em", or "L" for a carriageway's luminance.
const char* average_symbol(const rules::Finding& average);
// Returns the value with its limit: "412 ≥ 500"; "" without a finding.
std::string overview_cell(const Texts& t, const rules::Finding* finding);

}  // namespace report
