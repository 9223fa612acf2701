#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace calc {

// Returns the number of bytes to insert, delete or replace to turn `a` into `b` (Levenshtein).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

// Returns the distance of `found` from `name`, if it is within a third of the name's length, or 1.
// A text too long or too short for that costs next to nothing.
inline std::optional<std::size_t> distance_if_near(std::string_view found, std::string_view name) {
  const std::size_t most = std::max<std::size_t>(1, name.size() / 3);
  const std::size_t longer = std::max(found.size(), name.size());
  if (longer - std::min(found.size(), name.size()) > most) return std::nullopt;
  const std::size_t distance = edit_distance(found, name);
  return distance <= most ? std::optional(distance) : std::nullopt;
}

}  // namespace calc
