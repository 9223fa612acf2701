#pragma once
// Which file that is gone has become which new one.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace git {

// The share of lines that two texts have in common, of the longer one's, 0 to 1; the order of lines
// does not matter.
double common_lines(const std::string& a, const std::string& b);

// For each text of `now` its place in `gone`: the most similar pairs first, each text once, and
// only those that have at least half of their lines in common (as git does it); of equally similar
// ones the first. Empty: none.
std::vector<std::optional<std::size_t>> match_moved(const std::vector<std::string>& now,
                                                    const std::vector<std::string>& gone);

}  // namespace git
