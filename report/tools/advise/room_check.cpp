#include "report/tools/advise/room_check.h"

#include "report/advice/findings.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

constexpr double kMeantPlace_m = 1.0e-6;

// Whether the changed project has them where they were meant to be.
bool has_them(const report::SpacePart& room, const std::vector<check::AddedLuminaire>& added) {
  return std::all_of(added.begin(), added.end(), [&](const check::AddedLuminaire& one) {
    return std::any_of(
        room.luminaires.begin(), room.luminaires.end(), [&](const report::LuminaireMark& mark) {
          return mark.id == one.id && mark.type_id == one.type && mark.group == one.group &&
                 glm::length(mark.position_m - one.position_m) < kMeantPlace_m &&
                 glm::length(mark.c0 - one.c0) < kMeantPlace_m &&
                 glm::length(mark.axis - one.axis) < kMeantPlace_m;
        });
  });
}

// Of a luminaire that is placed anew: its own id where it stands alone in the file, "row-3" of the
// third one of a row, and of one without an id "luminaire-7".
std::string kept_id(const calc::Project& project, const calc::Space& room, std::size_t index) {
  const calc::Luminaire& luminaire = room.luminaires[index];
  const auto is_of_same = [&](const calc::Luminaire& other) {
    return other.where.line == luminaire.where.line && other.where.column == luminaire.where.column;
  };
  const auto first = std::find_if(room.luminaires.begin(), room.luminaires.end(), is_of_same);
  const auto all = std::count_if(first, room.luminaires.end(), is_of_same);
  if (luminaire.id.empty()) {
    return unused_luminaire_id(project, fmt::format("luminaire-{}", index + 1));
  }
  if (all == 1) return luminaire.id;
  const std::string row = luminaire.id.substr(0, luminaire.id.find_first_of("[."));
  const std::size_t number = index - static_cast<std::size_t>(first - room.luminaires.begin()) + 1;
  return unused_luminaire_id(project, fmt::format("{}-{}", row, number));
}

}  // namespace

double mended_share(const std::vector<AskedOfRoom>& asked, const std::vector<double>& gain_lx,
                    double more, double least) {
  double sum = 0.0;
  for (std::size_t r = 0; r < asked.size(); ++r) {
    const double lack = more * std::max(asked[r].lack_lx, 1.0e-9);
    sum += std::clamp(gain_lx[r] / lack, least, 1.0);
  }
  return sum / static_cast<double>(asked.size());
}

bool has_room(const calc::Project& project, const calc::PointFilter& filter,
              const calc::Luminaire& luminaire) {
  const glm::dvec3 half =
      0.5 * project.webs[project.luminaire_types[luminaire.type].web].opening().size_m();
  const glm::dmat3& frame = luminaire.world_from_luminaire;
  for (const glm::dvec2& corner : {glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(1, -1),
                                   glm::dvec2(-1, 1), glm::dvec2(-1, -1)}) {
    const glm::dvec3 at =
        luminaire.position_m + frame[0] * (corner.x * half.x) + frame[1] * (corner.y * half.y);
    const calc::PointStand stand = filter.stand({at, -frame[2], -frame[2]});
    if (stand.dropped || filter.is_beside_room(at)) return false;
  }
  return true;
}

calc::BoundingBox box_of(const calc::Space& room) {
  calc::BoundingBox box;
  for (const glm::dvec2& corner : room.shell->footprint_m) {
    box.add({corner.x, corner.y, room.shell->floor_z_m});
    box.add({corner.x, corner.y, room.shell->floor_z_m + room.shell->height_m});
  }
  return box;
}

OneByOne one_by_one(const RoomQuestions& questions, const calc::Space& room,
                    const std::map<std::size_t, std::optional<AdvisedPlace>>& changed) {
  OneByOne result;
  const auto is_replaced = [&](const calc::SourceLocation& where) {
    return std::any_of(
        result.elements.begin(), result.elements.end(), [&](const calc::SourceLocation& one) {
          return one.file == where.file && one.line == where.line && one.column == where.column;
        });
  };
  for (const auto& [luminaire, place] : changed) {
    const calc::SourceLocation& where = room.luminaires[luminaire].where;
    if (!is_replaced(where)) result.elements.push_back(where);
  }
  for (std::size_t l = 0; l < room.luminaires.size(); ++l) {
    const calc::Luminaire& one = room.luminaires[l];
    const auto other = changed.find(l);
    const bool is_other = other != changed.end();
    if (!is_replaced(one.where) || (is_other && !other->second)) continue;
    result.luminaires.push_back(
        {kept_id(questions.project, room, l), questions.project.luminaire_types[one.type].id,
         one.position_m, is_other ? other->second->c0 : one.world_from_luminaire[0],
         is_other ? other->second->axis : -one.world_from_luminaire[2], one.group});
  }
  return result;
}

void check_in_room(const RoomQuestions& questions, std::size_t part_index, const std::string& scene,
                   const std::vector<AskedOfRoom>& asked, const check::ChangedText& changed,
                   const std::vector<check::AddedLuminaire>& added, CheckedPlaces& result) {
  result.problem = changed.problem;
  if (!changed.text) return;
  const std::optional<report::ProjectPart> part = questions.check(*changed.text, result.problem);
  if (!part) return;
  const report::SpacePart& room = part->spaces[part_index];
  if (!has_them(room, added)) {
    result.problem = "the changed project does not have them at the expected places";
    return;
  }
  for (const AskedOfRoom& one : asked) {
    result.after.push_back(room.planes[one.plane].findings[one.finding]);
  }
  const PassCount count = count_passes(*part, scene);
  result.passing = count.passing;
  result.asked = count.asked;
  result.broken = broken_findings(questions.part, *part);
}

}  // namespace cli
