#include "report/shell/options/project_folders.h"

#include "calc/base/text.h"
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
constexpr std::string_view kEnding = ".xml";

// Behind what opens with `open` and closes with `close`, if that stands here.
bool skip(std::string_view& text, std::string_view open, std::string_view close) {
  if (!text.starts_with(open)) return false;
  const std::size_t end = text.find(close, open.size());
  text.remove_prefix(end == text.npos ? text.size() : end + close.size());
  return true;
}

// The name of the first element; "" if that cannot be told.
std::string_view root_element(std::string_view text) {
  text = calc::without_byte_order_mark(text);
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (skip(text, "<!--", "-->") || skip(text, "<?", "?>")) continue;
    // A document type may hold what looks like its end.
    if (!text.starts_with('<') || text.starts_with("<!")) return {};
    text.remove_prefix(1);
    const std::size_t end = text.find_first_of(" \t\r\n/>");
    const std::string_view name = end == text.npos ? std::string_view() : text.substr(0, end);
    return name.find('\0') == name.npos ? name : std::string_view();  // UTF-16 without its mark
  }
}

// Comments before the root may be long; what is further on is not looked for.
bool file_may_be_project(const fs::path& path) {
  constexpr std::size_t kMostBytes = 1 << 16;
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return may_be_project(text);
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

// Nobody has named it, so that it may show nothing that lies elsewhere.
bool leads_out(const fs::path& link, const std::string& folder) {
  std::error_code failure;
  const fs::path top = fs::weakly_canonical(folder, failure);
  if (failure) return true;
  const fs::path within = fs::weakly_canonical(link, failure).lexically_relative(top);
  return failure || within.empty() || *within.begin() == "..";
}

// A folder behind a link may be as large as a disk; what is further on counts as a project, for
// nothing is lost by a word too many.
bool may_hold_projects(const fs::path& folder) {
  constexpr int kMostFiles = 10'000;
  std::error_code failure, ignored;
  int files = 0;
  fs::recursive_directory_iterator at(folder, failure);
  for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure)) {
    if (++files > kMostFiles) return true;
    if (is_hidden(at->path())) {
      at.disable_recursion_pending();
    } else if (has_project_name(at->path().filename().string()) && at->is_regular_file(ignored) &&
               file_may_be_project(at->path())) {
      return true;
    }
  }
  return static_cast<bool>(failure);
}

bool counts_as_project(const fs::directory_entry& entry, const std::string& folder) {
  std::error_code ignored;
  const bool is_link = entry.is_symlink(ignored);
  if (is_link && entry.is_directory(ignored) && !leads_out(entry.path(), folder)) {
    // What it leads to is looked through by its own name, unless that is hidden.
    const fs::path top = fs::weakly_canonical(folder, ignored);
    const fs::path within = fs::weakly_canonical(entry.path(), ignored).lexically_relative(top);
    const bool is_seen = std::none_of(within.begin(), within.end(), [](const fs::path& part) {
      return part.string().starts_with('.') && part != ".";
    });
    return !is_seen && may_hold_projects(entry.path());
  }
  if (is_link && entry.is_directory(ignored)) {
    return may_hold_projects(entry.path());
  }
  if (!has_project_name(entry.path().filename().string())) return false;
  if (is_link && (!entry.exists(ignored) || leads_out(entry.path(), folder))) return true;
  return entry.is_regular_file(ignored) && file_may_be_project(entry.path());
}

// "" or why not.
std::string add_projects(const std::string& folder, std::vector<std::string>& projects) {
  std::error_code failure;
  std::vector<std::string> found;
  fs::recursive_directory_iterator at(folder, failure);
  for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure)) {
    if (is_hidden(at->path())) {
      at.disable_recursion_pending();
    } else if (counts_as_project(*at, folder)) {
      found.push_back(at->path().lexically_normal().string());
    }
  }
  if (failure) return fmt::format("cannot read the folder '{}': {}", folder, failure.message());
  if (found.empty()) return fmt::format("no project (*.xml) in the folder '{}'", folder);
  std::sort(found.begin(), found.end());
  projects.insert(projects.end(), found.begin(), found.end());
  return "";
}

}  // namespace

bool has_project_name(std::string_view name) {
  return name.size() > kEnding.size() &&
         calc::ascii_lowered(name.substr(name.size() - kEnding.size())) == kEnding;
}

bool may_be_project(std::string_view text) {
  const std::string_view root = root_element(text);
  return root.empty() || calc::ascii_lowered(root) == "luxgate";
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
