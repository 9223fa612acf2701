#include "report/revision/matching.h"

#include <filesystem>
#include <functional>

namespace report {
namespace {

using Projects = std::vector<const ProjectPart*>;
using Key = std::function<std::string(const ProjectPart&)>;

// Pairs those with a key that is not "" and that only one project of each side has.
void pair_by(const Key& key, Projects& before, Projects& after,
             std::vector<PartPair<ProjectPart>>& pairs) {
  const auto count = [&key](const Projects& list, const std::string& wanted) {
    return std::count_if(list.begin(), list.end(), [&](const ProjectPart* project) {
      return project != nullptr && key(*project) == wanted;
    });
  };
  const Projects all_before = before, all_after = after;
  for (std::size_t a = 0; a < after.size(); ++a) {
    if (after[a] == nullptr) continue;
    const std::string wanted = key(*after[a]);
    if (wanted.empty() || count(all_before, wanted) != 1 || count(all_after, wanted) != 1) continue;
    const auto found = std::find_if(before.begin(), before.end(), [&](const ProjectPart* project) {
      return project != nullptr && key(*project) == wanted;
    });
    pairs[a].before = *found;
    *found = nullptr;
    after[a] = nullptr;
  }
}

Projects pointers_to(const Document& document) {
  Projects list;
  for (const ProjectPart& project : document.projects) list.push_back(&project);
  return list;
}

// Of the project's own file; "" = not known.
std::string own_hash(const ProjectPart& project) {
  return project.inputs.empty() ? "" : project.inputs.front().sha256;
}

// Whatever is the same to the last byte, copies one after the other.
void pair_alike(Projects& before, Projects& after, std::vector<PartPair<ProjectPart>>& pairs) {
  for (std::size_t a = 0; a < after.size(); ++a) {
    if (after[a] == nullptr || own_hash(*after[a]).empty()) continue;
    const auto found = std::find_if(before.begin(), before.end(), [&](const ProjectPart* project) {
      return project != nullptr && own_hash(*project) == own_hash(*after[a]);
    });
    if (found == before.end()) continue;
    pairs[a].before = *found;
    *found = nullptr;
    after[a] = nullptr;
  }
}

// The only one that is left; null: none or several.
const ProjectPart** only_one(Projects& list) {
  const auto is_left = [](const ProjectPart* project) { return project != nullptr; };
  if (std::count_if(list.begin(), list.end(), is_left) != 1) return nullptr;
  return &*std::find_if(list.begin(), list.end(), is_left);
}

}  // namespace

std::vector<PartPair<LuminaireRow>> match_luminaires(const std::vector<LuminaireRow>& before,
                                                     const std::vector<LuminaireRow>& after) {
  auto pairs = match_parts(before, after, [](const LuminaireRow& row) { return row.type_id; });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].before != nullptr) continue;
    const auto gone = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return pair.after == nullptr && pair.before->sha256 == pairs[k].after->sha256;
    });
    if (gone == pairs.end()) continue;
    pairs[k].before = gone->before;
    pairs.erase(gone);  // it stands behind all that have an `after`
  }
  return pairs;
}

std::vector<PartPair<SpacePart>> match_rooms(const ProjectPart& before, const ProjectPart& after) {
  return match_renamed(
      before.spaces, after.spaces, [](const SpacePart& space) { return space.id; },
      [](const SpacePart& space) { return space.was; });
}

std::vector<PartPair<LuminaireMark>> match_marks(const std::vector<LuminaireMark>& before,
                                                 const std::vector<LuminaireMark>& after) {
  std::vector<const LuminaireMark*> left;
  for (const LuminaireMark& mark : before) left.push_back(&mark);
  std::vector<PartPair<LuminaireMark>> pairs;
  for (const LuminaireMark& mark : after) {
    PartPair<LuminaireMark> pair{nullptr, &mark};
    const auto found = std::find_if(left.begin(), left.end(), [&](const LuminaireMark* other) {
      return is_same_place(other->position_m, mark.position_m);
    });
    if (found != left.end()) {
      pair.before = *found;
      left.erase(found);
    }
    pairs.push_back(pair);
  }
  for (PartPair<LuminaireMark>& pair : pairs) {
    if (pair.before != nullptr || left.empty()) continue;
    const auto distance_m = [&](const LuminaireMark* other) {
      return glm::length(other->position_m - pair.after->position_m);
    };
    const auto nearest = std::min_element(left.begin(), left.end(),
                                          [&](const LuminaireMark* a, const LuminaireMark* b) {
                                            return distance_m(a) < distance_m(b);
                                          });
    pair.before = *nearest;
    left.erase(nearest);
  }
  for (const LuminaireMark* gone : left) pairs.push_back({gone, nullptr});
  return pairs;
}

std::vector<PartPair<ProjectPart>> match_projects(const Document& before, const Document& after) {
  std::vector<PartPair<ProjectPart>> pairs;
  for (const ProjectPart& project : after.projects) pairs.push_back({nullptr, &project});
  Projects left_before = pointers_to(before), left_after = pointers_to(after);
  pair_by([](const ProjectPart& p) { return p.path; }, left_before, left_after, pairs);
  pair_by([](const ProjectPart& p) { return p.name; }, left_before, left_after, pairs);
  pair_by([](const ProjectPart& p) { return std::filesystem::path(p.path).filename().string(); },
          left_before, left_after, pairs);
  // Several of one name, in folders of their own.
  pair_by(
      [](const ProjectPart& p) {
        const std::filesystem::path path(p.path);
        const std::filesystem::path folder = path.parent_path().filename();
        return folder.empty() ? std::string() : (folder / path.filename()).string();
      },
      left_before, left_after, pairs);
  pair_alike(left_before, left_after, pairs);
  const ProjectPart** last_before = only_one(left_before);
  const ProjectPart** last_after = only_one(left_after);
  if (last_before != nullptr && last_after != nullptr) {
    pairs[static_cast<std::size_t>(last_after - left_after.data())].before = *last_before;
    *last_before = nullptr;
  }
  for (const ProjectPart* gone : left_before) {
    if (gone != nullptr) pairs.push_back({gone, nullptr});
  }
  return pairs;
}

}  // namespace report
