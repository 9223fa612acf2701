#pragma once
// The manifest.csv of a collection of foreign photometry files outside the repository: one row a
// file, with its flux as integrated by another program.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace test_support {

using Row = std::map<std::string, std::string>;

inline std::vector<std::string> split_csv_line(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

inline std::vector<Row> read_manifest(const std::string& bytes) {
  std::vector<Row> rows;
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::vector<std::string> cells = split_csv_line(bytes.substr(begin, end - begin));
    begin = end + 1;
    if (names.empty()) {
      names = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) row[names[i]] = cells[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace test_support
