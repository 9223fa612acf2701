#pragma once
// Matches the parts of a document with those of an earlier one: by ids, never by paths alone, so
// that a design may move to another folder.

#include "report/document/document.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace report {

// Places nearer than this are the same: below the accuracy of any drawing, above the rounding of
// numbers in files.
constexpr double kSamePlace_m = 1e-6;
template <class Point>  // glm::dvec2, glm::dvec3
bool is_same_place(const Point& a, const Point& b) {
  return glm::length(a - b) <= kSamePlace_m;
}

// A pair of parts; either may be null: removed, or new.
template <class Part>
struct PartPair {
  const Part* before = nullptr;
  const Part* after = nullptr;
};

// Returns the parts of `after` in their order, then the removed ones. key(part): equal for equal
// parts; parts with the same key are matched in order.
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

// Matches by id; then parts that state their earlier id, with an unmatched part of that id.
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

// Matches by id, and the rest by photometry: another id makes no other luminaire.
std::vector<PartPair<LuminaireRow>> match_luminaires(const std::vector<LuminaireRow>& before,
                                                     const std::vector<LuminaireRow>& after);

// Matches the rooms of two matching projects.
std::vector<PartPair<SpacePart>> match_rooms(const ProjectPart& before, const ProjectPart& after);

// Matches marks at the same place, whatever their type, then each remaining mark with the nearest
// remaining one; new and removed marks come last.
std::vector<PartPair<LuminaireMark>> match_marks(const std::vector<LuminaireMark>& before,
                                                 const std::vector<LuminaireMark>& after);

// Matches projects, which have no ids: by equal path; then by name, if no other project of either
// side has it; then by file name, if it is unique; at last the only project that remains on either
// side.
std::vector<PartPair<ProjectPart>> match_projects(const Document& before, const Document& after);

}  // namespace report
