#include "report/revision/moved_rooms.h"

#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "report/revision/matching.h"
#include "report/revision/question_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace report {
namespace {

// A room that its project has lost, or got.
struct Room {
  std::size_t project = 0;  // in its document
  const SpacePart* space = nullptr;
};
struct Move {
  Room from, to;
};

bool is_same_room(const SpacePart& a, const SpacePart& b) {
  return a.id == b.id && a.name == b.name && is_same_number(a.floor_z_m, b.floor_z_m) &&
         is_same_number(a.height_m, b.height_m) &&
         std::equal(a.footprint_m.begin(), a.footprint_m.end(), b.footprint_m.begin(),
                    b.footprint_m.end(), is_same_place<glm::dvec2>);
}

std::size_t place_in(const Document& document, const ProjectPart* project) {
  return static_cast<std::size_t>(project - document.projects.data());
}

std::vector<Move> find_moves(const Document& before, const Document& after,
                             const std::vector<PartPair<ProjectPart>>& projects) {
  static const ProjectPart kNone;
  std::vector<Room> lost, got;
  for (const PartPair<ProjectPart>& pair : projects) {
    if (pair.before != nullptr && !pair.before->is_judged) continue;
    if (pair.after != nullptr && !pair.after->is_judged) continue;
    for (const PartPair<SpacePart>& room :
         match_rooms(pair.before != nullptr ? *pair.before : kNone,
                     pair.after != nullptr ? *pair.after : kNone)) {
      if (room.after == nullptr) lost.push_back({place_in(before, pair.before), room.before});
      if (room.before == nullptr) got.push_back({place_in(after, pair.after), room.after});
    }
  }
  const auto by_id = [](const std::vector<Room>& rooms) {
    std::map<std::string, std::vector<Room>> ids;
    for (const Room& room : rooms) ids[room.space->id].push_back(room);
    return ids;
  };
  const auto lost_by_id = by_id(lost), got_by_id = by_id(got);
  std::vector<Move> moves;
  for (const Room& from : lost) {
    const auto found = got_by_id.find(from.space->id);
    if (found == got_by_id.end()) continue;
    const auto is_it = [&from](const Room& room) { return is_same_room(*room.space, *from.space); };
    const auto count = [&is_it](const std::vector<Room>& rooms) {
      return std::count_if(rooms.begin(), rooms.end(), is_it);
    };
    if (count(lost_by_id.at(from.space->id)) != 1 || count(found->second) != 1) continue;
    moves.push_back({from, *std::find_if(found->second.begin(), found->second.end(), is_it)});
  }
  return moves;
}

std::string& id_of(LuminaireRow& row) { return row.type_id; }
std::string& id_of(MaterialRow& row) { return row.id; }
std::string& id_of(SceneRow& row) { return row.id; }

bool is_alike(const LuminaireRow& a, const LuminaireRow& b) {
  return a.sha256 == b.sha256 && a.flux_lm == b.flux_lm && a.power_w == b.power_w &&
         a.maintenance_factor == b.maintenance_factor;
}
bool is_alike(const MaterialRow& a, const MaterialRow& b) { return a.reflectance == b.reflectance; }
bool is_alike(const SceneRow& a, const SceneRow& b) { return a.level_of_group == b.level_of_group; }

// Rows of the origin in the target: one whose id means something else there gets another one. The
// ids there, by those of the origin.
template <class Row>
std::map<std::string, std::string> add_rows(std::vector<Row>& rows, const std::vector<Row>& more,
                                            const std::string& origin) {
  std::map<std::string, std::string> ids;
  for (Row row : more) {
    const std::string id = id_of(row);
    bool is_there = false;
    for (Row& other : rows) {
      if (id_of(other) != id_of(row)) continue;
      is_there = is_alike(other, row);
      if (is_there) break;
      id_of(row) = fmt::format("{} ({})", id, origin);
    }
    ids[id] = id_of(row);
    if (!is_there) rows.push_back(row);
  }
  return ids;
}

// Puts rooms where they are now.
class Arrangement {
 public:
  Arrangement(const Document& before, const Document& after,
              const std::vector<PartPair<ProjectPart>>& projects)
      : before_(before), after_(after), now_(before) {
    for (const PartPair<ProjectPart>& pair : projects) {
      if (pair.after == nullptr) continue;
      if (pair.before != nullptr) {
        place_of_[place_in(after, pair.after)] = place_in(before, pair.before);
      }
    }
    std::set<std::size_t> there;
    for (const auto& [_, place] : place_of_) there.insert(place);
    for (std::size_t k = 0; k < before.projects.size(); ++k) {
      if (!there.contains(k)) gone_.insert(k);
    }
  }

