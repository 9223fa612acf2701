// compare_csv EXPECTED ACTUAL TOLERANCE: fields that are numbers in both files may differ by
// TOLERANCE relative to the larger one; everything else must be equal byte by byte. Exit 0 equal, 1
// different, 2 unreadable. CMake scripts cannot compare decimal numbers; this is all it is for.
// Fields with line ends are not supported.

#include "calc/base/file_reader.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] != separator || quoted) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines = split(text, '\n');
  for (std::string_view& line : lines) {
    if (line.ends_with('\r')) line.remove_suffix(1);
  }
  return lines;
}

bool same_field(std::string_view expected, std::string_view actual, double tolerance) {
  if (expected == actual) return true;
  const auto a = calc::parse_number(expected);
  const auto b = calc::parse_number(actual);
  return a && b && std::abs(*a - *b) <= tolerance * std::max(std::abs(*a), std::abs(*b));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const calc::DiskFileReader files;
  const calc::FileContent expected = files.read(argv[1]);
  const calc::FileContent actual = files.read(argv[2]);
  const auto tolerance = calc::parse_number(argv[3]);
  if (!expected.ok() || !actual.ok() || !tolerance) {
    fmt::print("cannot compare: {} {} tolerance '{}'\n", expected.error, actual.error, argv[3]);
    return 2;
  }

  const auto expected_lines = split_lines(expected.bytes);
  const auto actual_lines = split_lines(actual.bytes);
  bool same = expected_lines.size() == actual_lines.size();
  if (!same) fmt::print("{} lines, expected {}\n", actual_lines.size(), expected_lines.size());
  for (std::size_t i = 0; i < std::min(expected_lines.size(), actual_lines.size()); ++i) {
    const auto wanted = split(expected_lines[i], ',');
    const auto found = split(actual_lines[i], ',');
    const bool same_line = std::equal(
        wanted.begin(), wanted.end(), found.begin(), found.end(),
        [&](std::string_view a, std::string_view b) { return same_field(a, b, *tolerance); });
    if (same_line) continue;
    same = false;
    fmt::print("line {}:\n  expected {}\n  found    {}\n", i + 1, expected_lines[i],
               actual_lines[i]);
  }
  return same ? 0 : 1;
}
