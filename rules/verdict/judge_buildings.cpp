#include "rules/verdict/judge_buildings.h"

#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/project/warnings/room_inside.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/lighting_energy.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/members.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <map>
#include <string>

namespace rules {
namespace {

constexpr std::size_t kMostToldRooms = 4;
constexpr std::size_t kMostToldUses = 4;

calc::Estimate exactly(double value) { return {value, value, value}; }

// Returns a member; its verdict is that of the limit for the room alone.
AggregateMember room_of(const calc::Project& project, const calc::Space& space,
                        const Requirement& requirement) {
  AggregateMember room;
  room.name = space.id;
  const calc::InstalledPower power = calc::installed_power(project, space);
  if (power.area_m2 > 0.0) room.area_m2 = power.area_m2;
  if (requirement.metric == Metric::leni) {
    const calc::LightingEnergy energy = calc::lighting_energy(project, space, power);
    room.reason = energy.problem;
    room.stated = energy.words;
    if (room.reason.empty()) room.value = energy.leni_kwh_m2;
  } else {
    room.reason = power.problem();
    room.value = power.density_w_m2();
  }
  if (room.value && requirement.problem.empty()) {
    room.verdict = decide(requirement, exactly(*room.value)).verdict;
  }
  return room;
}

// Returns why the floors of its rooms do not add up: two overlap, and the common part would count
// twice. "" = they do.
calc::Message overlap_of(const calc::Project& project, const calc::Building& building) {
  struct Room {
    const calc::Space* space;
    glm::dvec2 low_m, high_m;
  };
  std::vector<Room> rooms;
  for (const std::size_t index : building.rooms) {
    const calc::Space& space = project.spaces[index];
    if (!space.shell || space.shell->footprint_m.empty()) continue;
    Room room{&space, space.shell->footprint_m.front(), space.shell->footprint_m.front()};
    for (const glm::dvec2& corner : space.shell->footprint_m) {
      room.low_m = glm::min(room.low_m, corner);
      room.high_m = glm::max(room.high_m, corner);
    }
    for (const Room& other : rooms) {
      const bool is_apart = glm::any(glm::greaterThan(room.low_m, other.high_m)) ||
                            glm::any(glm::lessThan(room.high_m, other.low_m));
      if (is_apart || !calc::share_space(*other.space->shell, *space.shell)) continue;
      return calc::say<calc::Sentence::rooms_share_space>(other.space->id, space.id);
    }
    rooms.push_back(room);
  }
  return {};
}

// Returns "not judged: hall (power of 2 luminaires is not known)".
calc::Message unknown_rooms(const std::vector<AggregateMember>& rooms) {
  std::vector<calc::Message> names;
  for (const AggregateMember& room : rooms) {
    if (room.value) continue;
    names.push_back(calc::Message::words(room.name) + " (" + room.reason + ")");
  }
  return calc::say<calc::Sentence::not_judged_are>(calc::listed(names, kMostToldRooms));
}

// Adds hours and factors, each once; and that light outside of rooms is in no building.
void add_notes(const calc::Project& project, const std::vector<AggregateMember>& rooms,
               Requirement& requirement) {
  std::vector<calc::Message> uses;
  for (const AggregateMember& room : rooms) {
    if (room.stated.empty()) continue;
    if (std::find(uses.begin(), uses.end(), room.stated) == uses.end()) uses.push_back(room.stated);
  }
  for (std::size_t i = 0; i < std::min(uses.size(), kMostToldUses); ++i) {
    add_note(uses[i], requirement);
  }
  if (uses.size() > kMostToldUses) {
    add_note(calc::say<calc::Sentence::other_uses>(uses.size() - kMostToldUses), requirement);
  }
  std::size_t outside = 0;
  for (const calc::Space& space : project.spaces) {
    if (space.is_open_space() || space.road) outside += space.luminaires.size();
  }
  if (outside > 0) add_note(calc::say<calc::Sentence::outside_no_room>(outside), requirement);
}

Finding judge_sum(const Requirement& requirement, const std::vector<AggregateMember>& rooms,
                  const calc::Message& problem) {
  Finding finding;
  finding.requirement = requirement;
  finding.reason = requirement.problem.empty() ? problem : requirement.problem;
  const std::optional<double> sum = sum_of(rooms);
  if (!sum && finding.reason.empty()) finding.reason = unknown_rooms(rooms);
  if (!finding.reason.empty()) return finding;
  finding.measured = exactly(*sum);
  const Decision decision = decide(requirement, finding.measured);
  finding.verdict = decision.verdict;
  finding.is_close = decision.is_close;
  finding.by_tolerance = decision.by_tolerance;
  finding.margin = margin_of(requirement, finding.measured, finding.verdict);
  return finding;
}

}  // namespace

std::string building_finding_id(const std::string& building, const std::string& requirement) {
  return building + "/" + requirement;  // which no id holds
}

std::vector<AggregateFinding> judge_buildings(const calc::Project& project,
                                              const std::vector<BuildingQuestion>& questions,
                                              std::string_view today) {
  std::vector<AggregateFinding> findings;
  std::map<std::size_t, calc::Message> overlaps;  // by building
  for (const BuildingQuestion& question : questions) {
    const calc::Building& building = project.buildings[question.building];
    Requirement requirement = question.requirement;
    AggregateFinding finding;
    finding.kind = AggregateKind::building;
    finding.rule = AggregateRule::sum;
    finding.over = AggregateOver::rooms;
    finding.id = building_finding_id(building.id, requirement.id);
    finding.building_id = building.id;
    finding.building_was = building.was;
    finding.building_name = building.name;
    finding.clause = requirement.clause;
    finding.severity = requirement.severity;
    finding.where = requirement.where;
    for (const std::size_t room : building.rooms) {
      finding.members.push_back(room_of(project, project.spaces[room], requirement));
    }
    auto overlap = overlaps.find(question.building);
    if (overlap == overlaps.end()) {
      overlap = overlaps.emplace(question.building, overlap_of(project, building)).first;
    }
    add_notes(project, finding.members, requirement);
    finding.note = requirement.note;
    Finding sum = judge_sum(requirement, finding.members, overlap->second);
    apply_waiver(sum, today);
    finding.verdict = sum.verdict;
    finding.is_waived = sum.is_waived;
    finding.reason = sum.reason;
    finding.sum = std::move(sum);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace rules
