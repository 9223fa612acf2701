#include "report/git/moved_files.h"

#include "calc/base/line_cursor.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace git {
namespace {

constexpr double kLeastInCommon = 0.5;

using Lines = std::vector<std::string_view>;  // sorted

Lines sorted_lines(const std::string& text) {
  Lines list;
  calc::LineCursor lines(text);
  while (const std::optional<std::string_view> line = lines.next()) list.push_back(*line);
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Lines> all_sorted_lines(const std::vector<std::string>& texts) {
  std::vector<Lines> all;
  for (const std::string& text : texts) all.push_back(sorted_lines(text));
  return all;
}

double common_share(const Lines& a, const Lines& b) {
  const std::size_t most = std::max(a.size(), b.size()), least = std::min(a.size(), b.size());
  if (static_cast<double>(least) < kLeastInCommon * static_cast<double>(most)) return 0.0;
  Lines common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return most == 0 ? 0.0 : static_cast<double>(common.size()) / static_cast<double>(most);
}

struct LikePair {
  double share = 0.0;
  std::size_t now = 0, gone = 0;
};

}  // namespace

std::vector<std::optional<std::size_t>> match_moved(const std::vector<std::string>& now,
                                                    const std::vector<std::string>& gone) {
  const std::vector<Lines> lines_now = all_sorted_lines(now), lines_gone = all_sorted_lines(gone);
  std::vector<LikePair> pairs;
  for (std::size_t n = 0; n < now.size(); ++n) {
    for (std::size_t g = 0; g < gone.size(); ++g) {
      const double share = now[n] == gone[g] ? 1.0 : common_share(lines_now[n], lines_gone[g]);
      if (share >= kLeastInCommon) pairs.push_back({share, n, g});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const LikePair& a, const LikePair& b) { return a.share > b.share; });
  std::vector<std::optional<std::size_t>> matches(now.size());
  std::vector<bool> is_taken(gone.size(), false);
  for (const LikePair& pair : pairs) {
    if (matches[pair.now] || is_taken[pair.gone]) continue;
    matches[pair.now] = pair.gone;
    is_taken[pair.gone] = true;
  }
  return matches;
}

}  // namespace git
