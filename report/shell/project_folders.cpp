#include "report/shell/project_folders.h"

#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r\n";

// Behind what opens with `open` and closes with `close`, if that stands here.
bool skip(std::string_view& text, std::string_view open, std::string_view close) {
  if (!text.starts_with(open)) return false;
  const std::size_t end = text.find(close, open.size());
  text.remove_prefix(end == text.npos ? text.size() : end + close.size());
  return true;
}

// Comments before the root may be long; what is further on is not looked for.
bool may_be_project(const fs::path& path) {
  constexpr std::size_t kMostBytes = 1 << 16;
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  const std::string_view root = root_element(text);
  return root.empty() || root == "luxgate";
}

// Nobody has named it, so that it may show nothing that lies elsewhere.
bool leads_out(const fs::path& link, const std::string& folder) {
  std::error_code failure;
  const fs::path top = fs::weakly_canonical(folder, failure);
  if (failure) return true;
  const fs::path within = fs::weakly_canonical(link, failure).lexically_relative(top);
  return failure || within.empty() || *within.begin() == "..";
}

// "" or why not.
std::string add_projects(const std::string& folder, std::vector<std::string>& projects) {
  std::error_code failure;
  std::vector<std::string> found;
  fs::recursive_directory_iterator at(folder, failure);
  for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure)) {
    const fs::path& path = at->path();
    std::error_code ignored;
    if (path.filename().string().starts_with('.')) {
      if (at->is_directory(ignored)) at.disable_recursion_pending();
      continue;
    }
    if (path.extension() != ".xml" || !at->is_regular_file(ignored)) continue;
    if (at->is_symlink(ignored) && leads_out(path, folder)) {
      return fmt::format("'{}' is a link that leads out of the folder '{}': name it by itself",
                         path.lexically_normal().string(), folder);
    }
    if (may_be_project(path)) found.push_back(path.lexically_normal().string());
  }
  if (failure) return fmt::format("cannot read the folder '{}': {}", folder, failure.message());
  if (found.empty()) return fmt::format("no project (*.xml) in the folder '{}'", folder);
  std::sort(found.begin(), found.end());
  projects.insert(projects.end(), found.begin(), found.end());
  return "";
}

}  // namespace

std::string_view root_element(std::string_view text) {
  text = calc::without_byte_order_mark(text);
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (skip(text, "<!--", "-->") || skip(text, "<?", "?>")) continue;
    // A document type may hold what looks like its end.
    if (!text.starts_with('<') || text.starts_with("<!")) return {};
    text.remove_prefix(1);
    const std::size_t end = text.find_first_of(" \t\r\n/>");
    return end == text.npos ? std::string_view() : text.substr(0, end);
  }
}

bool is_folder(const std::string& project) {
  std::error_code ignored;
  return project != kStandardInput && fs::is_directory(project, ignored);
}

std::string expand_folders(std::vector<std::string>& projects) {
  std::vector<std::string> expanded;
  for (std::string& project : projects) {
    if (!is_folder(project)) {
      expanded.push_back(std::move(project));
      continue;
    }
    if (std::string problem = add_projects(project, expanded); !problem.empty()) return problem;
  }
  projects = std::move(expanded);
  return "";
}

}  // namespace cli
