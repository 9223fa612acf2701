#pragma once
// Documents of many rooms for tests of what is said room by room: hand-made numbers, no light is
// calculated. Rooms differ in their use, in what they come to and in how long their names are.

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "report/document/document.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace report {

struct RoomKind {
  const char* name;
  const char* row;  // of EN 12464-1:2021
  double average_lx, uniformity, glare;
};
inline constexpr std::array kRoomKinds{
    RoomKind{"Office", "34.2", 500, 0.6, 19}, RoomKind{"Corridor", "9.1", 100, 0.4, 28},
    RoomKind{"Storage of the registry, north wing, shelves 1 to 40", "34.7", 100, 0.4, 25},
    RoomKind{"Reception", "34.6", 500, 0.6, 19}};

inline rules::Finding room_finding(const RoomKind& kind, const std::string& id,
                                   rules::Metric metric, double limit,
                                   const calc::Estimate& measured) {
  rules::Finding finding = sample_finding(metric, limit, measured);
  finding.requirement.id = id;
  finding.requirement.clause = calc::Message::words(fmt::format("EN 12464-1:2021 {}", kind.row));
  finding.requirement.origin.pack = "en12464-1:2021";
  finding.requirement.origin.row = kind.row;
  return finding;
}

inline PlanePart room_plane(const std::string& room, const std::string& role) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  plane.id = room + "." + role;
  plane.name = "Use: " + role;
  plane.space_id = room;
  plane.made_by = calc::Message::words("workplace " + room + ": " + role);
  plane.findings.clear();
  return plane;
}

inline PlanePart task_plane(const std::string& room, const RoomKind& kind, double share) {
  PlanePart plane = room_plane(room, "task");
  const double lx = kind.average_lx * share;
  plane.findings = {room_finding(kind, "average", rules::Metric::average, kind.average_lx,
                                 estimate(lx, 0.01 * lx)),
                    room_finding(kind, "Uo", rules::Metric::uniformity_min_avg, kind.uniformity,
                                 estimate(kind.uniformity + 0.15, 0.01))};
  plane.findings[0].requirement.note = calc::say<calc::Sentence::one_source>();
  plane.findings[1].requirement.note = calc::say<calc::Sentence::one_source>();
  return plane;
}

inline PlanePart observer_plane(const std::string& room, const RoomKind& kind, double rating) {
  PlanePart plane = room_plane(room, "observer 1");
  plane.derived = calc::DerivedQuantity::ugr;
  plane.findings = {
      room_finding(kind, "UGR", rules::Metric::maximum, kind.glare, estimate(rating, 0.2))};
  rules::Requirement& requirement = plane.findings[0].requirement;
  requirement.derived = calc::DerivedQuantity::ugr;
  requirement.comparison = rules::Comparison::at_most;
  judge_again(plane.findings[0]);
  plane.remarks = {calc::say<calc::Sentence::ugr_method>(0.8)};
  return plane;
}

// Two of them.
inline void add_walls(const std::string& room, const RoomKind& kind, bool is_second_judged,
                      SpacePart& space) {
  rules::RoleCoverage role{"wall", rules::RoleState::met, {}};
  for (const std::string wall : {"wall 1", "wall 2"}) {
    PlanePart plane = room_plane(room, wall);
    plane.findings = {room_finding(kind, "average", rules::Metric::average, 50, estimate(80, 1))};
    plane.findings[0].requirement.origin.is_of_own_role = false;
    if (wall == "wall 2" && !is_second_judged) {
      plane.findings[0].verdict = rules::Verdict::not_judged;
      plane.findings[0].reason = calc::Message::words(
          "24 of 102 points are omitted: 24 inside 'cabinet' (to accept it, add <deviation "
          "in=\"points\">)");
    }
    role.of.push_back({plane.id, plane.findings[0].requirement.id});
    space.planes.push_back(plane);
  }
  space.coverage = {
      {room, calc::Message::words(fmt::format("EN 12464-1:2021 {}", kind.row)), {std::move(role)}}};
}

// number: from 0. Each seventh fails, each ninth has a wall that is not judged; every fifth has the
// name of another one.
inline SpacePart many_rooms_room(std::size_t number) {
  const RoomKind& kind = kRoomKinds.at(number % kRoomKinds.size());
  SpacePart space = small_document().projects[0].spaces[0];
  space.planes.clear();
  const std::size_t storey = number / 50;
  space.id = fmt::format("room-{}", number + 1);
  space.name = number % 5 == 4 ? "Copies"
                               : fmt::format("{}.{:02} {}", storey + 1, number % 50 + 1, kind.name);
  space.floor_z_m = 3.5 * static_cast<double>(storey);
  space.power.power_w = 40.0 + static_cast<double>(number % 8);
  space.power.area_m2 = 8.0;
  const bool fails = number % 7 == 3;
  space.planes.push_back(task_plane(space.id, kind, fails ? 0.82 : 1.25));
  space.planes.push_back(observer_plane(space.id, kind, number % 4 == 1 ? -20.28 : 16.4));
  add_walls(space.id, kind, number % 9 != 5, space);
  if (number % 6 == 2) space.planes[0].remarks = {calc::say<calc::Sentence::speck>(0.029)};
  return space;
}

// With a warning about each third room.
inline Document many_rooms_document(std::size_t rooms) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  project.name = "Town hall";
  project.spaces.clear();
  for (std::size_t r = 0; r < rooms; ++r) project.spaces.push_back(many_rooms_room(r));
  for (std::size_t r = 0; r < rooms; r += 3) {
    project.diagnostics.push_back(
        {calc::DiagnosticId::luminaire_partly_outside,
         {"office.xml", static_cast<int>(r) + 3, 5},
         fmt::format("luminaire 'G[{},0]': its luminous opening reaches 0.0729 m out of the room",
                     r)});
  }
  return document;
}

}  // namespace report
