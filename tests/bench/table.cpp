#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace bench {

Table::Table(std::string title, std::vector<std::string> heads)
    : title_(std::move(title)), rows_{std::move(heads)} {}

void Table::add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

void Table::print() const {
  std::vector<std::size_t> width(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < std::min(row.size(), width.size()); ++c) {
      width[c] = std::max(width[c], row[c].size());
    }
  }
  fmt::print("\n{}\n", title_);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < std::min(row.size(), width.size()); ++c) {
      if (c == 0) {
        fmt::print("  {:<{}}", row[c], width[c]);
      } else {
        fmt::print("  {:>{}}", row[c], width[c]);
      }
    }
    fmt::print("\n");
  }
  std::fflush(stdout);
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  return fmt::format("{:.{}f}", 100.0 * share, std::abs(share) < 0.001 ? 4 : 2);
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string count(double value) {
  return std::isfinite(value) ? fmt::format("{:.0f}", value) : "-";
}

}  // namespace bench
