#pragma once
// Which file that is gone has become which new one.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace git {

// For each text of `now` its place in `gone`: the most similar pairs first, each text once, and
// only those that have at least half of the longer one's lines in common, in any order; of equally
// similar ones the first. Empty: none.
std::vector<std::optional<std::size_t>> match_moved(const std::vector<std::string>& now,
                                                    const std::vector<std::string>& gone);

}  // namespace git
