#pragma once
// Which part of a document is which part of an earlier one: by ids, never by paths alone, so that a
// design may move to another folder.

#include "report/document/document.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Two places nearer than this are the same: less than any drawing means, more than numbers lose on
// their way through a file.
constexpr double kSamePlace_m = 1e-6;
template <class Point>  // glm::dvec2, glm::dvec3
bool is_same_place(const Point& a, const Point& b) {
  return glm::length(a - b) <= kSamePlace_m;
}

// Either may be null: gone, or new.
template <class Part>
struct PartPair {
  const Part* before = nullptr;
  const Part* after = nullptr;
};

// Those of `after` in their order, then what is gone. key(part): equal for two that are the same;
// of several with one key the first ones belong together, the second ones, and so on.
template <class Part, class Key>
std::vector<PartPair<Part>> match_parts(const std::vector<Part>& before,
                                        const std::vector<Part>& after, const Key& key) {
  std::vector<bool> is_taken(before.size(), false);
  std::vector<PartPair<Part>> pairs;
  for (const Part& part : after) {
    PartPair<Part> pair{nullptr, &part};
    for (std::size_t k = 0; k < before.size() && pair.before == nullptr; ++k) {
      if (is_taken[k] || key(before[k]) != key(part)) continue;
      is_taken[k] = true;
      pair.before = &before[k];
    }
    pairs.push_back(pair);
  }
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (!is_taken[k]) pairs.push_back({&before[k], nullptr});
  }
  return pairs;
}

// By id; then those that say what id they had, with one of it that is left.
template <class Part, class Key, class Former>
std::vector<PartPair<Part>> match_renamed(const std::vector<Part>& before,
                                          const std::vector<Part>& after, const Key& key,
                                          const Former& former) {
  std::vector<PartPair<Part>> pairs = match_parts(before, after, key);
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (pairs[k].before != nullptr || former(after[k]).empty()) continue;
    const auto gone = std::find_if(pairs.begin(), pairs.end(), [&](const PartPair<Part>& pair) {
      return pair.after == nullptr && key(*pair.before) == former(after[k]);
    });
    if (gone == pairs.end()) continue;
    pairs[k].before = gone->before;
    pairs.erase(gone);  // it stands behind all that have an `after`
  }
  return pairs;
}

// By id, and what then is left by photometry: another id makes no other luminaire.
std::vector<PartPair<LuminaireRow>> match_luminaires(const std::vector<LuminaireRow>& before,
                                                     const std::vector<LuminaireRow>& after);

// Of two projects that belong together.
std::vector<PartPair<SpacePart>> match_rooms(const ProjectPart& before, const ProjectPart& after);

// Those of one place, whatever their type, then each that is left with the nearest that is left;
// at last what is new or gone.
std::vector<PartPair<LuminaireMark>> match_marks(const std::vector<LuminaireMark>& before,
                                                 const std::vector<LuminaireMark>& after);

// Projects have no ids: those of one path are the same; of the others those of one name that no
// other project of either side has, then those whose files alone have one name, and at last the
// only one that is left on either side.
std::vector<PartPair<ProjectPart>> match_projects(const Document& before, const Document& after);

}  // namespace report
