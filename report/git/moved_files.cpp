#include "report/git/moved_files.h"

#include "calc/base/line_cursor.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace git {
namespace {

constexpr double kLeastInCommon = 0.5;

std::vector<std::string_view> sorted_lines(const std::string& text) {
  std::vector<std::string_view> list;
  calc::LineCursor lines(text);
  while (const std::optional<std::string_view> line = lines.next()) list.push_back(*line);
  std::sort(list.begin(), list.end());
  return list;
}

struct LikePair {
  double share = 0.0;
  std::size_t now = 0, gone = 0;
};

}  // namespace

double common_lines(const std::string& a, const std::string& b) {
  if (a == b) return 1.0;
  const std::vector<std::string_view> in_a = sorted_lines(a), in_b = sorted_lines(b);
  std::vector<std::string_view> common;
  std::set_intersection(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(),
                        std::back_inserter(common));
  const std::size_t most = std::max(in_a.size(), in_b.size());
  return most == 0 ? 0.0 : static_cast<double>(common.size()) / static_cast<double>(most);
}

std::vector<std::optional<std::size_t>> match_moved(const std::vector<std::string>& now,
                                                    const std::vector<std::string>& gone) {
  std::vector<LikePair> pairs;
  for (std::size_t n = 0; n < now.size(); ++n) {
    for (std::size_t g = 0; g < gone.size(); ++g) {
      const double share = common_lines(now[n], gone[g]);
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
