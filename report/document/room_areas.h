#pragma once
// The tasks of a room: workplaces, boards, carriageways and footways, each with its requirements.
// See room_summary.h.

#include "report/document/document.h"
#include "rules/verdict/outcome.h"

#include <cstddef>
#include <string>
#include <vector>

namespace report {

// A row of a rule pack that some requirement of a room comes from.
struct AskedRow {
  std::string pack, row;  // "en12464-1:2021", "34.2"
  bool is_user_supplied = false;

  bool operator==(const AskedRow&) const = default;
};

// Key values of several requirements. Points into the project.
struct KeyValues {
  // The gravest outcome of requirements that count: advice and waived ones do not.
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  int required = 0, met = 0;  // of the requirements that count
  // The requirement with the gravest verdict and then the least margin, of the task or of planes
  // that the project describes itself. Glare: of all planes. Null: none is required.
  const rules::Finding* average = nullptr;      // of illuminance, or of a carriageway's luminance
  const rules::Finding* uniformity = nullptr;   // minimum / average of either
  const rules::Finding* minimum = nullptr;      // as on the line of an escape route
  const rules::Finding* glare = nullptr;        // UGR, at observers or by table
  const rules::Finding* cylindrical = nullptr;  // average of Ez
};

// is_of_task: average, minimum and uniformity of a plain plane are key values.
void add_to_values(const PlanePart& plane, const rules::Finding& finding, bool is_of_task,
                   KeyValues& values);
void add_row(const rules::RuleOrigin& origin, std::vector<AskedRow>& rows);

// A workplace with all of its planes, or a plane that the project describes itself; if several rows
// require something of it, the part of one row. Points into the project.
struct RoomArea : KeyValues {
  const PlanePart* task = nullptr;  // the first plane of its task, for its name
  std::string workplace;            // id; "" = a plane by itself
  bool is_one_of_uses = false;      // another area is the same place, asked by another row
  std::vector<AskedRow> rows;       // that ask of its task
  std::vector<const rules::AggregateFinding*> classes;  // of roads
  struct Part {
    const PlanePart* plane = nullptr;
    const rules::Finding* finding = nullptr;
  };
  std::vector<Part> parts;  // all of it, in document order: advice and what is waived, too

  bool has(const rules::Finding* finding) const;
};

// Returns the areas, gravest first and then by least margin. Requirements that workplaces share,
// such as on walls, belong to each of them. Empty: fewer than two areas. aggregates: about the
// room.
std::vector<RoomArea> room_areas(const SpacePart& space,
                                 const std::vector<const rules::AggregateFinding*>& aggregates);

}  // namespace report