  void move(const Move& move) {
    const ProjectPart& origin = before_.projects[move.from.project];
    ProjectPart& target = now_.projects[place_in_now(move.to.project)];
    SpacePart room = *move.from.space;
    // All types: those that hang nowhere are what new ones are held against.
    const auto types = add_rows(target.luminaires, origin.luminaires, origin.path);
    const auto scenes = add_rows(target.scenes, origin.scenes, origin.path);
    add_rows(target.materials, origin.materials, origin.path);
    const auto rename = [](const std::map<std::string, std::string>& ids, std::string& id) {
      const auto found = ids.find(id);
      if (found != ids.end()) id = found->second;
    };
    for (LuminaireMark& mark : room.luminaires) rename(types, mark.type_id);
    for (PlanePart& plane : room.planes) {
      for (rules::Finding& finding : plane.findings) rename(scenes, finding.requirement.scene);
    }
    target.spaces.push_back(std::move(room));
    for (std::size_t k = 1; k < origin.inputs.size(); ++k)
      target.inputs.push_back(origin.inputs[k]);
    touched_.insert({move.from.project, place_in_now(move.to.project)});
    ProjectPart& left = now_.projects[move.from.project];
    std::erase_if(left.spaces,
                  [&](const SpacePart& space) { return space.id == move.from.space->id; });
    move_aggregates(left, target, [&](const rules::AggregateFinding& finding) {
      return finding.space_id == move.from.space->id;
    });
    const bool is_left = std::any_of(left.spaces.begin(), left.spaces.end(),
                                     [](const SpacePart& space) { return !space.planes.empty(); });
    if (is_left || !gone_.contains(move.from.project)) return;
    move_aggregates(left, target, [](const rules::AggregateFinding&) { return true; });
    emptied_.insert(move.from.project);
  }

  Document take() {
    for (const std::size_t k : touched_) count_luminaires(now_.projects[k]);
    std::vector<ProjectPart> projects;
    for (std::size_t k = 0; k < now_.projects.size(); ++k) {
      if (!emptied_.contains(k)) projects.push_back(std::move(now_.projects[k]));
    }
    now_.projects = std::move(projects);
    return std::move(now_);
  }

 private:
  // Of a project that was none before, a new one without anything.
  std::size_t place_in_now(std::size_t place_in_after) {
    const auto known = place_of_.find(place_in_after);
    if (known != place_of_.end()) return known->second;
    ProjectPart project;
    project.path = after_.projects[place_in_after].path;
    project.name = after_.projects[place_in_after].name;
    project.is_judged = true;
    const std::vector<calc::InputFile>& inputs = after_.projects[place_in_after].inputs;
    if (!inputs.empty()) project.inputs = {inputs.front()};  // its own file; the others come along
    now_.projects.push_back(std::move(project));
    return place_of_[place_in_after] = now_.projects.size() - 1;
  }

  static void move_aggregates(ProjectPart& from, ProjectPart& to, const auto& is_wanted) {
    const auto kept = std::stable_partition(
        from.aggregates.begin(), from.aggregates.end(),
        [&](const rules::AggregateFinding& finding) { return !is_wanted(finding); });
    std::move(kept, from.aggregates.end(), std::back_inserter(to.aggregates));
    from.aggregates.erase(kept, from.aggregates.end());
  }

  static void count_luminaires(ProjectPart& project) {
    for (LuminaireRow& row : project.luminaires) {
      row.count = 0;
      for (const SpacePart& space : project.spaces) {
        row.count += static_cast<int>(
            std::count_if(space.luminaires.begin(), space.luminaires.end(),
                          [&](const LuminaireMark& mark) { return mark.type_id == row.type_id; }));
      }
    }
  }

  const Document& before_;
  const Document& after_;
  Document now_;
  std::map<std::size_t, std::size_t> place_of_;  // in now_, by the place in after_
  std::set<std::size_t> gone_, emptied_;         // in before_
  std::set<std::size_t> touched_;                // in now_
};

std::vector<calc::Message> notes_of(const Document& before, const Document& after,
                                    const std::vector<Move>& moves) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> rooms;
  for (const Move& move : moves) {
    rooms[{move.from.project, move.to.project}].push_back(move.from.space->id);
  }
  constexpr std::size_t kMostNamed = 6;
  std::vector<calc::Message> notes;
  for (const auto& [projects, ids] : rooms) {
    notes.push_back(calc::say<calc::Sentence::rooms_moved>(
        calc::Message::path(before.projects[projects.first].path),
        calc::Message::path(after.projects[projects.second].path),
        calc::names_message(ids, kMostNamed)));
  }
  return notes;
}

}  // namespace

std::optional<MovedRooms> find_moved_rooms(const Document& before, const Document& after) {
  const std::vector<PartPair<ProjectPart>> projects = match_projects(before, after);
  const std::vector<Move> moves = find_moves(before, after, projects);
  if (moves.empty()) return std::nullopt;
  Arrangement arrangement(before, after, projects);
  for (const Move& move : moves) arrangement.move(move);
  return MovedRooms{arrangement.take(), notes_of(before, after, moves)};
}

}  // namespace report
