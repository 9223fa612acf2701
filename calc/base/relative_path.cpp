#include "calc/base/relative_path.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace calc {
namespace {

bool is_absolute(std::string_view path) {
  const bool has_drive = path.size() >= 2 && path[1] == ':';
  return path.starts_with('/') || path.starts_with('\\') || has_drive;
}

}  // namespace

std::optional<std::string> normalize_relative_path(std::string_view path) {
  if (is_absolute(path)) return std::nullopt;
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string_view part = path.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part != "..") {
      parts.push_back(part);
    } else if (parts.empty()) {
      return std::nullopt;
    } else {
      parts.pop_back();
    }
  }
  std::string normal;
  for (const std::string_view part : parts) {
    if (!normal.empty()) normal += '/';
    normal += part;
  }
  return normal;
}

}  // namespace calc
