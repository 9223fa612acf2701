#pragma once
// Matches removed files with new ones.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace git {

// Returns for each text of `now` its index in `gone`: the most similar pairs first, each text once,
// and only those with at least half of the longer one's lines in common, in any order; of equally
// similar ones the first. Empty: none.
std::vector<std::optional<std::size_t>> match_moved(const std::vector<std::string>& now,
                                                    const std::vector<std::string>& gone);

}  // namespace git
