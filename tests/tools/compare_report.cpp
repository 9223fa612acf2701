// Whether two generated Markdown reports say the same: words alike, numbers nearly. Machines round
// differently, and a ray that passes an edge on the other side changes a sampled number a little.
//   compare_report WRITTEN KEPT
// Words and counts (whole numbers of up to five digits in both) are the same; other
// numbers agree within 2 % of the larger one, or within 0.1 where a per cent sign follows; how many
// numbers lie in their interval may differ by five.
#include "calc/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr double kMostCoverageApart = 5.0;

bool read(const char* path, std::vector<std::string>& lines) {
  std::ifstream in(path);
  std::string line;
  while (std::getline(in, line)) lines.push_back(line);
  return !lines.empty();
}

bool is_count(std::string_view word) {
  return word.size() <= 5 && word.find_first_not_of("0123456789") == std::string_view::npos;
}

bool same_line(const std::string& a, const std::string& b) {
  const auto x = calc::split_words(a), y = calc::split_words(b);
  if (x.size() != y.size()) return false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (x[k] == y[k]) continue;
    const auto number = [](std::string_view word) {
      if (word.starts_with('+')) word.remove_prefix(1);
      return calc::parse_number(word);
    };
    const auto u = number(x[k]), v = number(y[k]);
    if (!u || !v) return false;
    // "268 lie in their stated 95 % interval": some are near its ends.
    const bool is_coverage = k + 1 < x.size() && x[k + 1] == "lie";
    if (is_coverage && std::abs(*u - *v) <= kMostCoverageApart) continue;
    if (is_count(x[k]) && is_count(y[k])) return false;
    const bool is_percent = k + 1 < x.size() && x[k + 1] == "%";
    const double allowed =
        std::max(0.02 * std::max(std::abs(*u), std::abs(*v)), is_percent ? 0.1 : 0.0);
    if (!(std::abs(*u - *v) <= allowed)) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> written, kept;
  if (argc != 3 || !read(argv[1], written) || !read(argv[2], kept)) {
    std::fprintf(stderr, "two reports are needed\n");
    return 2;
  }
  int differences = written.size() == kept.size() ? 0 : 1;
  if (differences > 0) {
    std::fprintf(stderr, "%zu lines were written, %zu are kept\n", written.size(), kept.size());
  }
  for (std::size_t k = 0; k < std::min(written.size(), kept.size()); ++k) {
    if (same_line(written[k], kept[k])) continue;
    if (++differences <= 5) {
      std::fprintf(stderr, "line %zu\n  written: %s\n  kept:    %s\n", k + 1, written[k].c_str(),
                   kept[k].c_str());
    }
  }
  if (differences > 0) std::fprintf(stderr, "the program that it names writes it anew\n");
  return differences > 0 ? 1 : 0;
}
